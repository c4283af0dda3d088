// Proposes and scores planes in any direction for the cells of a bsp tree.
#include "model/engine/bsp/facets.hpp"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>
#include <glm/geometric.hpp>

#include "model/unit/tri/vectors.hpp"

namespace rayclock::bsp {

namespace {

constexpr std::size_t max_items = 16, offering = 2;
constexpr double oblique_factor = 1.2;
constexpr int max_step = (1 << (normal_step_bits - 1)) - 1;

glm::dvec3 point(const Vec3i& p) { return {p[0], p[1], p[2]}; }

}   // namespace

Vec3i nearest_normal(const glm::dvec3& direction) {
    const glm::dvec3 size = glm::abs(direction);
    const double longest = std::max({size.x, size.y, size.z});
    if (!(longest > 0)) return {};
    const glm::dvec3 d = direction / longest;
    Vec3i best{};
    double least = 4;   // squared tangent of the angle between them
    for (int longer = 1; longer <= max_step; ++longer) {
        const glm::dvec3 n = glm::round(d * double(longer));
        const glm::dvec3 off = glm::cross(n, d);
        const double error = glm::dot(off, off) / glm::dot(n, n);
        if (error < least * (1 - 1e-9)) {
            least = error;
            best = {int(n.x), int(n.y), int(n.z)};
        }
    }
    return best;
}

Facets::Facets(const std::vector<PrimData>& prims, const space_cells::Pieces& pieces, const Config& config)
    : pieces_(pieces), normals_(prims.size()), stops_(config.straddlers == Straddlers::stop) {
    tbb::parallel_for(std::size_t(0), prims.size(),
                      [&](std::size_t i) { normals_[i] = normals_of(prims[i]); });
}

Facets::Normals Facets::normals_of(const PrimData& prim) {
    Normals normals{};
    if (!prim.is_triangle()) return normals;
    const std::array corners{point(prim.a), point(prim.b), point(prim.c)};
    const glm::dvec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    normals[0] = nearest_normal(across);
    for (std::size_t i = 0; i < 3; ++i)
        normals[1 + i] = nearest_normal(glm::cross(corners[(i + 1) % 3] - corners[i], across));
    return normals;
}

void Facets::consider(const space_cells::Items& items, const Solid& solid, std::uint32_t prim,
                      const Vec3i& normal, space_cells::Split& best) const {
    const auto own = pieces_.of(prim).reach(normal);
    std::array<space_cells::Clipper::Reach, max_items> reaches;
    for (std::size_t i = 0; i < items.size(); ++i) reaches[i] = pieces_.reach(items[i], normal);
    consider_at(std::span(reaches).first(items.size()), solid, normal, own.lo, best);
    if (own.hi != own.lo) consider_at(std::span(reaches).first(items.size()), solid, normal, own.hi, best);
}

void Facets::consider_at(std::span<const space_cells::Clipper::Reach> reaches, const Solid& solid,
                         const Vec3i& normal, std::int64_t at, space_cells::Split& best) const {
    std::size_t below = 0, above = 0, flat = 0;
    for (const space_cells::Clipper::Reach& reach : reaches) {
        below += reach.lo < at;
        above += reach.hi > at;
        flat += reach.lo == at && reach.hi == at;
    }
    const std::size_t all = reaches.size();
    if (stops_ && below + above + flat > all) return;
    // The two parts' surfaces sum to at least the cell's. So this is a lower bound on the cost; if it is too
    // high, skip the exact areas.
    if (oblique_factor * space_cells::cost_of(0.5, std::min(below, above), 0.5, std::min(below, above)) >=
        best.cost)
        return;
    const Solid::Halves halves = solid.halves(point(normal), double(at));
    const double lower = halves.lower / solid.area(), upper = halves.upper / solid.area();
    for (const bool flat_above : {false, true}) {
        const std::size_t b = below + (flat_above ? 0 : flat), a = above + (flat_above ? flat : 0);
        const double cost = oblique_factor * space_cells::cost_of(lower, b, upper, a);
        if (cost < best.cost)
            best = {{no_axis, std::int32_t(at), flat_above, normal}, cost, b, a, lower, upper};
        if (flat == 0) break;
    }
}

void Facets::best_split(const space_cells::Items& items, const space_cells::Region& region,
                        space_cells::Split& best) const {
    const std::size_t most = stops_ ? items.size() : 2 * items.size();
    if (items.size() > max_items) return space_cells::try_axes(items, region.box, most, best);
    Solid solid(region.box);
    for (std::size_t i = region.own; i < region.walls.size(); ++i)
        solid.cut(point(region.walls[i].normal), region.walls[i].at, region.walls[i].upper);
    if (!(solid.area() > 0)) return space_cells::try_axes(items, region.box, most, best);
    space_cells::Split across = best;
    across.cost = 2 * best.cost;
    space_cells::try_axes(items, region.box, most, across);
    if (across.is_there()) {   // scored like the other planes
        glm::dvec3 normal(0);
        normal[int(across.axis)] = 1;
        const Solid::Halves halves = solid.halves(normal, across.plane);
        across.cost = space_cells::cost_of(halves.lower / solid.area(), across.below,
                                           halves.upper / solid.area(), across.above);
        if (across.cost < best.cost) best = across;
    }
    const std::size_t asked = std::min(items.size(), offering);
    for (std::size_t i = 0; i < asked; ++i) {
        const std::uint32_t prim = items[i * items.size() / asked].prim;
        for (const Vec3i& normal : normals_.empty() ? Normals{} : normals_[prim]) {
            if ((normal[0] != 0) + (normal[1] != 0) + (normal[2] != 0) < 2) continue;
            consider(items, solid, prim, normal, best);
        }
    }
}

}   // namespace rayclock::bsp
