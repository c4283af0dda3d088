#pragma once
// A cycle of a pipeline: all links are settled, then every unit gets its clock edge.
#include "model/machine/pipeline.hpp"

namespace rayclock {

// Nearly without branches: see ring.hpp. When a link is idle, its ray number is that of an arbitrary context.
// A transfer leaves one unit and enters another, so it is recorded before either gets its clock edge.

/// Settles the link leaves, from a node unit's answer that arrives at trav. Both sides of the link need it.
template <bool plain>
[[gnu::always_inline]] inline void Pipeline::settle_leaves(Moves& m, std::uint64_t now) const {
    m.node_answer = node_unit_.answer(plain ? now : now - node_answer_delay_);
    if (!plain && is_list_)
        m.node_answer = {trav_.node_valid(), trav_.node_ray()};   // a page needs no memory
    m.offer(Link::leaves, m.node_answer.valid & has_tests(m.node_answer.ray), true, m.node_answer.ray);
}

template <bool plain>
[[gnu::always_inline]] inline void Pipeline::settle_prim_side(Moves& m, std::uint64_t now, std::size_t c) {
    const LinkRay from_tri = tri_.answer(now);
    m.tri_answer = plain ? from_tri : tri_.answer(now - tri_answer_delay_);
    m.another = !TestWord{*rays_[m.tri_answer.ray].at}.is_last();
    tested_[c] = {bool(m.tri_answer.valid & !m.another), m.tri_answer.ray};
    settle_leaves<plain>(m, now);
    m.offer(Link::prim_req, list_.prim_valid(), prim_cache_.ready<plain>(), list_.prim_ray<plain>());
    if constexpr (plain)
        m.offer(Link::tri_req, tri_.admitted(now).valid, true, 0);   // the ray is already in tri_
    else
        m.offer(Link::tri_req, prim_cache_.valid(), tri_.ready() & !is_held<plain>(tri_hold_left_),
                prim_cache_.answer());
    m.offer(Link::tri_rsp, from_tri.valid, true, from_tri.ray);
}

/// Settles the links of xform. `read`: the ray whose node was read; `enters`: the node is an instance.
template <bool plain> [[gnu::always_inline]] inline void Pipeline::settle_xform(Moves& m, std::uint64_t now,
                                                                                std::uint32_t read,
                                                                                bool enters) const {
    m.lower_code = node_unit_code<plain>(m, true);
    const LinkRay changed = xform_.answer(now);
    m.offer(Link::xform_req, node_cache_.valid<plain>() & enters, xform_hold_left_ == 0, read);
    m.offer(Link::change, changed.valid, true, changed.ray);
    m.read = m.read | m[Link::xform_req].fires;
    m.xform_code = (m[Link::xform_req].valid | (xform_hold_left_ > 0)) ? busy_code
                   : node_cache_.has_misses_in_flight() ? cause_code(Unit::xform, starved("memory"))
                                                        : cause_code(Unit::xform, starved("trav"));
}

template <Pipeline::RayFeed feed, bool levels, bool plain>
[[gnu::always_inline]] inline void Pipeline::settle_node_side(Moves& m, std::uint64_t now, std::size_t c) {
    m.offer(Link::ray, raygen_.valid(now), trav_.ray_ready(), raygen_.front());
    started_[c] = m[Link::ray];
    m.offer(Link::node_req, trav_.node_valid<levels>() & (plain || !is_list_), node_cache_.ready<plain>(),
            trav_.node_ray<levels, plain>());
    if constexpr (plain && !levels) {
        m.offer(node_unit_req, node_unit_.admitted(now).valid, true, 0);   // the ray is already in node_unit_
    } else {
        const std::uint32_t read = node_cache_.answer();
        const bool enters = levels && VisitWord{rays_[read].head}.is_entry();
        m.lower_request = levels && is_low(read);
        m.offer(node_unit_req, node_cache_.valid<plain>() & !enters,
                node_unit_.ready() & (!is_held<plain>(box_hold_left_) | (m.lower_request != box_is_low_)),
                read);
        m.read = m[node_unit_req].fires;
        if constexpr (levels) settle_xform<plain>(m, now, read, enters);
    }
    const LinkRay from_node_unit = node_unit_.answer(now);
    m.lower_answer = levels && is_low(from_node_unit.ray);
    m.offer(node_unit_rsp, from_node_unit.valid, true, from_node_unit.ray);
    settle_leaves<plain>(m, now);
    const bool tested = list_.tested_valid();
    m.offer(Link::tested, tested, trav_.tested_ready(tested), list_.tested_ray<plain>());
    m.step = trav_.step_valid(tested) & trav_.step_ready();
    constexpr Link left = is_shaded(feed) ? Link::closest : Link::hit;
    m.offer(left, trav_.done_valid(), is_shaded(feed) || sink_.ready(), trav_.done_ray<plain>());
    left_[c] = m[left];
}

template <Pipeline::RayFeed feed, bool levels, bool plain>
[[gnu::always_inline]] inline void Pipeline::settle_ray_side(Moves& m, std::uint64_t now) const {
    constexpr bool shades = is_shaded(feed), streams = feed == RayFeed::stream;
    const bool camera = !shades || raygen_link_.second(shade_.spawn_valid());
    const bool begins = raygen_.ready() & !is_held<plain>(raygen_hold_left_);
    m.offer(Link::slot, sched_.slot_valid(), streams ? surf_or_stream_cache_.ready<plain>() : begins & camera,
            sched_.slot<plain>().ray);
    if constexpr (streams) {
        m.record = record_addr(sched_.slot());
        m.offer(Link::record, surf_or_stream_cache_.valid<plain>(), begins, surf_or_stream_cache_.answer());
    }
    if constexpr (shades) {
        m.offer(Link::hit, shade_.pixel_valid(), sink_.ready(), shade_.pixel_ray<plain>());
        m.offer(Link::surf_req, shade_.surf_valid<levels>(), surf_or_stream_cache_.ready<plain>(),
                shade_.surf_ray<levels, plain>());
        const std::uint32_t came = surf_or_stream_cache_.answer();
        m.placing = levels && EndWord{*rays_[came].at}.is_place();
        m.offer(Link::surf_rsp, surf_or_stream_cache_.valid<plain>(), shade_.ready() | m.placing, came);
        m.offer(Link::spawn, shade_.spawn_valid(), begins & !camera, shade_.spawn_ray<plain>());
        m.shade_code = shade_.code(surf_or_stream_cache_.valid<plain>() & !m.placing,
                                   surf_or_stream_cache_.has_misses_in_flight());
        if constexpr (feed == RayFeed::textured) settle_tex(m, now);
    }
}

template <Pipeline::RayFeed feed, bool levels>
[[gnu::always_inline]] inline void Pipeline::settle(Moves& m, std::uint64_t now) {
    settle_prim_side<false>(m, now, 0);
    settle_node_side<feed, levels, false>(m, now, 0);
    settle_ray_side<feed, levels, false>(m, now);
}

inline void Pipeline::settle_tex(Moves& m, std::uint64_t now) const {
    const bool texels = tex_.requests_texels(), ready = tex_cache_.ready();
    m.offer(Link::tex_req, shade_.texture_valid(), ready & !texels, shade_.texture_ray());
    m.offer(Link::texel_req, shade_.texture_valid() | tex_.texels_wait(), ready,
            select(texels, tex_.texel_ray(), shade_.texture_ray()));
    m.offer(Link::texel_rsp, tex_cache_.valid(), true, tex_cache_.answer());
    const LinkRay filtered = tex_.answer(now);
    m.offer(Link::tex_rsp, filtered.valid, true, filtered.ray);
    m.tex_code = m[Link::texel_rsp].valid            ? busy_code
                 : tex_cache_.has_misses_in_flight() ? cause_code(Unit::tex, starved("memory"))
                                                     : cause_code(Unit::tex, starved("shade"));
}

template <bool plain>
[[gnu::always_inline]] inline std::uint32_t Pipeline::prim_side_codes(const Moves& m) const {
    const LinkInside& req = m[Link::tri_req];
    UnitCodes codes;
    codes.first = (m[Link::leaves].fires | m[Link::tri_rsp].fires) ? busy_code : list_starved;
    codes.second =
        is_held<plain>(tri_hold_left_)
            ? busy_code
            : tri_codes[std::size_t(req.valid + req.fires + 3 * prim_cache_.has_misses_in_flight())];
    return codes.packed();
}

template <bool plain>
[[gnu::always_inline]] inline std::uint32_t Pipeline::node_side_codes(const Moves& m) const {
    const std::size_t turn = trav_.step_valid(m[Link::tested].valid), free = trav_.step_ready();
    return UnitCodes{trav_codes[turn + 2 * free], node_unit_code<plain>(m, false)}.packed();
}

template <Pipeline::RayFeed feed, bool plain>
[[gnu::always_inline]] inline std::uint32_t Pipeline::ray_side_codes(const Moves& m) const {
    constexpr bool shades = is_shaded(feed);
    constexpr Link first = feed == RayFeed::stream ? Link::record : Link::slot;
    const bool asked = m[first].valid | (shades && m[Link::spawn].valid),
               begun = m[first].fires | (shades && m[Link::spawn].fires);
    UnitCodes codes;
    codes.first = sched_codes[std::size_t(sched_.pixel_valid() + m[Link::slot].valid + m[Link::slot].fires)];
    codes.second = is_held<plain>(raygen_hold_left_) ? busy_code : raygen_codes[std::size_t(asked + begun)];
    return codes.packed();
}

inline Decision::Flags Pipeline::decide(std::uint32_t ray, bool valid) {
    TraceCursor& cursor = rays_[ray];
    const VisitWord head{cursor.head};
    const bool again = head.dropped() > 0, done = !again & head.ends_ray();
    const bool visit = valid & !again & !done;
    const std::uint32_t turns = std::uint32_t(valid & again) << VisitWord::dropped_shift;
    cursor.at += visit;
    const std::uint32_t next = *cursor.at;
    cursor.head = select(visit, next, cursor.head - turns);
    return {visit, bool(valid & again), bool(valid & done)};
}

/// Moves a changed ray to the visit of its mesh's root.
inline void Pipeline::enter(const LinkInside& change) {
    TraceCursor& cursor = rays_[change.ray];
    cursor.at += change.fires;
    if (change.fires) cursor.head = *cursor.at;
}

template <Pipeline::RayFeed feed, bool plain>
[[gnu::always_inline]] inline void Pipeline::clock_sched(const Moves& m, std::size_t c, const Tile* tile) {
    const bool slot = m[Link::slot].fires;
    if (slot) {
        const Slot given = sched_.slot<plain>();
        TraceCursor& cursor = rays_[given.ray];
        cursor.at = ray_at(*trace_, given.x, given.y);
        cursor.head = *cursor.at;
    }
    if constexpr (is_shaded(feed)) {
        const bool second = raygen_link_.second(shade_.spawn_valid());
        raygen_link_.clock(shade_.spawn_valid() | sched_.slot_valid(), slot | m[Link::spawn].fires, second);
    }
    sched_.clock<plain>(slot, tile, is_shaded(feed) ? LinkRay(m[Link::hit]) : left_[c]);
    if constexpr (!plain) sink_.clock();
}

template <Pipeline::RayFeed feed, bool plain>
[[gnu::always_inline]] inline void Pipeline::clock_raygen(const Moves& m, std::uint64_t now, std::size_t c) {
    LinkRay in = m[feed == RayFeed::stream ? Link::record : Link::slot];
    if constexpr (is_shaded(feed)) {
        const LinkInside& spawn = m[Link::spawn];
        in = {bool(in.valid | spawn.fires), select(spawn.fires, spawn.ray, in.ray)};
    }
    raygen_.admit(now, started_[c].valid, in.valid, RayNumber(in.ray));
    if constexpr (!plain)
        raygen_hold_left_ = select(in.valid, raygen_hold_, raygen_hold_left_ - (raygen_hold_left_ > 0));
}

template <Pipeline::RayFeed feed, bool levels, bool plain>
[[gnu::always_inline]] inline void Pipeline::clock_trav(const Moves& m) {
    const LinkInside& tested = m[Link::tested];
    if constexpr (levels) enter(m[Link::change]);
    trav_.clock<levels, plain>({m[Link::ray],
                                {bool(m.node_answer.valid & !m[Link::leaves].fires), m.node_answer.ray},
                                {tested.valid, tested.ray},
                                !plain && is_list_ ? m.node_answer.valid : m[Link::node_req].fires,
                                m[is_shaded(feed) ? Link::closest : Link::hit].fires,
                                levels ? LinkRay(m[Link::change]) : LinkRay{}},
                               [this](std::uint32_t ray, bool valid) { return decide(ray, valid); });
}

template <bool unqueued, bool plain>
[[gnu::always_inline]] inline CacheOutcome Pipeline::clock_cache(Cache& cache, const LinkInside& request,
                                                                 std::uint32_t line, bool read, Delay& unit,
                                                                 std::uint64_t now,
                                                                 const std::uint32_t* fill) {
    if constexpr (!unqueued) return cache.clock<plain>(request.fires, {request.ray, line}, read, fill, now);
    const Cache::LookUp made = cache.clock_unqueued(request.fires, {request.ray, line}, now);
    unit.admit(now + 2, made.answer);
    return made.outcome;
}

template <bool levels, bool plain>
[[gnu::always_inline]] inline void Pipeline::clock_node_cache(const Moves& m, std::uint64_t now,
                                                              const std::uint32_t* fill) {
    const LinkInside& req = m[Link::node_req];
    constexpr bool unqueued = plain && !levels;
    node_outcome_ =
        clock_cache<unqueued, plain>(node_cache_, req, node_addr(req.ray), m.read, node_unit_, now, fill);
}

template <bool levels, bool plain>
[[gnu::always_inline]] inline void Pipeline::clock_node_unit(const Moves& m, std::uint64_t now) {
    if constexpr (plain && !levels) return;
    node_unit_.clock(now, m[node_unit_req]);
    if constexpr (plain) return;
    box_hold_left_ = select(m[node_unit_req].fires & (m.lower_request == box_is_low_), box_hold_,
                            box_hold_left_ - (box_hold_left_ > 0));
}

template <bool plain> [[gnu::always_inline]] inline void Pipeline::clock_list(const Moves& m) {
    const LinkInside& leaves = m[Link::leaves];
    rays_[leaves.ray].at += leaves.fires;   // to the first triangle
    const LinkRay next{bool(m.tri_answer.valid & m.another), m.tri_answer.ray};
    rays_[next.ray].at += next.valid;
    list_.clock_prims<plain>(leaves, next, m[Link::prim_req].fires);
}

template <bool plain>
[[gnu::always_inline]] inline void Pipeline::clock_prim_cache(const Moves& m, std::uint64_t now,
                                                              const std::uint32_t* fill) {
    const LinkInside& req = m[Link::prim_req];
    prim_outcome_ = clock_cache<plain, plain>(prim_cache_, req, prim_addr(req.ray) >> 1,
                                              m[Link::tri_req].fires, tri_, now, fill);
}

template <bool plain>
[[gnu::always_inline]] inline void Pipeline::clock_tri(const Moves& m, std::uint64_t now) {
    if constexpr (plain) return;
    tri_.clock(now, m[Link::tri_req]);
    tri_hold_left_ = select(m[Link::tri_req].fires, tri_hold_, tri_hold_left_ - (tri_hold_left_ > 0));
}

[[gnu::always_inline]] inline void Pipeline::clock_xform(const Moves& m, std::uint64_t now) {
    const LinkInside& req = m[Link::xform_req];
    last_xform_ = m.xform_code;
    ++xforms_[last_xform_];
    last_lower_ = m.lower_code;
    ++lowers_[last_lower_];
    xform_.clock(now, req);
    xform_hold_left_ = select(req.fires, xform_hold_, xform_hold_left_ - (xform_hold_left_ > 0));
}

template <bool plain>
[[gnu::always_inline]] inline void Pipeline::clock_surf_cache(const Moves& m, std::uint64_t now,
                                                              const std::uint32_t* fill) {
    const LinkInside& req = m[Link::surf_req];
    surf_or_stream_outcome_ = surf_or_stream_cache_.clock<plain>(req.fires, {req.ray, surf_addr(req.ray)},
                                                                 m[Link::surf_rsp].fires, fill, now);
    last_surf_or_stream_ = std::uint32_t(surf_or_stream_outcome_) | m.shade_code << cause_bits;
    ++surf_or_stream_cycles_[last_surf_or_stream_];
}

template <bool plain>
[[gnu::always_inline]] inline void Pipeline::clock_prim_side(const Moves& m, std::uint64_t now,
                                                             const std::uint32_t* fill) {
    const std::uint32_t codes = prim_side_codes<plain>(m);
    clock_list<plain>(m);
    clock_prim_cache<plain>(m, now, fill);
    clock_tri<plain>(m, now);
    account_prim_side<plain>(codes);
}

template <Pipeline::RayFeed feed, bool levels, bool plain>
[[gnu::always_inline]] inline void Pipeline::clock_node_side(const Moves& m, std::uint64_t now, std::size_t c,
                                                             const std::uint32_t* fill) {
    const std::uint32_t codes = node_side_codes<plain>(m);
    raygen_.take(m[Link::ray].fires);
    list_.clock_tested<plain>(tested_[c], m[Link::tested].fires);
    clock_trav<feed, levels, plain>(m);
    if constexpr (levels) clock_xform(m, now);
    clock_node_cache<levels, plain>(m, now, fill);
    clock_node_unit<levels, plain>(m, now);
    account_node_side<plain>(codes);
}

template <Pipeline::RayFeed feed, bool levels, bool plain>
[[gnu::always_inline]] inline void Pipeline::clock_ray_side(const Moves& m, std::uint64_t now, std::size_t c,
                                                            const Tile* tile, const std::uint32_t* fill,
                                                            const std::uint32_t* tex_fill) {
    account_ray_side<plain>(ray_side_codes<feed, plain>(m));
    clock_sched<feed, plain>(m, c, tile);
    clock_raygen<feed, plain>(m, now, c);
    if constexpr (feed == RayFeed::stream) clock_stream(m, now, fill);
    if constexpr (is_shaded(feed)) {
        clock_surf_cache<plain>(m, now, fill);
        clock_shade<feed, levels, plain>(m, now, c);
        if constexpr (feed == RayFeed::textured) clock_tex(m, now, tex_fill);
    }
}

template <Pipeline::RayFeed feed, bool levels>
[[gnu::always_inline]] inline void Pipeline::clock(const Moves& m, std::uint64_t now,
                                                   const SharedMoves& shared) {
    bool still =
        !(!trav_.idle() | sched_.passing() | m.node_answer.valid | m.tri_answer.valid |
          (raygen_hold_left_ > 0) | (box_hold_left_ > 0) | (tri_hold_left_ > 0) | m.step | shared.any() |
          m.any(Link::slot, Link::ray, Link::node_req, node_unit_req, node_unit_rsp, Link::prim_req,
                Link::tri_req, Link::tri_rsp, Link::hit));
    if constexpr (levels) still = still & (xform_hold_left_ == 0) & !m.any(Link::xform_req, Link::change);
    if constexpr (feed == RayFeed::stream) still = still & !m.any(Link::record);
    if constexpr (is_shaded(feed))
        still = still & !shade_.answers(now) & !shade_.offers(false) & !shade_.is_occupied() &
                !shade_.comes() & !m.any(Link::closest, Link::surf_req, Link::surf_rsp, Link::spawn);
    if constexpr (feed == RayFeed::textured)
        still = still & tex_.is_idle(now) &
                !m.any(Link::tex_req, Link::texel_req, Link::texel_rsp, Link::tex_rsp);
    clock_prim_side<false>(m, now, shared.prim_fill);
    clock_node_side<feed, levels, false>(m, now, 0, shared.node_fill);
    clock_ray_side<feed, levels, false>(m, now, 0, shared.tile, shared.surf_or_stream_fill, shared.tex_fill);
    const auto rests = [](CacheOutcome outcome, const Cache& cache) {
        return (outcome > CacheOutcome::drain) & !cache.loaded();
    };
    asleep_ = still & rests(node_outcome_, node_cache_) & rests(prim_outcome_, prim_cache_);
    if constexpr (feed != RayFeed::camera)
        asleep_ = asleep_ & rests(surf_or_stream_outcome_, surf_or_stream_cache_);
    if constexpr (feed == RayFeed::textured) asleep_ = asleep_ & rests(tex_outcome_, tex_cache_);
}

template <Pipeline::RayFeed feed, bool levels>
inline bool Pipeline::step(std::uint64_t now, const SharedMoves& shared) {
    Moves m;   // a local instead of moves_, so that it stays in registers
    settle<feed, levels>(m, now);
    clock<feed, levels>(m, now, shared);
    return m[Link::hit].fires;
}

inline bool Pipeline::step(std::uint64_t now, const SharedMoves& shared) {
    return with_shape([&]<RayFeed feed, bool levels>() { return step<feed, levels>(now, shared); });
}

template <Pipeline::RayFeed feed, bool levels, bool plain>
inline std::uint32_t Pipeline::run(std::uint64_t now, std::uint64_t cycles,
                                   const std::array<Fills, 4>& fills) {
    looked_up_ = false;
    for (std::size_t c = 0; c < cycles; ++c) {
        Moves m;
        settle_prim_side<plain>(m, now + c, c);
        clock_prim_side<plain>(m, now + c, nullptr);
        if (const std::uint32_t* fill = fills[1].at(c)) [[unlikely]]
            prim_cache_.fill(*fill);
    }
    for (std::size_t c = 0; c < cycles; ++c) {
        Moves m;
        settle_node_side<feed, levels, plain>(m, now + c, c);
        clock_node_side<feed, levels, plain>(m, now + c, c, nullptr);
        if (const std::uint32_t* fill = fills[0].at(c)) [[unlikely]]
            node_cache_.fill(*fill);
    }
    std::uint32_t hits = 0;
    for (std::size_t c = 0; c < cycles; ++c) {
        Moves m;
        settle_ray_side<feed, levels, plain>(m, now + c);
        clock_ray_side<feed, levels, plain>(m, now + c, c, nullptr, fills[2].at(c), fills[3].at(c));
        hits += is_shaded(feed) ? m[Link::hit].fires : left_[c].valid;
    }
    return hits;
}

inline std::uint32_t Pipeline::run(std::uint64_t now, std::uint64_t cycles,
                                   const std::array<Fills, 4>& fills) {
    if (is_plain_ && !in_windows_) enter_windows(now);
    return with_shape([&]<RayFeed feed, bool levels>() {
        return is_plain_ ? run<feed, levels, true>(now, cycles, fills)
                         : run<feed, levels, false>(now, cycles, fills);
    });
}

}   // namespace rayclock
