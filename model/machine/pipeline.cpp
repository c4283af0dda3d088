// The parts of a pipeline outside its inner loop: shading, masks, idle times and accounts.
#include "model/machine/pipeline.hpp"

#include <algorithm>
#include <utility>

namespace rayclock {

namespace {
/// Returns the number of cycles for which no side of a pipeline depends on a later one.
std::uint64_t longest_window(const Config& config) {
    if (config.is_list()) return 1;   // trav's nodes are list's leaves in the same cycle
    const int latency = std::min({node_latency(config), config.tri_latency(), config.raygen_latency()});
    return std::min(std::uint64_t(latency) + 1, Pipeline::max_window);
}
}   // namespace

Pipeline::Pipeline(const Config& config, Disturbance disturbance, int number)
    : feed_(feed_of(config)),
      has_instances_(config.has_instances()),
      is_list_(config.is_list()),
      upper_(node_unit(config.engine())),
      lower_(node_unit(config.lower_engine())),
      pixel_bits_(config.pixel_bits),
      box_is_low_(config.has_two_engines() && config.lower_engine() == Structure::bvh),
      sched_(config),
      raygen_(config.raygen_latency(), config.raygen_queue),
      raygen_hold_(std::uint32_t(config.raygen_interval - 1)),
      trav_(config),
      node_cache_(node_cache_shape(config)),
      node_unit_(node_latency(config), config.box_queue, Stages(config).node_answer_delay),
      node_answer_delay_(std::uint64_t(Stages(config).node_answer_delay)),
      box_hold_(std::uint32_t(config.box_interval() - 1)),
      xform_(config.xform_latency() - 1, config.contexts),
      xform_hold_(std::uint32_t(config.xform_interval - 1)),
      list_(config),
      prim_cache_(prim_cache_shape(config)),
      tri_(config.tri_latency(), config.tri_queue, Stages(config).tri_answer_delay),
      tri_answer_delay_(std::uint64_t(Stages(config).tri_answer_delay)),
      tri_hold_(std::uint32_t(config.tri_interval - 1)),
      surf_or_stream_cache_(config.is_stream() ? stream_cache_shape(config) : surf_cache_shape(config)),
      shade_(config),
      tex_(config),
      tex_cache_(tex_cache_shape(config)),
      reads_texels_(std::size_t(config.contexts)),
      // In a chip that writes hits, only the unit hits stalls answers.
      sink_(config.writes_hits() ? Disturbance{} : disturbance, number),
      rays_(std::size_t(config.contexts)),
      is_plain_(config.timing == Timing::relaxed && !config.is_list() && disturbance.none() &&
                config.contexts <= RayRing::most_few && raygen_hold_ + box_hold_ + tri_hold_ == 0 &&
                node_unit_.never_stalls() && tri_.never_stalls() && prim_cache_.answers_at_once() &&
                node_cache_.answers_at_once()),
      window_(longest_window(config)) {}

/// Calls `f` for each cache whose answers are not queued in windows, and the unit behind it.
template <class F> void Pipeline::each_unqueued(F&& f) {
    f(prim_cache_, tri_);
    if (!has_instances_) f(node_cache_, node_unit_);
}

void Pipeline::enter_windows(std::uint64_t now) {
    in_windows_ = true;
    each_unqueued([now](Cache& cache, Delay& unit) {
        const std::array<LinkRay, 2> answers = cache.take_answers();
        unit.admit(now, answers[0]);
        unit.admit(now + 1, answers[1]);
    });
}

void Pipeline::leave_windows(std::uint64_t now) {
    if (!std::exchange(in_windows_, false)) return;
    each_unqueued([now](Cache& cache, Delay& unit) {
        cache.put_answers({unit.admitted(now), unit.admitted(now + 1)});
        unit.count(now);
    });
}

void Pipeline::settle(std::uint64_t now) {
    moves_ = {};
    with_shape([&]<RayFeed feed, bool levels>() { settle<feed, levels>(moves_, now); });
}
void Pipeline::clock(std::uint64_t now, const SharedMoves& shared) {
    with_shape([&]<RayFeed feed, bool levels>() { clock<feed, levels>(moves_, now, shared); });
}

void Pipeline::clock_in_order(std::uint64_t now, const SharedMoves& shared,
                              const std::array<int, pipeline_units>& order) {
    const std::uint32_t prim_codes = prim_side_codes<false>(moves_),
                        node_codes = node_side_codes<false>(moves_);
    with_shape(
        [&]<RayFeed feed, bool levels>() { account_ray_side<false>(ray_side_codes<feed, false>(moves_)); });
    for (const int unit : order) switch (Unit(unit)) {
            case Unit::sched:
                with_shape(
                    [&]<RayFeed feed, bool levels>() { clock_sched<feed, false>(moves_, 0, shared.tile); });
                break;
            case Unit::raygen:
                raygen_.take(moves_[Link::ray].fires);
                with_shape([&]<RayFeed feed, bool levels>() { clock_raygen<feed, false>(moves_, now, 0); });
                break;
            case Unit::trav:
                with_shape([&]<RayFeed feed, bool levels>() { clock_trav<feed, levels, false>(moves_); });
                break;
            case Unit::node_cache: clock_node_cache<false, false>(moves_, now, shared.node_fill); break;
            case Unit::box:
                clock_node_unit<false, false>(moves_, now);
                break;   // whichever engine it belongs to
            case Unit::xform:
                if (has_instances_) clock_xform(moves_, now);
                break;
            case Unit::list:
                clock_list<false>(moves_);
                list_.clock_tested(tested_[0], moves_[Link::tested].fires);
                break;
            case Unit::prim_cache: clock_prim_cache<false>(moves_, now, shared.prim_fill); break;
            case Unit::tri: clock_tri<false>(moves_, now); break;
            case Unit::surf_cache:
                if (is_shaded(feed_)) clock_surf_cache<false>(moves_, now, shared.surf_or_stream_fill);
                break;
            case Unit::stream:
                if (feed_ == RayFeed::stream) clock_stream(moves_, now, shared.surf_or_stream_fill);
                break;
            case Unit::shade:
                with_shape([&]<RayFeed feed, bool levels>() {
                    if constexpr (is_shaded(feed)) clock_shade<feed, levels, false>(moves_, now, 0);
                });
                break;
            case Unit::tex:
                if (feed_ == RayFeed::textured) clock_tex(moves_, now, shared.tex_fill);   // and tex_cache
                break;
            default: break;   // the other node units: see the case of box
        }
    account_prim_side<false>(prim_codes);
    account_node_side<false>(node_codes);
}

void Pipeline::clock_stream(const Moves& m, std::uint64_t now, const std::uint32_t* fill) {
    const LinkInside& slot = m[Link::slot];
    surf_or_stream_outcome_ =
        surf_or_stream_cache_.clock(slot.fires, {slot.ray, m.record}, m[Link::record].fires, fill, now);
    last_surf_or_stream_ = std::uint32_t(surf_or_stream_outcome_);
    ++surf_or_stream_cycles_[last_surf_or_stream_];
}

/// Returns the outcome of a ray's passes, as the trace holds it after the ray.
template <Pipeline::RayFeed feed, bool levels> Shade::Leave Pipeline::turn_of(std::uint32_t ray) {
    TraceCursor& cursor = rays_[ray];
    --cursor.head;
    // The first pass of a surface or cut-out has just ended; with two levels it is a surface's second pass.
    if (feed == RayFeed::textured && EndWord{*cursor.at}.has_texture() &&
        cursor.at[1] - cursor.head == (levels && !EndWord{*cursor.at}.is_cutout() ? 2 : 1))
        return Shade::Leave::texture;
    if (cursor.head > 0) return Shade::Leave::again;
    if (EndWord{*cursor.at}.ends_pixel()) return Shade::Leave::pixel;
    cursor.at += 2;
    cursor.head = *cursor.at;
    return Shade::Leave::spawn;
}

void Pipeline::clock_tex(const Moves& m, std::uint64_t now, const std::uint32_t* fill) {
    const LinkInside &req = m[Link::texel_req], &came = m[Link::texel_rsp];
    const bool texels = reads_texels_[came.ray];
    const std::uint32_t line = EndWord{rays_[req.ray].at[m[Link::tex_req].fires ? -2 : -1]}.line();
    tex_.clock(now, req.valid, req.fires, {came.fires && !texels, came.ray},
               {came.fires && texels, came.ray});
    if (req.fires) reads_texels_[req.ray] = !m[Link::tex_req].fires;
    tex_outcome_ = tex_cache_.clock(req.fires, {req.ray, line}, came.fires, fill, now);
    last_tex_ = std::uint32_t(tex_outcome_) | m.tex_code << cause_bits;
    ++tex_cycles_[last_tex_];
}

template <Pipeline::RayFeed feed, bool levels, bool plain>
void Pipeline::clock_shade(const Moves& m, std::uint64_t now, std::size_t c) {
    Shade::Fetch fetch = Shade::Fetch::none;
    const LinkRay& closest = left_[c];
    const LinkInside& came = m[Link::surf_rsp];
    const auto next = [this](std::uint32_t ray) -> EndWord {
        TraceCursor& cursor = rays_[ray];
        ++cursor.at;
        if (feed == RayFeed::textured && EndWord{*cursor.at}.is_record())
            cursor.at += 2;   // the two words of a texture precede the surface's word
        cursor.head = cursor.at[1];
        return {*cursor.at};
    };
    if (closest.valid) {   // past the last visit, or its last triangle
        const EndWord word = next(closest.ray);
        if (levels && word.is_place())
            fetch = Shade::Fetch::instance;
        else if (word.has_line())
            fetch = Shade::Fetch::surface;
    }
    const bool placed = came.fires & m.placing;
    if (placed) next(came.ray);
    shade_.clock<levels, feed == RayFeed::textured, plain>(
        now,
        {.closest = closest,
         .fetch = fetch,
         .surface = {bool(came.fires & !m.placing), came.ray},
         .place = {placed, came.ray},
         .textured = feed == RayFeed::textured ? LinkRay(m[Link::tex_rsp]) : LinkRay{},
         .surf_taken = bool(m[Link::surf_req].fires),
         .spawn_taken = bool(m[Link::spawn].fires),
         .pixel_taken = bool(m[Link::hit].fires),
         .texture_taken = feed == RayFeed::textured && m[Link::tex_req].fires},
        [this](std::uint32_t ray) { return turn_of<feed, levels>(ray); });
}
#define RC_INSTANCE(feed, levels)                                                                            \
    template void Pipeline::clock_shade<Pipeline::RayFeed::feed, levels, false>(const Moves&, std::uint64_t, \
                                                                                std::size_t);                \
    template void Pipeline::clock_shade<Pipeline::RayFeed::feed, levels, true>(const Moves&, std::uint64_t,  \
                                                                               std::size_t);
RC_INSTANCE(shade, false)
RC_INSTANCE(shade, true)
RC_INSTANCE(textured, false)
RC_INSTANCE(textured, true)
#undef RC_INSTANCE

namespace {
LinkMask at(bool on, Link link) { return LinkMask(on) << index(link); }
}   // namespace

LinkMask Pipeline::valid_mask(const SharedMoves& shared) const {
    const std::uint32_t requests = misses(~std::uint64_t(0));
    LinkMask mask = at(shared.tile, Link::tile) | at(requests & 1, Link::node_miss) |
                    at(shared.node_fill, Link::node_fill) | at(requests & 2, Link::prim_miss) |
                    at(shared.prim_fill, Link::prim_fill) |
                    at(requests & 4, surf_or_stream(Link::surf_miss, Link::stream_miss)) |
                    at(shared.surf_or_stream_fill, surf_or_stream(Link::surf_fill, Link::stream_fill)) |
                    at(requests & 8, Link::tex_miss) | at(shared.tex_fill, Link::tex_fill);
    for (std::size_t i = 0; i < pipeline_links; ++i) mask |= at(moves_.links[i].valid, outside(Link(i)));
    return mask;
}

LinkMask Pipeline::fire_mask(const SharedMoves& shared) const {
    LinkMask mask = at(shared.tile, Link::tile) | at(shared.node_miss, Link::node_miss) |
                    at(shared.node_fill, Link::node_fill) | at(shared.prim_miss, Link::prim_miss) |
                    at(shared.prim_fill, Link::prim_fill) |
                    at(shared.surf_or_stream_miss, surf_or_stream(Link::surf_miss, Link::stream_miss)) |
                    at(shared.surf_or_stream_fill, surf_or_stream(Link::surf_fill, Link::stream_fill)) |
                    at(shared.tex_miss, Link::tex_miss) | at(shared.tex_fill, Link::tex_fill);
    for (std::size_t i = 0; i < pipeline_links; ++i) mask |= at(moves_.links[i].fires, outside(Link(i)));
    return mask;
}

std::uint64_t Pipeline::wakes(std::uint64_t now) const {
    if (node_cache_.answers() || prim_cache_.answers() ||
        (feed_ != RayFeed::camera && surf_or_stream_cache_.answers()) ||
        (feed_ == RayFeed::textured && tex_cache_.answers()))
        return now;
    std::uint64_t wakes = std::min({raygen_.due(), node_unit_.due(now), tri_.due(now)});
    if (has_instances_) wakes = std::min(wakes, xform_.due(now));
    if (feed_ == RayFeed::textured) wakes = std::min(wakes, tex_.due(now));
    return is_shaded(feed_) ? std::min(wakes, shade_.due()) : wakes;
}

std::string Pipeline::where(std::uint32_t ray, std::uint64_t now) const {
    if (!sched_.in_use(ray)) return {};
    if (const char* place = trav_.where(ray)) return place;
    if (const char* place = list_.where(ray)) return place;
    if (const char* place = is_shaded(feed_) ? shade_.where(ray) : nullptr) return place;
    if (const char* place = feed_ == RayFeed::textured ? tex_.where(ray, now) : nullptr) return place;
    if (std::string place = feed_ == RayFeed::textured ? tex_cache_.where(ray) : ""; !place.empty())
        return "tex_cache: " + place;
    if (std::string place = feed_ != RayFeed::camera ? surf_or_stream_cache_.where(ray) : ""; !place.empty())
        return (feed_ == RayFeed::stream ? "stream: " : "surf_cache: ") + place;
    if (std::string place = node_cache_.where(ray); !place.empty()) return "node_cache: " + place;
    if (std::string place = prim_cache_.where(ray); !place.empty()) return "prim_cache: " + place;
    return raygen_.contains(RayNumber(ray)) ? "raygen"
           : node_unit_.contains(RayNumber(ray), now)
               ? unit_infos[index((is_low(ray) ? lower_ : upper_).unit)].name
           : xform_.contains(RayNumber(ray), now)  ? "xform"
           : tri_.contains(RayNumber(ray), now)    ? "tri"
           : node_unit_.keeps(RayNumber(ray), now) ? "trav: looks at a node's answer"
           : tri_.keeps(RayNumber(ray), now)       ? "list: looks at tri's answer"
                                                   : "nowhere";
}

Accounts Pipeline::accounts() const {
    Accounts sums;
    const auto add = [&](Unit unit, std::uint32_t code, std::uint64_t cycles) {
        sums.units[index(unit)][code] += cycles;
    };
    const bool streams = feed_ == RayFeed::stream;
    for (std::uint32_t i = 0; i < ray_side_.size(); ++i) {
        auto [sched, raygen] = UnitCodes::of(i);
        if (streams) {   // the unit stream lies between sched and raygen
            if (sched == cause_code(Unit::sched, stalled("raygen")))
                sched = cause_code(Unit::sched, stalled("stream"));
            if (raygen == cause_code(Unit::raygen, starved("sched")))
                raygen = cause_code(Unit::raygen, starved("stream"));
        }
        add(Unit::sched, sched, ray_side_[i]);
        add(Unit::raygen, raygen, ray_side_[i]);
    }
    constexpr std::uint32_t outcome = (1u << cause_bits) - 1;
    for (std::uint32_t i = 0; i < node_side_.size(); ++i) {
        const auto [trav, node_unit] = UnitCodes::of(i >> cause_bits);
        add(Unit::trav, trav, node_side_[i]);
        if (is_list_) continue;
        add(upper_.unit, node_unit, node_side_[i]);
        add(Unit::node_cache, i & outcome, node_side_[i]);
    }
    for (std::uint32_t i = 0; i < prim_side_.size(); ++i) {
        const auto [list, tri] = UnitCodes::of(i >> cause_bits);
        add(Unit::list, list, prim_side_[i]);
        add(Unit::tri, tri, prim_side_[i]);
        add(Unit::prim_cache, i & outcome, prim_side_[i]);
    }
    for (std::uint32_t i = 0; i < tex_cycles_.size(); ++i) {
        add(Unit::tex_cache, i & outcome, tex_cycles_[i]);
        add(Unit::tex, i >> cause_bits, tex_cycles_[i]);
    }
    for (std::uint32_t i = 0; i < xforms_.size(); ++i) add(Unit::xform, i, xforms_[i]);
    for (std::uint32_t i = 0; lower_.unit != upper_.unit && i < lowers_.size(); ++i)
        add(lower_.unit, i, lowers_[i]);
    for (std::uint32_t i = 0; i < surf_or_stream_cycles_.size(); ++i) {
        add(streams ? Unit::stream : Unit::surf_cache, i & outcome, surf_or_stream_cycles_[i]);
        if (!streams) add(Unit::shade, i >> cause_bits, surf_or_stream_cycles_[i]);
    }
    return sums;
}

}   // namespace rayclock
