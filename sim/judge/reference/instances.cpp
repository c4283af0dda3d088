// The two levels of the search, both with the reference tracer's box test.
#include "sim/judge/reference/instances.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/matrix.hpp>

namespace rayclock {
namespace {

template <class Mesh> Scene alone(const Mesh& mesh) {
    Scene scene;
    scene.vertices = mesh.vertices;
    scene.triangles = mesh.triangles;
    scene.materials.emplace_back();
    return scene;
}

/// Returns the bounds of the image of a box: those of its corners' images.
Bounds image_of(const Bounds& box, const glm::dmat4& place) {
    constexpr double far = std::numeric_limits<double>::infinity();
    Bounds out{glm::dvec3(far), glm::dvec3(-far)};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p(corner & 1 ? box.hi.x : box.lo.x, corner & 2 ? box.hi.y : box.lo.y,
                           corner & 4 ? box.hi.z : box.lo.z);
        const auto at = glm::dvec3(place * glm::dvec4(p, 1));
        out.lo = glm::min(out.lo, at);
        out.hi = glm::max(out.hi, at);
    }
    return out;
}

Scene corners_of(const std::vector<Bounds>& boxes) {
    Scene scene;
    for (const Bounds& box : boxes) {
        const auto first = static_cast<std::uint32_t>(scene.vertices.size());
        scene.vertices.push_back(box.lo);
        scene.vertices.push_back(box.hi);
        scene.triangles.push_back({{first, first + 1, first + 1}, 0});
    }
    return scene;
}

/// Returns a float at least one float step below x. The rounding error of the doubles is far smaller than
/// that step.
float well_below(double x) { return std::nextafter(float_below(x), -std::numeric_limits<float>::infinity()); }

}   // namespace

RefInstances::RefInstances(const PlacedScene& scene) : space_(Scene{}) {
    std::vector<Bounds> boxes;
    std::uint64_t first = 0;
    const auto place = [&](const glm::dmat4& at, std::uint32_t mesh, std::size_t triangles) {
        if (triangles > 0) {
            add(at, mesh, first);
            boxes.push_back(image_of(bounds_[mesh], at));
        }
        first += triangles;
    };
    const auto keep = [&](const Scene& mesh) {
        meshes_.emplace_back(mesh);
        bounds_.push_back(mesh.triangles.empty() ? Bounds{} : bounds(mesh));
    };
    keep(alone(scene.own));
    for (const SharedMesh& mesh : scene.meshes) keep(alone(mesh));
    place(glm::dmat4(1), 0, scene.own.triangles.size());
    for (const Instance& instance : scene.instances)
        place(instance.place, instance.mesh + 1, scene.meshes[instance.mesh].triangles.size());
    space_ = RefUnitSpace(corners_of(boxes));
    std::vector<RefBox> unit(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const glm::dvec3 lo = space_(boxes[i].lo), hi = space_(boxes[i].hi);
        for (int k = 0; k < 3; ++k) {
            unit[i].lo[k] = well_below(lo[k]);
            unit[i].hi[k] = -well_below(-hi[k]);
        }
        unit[i].primitive = static_cast<std::uint32_t>(i);
    }
    RefHierarchy hierarchy = build_hierarchy(unit);
    nodes_ = std::move(hierarchy.nodes);
    order_ = std::move(hierarchy.order);
}

void RefInstances::add(const glm::dmat4& place, std::uint32_t mesh, std::uint64_t first) {
    const glm::dmat3 linear(place);
    placed_.push_back({glm::inverse(linear), glm::dvec3(place[3]), mesh, static_cast<std::uint32_t>(first),
                       glm::determinant(linear) < 0});
}

/// Tests one instance. Depths are those of the scene, along a unit direction. At equal depth the lower number
/// wins, as in a flat scene.
void RefInstances::test(const Placed& placed, const glm::dvec3& origin, const glm::dvec3& direction,
                        RefClosest& best) const {
    const RefGeometry& geometry = meshes_[placed.mesh];
    const glm::dvec3 turned = placed.back * direction;
    RefPath path;
    if (!geometry.find_path(placed.back * (origin - placed.origin), turned, path)) return;
    const RefClosest own = geometry.closest(path);
    if (own.primitive == no_primitive) return;
    const double depth = own.depth / geometry.space().scale / glm::length(turned);
    const std::uint32_t number = placed.first + own.primitive;
    if (!best.yields_to(depth, number)) return;
    best = {depth, own.u, own.v, number};
    if (placed.is_mirrored) std::swap(best.u, best.v);   // it swaps its second and third corner
}

Hit RefInstances::trace(const glm::dvec3& origin, const glm::dvec3& given) const {
    const glm::dvec3 size = glm::abs(given);
    const double largest = std::max(size.x, std::max(size.y, size.z));
    if (!(largest > 0) || !std::isfinite(largest) || nodes_.empty()) return {};
    const glm::dvec3 direction = glm::normalize(given / largest), from = space_(origin);
    const RefRay ray(from, direction);
    RefClosest best;
    struct Entry {
        std::uint32_t child, blocks;
        float near;
    };
    Entry stack[ref_stack_size];
    stack[0] = {0, 0, 0};
    for (int top = 1; top > 0;) {
        const Entry entry = stack[--top];
        const float limit = float_above(best.depth * space_.scale) * slab_margin;
        if (entry.near > limit) continue;
        if (entry.blocks > 0) {   // the last entry of a leaf may repeat the one before
            std::uint32_t before = no_primitive;
            for (std::uint32_t i = entry.child * ref_block_size;
                 i < (entry.child + entry.blocks) * ref_block_size; ++i) {
                if (order_[i] != before) test(placed_[order_[i]], origin, direction, best);
                before = order_[i];
            }
            continue;
        }
        RefFloat4 near;
        int entered = boxes_entered(nodes_[entry.child], ray, limit, near);
        const int base = top;
        for (; entered != 0; entered &= entered - 1) {   // push the nearest last
            const int i = std::countr_zero(static_cast<unsigned>(entered));
            int place = top++;
            for (; place > base && stack[place - 1].near < near[i]; --place) stack[place] = stack[place - 1];
            stack[place] = {nodes_[entry.child].child[i], nodes_[entry.child].blocks[i], near[i]};
        }
    }
    if (best.primitive == no_primitive) return {};
    return {best.primitive, static_cast<float>(best.depth), static_cast<float>(best.u),
            static_cast<float>(best.v)};
}

}   // namespace rayclock
