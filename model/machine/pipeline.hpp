#pragma once
#include <string>

#include "model/core/links.hpp"
#include "model/unit/list/list.hpp"
#include "model/mem/cache.hpp"
#include "model/mem/memport.hpp"
#include "model/unit/sched/sched.hpp"
#include "model/unit/shade/unit.hpp"
#include "model/trace/trace.hpp"
#include "model/unit/trav/trav.hpp"

namespace rayclock {

/// What a pipeline gets from what all share, in one cycle: a tile, the ids of words that memory sends to its
/// caches (null if none), and whether the caches' own requests are accepted.
struct SharedMoves {
    const Tile* tile = nullptr;
    const std::uint32_t *node_fill = nullptr, *prim_fill = nullptr, *surf_fill = nullptr;
    bool node_miss = false, prim_miss = false, surf_miss = false;
    bool any() const {
        return (tile != nullptr) | (node_fill != nullptr) | (prim_fill != nullptr) | (surf_fill != nullptr) |
               node_miss | prim_miss | surf_miss;
    }
};

/// One pipeline, cycle by cycle: *when* its rays, whose doings are in a trace, move from unit to unit. Mirror
/// of rtl/rc_pipeline.sv.
class Pipeline {
public:
    Pipeline(const Config& config, Traffic traffic, int number);

    void start(const Frame& frame, const Trace& trace) {
        sched_.start(frame);
        trace_ = &trace;
        meshes_ = trace.meshes;
        rays_.assign(rays_.size(), {});   // no word of the last frame's trace is looked at again
    }

    /// Cycle `now`: what moves, from registered state, and the clock edge. True if a hit left.
    bool step(std::uint64_t now, const SharedMoves& shared);
    /// The two halves, for those who want to see the links in between.
    void settle(std::uint64_t now);
    void clock(std::uint64_t now, const SharedMoves& shared);
    /// The clock edge with the units in the given order (a permutation of 0..pipeline_units - 1), for the
    /// test that it does not matter.
    void clock_in_order(std::uint64_t now, const SharedMoves& shared,
                        const std::array<int, pipeline_units>& order);

    // ---- What is on the links, between settle() and clock().

    LinkMask valid_mask(const SharedMoves& shared) const;
    LinkMask fire_mask(const SharedMoves& shared) const;
    bool tile_ready() const { return sched_.tile_ready(); }
    bool node_miss_valid() const { return node_cache_.miss_valid(); }
    bool prim_miss_valid() const { return prim_cache_.miss_valid(); }
    Cache::Miss node_miss() const { return node_cache_.miss(); }
    Cache::Miss prim_miss() const { return prim_cache_.miss(); }
    bool surf_miss_valid() const { return shading_ & surf_cache_.miss_valid(); }
    Cache::Miss surf_miss() const { return surf_cache_.miss(); }
    /// Of links that carry one and move.
    std::uint32_t ray_on(Link link) const { return moves_[inside(link)].ray; }
    /// Something is to be moved between it and what all share; `more`: there are tiles left.
    bool asks(bool more) const {
        return node_cache_.miss_valid() | prim_cache_.miss_valid() | surf_miss_valid() |
               (tile_ready() & more);
    }
    Slot slot() const { return sched_.slot(); }
    const Slot& pixel(std::uint32_t ray) const { return sched_.pixel(ray); }
    std::uint32_t node_addr(std::uint32_t ray) const { return rays_[ray].head & Trace::node_mask; }
    std::uint32_t prim_addr(std::uint32_t ray) const { return *rays_[ray].at & Trace::prim_mask; }
    std::uint32_t surf_addr(std::uint32_t ray) const { return *rays_[ray].at & Trace::node_mask; }

    // ---- For those who watch it.

    /// What a cache did at the last clock edge.
    CacheDeed deed(Unit cache) const {
        return cache == Unit::node_cache ? node_deed_ : cache == Unit::prim_cache ? prim_deed_ : surf_deed_;
    }
    /// What the ray that is now spawned is for; while its transfer is seen.
    RayPurpose purpose(std::uint32_t ray) const {
        return RayPurpose(rays_[ray].at[-2] >> Trace::purpose_shift & 3);
    }

    // ---- For idle times.

    /// In the last cycle nothing moved and nothing changed: the next will be the same until `wakes()`.
    bool slept() const { return asleep_; }
    std::uint64_t wakes(std::uint64_t now) const;
    void skip(std::uint64_t cycles) {
        units_[last_units_] += cycles;
        caches_[last_caches_] += cycles;
        if (shading_) shades_[last_shades_] += cycles;
        if (levels_) xforms_[last_xform_] += cycles, lowers_[last_lower_] += cycles;
    }

    Accounts accounts() const;
    /// The queue or unit that holds a ray, for people.
    std::string where(std::uint32_t ray, std::uint64_t now) const;

private:
    /// Where a context's ray is in the trace.
    struct Place {
        /// Word of the visit, or of the triangle under way; the first after a ray.
        const std::uint32_t* at = nowhere;
        /// The visit's word; turns count down. After a ray the passes left.
        std::uint32_t head = 0;
    };
    static constexpr std::uint32_t nowhere[1] = {0};
    /// A link in a cycle: whether something is on it, whether it moves, and its ray, which is some context's
    /// also if nothing is there.
    struct LinkInside {
        bool valid, fires;
        std::uint32_t ray;
        operator OnLink() const { return {fires, ray}; }
    };
    /// All links inside in a cycle. Those to what the pipelines share are in SharedMoves.
    struct Moves {
        std::array<LinkInside, pipeline_links> links;
        OnLink boxed, tried;                        // box's and tri's answers as far as trav and list are
        bool step = false;                          // inside trav, of a ray that was tested or has no leaves
        bool read = false;                          // node_cache's answer is taken
        bool placing = false;                       // surf_cache's answer is an instance
        bool low_asks = false, low_tells = false;   // box's links are those of the lower engine's unit
        std::uint32_t shade_code = 0, xform_code = 0, lower_code = 0;   // of units.hpp
        const LinkInside& operator[](Link link) const { return links[index(link)]; }
        void offer(Link link, bool offered, bool ready, std::uint32_t ray) {
            links[index(link)] = {offered, bool(offered & ready), ray};
        }
        /// Whether one of them moves.
        template <class... Links> bool any(Links... some) const { return (links[index(some)].fires | ...); }
    };
    /// box's links are those of the unit that decides nodes, whichever it is. If there are two, one of them
    /// is asked in a cycle, and one answers, since the quicker one's answers wait as long as the other's.
    static constexpr Link inside(Link link) {
        return asks_of_node(link) ? Link::box_req : tells_of_node(link) ? Link::box_rsp : link;
    }
    /// And as they are called outside.
    Link outside(Link link) const {
        return link == Link::box_req   ? (moves_.low_asks ? lower_ : upper_).req
               : link == Link::box_rsp ? (moves_.low_tells ? lower_ : upper_).rsp
                                       : link;
    }
    /// Whether the lower engine walks the ray's node; false if there is one engine.
    bool is_low(std::uint32_t ray) const { return node_addr(ray) >= meshes_; }
    /// Of one engine, or the upper or lower of two.
    std::uint32_t decide_code(const Moves& m, bool low) const {
        const LinkInside& req = m[Link::box_req];
        const bool own = m.low_asks == low;
        if (box_rest_ > 0 && box_is_low_ == low) return 0;
        return test_codes[std::size_t((own & req.valid) + (own & req.fires) + 3 * node_cache_.waits())];
    }
    template <bool shades, bool levels> void settle(Moves& m, std::uint64_t now) const;
    template <bool shades, bool levels>
    void clock(const Moves& m, std::uint64_t now, const SharedMoves& shared);
    template <bool shades, bool levels> bool step(std::uint64_t now, const SharedMoves& shared);
    Turn::Flags decide(std::uint32_t ray, bool valid);
    bool has_tests(std::uint32_t ray) const { return rays_[ray].head & Trace::tests_flag; }
    void enter(const LinkInside& change);
    bool has_more(std::uint32_t ray, bool tested);
    Shade::Turn turn_of(std::uint32_t ray);
    template <bool shades> void account_units(const Moves& m);
    void account_caches() {
        last_caches_ = std::uint32_t(node_deed_) | std::uint32_t(prim_deed_) << 3;
        ++caches_[last_caches_];
    }
    template <bool shades> void clock_sched(const Moves& m, const Tile* tile);
    template <bool shades> void clock_raygen(const Moves& m, std::uint64_t now);
    template <bool shades, bool levels> void clock_trav(const Moves& m);
    void clock_node_cache(const Moves& m, const SharedMoves& shared);
    void clock_box(const Moves& m, std::uint64_t now);
    void clock_xform(const Moves& m, std::uint64_t now);
    void clock_list(const Moves& m);
    void clock_prim_cache(const Moves& m, const SharedMoves& shared);
    void clock_tri(const Moves& m, std::uint64_t now);
    void clock_surf_cache(const Moves& m, const SharedMoves& shared);
    template <bool levels> void clock_shade(const Moves& m, std::uint64_t now);

    bool shading_, levels_, lists_;   // levels_: there are instances; lists_: there are no nodes
    NodeUnit upper_, lower_;          // what decides nodes of the scene's tree, and of meshes
    std::uint32_t meshes_ = ~0u;      // line from which on lower_ does
    bool box_is_low_;                 // of two units lower_ takes a node every few cycles, not upper_
    const Trace* trace_ = nullptr;
    Sched sched_;
    Pipe<RayNumber> raygen_;
    std::uint32_t raygen_rests_, raygen_rest_ = 0;   // cycles after a ray in which raygen begins none; left
    Trav trav_;
    Cache node_cache_;
    Delay box_, boxed_;                        // boxed_, tried_: what trav and list look at in a fast chip
    std::uint32_t box_rests_, box_rest_ = 0;   // as raygen's, after a node
    Delay xform_;
    std::uint32_t xform_rests_, xform_rest_ = 0;   // as tri's
    List list_;
    Cache prim_cache_;
    Delay tri_, tried_;
    std::uint32_t tri_rests_, tri_rest_ = 0;   // likewise of tri, after a primitive
    bool late_;                                // there are boxed_ and tried_
    Cache surf_cache_;
    Shade shade_;
    Merge raygen_link_;
    Sink sink_;
    std::vector<Place> rays_;

    Moves moves_{};   // of the cycle that was settled
    CacheDeed node_deed_{}, prim_deed_{}, surf_deed_{CacheDeed::starved};
    bool asleep_ = false;

    // Codes of units.hpp, by how far the thing that the unit waits for has come: nothing is there, it is on
    // offer, it is accepted. Before that, sched's pixel must be there. For box and tri it matters as well
    // whether memory is asked for something (3 more). For trav it matters whether a step waits, and whether
    // no ray goes round (2 more), which is work, too.
    static constexpr std::array<std::uint8_t, 4> sched_codes{2, 1, 3, 0}, trav_codes{0, 2, 1, 0};
    static constexpr std::array<std::uint8_t, 3> raygen_codes{1, 2, 0};
    static constexpr std::array<std::uint8_t, 6> test_codes{2, 3, 0, 1, 3, 0};

    // Cycles by the units' codes, several units to an index; see account_units().
    std::uint32_t last_units_ = 0, last_caches_ = 0, last_shades_ = 0;
    std::array<std::uint64_t, 1 << 11> units_{};
    std::array<std::uint64_t, 1 << 6> caches_{};
    std::array<std::uint64_t, 1 << 5> shades_{};   // surf_cache, shade
    std::uint32_t last_xform_ = 0;
    std::array<std::uint64_t, 3> xforms_{};
    std::uint32_t last_lower_ = 0;
    std::array<std::uint64_t, 4> lowers_{};   // of the lower engine's unit
};

}   // namespace rayclock

#include "model/machine/pipeline.inl"
