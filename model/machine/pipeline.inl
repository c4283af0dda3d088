#pragma once
// A cycle of a pipeline: all links are settled, then every unit gets its clock edge.
#include "model/machine/pipeline.hpp"

namespace rayclock {

// Nearly without branches: see ring.hpp. When a link is idle, its ray number is that of an arbitrary context.
template <Pipeline::RayFeed feed, bool levels>
[[gnu::always_inline]] inline void Pipeline::settle(Moves& m, std::uint64_t now) const {
    constexpr bool shades = is_shaded(feed), streams = feed == RayFeed::stream;
    // A transfer leaves one unit and enters another, so it is recorded before either gets its clock edge.
    const bool camera = !shades || raygen_link_.second(shade_.spawn_valid());
    const bool begins = raygen_.ready() & (raygen_hold_left_ == 0);
    m.offer(Link::slot, sched_.slot_valid(), streams ? surf_or_stream_cache_.ready() : begins & camera,
            sched_.slot().ray);
    if constexpr (streams) {
        m.record = record_addr(sched_.slot());
        m.offer(Link::record, surf_or_stream_cache_.valid(), begins, surf_or_stream_cache_.answer());
    }
    m.offer(Link::ray, raygen_.valid(now), trav_.ray_ready(), raygen_.front());
    m.offer(Link::node_req, trav_.node_valid<levels>() & !is_list_, node_cache_.ready(),
            trav_.node_ray<levels>());
    const std::uint32_t read = node_cache_.answer();
    const bool enters = levels && VisitWord{rays_[read].head}.is_entry();
    m.lower_request = levels && is_low(read);
    m.offer(node_unit_req, node_cache_.valid() & !enters,
            node_unit_.ready() & ((box_hold_left_ == 0) | (m.lower_request != box_is_low_)), read);
    if constexpr (levels) m.lower_code = node_unit_code(m, true);
    m.read = m[node_unit_req].fires;
    if constexpr (levels) {
        const LinkRay changed = xform_.answer(now);
        m.offer(Link::xform_req, node_cache_.valid() & enters, xform_hold_left_ == 0, read);
        m.offer(Link::change, changed.valid, true, changed.ray);
        m.read = m.read | m[Link::xform_req].fires;
        m.xform_code = (m[Link::xform_req].valid | (xform_hold_left_ > 0)) ? busy_code
                       : node_cache_.has_misses_in_flight() ? cause_code(Unit::xform, starved("memory"))
                                                            : cause_code(Unit::xform, starved("trav"));
    }
    const LinkRay from_node_unit = node_unit_.answer(now), from_tri = tri_.answer(now);
    m.lower_answer = levels && is_low(from_node_unit.ray);
    m.node_answer = delays_answers_ ? node_answer_delay_.answer(now) : from_node_unit;
    if (is_list_) m.node_answer = {trav_.node_valid(), trav_.node_ray()};   // a page needs no memory
    m.tri_answer = delays_answers_ ? tri_answer_delay_.answer(now) : from_tri;
    m.offer(node_unit_rsp, from_node_unit.valid, true, from_node_unit.ray);
    m.offer(Link::leaves, m.node_answer.valid & has_tests(m.node_answer.ray), true, m.node_answer.ray);
    m.offer(Link::prim_req, list_.prim_valid(), prim_cache_.ready(), list_.prim_ray());
    m.offer(Link::tri_req, prim_cache_.valid(), tri_.ready() & (tri_hold_left_ == 0), prim_cache_.answer());
    m.offer(Link::tri_rsp, from_tri.valid, true, from_tri.ray);
    const bool tested = list_.tested_valid();
    m.offer(Link::tested, tested, trav_.tested_ready(tested), list_.tested_ray());
    m.step = trav_.step_valid(tested) & trav_.step_ready();
    if constexpr (shades) {
        m.offer(Link::hit, shade_.pixel_valid(), sink_.ready(), shade_.pixel_ray());
        m.offer(Link::closest, trav_.done_valid(), true, trav_.done_ray());
        m.offer(Link::surf_req, shade_.surf_valid<levels>(), surf_or_stream_cache_.ready(),
                shade_.surf_ray<levels>());
        const std::uint32_t came = surf_or_stream_cache_.answer();
        m.placing = levels && EndWord{*rays_[came].at}.is_place();
        m.offer(Link::surf_rsp, surf_or_stream_cache_.valid(), shade_.ready() | m.placing, came);
        m.offer(Link::spawn, shade_.spawn_valid(), begins & !camera, shade_.spawn_ray());
        m.shade_code = shade_.code(surf_or_stream_cache_.valid() & !m.placing,
                                   surf_or_stream_cache_.has_misses_in_flight());
        if constexpr (feed == RayFeed::textured) settle_tex(m, now);
    } else {
        m.offer(Link::hit, trav_.done_valid(), sink_.ready(), trav_.done_ray());
    }
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

template <Pipeline::RayFeed feed> [[gnu::always_inline]] inline void Pipeline::account_units(const Moves& m) {
    const auto progress = [&m](Link link) { return m[link].valid + m[link].fires; };
    constexpr bool shades = is_shaded(feed);
    constexpr Link first = feed == RayFeed::stream ? Link::record : Link::slot;
    const bool asked = m[first].valid | (shades && m[Link::spawn].valid),
               begun = m[first].fires | (shades && m[Link::spawn].fires);
    const std::size_t turn = trav_.step_valid(m[Link::tested].valid), free = trav_.step_ready();
    UnitCodes codes;
    codes.sched = sched_codes[std::size_t(sched_.pixel_valid() + progress(Link::slot))];
    codes.raygen = raygen_hold_left_ > 0 ? busy_code : raygen_codes[std::size_t(asked + begun)];
    codes.trav = trav_codes[turn + 2 * free];
    codes.node_unit = node_unit_code(m, false);
    codes.list = (m[Link::leaves].fires | m[Link::tri_rsp].fires) ? busy_code : list_starved;
    codes.tri =
        tri_hold_left_ > 0
            ? busy_code
            : tri_codes[std::size_t(progress(Link::tri_req) + 3 * prim_cache_.has_misses_in_flight())];
    last_units_ = codes.packed();
    ++units_[last_units_];
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

inline bool Pipeline::has_more(std::uint32_t ray, bool tested) {
    TraceCursor& cursor = rays_[ray];
    const bool more = !TestWord{*cursor.at}.is_last();
    cursor.at += more & tested;
    return more;
}

template <Pipeline::RayFeed feed>
[[gnu::always_inline]] inline void Pipeline::clock_sched(const Moves& m, const Tile* tile) {
    const bool slot = m[Link::slot].fires;
    if (slot) {
        const Slot given = sched_.slot();
        TraceCursor& cursor = rays_[given.ray];
        cursor.at = ray_at(*trace_, given.x, given.y);
        cursor.head = *cursor.at;
    }
    if constexpr (is_shaded(feed)) {
        const bool second = raygen_link_.second(shade_.spawn_valid());
        raygen_link_.clock(shade_.spawn_valid() | sched_.slot_valid(), slot | m[Link::spawn].fires, second);
    }
    sched_.clock(slot, tile, m[Link::hit]);
    sink_.clock();
}

template <Pipeline::RayFeed feed>
[[gnu::always_inline]] inline void Pipeline::clock_raygen(const Moves& m, std::uint64_t now) {
    LinkRay in = m[feed == RayFeed::stream ? Link::record : Link::slot];
    if constexpr (is_shaded(feed)) {
        const LinkInside& spawn = m[Link::spawn];
        in = {bool(in.valid | spawn.fires), select(spawn.fires, spawn.ray, in.ray)};
    }
    raygen_.clock(now, m[Link::ray].fires, in.valid, RayNumber(in.ray));
    raygen_hold_left_ = select(in.valid, raygen_hold_, raygen_hold_left_ - (raygen_hold_left_ > 0));
}

template <Pipeline::RayFeed feed, bool levels>
[[gnu::always_inline]] inline void Pipeline::clock_trav(const Moves& m) {
    const LinkInside& tested = m[Link::tested];
    if constexpr (levels) enter(m[Link::change]);
    trav_.clock<levels>({m[Link::ray],
                         {bool(m.node_answer.valid & !m[Link::leaves].fires), m.node_answer.ray},
                         {tested.valid, tested.ray},
                         is_list_ ? m.node_answer.valid : m[Link::node_req].fires,
                         m[is_shaded(feed) ? Link::closest : Link::hit].fires,
                         levels ? LinkRay(m[Link::change]) : LinkRay{}},
                        [this](std::uint32_t ray, bool valid) { return decide(ray, valid); });
}

[[gnu::always_inline]] inline void Pipeline::clock_node_cache(const Moves& m, const SharedMoves& shared) {
    const LinkInside& req = m[Link::node_req];
    node_outcome_ = node_cache_.clock(req.fires, {req.ray, node_addr(req.ray)}, m.read, shared.node_fill,
                                      shared.node_miss);
}

[[gnu::always_inline]] inline void Pipeline::clock_node_unit(const Moves& m, std::uint64_t now) {
    node_unit_.clock(now, m[node_unit_req]);
    box_hold_left_ = select(m[node_unit_req].fires & (m.lower_request == box_is_low_), box_hold_,
                            box_hold_left_ - (box_hold_left_ > 0));
    if (delays_answers_) node_answer_delay_.clock(now, m[node_unit_rsp]);
}

[[gnu::always_inline]] inline void Pipeline::clock_list(const Moves& m) {
    const LinkInside& leaves = m[Link::leaves];
    rays_[leaves.ray].at += leaves.fires;   // to the first triangle
    list_.clock(leaves, m.tri_answer, has_more(m.tri_answer.ray, m.tri_answer.valid), m[Link::prim_req].fires,
                m[Link::tested].fires);
}

[[gnu::always_inline]] inline void Pipeline::clock_prim_cache(const Moves& m, const SharedMoves& shared) {
    const LinkInside& req = m[Link::prim_req];
    prim_outcome_ = prim_cache_.clock(req.fires, {req.ray, prim_addr(req.ray) >> 1}, m[Link::tri_req].fires,
                                      shared.prim_fill, shared.prim_miss);
}

[[gnu::always_inline]] inline void Pipeline::clock_tri(const Moves& m, std::uint64_t now) {
    tri_.clock(now, m[Link::tri_req]);
    tri_hold_left_ = select(m[Link::tri_req].fires, tri_hold_, tri_hold_left_ - (tri_hold_left_ > 0));
    if (delays_answers_) tri_answer_delay_.clock(now, m[Link::tri_rsp]);
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

template <Pipeline::RayFeed feed, bool levels>
[[gnu::always_inline]] inline void Pipeline::clock(const Moves& m, std::uint64_t now,
                                                   const SharedMoves& shared) {
    account_units<feed>(m);
    const bool turning = !trav_.idle() | sched_.passing() | m.node_answer.valid | m.tri_answer.valid |
                         (raygen_hold_left_ > 0) | (box_hold_left_ > 0) | (tri_hold_left_ > 0) |
                         (levels && xform_hold_left_ > 0);
    clock_sched<feed>(m, shared.tile);
    clock_raygen<feed>(m, now);
    clock_trav<feed, levels>(m);
    if constexpr (levels) clock_xform(m, now);
    clock_node_cache(m, shared);
    clock_node_unit(m, now);
    clock_list(m);
    clock_prim_cache(m, shared);
    clock_tri(m, now);
    account_caches();
    asleep_ = (node_outcome_ > CacheOutcome::drain) & (prim_outcome_ > CacheOutcome::drain) &
              !node_cache_.loaded() & !prim_cache_.loaded() &
              !(turning | m.step | shared.any() |
                m.any(Link::slot, Link::ray, Link::node_req, node_unit_req, node_unit_rsp, Link::prim_req,
                      Link::tri_req, Link::tri_rsp, Link::hit));
    if constexpr (levels) asleep_ = asleep_ & !m.any(Link::xform_req, Link::change);
    if constexpr (feed == RayFeed::stream) {
        clock_stream(m, shared);
        asleep_ = asleep_ & !m.any(Link::record) & (surf_or_stream_outcome_ > CacheOutcome::drain) &
                  !surf_or_stream_cache_.loaded();
    }
    if constexpr (is_shaded(feed)) {
        asleep_ = asleep_ & !shade_.answers(now) & !shade_.offers(false) & !shade_.is_occupied() &
                  !shade_.comes() & !m.any(Link::closest, Link::surf_req, Link::surf_rsp, Link::spawn);
        clock_surf_cache(m, shared);
        clock_shade<feed, levels>(m, now);
        asleep_ = asleep_ & (surf_or_stream_outcome_ > CacheOutcome::drain) & !surf_or_stream_cache_.loaded();
        if constexpr (feed == RayFeed::textured) {
            asleep_ = asleep_ & tex_.is_idle(now) &
                      !m.any(Link::tex_req, Link::texel_req, Link::texel_rsp, Link::tex_rsp);
            clock_tex(m, now, shared);
            asleep_ = asleep_ & (tex_outcome_ > CacheOutcome::drain) & !tex_cache_.loaded();
        }
    }
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

}   // namespace rayclock
