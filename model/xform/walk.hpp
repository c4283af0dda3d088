#pragma once
// A ray's walk through two levels: TreeWalk, as everywhere, where the line of an instance is a node with one
// child, the root of its mesh, which every ray meets at once.
#include "model/bvh/walk.hpp"
#include "model/isect/primitive.hpp"
#include "model/trace/decoder.hpp"
#include "model/xform/xform.hpp"

namespace rayclock {

/// How a ray meets nodes, instances and primitives. In which space a node lies is said by its line, not by
/// what the ray did before: a ray that comes back from an instance needs nothing to be put right.
struct LevelWay {
    using Order = ByDistance;
    const Config& config;
    const MemoryImage& image;
    const Decoder& decoder;
    TriTest* primitive_test;
    Ray scene{}, mesh{};   ///< the ray as it came, and in the space of the last instance
    BoxRay from_scene{}, from_mesh{};
    std::uint32_t first = 0;   ///< number of that instance's first primitive
    BestHit hit{};
    WideNode entry{};

    void start(const Ray& ray) {
        scene = ray;
        from_scene = box_ray(ray);
        hit = {{ray.ray, ray.kind}, reach_of(RayKind(ray.kind), config)};
    }
    /// The ray changes, and goes on: its best hit and its distance to beat stay.
    const WideNode& enter(const Placement& placement, std::uint32_t* t_near, std::uint32_t& hits) {
        mesh = xform(scene, placement, config);
        from_mesh = box_ray(mesh);
        first = placement.first;
        entry.base = placement.root;
        entry.children = entry.children_mask = entry.inner_mask = 1;
        t_near[0] = 0;
        hits = 1;
        return entry;
    }
    const WideNode& boxes(std::uint32_t line, std::uint32_t* t_near, std::uint32_t& hits) {
        const std::uint32_t* words = image.line(line);
        const LineKind kind = line_kind(words);
        if (kind == LineKind::placement) return enter(unpack<Placement>(words, config), t_near, hits);
        const WideNode& node = decoder.node(line);
        hits = box_children(kind == LineKind::mesh_node ? from_mesh : from_scene, node, config, t_near);
        return node;
    }
    void test(std::uint32_t half_line) {
        PrimData prim = decoder.prim(half_line);
        prim.prim += first;
        TriRsp tri;
        tri.ray = mesh.ray;
        primitive_test(mesh.o, mesh.d, prim, hit.best(), config, tri);
        hit.take(tri);
    }
    std::uint32_t t() const { return hit.t(); }
    bool stop() const { return hit.stop(); }
};

/// What a ray took.
struct LevelCounts {
    std::uint64_t visits = 0, changes = 0, tests = 0;   ///< nodes of both levels; instances; primitives
    LevelCounts& operator+=(const LevelCounts& other) {
        visits += other.visits, changes += other.changes, tests += other.tests;
        return *this;
    }
};

/// Rays, one after the other.
class LevelWalk {
public:
    LevelWalk(const MemoryImage& image, const Decoder& decoder, const Config& config)
        : way_{config, image, decoder, tri_test_of(config)}, stack_(config) {}
    LevelWalk(const LevelWalk&) = delete;

    Closest trace(const Ray& ray) {
        way_.start(ray);
        TreeWalk<LevelWay> walk(way_, stack_, room_);
        walk.run(0, *this);
        return way_.hit.closest();
    }
    const Best& best() const { return way_.hit.best(); }   ///< of the last
    const LevelCounts& counts() const { return counts_; }

    // As a watch of its own walk.
    void visit(const TreeWalk<LevelWay>& walk) {
        const bool is_entry = &walk.node() == &way_.entry;
        counts_.changes += is_entry;
        counts_.visits += !is_entry;
    }
    void test(std::uint32_t) { ++counts_.tests; }
    void decided(std::uint32_t, bool) {}

private:
    LevelWay way_;
    Stack stack_;
    WalkRoom<ByDistance> room_;
    LevelCounts counts_;
};

}   // namespace rayclock
