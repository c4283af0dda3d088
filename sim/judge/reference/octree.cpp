// Building the octree, and the recursive traversal of its leaves.
#include "sim/judge/reference/octree.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace rayclock {

namespace {

constexpr double thin = 0.02, around_root = 0.001;   // in the scene's units

using Corners = std::array<glm::dvec3, 3>;

Corners corners_of(const Scene& scene, const Triangle& t) {
    return {scene.vertices[t.vertex[0]], scene.vertices[t.vertex[1]], scene.vertices[t.vertex[2]]};
}

/// Returns true if two triangles are halves of a parallelogram: three corners of one and the fourth of the
/// other.
bool are_halves(const Corners& a, const Corners& b) {
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const glm::dvec3 &p = a[(i + 1) % 3], &q = a[(i + 2) % 3];   // the diagonal, opposite a[i]
            if (b[(j + 2) % 3] != p || b[(j + 1) % 3] != q) continue;
            return glm::length(a[i] + b[j] - p - q) <= 1e-12 * glm::length(p - q);
        }
    return false;
}

glm::dvec3 across(const Corners& c) { return glm::cross(c[1] - c[0], c[2] - c[0]); }

/// Returns true if a triangle may belong to the same polygon as another: it lies in the same plane and faces
/// the same side.
bool is_in_plane(const Corners& a, const Corners& b) {
    const glm::dvec3 n = across(a);
    if (!(glm::dot(n, across(b)) > 0)) return false;
    return std::all_of(b.begin(), b.end(), [&](const glm::dvec3& p) {
        return std::abs(glm::dot(n, p - a[0])) <= 1e-9 * glm::length(n) * glm::length(p - a[0]);
    });
}

/// Polygons in scenes without vertex normals: consecutive triangles in one plane that are connected by edges.
class FlatPolygons {
public:
    explicit FlatPolygons(const Scene& scene) : scene_(scene), of_(scene.triangles.size()) {
        std::iota(of_.begin(), of_.end(), 0);
        for (std::uint32_t first = 0, end = 0; first < of_.size(); first = end) {
            const Corners plane = corners_of(scene, scene.triangles[first]);
            for (end = first + 1; end < of_.size(); ++end)
                if (scene.triangles[end].material != scene.triangles[first].material ||
                    !is_in_plane(plane, corners_of(scene, scene.triangles[end])))
                    break;
            connect(first, end);
        }
    }
    /// Returns the first triangle of the polygon.
    std::uint32_t of(std::uint32_t triangle) const {
        while (of_[triangle] != triangle) triangle = of_[triangle];
        return triangle;
    }

private:
    void connect(std::uint32_t first, std::uint32_t end) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> edges;
        for (std::uint32_t i = first; i < end; ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto [a, b] =
                    std::minmax(scene_.triangles[i].vertex[k], scene_.triangles[i].vertex[(k + 1) % 3]);
                const auto [edge, is_new] = edges.try_emplace({a, b}, i);
                if (is_new) continue;
                const std::uint32_t one = of(edge->second), other = of(i);
                of_[std::max(one, other)] = std::min(one, other);
            }
    }

    const Scene& scene_;
    std::vector<std::uint32_t> of_;   ///< an earlier triangle of the same polygon, or itself
};

}   // namespace

RefOctree::RefOctree(const Scene& scene, int depth) {
    add_objects(scene);
    root_ = boxes_.at(0);
    std::vector<std::uint32_t> all(boxes_.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) {
        all[i] = i;
        root_ = {glm::min(root_.lo, boxes_[i].lo), glm::max(root_.hi, boxes_[i].hi)};
    }
    root_ = {root_.lo - around_root, root_.hi + around_root};
    nodes_.emplace_back();
    build(0, root_, all, depth);
}

void RefOctree::add_objects(const Scene& scene) {
    if (scene.normals.empty())
        add_flat_objects(scene);
    else
        add_smooth_objects(scene);
    for (Box& box : boxes_)
        for (int k = 0; k < 3; ++k)
            if (box.hi[k] - box.lo[k] < thin) box.lo[k] -= thin, box.hi[k] += thin;
    for (const Sphere& s : scene.spheres) {
        object_of_.push_back(std::uint32_t(boxes_.size()));
        boxes_.push_back({s.centre - s.radius, s.centre + s.radius});
    }
}

void RefOctree::add_flat_objects(const Scene& scene) {
    const FlatPolygons polygons(scene);
    for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
        const std::uint32_t first = polygons.of(i);
        const Corners corners = corners_of(scene, scene.triangles[i]);
        object_of_.push_back(first == i ? std::uint32_t(boxes_.size()) : object_of_[first]);
        if (first == i) boxes_.push_back({corners[0], corners[0]});
        boxes_[object_of_[i]].add(corners);
    }
}

void RefOctree::add_smooth_objects(const Scene& scene) {
    bool is_whole = true;   // the previous triangle is not the first half of a parallelogram
    Corners before{};
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        const Corners corners = corners_of(scene, scene.triangles[i]);
        const bool goes_on = i > 0 && !is_whole &&
                             scene.triangles[i].material == scene.triangles[i - 1].material &&
                             are_halves(before, corners);
        if (!goes_on) boxes_.push_back({corners[0], corners[0]});
        boxes_.back().add(corners);
        object_of_.push_back(std::uint32_t(boxes_.size() - 1));
        is_whole = goes_on;
        before = corners;
    }
}

void RefOctree::build(std::uint32_t node, const Box& box, const std::vector<std::uint32_t>& objects,
                      int depth) {
    if (objects.size() <= 1 || depth == 0) {
        nodes_[node].objects = std::uint32_t(objects.size());
        nodes_[node].list = lists_.size();
        lists_.insert(lists_.end(), objects.begin(), objects.end());
        ++size_.leaves;
        size_.empty += objects.empty();
        size_.references += objects.size();
        return;
    }
    ++size_.inner;
    const auto first = std::uint32_t(nodes_.size());
    nodes_[node].first = first;
    nodes_.resize(nodes_.size() + 8);
    const glm::dvec3 middle = 0.5 * (box.lo + box.hi);
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
        Box part = box;
        for (int k = 0; k < 3; ++k) (octant >> k & 1 ? part.lo : part.hi)[k] = middle[k];
        std::vector<std::uint32_t> inside;
        for (const std::uint32_t o : objects)
            if (glm::all(glm::lessThanEqual(boxes_[o].lo, part.hi)) &&
                glm::all(glm::greaterThanEqual(boxes_[o].hi, part.lo)))
                inside.push_back(o);
        build(first + octant, part, inside, depth - 1);
    }
}

void RefOctree::walk(const glm::dvec3& from, const glm::dvec3& direction, double reach, OctreeWork& work,
                     const std::vector<std::uint32_t>& blockers) const {
    ++work.rays;
    double begin = 0, end = reach;
    for (int k = 0; k < 3; ++k) {
        if (direction[k] == 0) {
            if (from[k] < root_.lo[k] || from[k] > root_.hi[k]) return;
            continue;
        }
        const double a = (root_.lo[k] - from[k]) / direction[k], b = (root_.hi[k] - from[k]) / direction[k];
        begin = std::max(begin, std::min(a, b));
        end = std::min(end, std::max(a, b));
    }
    std::vector<std::uint32_t> objects;
    for (const std::uint32_t primitive : blockers) objects.push_back(object_of_.at(primitive));
    if (begin <= end) visit({from, direction, objects, work}, 0, root_, begin, end);
}

/// Visits a node. Returns true if the ray ends there.
bool RefOctree::visit(const Way& way, std::uint32_t node, const Box& box, double begin, double end) const {
    if (nodes_[node].first > 0) return halve(way, nodes_[node].first, box, 0, begin, end);
    const std::uint32_t objects = nodes_[node].objects;
    const std::uint32_t* list = lists_.data() + nodes_[node].list;
    // Index of the last tested object in the list. It is `objects` if none ends the ray.
    std::uint32_t last = objects;
    for (const std::uint32_t blocker : way.blockers) {
        const std::uint32_t* at = std::lower_bound(list, list + objects, blocker);
        if (at != list + objects && *at == blocker) last = std::min(last, std::uint32_t(at - list));
    }
    const bool ends = last < objects;
    ++way.work.leaves;
    way.work.empty += objects == 0;
    way.work.tests += ends ? last + 1 : objects;
    return ends;
}

/// Traces the part begin..end of a ray through a box that is still to be halved on `axis` and the axes after
/// it. Returns true if the ray ends there.
bool RefOctree::halve(const Way& way, std::uint32_t octant, const Box& box, int axis, double begin,
                      double end) const {
    if (axis == 3) return visit(way, octant, box, begin, end);
    const double middle = 0.5 * (box.lo[axis] + box.hi[axis]);
    Box half[2] = {box, box};
    half[0].hi[axis] = half[1].lo[axis] = middle;
    const double d = way.direction[axis], ahead = middle - way.from[axis];
    const double at = d == 0 ? HUGE_VAL : ahead / d;
    const auto go = [&](int side, double from, double to) {
        return halve(way, octant + (std::uint32_t(side) << axis), half[side], axis + 1, from, to);
    };
    // The side on which the part begins.
    const int first = d == 0 || at > begin ? (d == 0 ? ahead <= 0 : d < 0) : d > 0;
    if (d == 0 || at <= begin || at >= end) return go(first, begin, end);
    return go(first, begin, at) || go(1 - first, at, end);
}

}   // namespace rayclock
