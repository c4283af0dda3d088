#include "model/pipeline.hpp"

#include <algorithm>

namespace rayclock {

Pipeline::Pipeline(const Config& config, Traffic traffic, int number)
    : sched_(config), raygen_(config.raygen_latency(), config.raygen_queue), trav_(config), node_cache_(node_cache_shape(config)),
      box_(config.box_latency(), config.box_queue), list_(config), prim_cache_(prim_cache_shape(config)),
      tri_(config.tri_latency(), config.tri_queue), sink_(traffic, number), rays_(std::size_t(config.contexts)) {}

void Pipeline::settle(std::uint64_t now) { moves_ = moving(now); }
void Pipeline::clock(std::uint64_t now, const SharedMoves& shared) { clock(moves_, now, shared); }

void Pipeline::clock_in_order(std::uint64_t now, const SharedMoves& shared, const std::array<int, pipeline_units>& order) {
    for (const int unit : order) switch (Unit(unit)) {
        case Unit::sched: clock_sched(moves_, shared.tile); break;
        case Unit::raygen: clock_raygen(moves_, now); break;
        case Unit::trav: clock_trav(moves_); break;
        case Unit::node_cache: clock_node_cache(moves_, now, shared); break;
        case Unit::box: clock_box(moves_, now); break;
        case Unit::list: clock_list(moves_); break;
        case Unit::prim_cache: clock_prim_cache(moves_, now, shared); break;
        default: clock_tri(moves_, now); break;
        }
    account_caches();
}

namespace {
std::uint32_t at(bool on, Channel c) { return std::uint32_t(on) << index(c); }
} // namespace

std::uint32_t Pipeline::valid_mask(const SharedMoves& shared, std::uint64_t now) const {
    return at(sched_.slot_valid(), Channel::slot) | at(raygen_.valid(now), Channel::ray) | at(trav_.node_valid(), Channel::node_req)
        | at(node_cache_.miss_valid(), Channel::node_miss) | at(node_cache_.valid(now), Channel::box_req) | at(box_.valid(now), Channel::box_rsp)
        | at(list_.prim_valid(), Channel::prim_req) | at(prim_cache_.miss_valid(), Channel::prim_miss)
        | at(prim_cache_.valid(now), Channel::tri_req) | at(tri_.valid(now), Channel::tri_rsp) | at(list_.step_valid(), Channel::step)
        | at(trav_.done_valid(), Channel::hit) | at(shared.tile, Channel::tile) | at(shared.node_fill, Channel::node_fill)
        | at(shared.prim_fill, Channel::prim_fill);
}

std::uint32_t Pipeline::fire_mask(const SharedMoves& shared) const {
    const Moves& m = moves_;
    return at(m.slot, Channel::slot) | at(m.ray, Channel::ray) | at(m.node_req, Channel::node_req) | at(m.box_req, Channel::box_req)
        | at(m.box_rsp, Channel::box_rsp) | at(m.prim_req, Channel::prim_req) | at(m.tri_req, Channel::tri_req) | at(m.tri_rsp, Channel::tri_rsp)
        | at(m.step, Channel::step) | at(m.hit, Channel::hit) | at(shared.node_miss, Channel::node_miss) | at(shared.prim_miss, Channel::prim_miss)
        | at(shared.tile, Channel::tile) | at(shared.node_fill, Channel::node_fill) | at(shared.prim_fill, Channel::prim_fill);
}

std::uint64_t Pipeline::wakes() const {
    return std::min({raygen_.due(), box_.due(), tri_.due(), node_cache_.due(), prim_cache_.due()});
}

std::uint32_t Pipeline::ray_on(Channel c) const {
    switch (c) {
    case Channel::slot: return moves_.given.ray;
    case Channel::ray: return moves_.started;
    case Channel::node_req: return moves_.node_out.id;
    case Channel::box_req: return moves_.node_in;
    case Channel::box_rsp: return moves_.boxed;
    case Channel::prim_req: return moves_.prim_out.id;
    case Channel::tri_req: return moves_.prim_in;
    case Channel::tri_rsp: return moves_.tested;
    case Channel::step: return moves_.stepped;
    default: return moves_.ended;
    }
}

std::string Pipeline::where(std::uint32_t ray) const {
    if (!sched_.in_use(ray)) return {};
    if (const char* place = trav_.where(ray)) return place;
    if (const char* place = list_.where(ray)) return place;
    if (std::string place = node_cache_.where(ray); !place.empty()) return "node_cache: " + place;
    if (std::string place = prim_cache_.where(ray); !place.empty()) return "prim_cache: " + place;
    return raygen_.contains(RayNumber(ray)) ? "raygen" : box_.contains(RayNumber(ray)) ? "box" : tri_.contains(RayNumber(ray)) ? "tri" : "nowhere";
}

Accounts Pipeline::accounts() const {
    Accounts sums;
    const auto add = [&](Unit unit, std::uint32_t code, std::uint64_t cycles) { sums.units[index(unit)][code] += cycles; };
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
    return sums;
}

} // namespace rayclock
