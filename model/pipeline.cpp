#include "model/pipeline.hpp"

#include <algorithm>

namespace rayclock {

Pipeline::Pipeline(const Config& config, Traffic traffic, int number)
    : shading_(config.shading != 0),
      sched_(config),
      raygen_(config.raygen_latency(), config.raygen_queue),
      trav_(config),
      node_cache_(node_cache_shape(config)),
      box_(config.box_latency(), config.box_queue),
      list_(config),
      prim_cache_(prim_cache_shape(config)),
      tri_(config.tri_latency(), config.tri_queue),
      surf_cache_(surf_cache_shape(config)),
      shade_(config),
      sink_(traffic, number),
      rays_(std::size_t(config.contexts)) {}

void Pipeline::settle(std::uint64_t now) { moves_ = moving(now); }
void Pipeline::clock(std::uint64_t now, const SharedMoves& shared) { clock(moves_, now, shared); }

void Pipeline::clock_in_order(std::uint64_t now, const SharedMoves& shared,
                              const std::array<int, pipeline_units>& order) {
    for (const int unit : order) switch (Unit(unit)) {
            case Unit::sched: clock_sched(moves_, shared.tile); break;
            case Unit::raygen: clock_raygen(moves_, now); break;
            case Unit::trav: clock_trav(moves_); break;
            case Unit::node_cache: clock_node_cache(moves_, now, shared); break;
            case Unit::box: clock_box(moves_, now); break;
            case Unit::list: clock_list(moves_); break;
            case Unit::prim_cache: clock_prim_cache(moves_, now, shared); break;
            case Unit::tri: clock_tri(moves_, now); break;
            case Unit::surf_cache:
                if (shading_) clock_surf_cache(moves_, now, shared);
                break;
            default:
                if (shading_) clock_shade(moves_, now);
                break;
        }
    account_caches();
}

void Pipeline::moving_shaded(Moves& m, std::uint64_t now) {
    const bool slot = raygen_link_.second(shade_.spawn_valid());
    m.slot = m.slot && slot;
    if ((m.spawn = !slot && shade_.spawn_valid() && raygen_.ready())) m.spawned = shade_.spawn_ray();
    if ((m.closest = trav_.done_valid())) m.closed = trav_.done_ray();
    if ((m.surf_req = shade_.surf_valid() && surf_cache_.ready()))
        m.surf_out = {shade_.surf_ray(), surf_addr(shade_.surf_ray())};
    if ((m.surf_rsp = surf_cache_.valid(now) && shade_.ready())) m.surf_in = surf_cache_.answer();
    if ((m.hit = shade_.pixel_valid() && sink_.ready())) m.ended = shade_.pixel_ray();
    // Codes of units.hpp.
    const bool offered = shade_.offers(surf_cache_.valid(now));
    shade_code_ = offered ? (shade_.ready() ? 0 : 3) : surf_cache_.waits() ? 1 : 2;
}

void Pipeline::clock_surf_cache(const Moves& m, std::uint64_t now, const SharedMoves& shared) {
    surf_deed_ = surf_cache_.clock(now, m.surf_req ? &m.surf_out : nullptr, m.surf_rsp, shared.surf_fill,
                                   shared.surf_miss);
    last_shades_ = std::uint32_t(surf_deed_) | shade_code_ << 3;
    ++shades_[last_shades_];
}

/// What the trace says after a ray: what its passes lead to.
Shade::Turn Pipeline::turn_of(std::uint32_t ray) {
    Place& place = rays_[ray];
    if (--place.head > 0) return Shade::Turn::again;
    if (*place.at & Trace::pixel_flag) return Shade::Turn::pixel;
    place.at += 2;
    place.head = *place.at;
    return Shade::Turn::spawn;
}

void Pipeline::clock_shade(const Moves& m, std::uint64_t now) {
    bool surface = false;
    if (m.closest) {   // past the last visit, or its last triangle
        Place& place = rays_[m.closed];
        ++place.at;
        place.head = place.at[1];
        surface = *place.at & Trace::surface_flag;
    }
    shade_.clock(now, m.closest ? &m.closed : nullptr, surface, m.surf_rsp ? &m.surf_in : nullptr, m.surf_req,
                 m.spawn, m.hit, [this](std::uint32_t ray) { return turn_of(ray); });
}

namespace {
std::uint32_t at(bool on, Link c) { return std::uint32_t(on) << index(c); }
}   // namespace

std::uint32_t Pipeline::valid_mask(const SharedMoves& shared, std::uint64_t now) const {
    return at(sched_.slot_valid(), Link::slot) | at(raygen_.valid(now), Link::ray) |
           at(trav_.node_valid(), Link::node_req) | at(node_cache_.miss_valid(), Link::node_miss) |
           at(node_cache_.valid(now), Link::box_req) | at(box_.valid(now), Link::box_rsp) |
           at(box_.valid(now) && has_tests(box_.front()), Link::leaves) |
           at(list_.prim_valid(), Link::prim_req) | at(prim_cache_.miss_valid(), Link::prim_miss) |
           at(prim_cache_.valid(now), Link::tri_req) | at(tri_.valid(now), Link::tri_rsp) |
           at(list_.tested_valid(), Link::tested) |
           at(shading_ ? shade_.pixel_valid() : trav_.done_valid(), Link::hit) | at(shared.tile, Link::tile) |
           at(shared.node_fill, Link::node_fill) | at(shared.prim_fill, Link::prim_fill) |
           (shading_ ? shaded_valid(shared, now) : 0);
}

std::uint32_t Pipeline::shaded_valid(const SharedMoves& shared, std::uint64_t now) const {
    return at(trav_.done_valid(), Link::closest) | at(shade_.surf_valid(), Link::surf_req) |
           at(surf_cache_.miss_valid(), Link::surf_miss) | at(shared.surf_fill, Link::surf_fill) |
           at(surf_cache_.valid(now), Link::surf_rsp) | at(shade_.spawn_valid(), Link::spawn);
}

std::uint32_t Pipeline::fire_mask(const SharedMoves& shared) const {
    const Moves& m = moves_;
    return at(m.slot, Link::slot) | at(m.ray, Link::ray) | at(m.node_req, Link::node_req) |
           at(m.box_req, Link::box_req) | at(m.box_rsp, Link::box_rsp) | at(m.leaves, Link::leaves) |
           at(m.prim_req, Link::prim_req) | at(m.tri_req, Link::tri_req) | at(m.tri_rsp, Link::tri_rsp) |
           at(m.tested, Link::tested) | at(m.hit, Link::hit) | at(shared.node_miss, Link::node_miss) |
           at(shared.prim_miss, Link::prim_miss) | at(shared.tile, Link::tile) |
           at(shared.node_fill, Link::node_fill) | at(shared.prim_fill, Link::prim_fill) |
           at(m.closest, Link::closest) | at(m.surf_req, Link::surf_req) |
           at(shared.surf_miss, Link::surf_miss) | at(shared.surf_fill, Link::surf_fill) |
           at(m.surf_rsp, Link::surf_rsp) | at(m.spawn, Link::spawn);
}

std::uint64_t Pipeline::wakes() const {
    const std::uint64_t wakes =
        std::min({raygen_.due(), box_.due(), tri_.due(), node_cache_.due(), prim_cache_.due()});
    return shading_ ? std::min({wakes, shade_.due(), surf_cache_.due()}) : wakes;
}

std::uint32_t Pipeline::ray_on(Link c) const {
    switch (c) {
        case Link::slot: return moves_.given.ray;
        case Link::ray: return moves_.started;
        case Link::node_req: return moves_.node_out.id;
        case Link::box_req: return moves_.node_in;
        case Link::box_rsp:
        case Link::leaves: return moves_.boxed;
        case Link::prim_req: return moves_.prim_out.id;
        case Link::tri_req: return moves_.prim_in;
        case Link::tri_rsp: return moves_.answered;
        case Link::tested: return moves_.returned;
        case Link::closest: return moves_.closed;
        case Link::surf_req: return moves_.surf_out.id;
        case Link::surf_rsp: return moves_.surf_in;
        case Link::spawn: return moves_.spawned;
        default: return moves_.ended;
    }
}

std::string Pipeline::where(std::uint32_t ray) const {
    if (!sched_.in_use(ray)) return {};
    if (const char* place = trav_.where(ray)) return place;
    if (const char* place = list_.where(ray)) return place;
    if (const char* place = shading_ ? shade_.where(ray) : nullptr) return place;
    if (std::string place = shading_ ? surf_cache_.where(ray) : ""; !place.empty())
        return "surf_cache: " + place;
    if (std::string place = node_cache_.where(ray); !place.empty()) return "node_cache: " + place;
    if (std::string place = prim_cache_.where(ray); !place.empty()) return "prim_cache: " + place;
    return raygen_.contains(RayNumber(ray)) ? "raygen"
           : box_.contains(RayNumber(ray))  ? "box"
           : tri_.contains(RayNumber(ray))  ? "tri"
                                            : "nowhere";
}

Accounts Pipeline::accounts() const {
    Accounts sums;
    const auto add = [&](Unit unit, std::uint32_t code, std::uint64_t cycles) {
        sums.units[index(unit)][code] += cycles;
    };
    for (std::uint32_t i = 0; i < units_.size(); ++i) {
        if (units_[i] == 0) continue;
        add(Unit::sched, i & 3, units_[i]);
        add(Unit::raygen, i >> 2 & 3, units_[i]);
        add(Unit::trav, i >> 4 & 3, units_[i]);
        add(Unit::box, i >> 6 & 3, units_[i]);
        add(Unit::list, i >> 8 & 1, units_[i]);
        add(Unit::tri, i >> 9 & 3, units_[i]);
    }
    for (std::uint32_t i = 0; i < caches_.size(); ++i) {
        add(Unit::node_cache, i & 7, caches_[i]);
        add(Unit::prim_cache, i >> 3, caches_[i]);
    }
    for (std::uint32_t i = 0; i < shades_.size(); ++i) {
        add(Unit::surf_cache, i & 7, shades_[i]);
        add(Unit::shade, i >> 3, shades_[i]);
    }
    return sums;
}

}   // namespace rayclock
