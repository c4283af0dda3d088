// Building the hierarchies, and the traversals.
#include "sim/judge/reference/geometry.hpp"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "model/base/stopwatch.hpp"
#include "sim/judge/reference/distinct.hpp"

namespace rayclock {
namespace {

std::vector<RefBox> triangle_boxes(const Scene& scene, const RefUnitSpace& space) {
    const std::vector<std::uint32_t> kept = distinct_triangles(scene);
    std::vector<RefBox> boxes(kept.size());
    tbb::parallel_for(std::size_t{0}, boxes.size(), [&](std::size_t i) {
        const auto& vertex = scene.triangles[kept[i]].vertex;
        const glm::dvec3 a = space(scene.vertices[vertex[0]]), b = space(scene.vertices[vertex[1]]),
                         c = space(scene.vertices[vertex[2]]);
        const glm::dvec3 lo = glm::min(a, glm::min(b, c)), hi = glm::max(a, glm::max(b, c));
        for (int k = 0; k < 3; ++k) {
            boxes[i].lo[k] = float_below(lo[k]);
            boxes[i].hi[k] = float_above(hi[k]);
        }
        boxes[i].primitive = kept[i];
    });
    return boxes;
}

std::vector<RefBlock> gather_blocks(const Scene& scene, const RefUnitSpace& space,
                                    const std::vector<std::uint32_t>& order) {
    std::vector<RefBlock> blocks(order.size() / ref_block_size);
    tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t i) {
        for (int lane = 0; lane < ref_block_size; ++lane) {
            const std::uint32_t primitive = order[i * ref_block_size + lane];
            blocks[i].primitive[lane] = primitive;
            for (int v = 0; v < 3; ++v) {
                const glm::dvec3 p = space(scene.vertices[scene.triangles[primitive].vertex[v]]);
                for (int k = 0; k < 3; ++k) blocks[i].vertex[v][k][lane] = p[k];
            }
        }
    });
    return blocks;
}

std::vector<RefSphere> all_spheres(const Scene& scene, const RefUnitSpace& space) {
    std::vector<RefSphere> spheres;
    for (const std::uint32_t i : distinct_spheres(scene)) {
        const Sphere& s = scene.spheres[i];
        spheres.push_back({space(s.centre), s.radius * space.scale,
                           static_cast<std::uint32_t>(scene.triangles.size() + i),
                           scene.materials[s.material].transmit > 0});
    }
    return spheres;
}

/// Returns the bounds of spheres. `primitive` is the index in `spheres`.
std::vector<RefBox> sphere_boxes(const std::vector<RefSphere>& spheres) {
    std::vector<RefBox> boxes(spheres.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            boxes[i].lo[k] = float_below(spheres[i].centre[k] - spheres[i].radius);
            boxes[i].hi[k] = float_above(spheres[i].centre[k] + spheres[i].radius);
        }
        boxes[i].primitive = static_cast<std::uint32_t>(i);
    }
    return boxes;
}

/// Returns the closest hit, or `best` if no hit precedes it. Visits the nearest child first. test(block,
/// best) keeps the closer hit, and the search ends once one is nearer than `enough`. It skips a box only if
/// the box begins beyond the closest hit. The result is the smallest (depth, primitive) of all hits, so it
/// does not depend on the order of the visits.
template <class Test, class AtNode>
[[gnu::always_inline]] inline RefClosest search(const std::vector<RefNode>& nodes, const RefRay& ray,
                                                RefClosest best, double enough, const Test& test,
                                                const AtNode& at_node) {
    struct Entry {
        std::uint32_t child, blocks;
        float near;
    };
    Entry stack[ref_stack_size];
    stack[0] = {0, 0, 0};
    int top = nodes.empty() ? 0 : 1;
    float limit = float_above(best.depth) * slab_margin;
    while (top > 0) {
        const Entry entry = stack[--top];
        if (entry.near > limit) continue;
        if (entry.blocks == 0) {
            const RefNode& node = nodes[entry.child];
            at_node();
            RefFloat4 near;
            int entered = boxes_entered(node, ray, limit, near);
            const int base = top;
            for (; entered != 0; entered &= entered - 1) {
                const int i = std::countr_zero(static_cast<unsigned>(entered));
                int place = top++;
                for (; place > base && stack[place - 1].near < near[i]; --place)
                    stack[place] = stack[place - 1];
                stack[place] = {node.child[i], node.blocks[i], near[i]};
            }
        } else {
            for (std::uint32_t i = 0; i < entry.blocks; ++i) test(entry.child + i, best);
            if (best.depth < enough) return best;
            limit = float_above(best.depth) * slab_margin;
        }
    }
    return best;
}

}   // namespace

RefGeometry::RefGeometry(const Scene& scene) : space_(scene) {
    std::vector<RefBox> boxes = triangle_boxes(scene, space_);
    RefHierarchy hierarchy = build_hierarchy(boxes);
    nodes_ = std::move(hierarchy.nodes);
    blocks_ = gather_blocks(scene, space_, hierarchy.order);

    const std::vector<RefSphere> spheres = all_spheres(scene, space_);
    boxes = sphere_boxes(spheres);
    hierarchy = build_hierarchy(boxes);
    sphere_nodes_ = std::move(hierarchy.nodes);
    for (const std::uint32_t i : hierarchy.order) spheres_.push_back(spheres[i]);

    const auto first_plane = static_cast<std::uint32_t>(scene.triangles.size() + scene.spheres.size());
    for (const std::uint32_t i : distinct_planes(scene))
        planes_.emplace_back(scene.planes[i], space_, first_plane + i);
}

namespace {

/// Returns a block with one triangle in all lanes.
RefBlock only_lane(const RefBlock& block, int lane) {
    RefBlock one = block;
    for (int other = 0; other < ref_block_size; ++other) {
        one.primitive[other] = block.primitive[lane];
        for (int v = 0; v < 3; ++v)
            for (int k = 0; k < 3; ++k) one.vertex[v][k][other] = block.vertex[v][k][lane];
    }
    return one;
}

/// Replaces RefEffort in searches that count nothing.
struct NotCounted {
    struct Count {
        void operator+=(std::uint64_t) {}
    } boxes, tests;
};

}   // namespace

/// Finds the closest hit of all kinds of primitives. Both functions are inlined, so that closest-hit searches
/// do not compare with `enough`.
template <class Effort>
[[gnu::always_inline]] inline RefClosest RefGeometry::closest_of_all(const RefPath& path, const RefRay& ray,
                                                                     const RefClosest& limit, double enough,
                                                                     Effort effort) const {
    const RefBlock* blocks = blocks_.data();
    const std::uint32_t start = path.left;
    const RefClosest best = search(
        nodes_, ray, limit, enough,
        [&](std::uint32_t block, RefClosest& b) {
            effort.tests += ref_block_size;
            test_block(blocks[block], ray, b, start);
        },
        [&] { effort.boxes += std::size(RefNode{}.child); });
    if (best.depth < enough || (planes_.empty() && spheres_.empty())) return best;
    return closest_round<Effort>(path, ray, best, enough, effort);
}

template <class Effort>
[[gnu::noinline]] RefClosest RefGeometry::closest_round(const RefPath& path, const RefRay& ray,
                                                        RefClosest best, double enough, Effort effort) const {
    for (const RefPlane& plane : planes_) test_plane(plane, path, best);
    effort.tests += planes_.size();
    if (best.depth < enough) return best;
    return search(
        sphere_nodes_, ray, best, enough,
        [&](std::uint32_t block, RefClosest& b) {
            effort.tests += ref_block_size;
            for (int lane = 0; lane < ref_block_size; ++lane)
                test_sphere(spheres_[block * ref_block_size + lane], path, b);
        },
        [&] { effort.boxes += std::size(RefNode{}.child); });
}

RefClosest RefGeometry::closest(const RefPath& path, const RefRay& ray) const {
    return closest_of_all(path, ray, {}, 0, NotCounted{});
}

bool RefGeometry::is_blocked(const RefPath& path, double distance) const {
    // Primitive 0: a hit at exactly this distance does not count.
    const RefClosest limit{.depth = distance, .primitive = 0};
    if (effort_) return watched(path, limit, distance).depth < distance;
    const RefRay ray(path.from, path.direction);
    return closest_of_all(path, ray, limit, distance, NotCounted{}).depth < distance;
}

RefClosest RefGeometry::only(const RefPath& path, std::uint32_t primitive) const {
    const RefRay ray(path.from, path.direction);
    RefClosest found;
    for (const RefBlock& block : blocks_)
        for (int lane = 0; lane < ref_block_size; ++lane)
            if (block.primitive[lane] == primitive) test_block(only_lane(block, lane), ray, found, path.left);
    for (const RefPlane& plane : planes_)
        if (plane.primitive == primitive) test_plane(plane, path, found);
    for (const RefSphere& sphere : spheres_)
        if (sphere.primitive == primitive) test_sphere(sphere, path, found);
    return found;
}

std::vector<RefClosest> RefGeometry::hits_before(
    const RefPath& path, double distance, const std::function<bool(const RefClosest&)>& is_last) const {
    const RefClosest limit{.depth = distance, .primitive = 0};
    const RefRay ray(path.from, path.direction);
    std::vector<RefClosest> found;
    bool ends = false;
    const auto keep = [&](const RefClosest& one) {
        const auto is_same = [&](const RefClosest& other) { return other.primitive == one.primitive; };
        if (ends || !(one.depth < distance) || std::any_of(found.begin(), found.end(), is_same)) return;
        found.push_back(one);
        ends = is_last && is_last(one);
    };
    // The last hit ends a search: nothing is nearer than 0.
    const auto end_if_last = [&](RefClosest& best) {
        if (ends) best.depth = 0;
    };
    search(
        nodes_, ray, limit, distance,
        [&](std::uint32_t block, RefClosest& best) {
            for (int lane = 0; lane < ref_block_size && !ends; ++lane) {
                RefClosest one = limit;
                test_block(only_lane(blocks_[block], lane), ray, one, path.left);
                keep(one);
            }
            end_if_last(best);
        },
        [] {});
    for (const RefPlane& plane : planes_) {
        RefClosest one = limit;
        test_plane(plane, path, one);
        keep(one);
    }
    if (ends) return found;
    search(
        sphere_nodes_, ray, limit, distance,
        [&](std::uint32_t block, RefClosest& best) {
            for (int lane = 0; lane < ref_block_size; ++lane) {
                RefClosest one = limit;
                test_sphere(spheres_[block * ref_block_size + lane], path, one);
                keep(one);
            }
            end_if_last(best);
        },
        [] {});
    return found;
}

std::vector<std::uint32_t> RefGeometry::blockers(const RefPath& path, double distance) const {
    std::vector<std::uint32_t> numbers;
    for (const RefClosest& hit : hits_before(path, distance)) numbers.push_back(hit.primitive);
    return numbers;
}

RefClosest RefGeometry::watched(const RefPath& path, const RefClosest& limit, double enough) const {
    const Stopwatch watch;
    const RefRay ray(path.from, path.direction);
    const RefClosest best = effort_->tests_all
                                ? test_all(path, ray, limit, enough)
                                : closest_of_all<RefEffort&>(path, ray, limit, enough, *effort_);
    effort_->seconds += watch.seconds();
    ++effort_->rays;
    return best;
}

RefClosest RefGeometry::test_all(const RefPath& path, const RefRay& ray, RefClosest best,
                                 double enough) const {
    for (const RefBlock& block : blocks_) {
        test_block(block, ray, best, path.left);
        effort_->tests += ref_block_size;
        if (best.depth < enough) return best;
    }
    for (const RefPlane& plane : planes_) {
        test_plane(plane, path, best);
        ++effort_->tests;
        if (best.depth < enough) return best;
    }
    for (const RefSphere& sphere : spheres_) {
        test_sphere(sphere, path, best);
        ++effort_->tests;
        if (best.depth < enough) return best;
    }
    return best;
}

}   // namespace rayclock
