#pragma once
#include <string>

#include "model/core/links.hpp"
#include "model/list/list.hpp"
#include "model/mem/cache.hpp"
#include "model/mem/memport.hpp"
#include "model/sched/sched.hpp"
#include "model/shade/unit.hpp"
#include "model/trace/trace.hpp"
#include "model/bvh/trav.hpp"

namespace rayclock {

/// What a pipeline gets from what all share, in one cycle: a tile, the ids of words that memory sends to its
/// caches (null if none), and whether the caches' own requests are accepted.
struct SharedMoves {
    const Tile* tile = nullptr;
    const std::uint32_t *node_fill = nullptr, *prim_fill = nullptr, *surf_fill = nullptr;
    bool node_miss = false, prim_miss = false, surf_miss = false;
    bool any() const {
        return tile || node_fill || prim_fill || surf_fill || node_miss || prim_miss || surf_miss;
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

    std::uint32_t valid_mask(const SharedMoves& shared, std::uint64_t now) const;
    std::uint32_t fire_mask(const SharedMoves& shared) const;
    bool tile_ready() const { return sched_.tile_ready(); }
    bool node_miss_valid() const { return node_cache_.miss_valid(); }
    bool prim_miss_valid() const { return prim_cache_.miss_valid(); }
    Cache::Miss node_miss() const { return node_cache_.miss(); }
    Cache::Miss prim_miss() const { return prim_cache_.miss(); }
    bool surf_miss_valid() const { return shading_ && surf_cache_.miss_valid(); }
    Cache::Miss surf_miss() const { return surf_cache_.miss(); }
    std::uint32_t ray_on(Link c) const;   ///< of links that carry one and move
    Slot slot() const { return sched_.slot(); }
    const Slot& pixel(std::uint32_t ray) const { return sched_.pixel(ray); }
    std::uint32_t node_addr(std::uint32_t ray) const { return rays_[ray].head & Trace::node_mask; }
    std::uint32_t prim_addr(std::uint32_t ray) const { return *rays_[ray].at & Trace::prim_mask; }
    std::uint32_t surf_addr(std::uint32_t ray) const { return *rays_[ray].at & Trace::node_mask; }

    // ---- For idle times.

    /// In the last cycle nothing moved and nothing changed: the next will be the same until `wakes()`.
    bool slept() const { return asleep_; }
    std::uint64_t wakes() const;
    void skip(std::uint64_t cycles) {
        units_[last_units_] += cycles;
        caches_[last_caches_] += cycles;
        if (shading_) shades_[last_shades_] += cycles;
    }

    Accounts accounts() const;
    std::string where(std::uint32_t ray) const;   ///< the queue or unit that holds a ray, for people

private:
    /// Where a context's ray is in the trace.
    struct Place {
        const std::uint32_t* at = nullptr;   ///< word of the visit, or of the triangle under way; the first
                                             ///< after a ray
        std::uint32_t head = 0;   ///< the visit's word; turns count down. After a ray the passes left
    };
    /// Links inside that move in a cycle, and what is on them: rays, but for a slot and requests to the
    /// caches.
    struct Moves {
        bool slot, ray, node_req, box_req, box_rsp, leaves, prim_req, tri_req, tri_rsp, tested, hit;
        bool offered;                              // by list to trav: `tested`, if it is taken
        bool step;                                 // inside trav, of a ray that was tested or has no leaves
        bool closest, surf_req, surf_rsp, spawn;   // of a chip that shades
        Slot given;
        Cache::Request node_out, prim_out, surf_out;
        std::uint32_t started, node_in, boxed, prim_in, answered, returned, ended, closed, surf_in, spawned;
        bool any() const {
            return slot | ray | node_req | box_req | box_rsp | prim_req | tri_req | tri_rsp | step | hit |
                   closest | surf_req | surf_rsp | spawn;
        }
    };
    Moves moving(std::uint64_t now);
    void clock(const Moves& m, std::uint64_t now, const SharedMoves& shared);
    Turn::Kind decide(std::uint32_t ray);
    bool has_tests(std::uint32_t ray) const { return rays_[ray].head & Trace::tests_flag; }
    bool has_more(std::uint32_t ray);
    void moving_shaded(Moves& m, std::uint64_t now);
    Shade::Turn turn_of(std::uint32_t ray);
    void account_units(const Moves& m, std::uint64_t now);
    void account_caches() {
        last_caches_ = std::uint32_t(node_deed_) | std::uint32_t(prim_deed_) << 3;
        ++caches_[last_caches_];
    }
    void clock_sched(const Moves& m, const Tile* tile);
    void clock_raygen(const Moves& m, std::uint64_t now);
    void clock_trav(const Moves& m);
    void clock_node_cache(const Moves& m, std::uint64_t now, const SharedMoves& shared);
    void clock_box(const Moves& m, std::uint64_t now);
    void clock_list(const Moves& m);
    void clock_prim_cache(const Moves& m, std::uint64_t now, const SharedMoves& shared);
    void clock_tri(const Moves& m, std::uint64_t now);
    void clock_surf_cache(const Moves& m, std::uint64_t now, const SharedMoves& shared);
    void clock_shade(const Moves& m, std::uint64_t now);
    std::uint32_t shaded_valid(const SharedMoves& shared, std::uint64_t now) const;

    bool shading_;
    const Trace* trace_ = nullptr;
    Sched sched_;
    Pipe<RayNumber> raygen_;
    Trav trav_;
    Cache node_cache_;
    Pipe<RayNumber> box_;
    List list_;
    Cache prim_cache_;
    Pipe<RayNumber> tri_;
    Cache surf_cache_;
    Shade shade_;
    Merge raygen_link_;
    std::uint32_t shade_code_ = 2;
    Sink sink_;
    std::vector<Place> rays_;

    Moves moves_{};   // of the cycle that was settled
    CacheDeed node_deed_{}, prim_deed_{}, surf_deed_{CacheDeed::starved};
    bool asleep_ = false;

    // Cycles by the units' codes, several units to an index; see account_units().
    std::uint32_t last_units_ = 0, last_caches_ = 0, last_shades_ = 0;
    std::array<std::uint64_t, 1 << 11> units_{};
    std::array<std::uint64_t, 1 << 6> caches_{};
    std::array<std::uint64_t, 1 << 5> shades_{};   // surf_cache, shade
};

[[gnu::always_inline]] inline Pipeline::Moves Pipeline::moving(std::uint64_t now) {
    // What leaves one unit enters another: noted before either sees the clock edge.
    Moves m;
    m.closest = m.surf_req = m.surf_rsp = m.spawn = false;
    if ((m.slot = sched_.slot_valid() && raygen_.ready())) m.given = sched_.slot();
    if ((m.ray = raygen_.valid(now) && trav_.ray_ready())) m.started = raygen_.front();
    if ((m.node_req = trav_.node_valid() && node_cache_.ready())) {
        const std::uint32_t ray = trav_.node_ray();
        m.node_out = {ray, node_addr(ray)};
    }
    if ((m.box_req = node_cache_.valid(now) && box_.ready())) m.node_in = node_cache_.answer();
    if ((m.box_rsp = box_.valid(now))) m.boxed = box_.front();
    m.leaves = m.box_rsp && has_tests(m.boxed);
    if ((m.prim_req = list_.prim_valid() && prim_cache_.ready())) {
        const std::uint32_t ray = list_.prim_ray();
        m.prim_out = {ray, prim_addr(ray) >> 1};
    }
    if ((m.tri_req = prim_cache_.valid(now) && tri_.ready())) m.prim_in = prim_cache_.answer();
    if ((m.tri_rsp = tri_.valid(now))) m.answered = tri_.front();
    if ((m.offered = list_.tested_valid())) m.returned = list_.tested_ray();
    m.tested = m.offered && trav_.tested_ready(m.offered);
    m.step = trav_.step_valid(m.offered) && trav_.step_ready();
    if (shading_) [[unlikely]]
        moving_shaded(m, now);
    else if ((m.hit = trav_.done_valid() && sink_.ready()))
        m.ended = trav_.done_ray();
    account_units(m, now);
    return m;
}

inline void Pipeline::account_units(const Moves& m, std::uint64_t now) {
    // Codes of units.hpp: 0 where a link moves; a refused offer and an idle link have their own.
    const std::uint32_t sched = m.slot ? 0 : sched_.slot_valid() ? 3 : sched_.pixel_valid() ? 1 : 2;
    const std::uint32_t raygen = m.ray ? 0 : raygen_.valid(now) ? 2 : 1;
    const std::uint32_t trav = m.step                        ? 0
                               : trav_.step_valid(m.offered) ? 2
                                                             : trav_.step_ready();   // a ray that goes round
                                                                                     // is work, if no step
                                                                                     // waits
    const std::uint32_t box = m.box_req ? 0 : node_cache_.valid(now) ? 3 : node_cache_.waits() ? 1 : 2;
    const std::uint32_t list = !(m.leaves | m.tri_rsp);
    const std::uint32_t tri = m.tri_req ? 0 : prim_cache_.valid(now) ? 3 : prim_cache_.waits() ? 1 : 2;
    last_units_ = sched | raygen << 2 | trav << 4 | box << 6 | list << 8 | tri << 9;
    ++units_[last_units_];
}

inline Turn::Kind Pipeline::decide(std::uint32_t ray) {
    Place& place = rays_[ray];
    if (place.head >> Trace::turns_shift) {
        place.head -= 1u << Trace::turns_shift;
        return Turn::Kind::again;
    }
    if (place.head & Trace::end_flag) return Turn::Kind::done;
    place.head = *++place.at;
    return Turn::Kind::visit;
}

inline bool Pipeline::has_more(std::uint32_t ray) {
    Place& place = rays_[ray];
    const bool more = !(*place.at & Trace::last_flag);
    place.at += more;
    return more;
}

inline void Pipeline::clock_sched(const Moves& m, const Tile* tile) {
    if (m.slot) {
        Place& place = rays_[m.given.ray];
        place.at = ray_at(*trace_, m.given.x, m.given.y);
        place.head = *place.at;
    }
    if (shading_) [[unlikely]] {
        const bool slot = raygen_link_.second(shade_.spawn_valid());
        raygen_link_.clock(shade_.spawn_valid() || sched_.slot_valid(), m.slot || m.spawn, slot);
    }
    sched_.clock(m.slot, tile, m.hit ? &m.ended : nullptr);
    sink_.clock();
}

inline void Pipeline::clock_raygen(const Moves& m, std::uint64_t now) {
    if (m.ray) raygen_.leave();
    if (m.slot) raygen_.admit(now) = RayNumber(m.given.ray);
    if (m.spawn) raygen_.admit(now) = RayNumber(m.spawned);
}

inline void Pipeline::clock_trav(const Moves& m) {
    trav_.clock({m.ray ? &m.started : nullptr, m.box_rsp && !m.leaves ? &m.boxed : nullptr,
                 m.offered ? &m.returned : nullptr, m.node_req, shading_ ? m.closest : m.hit},
                [this](std::uint32_t ray) { return decide(ray); });
}

inline void Pipeline::clock_node_cache(const Moves& m, std::uint64_t now, const SharedMoves& shared) {
    node_deed_ = node_cache_.clock(now, m.node_req ? &m.node_out : nullptr, m.box_req, shared.node_fill,
                                   shared.node_miss);
}

inline void Pipeline::clock_box(const Moves& m, std::uint64_t now) {
    if (m.box_rsp) box_.leave();
    if (m.box_req) box_.admit(now) = RayNumber(m.node_in);
}

inline void Pipeline::clock_list(const Moves& m) {
    if (m.leaves) ++rays_[m.boxed].at;   // to the first triangle
    list_.clock(m.leaves ? &m.boxed : nullptr, m.tri_rsp ? &m.answered : nullptr,
                m.tri_rsp && has_more(m.answered), m.prim_req, m.tested);
}

inline void Pipeline::clock_prim_cache(const Moves& m, std::uint64_t now, const SharedMoves& shared) {
    prim_deed_ = prim_cache_.clock(now, m.prim_req ? &m.prim_out : nullptr, m.tri_req, shared.prim_fill,
                                   shared.prim_miss);
}

inline void Pipeline::clock_tri(const Moves& m, std::uint64_t now) {
    if (m.tri_rsp) tri_.leave();
    if (m.tri_req) tri_.admit(now) = RayNumber(m.prim_in);
}

[[gnu::always_inline]] inline void Pipeline::clock(const Moves& m, std::uint64_t now,
                                                   const SharedMoves& shared) {
    const bool turning = !trav_.idle() || sched_.passing();
    clock_sched(m, shared.tile);
    clock_raygen(m, now);
    clock_trav(m);
    clock_node_cache(m, now, shared);
    clock_box(m, now);
    clock_list(m);
    clock_prim_cache(m, now, shared);
    clock_tri(m, now);
    account_caches();
    asleep_ = node_deed_ > CacheDeed::drain && prim_deed_ > CacheDeed::drain && !turning && !m.any() &&
              !shared.any();
    if (shading_) [[unlikely]] {
        asleep_ = asleep_ && !shade_.answers(now) && !shade_.offers(false);
        clock_surf_cache(m, now, shared);
        clock_shade(m, now);
        asleep_ = asleep_ && surf_deed_ > CacheDeed::drain;
    }
}

inline bool Pipeline::step(std::uint64_t now, const SharedMoves& shared) {
    const Moves moves = moving(now);   // by value, so that it lives in registers
    clock(moves, now, shared);
    return moves.hit;
}

}   // namespace rayclock
