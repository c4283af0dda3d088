#pragma once
// A pipeline, cycle by cycle, and its connection to the shared units.
#include <string>

#include "model/machine/links.hpp"
#include "model/machine/unit_codes.hpp"
#include "model/mem/cache.hpp"
#include "model/mem/ideal_memory.hpp"
#include "model/trace/trace.hpp"
#include "model/unit/list/list.hpp"
#include "model/unit/sched/sched.hpp"
#include "model/unit/shade/shade.hpp"
#include "model/unit/tex/tex.hpp"
#include "model/unit/trav/trav.hpp"

namespace rayclock {

/// The shared units' inputs to a pipeline in one cycle: a tile, the ids of words that memory sends to its
/// caches (null if none), and flags that its caches' own requests are accepted.
struct SharedMoves {
    const Tile* tile = nullptr;
    const std::uint32_t *node_fill = nullptr, *prim_fill = nullptr, *surf_or_stream_fill = nullptr,
                        *tex_fill = nullptr;
    bool node_miss = false, prim_miss = false, surf_or_stream_miss = false, tex_miss = false;
    bool any() const {
        return (tile != nullptr) | (node_fill != nullptr) | (prim_fill != nullptr) |
               (surf_or_stream_fill != nullptr) | (tex_fill != nullptr) | node_miss | prim_miss |
               surf_or_stream_miss | tex_miss;
    }
};

/// The words that memory sends to one cache in a window of cycles.
struct Fills {
    std::uint32_t cycles = 0;   ///< bit c: cycle c of the window has one
    std::array<std::uint32_t, 8> ids{};
    void add(std::size_t cycle, std::uint32_t id) { cycles |= 1u << cycle, ids[cycle] = id; }
    const std::uint32_t* at(std::size_t cycle) const { return cycles >> cycle & 1 ? &ids[cycle] : nullptr; }
};

/// One pipeline, cycle by cycle: *when* the rays of a trace move from unit to unit. Mirror of
/// rtl/rc_pipeline.sv.
///
/// Its units form three sides. The prim side has list's requests, prim_cache and tri; the node side has trav,
/// node_cache, the node units, xform, and list's answers; the ray side has sched, raygen and shading. In a
/// window of cycles each side can run alone, one after the other in this order: between a later and an
/// earlier side lies a unit whose latency is at least as long as the window. The signals from an earlier to a
/// later side are kept for each cycle of the window.
class Pipeline {
public:
    /// Most cycles of a window.
    static constexpr std::uint64_t max_window = 8;

    Pipeline(const Config& config, Disturbance disturbance, int number);

    void start(const Frame& frame, const Trace& trace) {
        sched_.start(frame);
        for (Delay* delay : {&node_unit_, &xform_, &tri_}) delay->clear();
        tex_.start();
        trace_ = &trace;
        first_ray_line_ = frame.first_ray_line;
        first_mesh_line_ = trace.first_mesh_line;
        rays_.assign(rays_.size(), {});   // the last frame's trace is not read again
    }

    /// Performs cycle `now`: settles the links from registered state, and clocks. Returns true if a hit left.
    bool step(std::uint64_t now, const SharedMoves& shared);
    /// Performs `cycles` cycles from `now` on, at most window(). No tile comes, and the receiver of pixels
    /// does not change. Returns the number of hits that left. `fills`: in the order of the caches' numbers.
    std::uint32_t run(std::uint64_t now, std::uint64_t cycles, const std::array<Fills, 4>& fills);
    /// Prepares for another call than run(), at the end of the windows before cycle `now`.
    void leave_windows(std::uint64_t now);
    /// Returns the longest window from this cycle on. `more`: there are tiles left.
    std::uint64_t window(bool more) const { return more ? std::min(window_, sched_.before_tile()) : window_; }
    /// True if the caches looked nothing up in the last cycle: the pipeline may be asleep.
    bool looks_idle() const {
        return (node_outcome_ > CacheOutcome::drain) & (prim_outcome_ > CacheOutcome::drain);
    }
    /// True if node_cache or prim_cache looked something up, or drained, in the last run().
    bool looked_up() const { return looked_up_; }
    /// A request of a cache to memory was accepted.
    void take_miss(std::uint32_t cache) {
        (cache == 0   ? node_cache_
         : cache == 1 ? prim_cache_
         : cache == 2 ? surf_or_stream_cache_
                      : tex_cache_)
            .take_miss();
    }
    /// Opens or closes the receiver of pixels for the next cycle. It is open at first.
    void open_sink(bool is_open) { sink_.open(is_open); }
    /// Perform the two halves of step(), so that callers can observe the links in between.
    void settle(std::uint64_t now);
    void clock(std::uint64_t now, const SharedMoves& shared);
    /// Clocks the units in the given order (a permutation of 0..pipeline_units - 1), for the test that the
    /// order does not matter.
    void clock_in_order(std::uint64_t now, const SharedMoves& shared,
                        const std::array<int, pipeline_units>& order);

    // ---- The content of the links, between settle() and clock().

    LinkMask valid_mask(const SharedMoves& shared) const;
    LinkMask fire_mask(const SharedMoves& shared) const;
    bool tile_ready() const { return sched_.tile_ready(); }
    /// Returns the caches with a request to memory in cycle `now`, as bits in the order of their numbers.
    std::uint32_t misses(std::uint64_t now) const {
        return std::uint32_t(node_cache_.miss_valid(now)) | std::uint32_t(prim_cache_.miss_valid(now)) << 1 |
               std::uint32_t((feed_ != RayFeed::camera) && surf_or_stream_cache_.miss_valid(now)) << 2 |
               std::uint32_t((feed_ == RayFeed::textured) && tex_cache_.miss_valid(now)) << 3;
    }
    /// Returns the first cycle in which a cache offers a request to memory, if no more are looked up.
    std::uint64_t next_miss() const {
        std::uint64_t next = std::min(node_cache_.next_miss(), prim_cache_.next_miss());
        if (feed_ != RayFeed::camera) next = std::min(next, surf_or_stream_cache_.next_miss());
        return feed_ == RayFeed::textured ? std::min(next, tex_cache_.next_miss()) : next;
    }
    Cache::Miss node_miss() const { return node_cache_.miss(); }
    Cache::Miss prim_miss() const { return prim_cache_.miss(); }
    Cache::Miss surf_or_stream_miss() const { return surf_or_stream_cache_.miss(); }
    Cache::Miss tex_miss() const { return tex_cache_.miss(); }
    /// Returns the context on a link that carries one and fires.
    std::uint32_t ray_on(Link link) const { return moves_[inside(link)].ray; }
    /// True if something is to move between this pipeline and the shared units. `more`: there are tiles left.
    bool has_request(bool more) const { return (misses(~std::uint64_t(0)) != 0) | (tile_ready() & more); }
    Slot slot() const { return sched_.slot(); }
    const Slot& pixel(std::uint32_t ray) const { return sched_.pixel(ray); }
    std::uint32_t node_addr(std::uint32_t ray) const { return VisitWord{rays_[ray].head}.line(); }
    std::uint32_t prim_addr(std::uint32_t ray) const { return TestWord{*rays_[ray].at}.half_line(); }
    std::uint32_t surf_addr(std::uint32_t ray) const { return EndWord{*rays_[ray].at}.line(); }
    /// Returns the line that tex requests for a ray.
    std::uint32_t texel_addr(std::uint32_t ray) const {
        return EndWord{rays_[ray].at[moves_[Link::tex_req].fires ? -2 : -1]}.line();
    }
    /// Returns the line of the record of a ray that a context is about to get.
    std::uint32_t record_addr(const Slot& slot) const {
        return first_ray_line_ + ((slot.y << pixel_bits_ | slot.x) >> 1);
    }

    // ---- For observers.

    /// Returns the outcome of a cache at the last clock edge.
    CacheOutcome outcome(Unit cache) const {
        return cache == Unit::node_cache   ? node_outcome_
               : cache == Unit::prim_cache ? prim_outcome_
               : cache == Unit::tex_cache  ? tex_outcome_
                                           : surf_or_stream_outcome_;
    }
    /// Returns the purpose of the ray that is being spawned. Call it while its transfer is observed.
    RayPurpose purpose(std::uint32_t ray) const { return EndWord{rays_[ray].at[-2]}.purpose(); }

    /// Calls `look_up(Cache&, word)` for each word that a pixel's rays read, ray by ray. Samples of a frame
    /// warm the caches with it.
    template <class LookUp> void replay_reads(const std::uint32_t* at, LookUp&& look_up);

    // ---- For idle times.

    /// True if nothing moved or changed in the last cycle. The following cycles are the same until `wakes()`.
    bool slept() const { return asleep_; }
    std::uint64_t wakes(std::uint64_t now) const;
    void skip(std::uint64_t now, std::uint64_t cycles) {
        for (Delay* delay : {&node_unit_, &xform_, &tri_}) delay->skip(now, cycles);
        if (feed_ == RayFeed::textured) tex_.skip(now, cycles);
        node_side_[last_node_side_] += cycles;
        prim_side_[last_prim_side_] += cycles;
        ray_side_[last_ray_side_] += cycles;
        if (feed_ != RayFeed::camera) surf_or_stream_cycles_[last_surf_or_stream_] += cycles;
        if (feed_ == RayFeed::textured) tex_cycles_[last_tex_] += cycles;
        if (has_instances_) xforms_[last_xform_] += cycles, lowers_[last_lower_] += cycles;
    }

    Accounts accounts() const;
    /// Returns the queue or unit that holds a ray, for messages.
    std::string where(std::uint32_t ray, std::uint64_t now) const;

private:
    /// The source of raygen's rays: the camera alone, the camera and shade (with or without textures), or
    /// records in memory.
    enum class RayFeed : std::uint8_t { camera, shade, textured, stream };
    static constexpr bool is_shaded(RayFeed feed) {
        return feed == RayFeed::shade || feed == RayFeed::textured;
    }
    static RayFeed feed_of(const Config& config) {
        return config.is_stream()      ? RayFeed::stream
               : config.has_textures() ? RayFeed::textured
               : config.shading        ? RayFeed::shade
                                       : RayFeed::camera;
    }
    /// Calls `f<feed, levels>()` for this pipeline's shape.
    template <class F> decltype(auto) with_shape(F&& f) const {
        const auto levels = [&]<RayFeed feed>() -> decltype(auto) {
            return has_instances_ ? f.template operator()<feed, true>()
                                  : f.template operator()<feed, false>();
        };
        return feed_ == RayFeed::shade      ? levels.template operator()<RayFeed::shade>()
               : feed_ == RayFeed::textured ? levels.template operator()<RayFeed::textured>()
               : feed_ == RayFeed::stream   ? levels.template operator()<RayFeed::stream>()
                                            : levels.template operator()<RayFeed::camera>();
    }
    /// The position of a context's ray in the trace.
    struct TraceCursor {
        /// Word of the visit, or of the triangle in flight; after a ray, the first word behind it.
        const std::uint32_t* at = nowhere;
        /// The visit's word, in which turns count down. After a ray: the passes left.
        std::uint32_t head = 0;
    };
    static constexpr std::uint32_t nowhere[1] = {0};
    /// A link in a cycle. When a link is idle, its ray number is that of an arbitrary context.
    struct LinkInside {
        bool valid, fires;
        std::uint32_t ray;
        operator LinkRay() const { return {fires, ray}; }
    };
    /// All inner links in a cycle. SharedMoves has the links to the shared units. When a side runs alone,
    /// only its own links are set.
    struct Moves {
        std::array<LinkInside, pipeline_links> links;
        LinkRay node_answer, tri_answer;   // the node unit's and tri's answers on arrival at trav and list
        bool another = false;              // tri's answer has another triangle to test
        bool step = false;                 // trav accepts a step of a ray that was tested or has no leaves
        bool read = false;                 // node_cache's answer is accepted
        bool placing = false;              // surf_cache's answer is an instance
        bool lower_request = false;        // the request to a node unit is for lower_
        bool lower_answer = false;         // the answer of a node unit is from lower_
        std::uint32_t record = 0;          // line of the record of sched's next ray
        std::uint32_t shade_code = 0, xform_code = 0, lower_code = 0, tex_code = 0;   // codes of units.hpp
        const LinkInside& operator[](Link link) const { return links[index(link)]; }
        void offer(Link link, bool offered, bool ready, std::uint32_t ray) {
            links[index(link)] = {offered, bool(offered & ready), ray};
        }
        /// True if one of these links fires.
        template <class... Links> bool any(Links... some) const { return (links[index(some)].fires | ...); }
    };
    /// The links of the node units share two entries of Moves. With two node units, at most one gets a
    /// request in a cycle and at most one answers, because both have the latency of the slower one.
    static constexpr Link node_unit_req = Link::box_req, node_unit_rsp = Link::box_rsp;
    /// Returns the link's entry in Moves.
    static constexpr Link inside(Link link) {
        return is_node_request(link) ? node_unit_req : is_node_answer(link) ? node_unit_rsp : link;
    }
    /// Returns the link of an entry in Moves.
    Link outside(Link link) const {
        return link == node_unit_req   ? (moves_.lower_request ? lower_ : upper_).req
               : link == node_unit_rsp ? (moves_.lower_answer ? lower_ : upper_).rsp
                                       : link;
    }
    /// True if the lower engine walks the ray's node; false with one engine.
    bool is_low(std::uint32_t ray) const { return node_addr(ray) >= first_mesh_line_; }
    /// Returns the cause of a node unit: of the only one, or of the upper or lower one.
    template <bool plain> std::uint32_t node_unit_code(const Moves& m, bool low) const {
        const LinkInside& req = m[node_unit_req];
        const bool own = m.lower_request == low;
        if (is_held<plain>(box_hold_left_) && box_is_low_ == low) return busy_code;
        return node_unit_codes[std::size_t((own & req.valid) + (own & req.fires) +
                                           3 * node_cache_.has_misses_in_flight())];
    }
    // `plain`: the caller guarantees is_plain_. The compiler then omits the cases that a plain chip never
    // reaches.
    template <bool plain> static bool is_held(std::uint32_t hold_left) { return !plain && hold_left > 0; }
    template <RayFeed feed, bool levels> void settle(Moves& m, std::uint64_t now);
    template <bool plain> void settle_leaves(Moves& m, std::uint64_t now) const;
    template <bool plain> void settle_prim_side(Moves& m, std::uint64_t now, std::size_t c);
    template <RayFeed feed, bool levels, bool plain>
    void settle_node_side(Moves& m, std::uint64_t now, std::size_t c);
    template <RayFeed feed, bool levels, bool plain> void settle_ray_side(Moves& m, std::uint64_t now) const;
    template <bool plain>
    void settle_xform(Moves& m, std::uint64_t now, std::uint32_t read, bool enters) const;
    void settle_tex(Moves& m, std::uint64_t now) const;
    template <bool plain> void clock_prim_side(const Moves& m, std::uint64_t now, const std::uint32_t* fill);
    template <RayFeed feed, bool levels, bool plain>
    void clock_node_side(const Moves& m, std::uint64_t now, std::size_t c, const std::uint32_t* fill);
    template <RayFeed feed, bool levels, bool plain>
    void clock_ray_side(const Moves& m, std::uint64_t now, std::size_t c, const Tile* tile,
                        const std::uint32_t* fill, const std::uint32_t* tex_fill);
    template <RayFeed feed, bool levels>
    void clock(const Moves& m, std::uint64_t now, const SharedMoves& shared);
    template <RayFeed feed, bool levels> bool step(std::uint64_t now, const SharedMoves& shared);
    template <RayFeed feed, bool levels, bool plain>
    std::uint32_t run(std::uint64_t now, std::uint64_t cycles, const std::array<Fills, 4>& fills);
    /// Returns the name of a link of surf_cache or of stream.
    Link surf_or_stream(Link of_surf_cache, Link of_stream) const {
        return feed_ == RayFeed::stream ? of_stream : of_surf_cache;
    }
    Decision::Flags decide(std::uint32_t ray, bool valid);
    bool has_tests(std::uint32_t ray) const { return VisitWord{rays_[ray].head}.has_tests(); }
    void enter(const LinkInside& change);
    void enter_windows(std::uint64_t now);
    template <class F> void each_unqueued(F&& f);
    template <RayFeed feed, bool levels> Shade::Leave turn_of(std::uint32_t ray);
    // Codes of the units other than caches, before the clock edge.
    template <bool plain> std::uint32_t prim_side_codes(const Moves& m) const;
    template <bool plain> std::uint32_t node_side_codes(const Moves& m) const;
    template <RayFeed feed, bool plain> std::uint32_t ray_side_codes(const Moves& m) const;
    // Count a cycle by these codes, and by the outcome of the side's cache if it has one. last_..._side_ is
    // read only after single cycles, which are never plain.
    template <bool plain> void account_prim_side(std::uint32_t codes) {
        const std::uint32_t packed = codes << cause_bits | std::uint32_t(prim_outcome_);
        ++prim_side_[packed];
        if (!plain) last_prim_side_ = packed;
        looked_up_ |= prim_outcome_ <= CacheOutcome::drain;
    }
    template <bool plain> void account_node_side(std::uint32_t codes) {
        const std::uint32_t packed = codes << cause_bits | std::uint32_t(node_outcome_);
        ++node_side_[packed];
        if (!plain) last_node_side_ = packed;
        looked_up_ |= node_outcome_ <= CacheOutcome::drain;
    }
    template <bool plain> void account_ray_side(std::uint32_t codes) {
        ++ray_side_[codes];
        if (!plain) last_ray_side_ = codes;
    }
    template <RayFeed feed, bool plain> void clock_sched(const Moves& m, std::size_t c, const Tile* tile);
    template <RayFeed feed, bool plain> void clock_raygen(const Moves& m, std::uint64_t now, std::size_t c);
    template <RayFeed feed, bool levels, bool plain> void clock_trav(const Moves& m);
    /// Clocks a cache in front of a unit. `read`: the unit accepts its answer. `unqueued`: the answer is sent
    /// ahead to the unit, which always accepts it.
    template <bool unqueued, bool plain>
    CacheOutcome clock_cache(Cache& cache, const LinkInside& request, std::uint32_t line, bool read,
                             Delay& unit, std::uint64_t now, const std::uint32_t* fill);
    template <bool levels, bool plain>
    void clock_node_cache(const Moves& m, std::uint64_t now, const std::uint32_t* fill);
    template <bool levels, bool plain> void clock_node_unit(const Moves& m, std::uint64_t now);
    void clock_xform(const Moves& m, std::uint64_t now);
    template <bool plain> void clock_list(const Moves& m);
    template <bool plain> void clock_prim_cache(const Moves& m, std::uint64_t now, const std::uint32_t* fill);
    template <bool plain> void clock_tri(const Moves& m, std::uint64_t now);
    template <bool plain> void clock_surf_cache(const Moves& m, std::uint64_t now, const std::uint32_t* fill);
    void clock_stream(const Moves& m, std::uint64_t now, const std::uint32_t* fill);
    void clock_tex(const Moves& m, std::uint64_t now, const std::uint32_t* fill);
    template <RayFeed feed, bool levels, bool plain>
    void clock_shade(const Moves& m, std::uint64_t now, std::size_t c);

    RayFeed feed_;
    bool has_instances_;
    bool is_list_;                       // no nodes
    NodeUnit upper_, lower_;             // of the scene's tree, and of meshes; equal with one engine
    std::uint32_t first_ray_line_ = 0;   // line of the stream's first record
    int pixel_bits_;
    std::uint32_t first_mesh_line_ = ~0u;   // first line whose nodes lower_ decides
    bool box_is_low_;   // with two engines: lower_ is the unit box, which accepts a node every few cycles
    const Trace* trace_ = nullptr;
    Sched sched_;
    Pipe<RayNumber> raygen_;
    // Cycles after a ray in which raygen begins no other ray, and how many of them are left.
    std::uint32_t raygen_hold_, raygen_hold_left_ = 0;
    Trav trav_;
    Cache node_cache_;
    Delay node_unit_;
    std::uint64_t node_answer_delay_;              // cycles from an answer to its arrival at trav
    std::uint32_t box_hold_, box_hold_left_ = 0;   // the same of the unit box, after a node
    Delay xform_;
    std::uint32_t xform_hold_, xform_hold_left_ = 0;   // the same of xform, after a ray
    List list_;
    Cache prim_cache_;
    Delay tri_;
    std::uint64_t tri_answer_delay_;               // cycles from an answer to its arrival at list
    std::uint32_t tri_hold_, tri_hold_left_ = 0;   // the same of tri, after a primitive
    Cache surf_or_stream_cache_;
    Shade shade_;
    Tex tex_;
    Cache tex_cache_;
    std::vector<bool> reads_texels_;   // [ray]: tex_cache's next answer for it holds texels
    Merge raygen_link_;
    Sink sink_;
    std::vector<TraceCursor> rays_;

    /// A chip that is not fast, with a tree, few contexts, no disturbance, and units that accept a ray in
    /// every cycle.
    bool is_plain_;
    /// A plain chip is between windows: the answers of prim_cache are already in tri_, and with one level
    /// those of node_cache in node_unit_.
    bool in_windows_ = false;
    std::uint64_t window_;   // most cycles in which the sides run alone
    // Signals from an earlier to a later side, by cycle of the window: rays that leave list's tests, the
    // transfers on the link ray, and rays that leave trav (the link closest, or hit).
    std::array<LinkRay, max_window> tested_{}, started_{}, left_{};

    Moves moves_{};   // of the settled cycle
    CacheOutcome node_outcome_{}, prim_outcome_{}, surf_or_stream_outcome_{CacheOutcome::starved},
        tex_outcome_{CacheOutcome::starved};
    bool asleep_ = false;

    // Cycles by the units' codes. A cache's outcome has cause_bits; the code of shade or tex follows it.
    bool looked_up_ = false;
    std::uint32_t last_prim_side_ = 0, last_node_side_ = 0, last_ray_side_ = 0, last_surf_or_stream_ = 0;
    std::array<std::uint64_t, 1 << (cause_bits + 2 * UnitCodes::code_bits)> prim_side_{}, node_side_{};
    std::array<std::uint64_t, 1 << 2 * UnitCodes::code_bits> ray_side_{};
    static constexpr int outcome_and_code_bits = cause_bits + UnitCodes::code_bits;
    std::array<std::uint64_t, 1 << outcome_and_code_bits> surf_or_stream_cycles_{};   // surf_cache or stream,
                                                                                      // then shade
    std::uint32_t last_tex_ = 0;
    std::array<std::uint64_t, 1 << outcome_and_code_bits> tex_cycles_{};   // tex_cache, then tex
    std::uint32_t last_xform_ = 0;
    std::array<std::uint64_t, 3> xforms_{};
    std::uint32_t last_lower_ = 0;
    std::array<std::uint64_t, 4> lowers_{};   // of the lower engine's unit
};

template <class LookUp> void Pipeline::replay_reads(const std::uint32_t* at, LookUp&& look_up) {
    for (;;) {
        for (VisitWord visit; !visit.ends_ray();) {
            visit = {*at++};
            if (!is_list_) look_up(node_cache_, visit.line());
            if (!visit.has_tests()) continue;
            do look_up(prim_cache_, TestWord{*at}.half_line() >> 1);
            while (!TestWord{*at++}.is_last());
        }
        if (!is_shaded(feed_)) return;
        while (EndWord{*at}.is_place()) look_up(surf_or_stream_cache_, EndWord{*at++}.line());
        if (EndWord{*at}.is_record()) {
            look_up(tex_cache_, EndWord{*at++}.line());
            look_up(tex_cache_, EndWord{*at++}.line());
        }
        const EndWord surface{*at};
        if (surface.has_line()) look_up(surf_or_stream_cache_, surface.line());
        if (surface.ends_pixel()) return;
        at += 2;
    }
}

}   // namespace rayclock

#include "model/machine/pipeline.inl"
