// Embree 3.13 as a second opinion on the built-in scenes. It computes in single precision, so its rounding
// must explain every pixel where it disagrees.
#include <catch2/catch.hpp>

#include "sim/judge/reference/instances.hpp"
#include "sim/judge/reference/reference.hpp"
#include "model/scene/builtin.hpp"
#include "tests/reference/embree_scene.hpp"
#include "tests/reference/oracle.hpp"

using namespace rayclock;

namespace {

const FrameSize size{256, 192};

/// Returns the largest error of Embree's view of a ray and a triangle, as a length in the scene. d is the
/// distance of the triangle's farthest corner. One rounding is 2^-24 relative. Origin and vertices are
/// rounded once (o and o + d), the direction once (d). Then its Pluecker test translates, subtracts vertices
/// and sums three products of differences: about 8 roundings of at most d. Twice the sum leaves room.
long double embree_error(const Scene& scene, std::uint32_t primitive, const glm::dvec3& origin) {
    long double d = 0;
    for (const std::uint32_t v : scene.triangles[primitive].vertex)
        d = std::max<long double>(d, glm::length(scene.vertices[v] - origin));
    const long double o = glm::length(origin);
    return 2 * 0x1p-24L * (o + (o + d) + d + 8 * d);
}

struct Counts {
    int disputed = 0;      ///< another primitive, explained
    int unexplained = 0;   ///< another primitive, not explained
    int wrong_depth = 0;   ///< same primitive, depth beyond the bound
    int hits = 0;
};

struct Judge {
    const Scene& scene;
    glm::dvec3 origin, direction;
    PlaneHit plane(std::uint32_t primitive) const { return plane_hit(scene, primitive, origin, direction); }

    /// Returns true if the ray passes so close to an edge of the triangle that Embree cannot decide the side.
    bool at_edge(std::uint32_t primitive) const {
        return distance_to_edges(scene, primitive, origin, direction) <=
               embree_error(scene, primitive, origin);
    }
    /// A shift across the ray changes the plane's depth by the tangent of its slope.
    long double depth_error(std::uint32_t primitive) const {
        return embree_error(scene, primitive, origin) / plane(primitive).cosine;
    }

    /// Returns true if rounding explains the difference. Either the depths are equal within rounding and one
    /// triangle is met or nearly met. Or the nearer one is met or missed only by rounding at its edge.
    bool explains(std::uint32_t ours, std::uint32_t theirs) const {
        if (ours == no_primitive || theirs == no_primitive)
            return at_edge(ours == no_primitive ? theirs : ours);
        const PlaneHit a = plane(ours), b = plane(theirs);
        const bool a_met = a.crosses && (a.inside >= 0 || at_edge(ours));
        const bool b_met = b.crosses && (b.inside >= 0 || at_edge(theirs));
        if (a_met && b_met && std::abs(a.depth - b.depth) <= depth_error(ours) + depth_error(theirs))
            return true;
        return at_edge(a.depth < b.depth ? ours : theirs);
    }
};

/// `scene` is flat; `ours` and `theirs` use the numbers of its primitives.
template <class Ours, class Theirs>
Counts compare_with_embree(const Scene& scene, const Ours& ours_of, const Theirs& embree) {
    const Camera camera = scene.camera ? *scene.camera : fit_camera(scene, 256.0 / 192.0);
    const PixelRays rays = pixel_rays(camera, size);
    Counts counts;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Judge judge{scene, rays.eye, glm::normalize(rays.direction(x, y))};
            const Hit ours = ours_of.trace(judge.origin, judge.direction);
            const Hit theirs = embree.trace(judge.origin, judge.direction);
            counts.hits += ours.primitive != no_primitive;
            if (ours.primitive != theirs.primitive) {
                const bool explained = judge.explains(ours.primitive, theirs.primitive);
                ++(explained ? counts.disputed : counts.unexplained);
                if (!explained)
                    UNSCOPED_INFO("pixel " << x << ", " << y << ": " << ours.primitive << " at " << ours.depth
                                           << ", embree " << theirs.primitive << " at " << theirs.depth);
            } else if (ours.primitive != no_primitive) {
                const long double bound = judge.depth_error(ours.primitive);
                counts.wrong_depth += std::abs(static_cast<long double>(ours.depth) - theirs.depth) > bound;
            }
        }
    return counts;
}

void check(const std::string& spec, const Counts& counts) {
    WARN(spec << ": " << counts.hits << " of " << size.width * size.height << " pixels hit, "
              << counts.disputed << " disputed at edges or equal depth");
    CHECK(counts.unexplained == 0);
    CHECK(counts.wrong_depth == 0);
    CHECK(counts.hits > size.width * size.height / 20);
    // An explanation of many pixels would explain nothing: rounding is 1e-6, a pixel 1e-2 of the picture.
    CHECK(counts.disputed <= size.width * size.height / 500);
}

}   // namespace

TEST_CASE("Embree finds the same primitives, except for its rounding", "[reference][embree]") {
    const auto spec = GENERATE(as<std::string>{}, "tetra:6", "mount:6", "gears:2", "balls:2", "teapot:6",
                               "rings:2", "tree:4", "icosphere:4", "cornell");
    const Scene scene = make_builtin(spec);
    check(spec, compare_with_embree(scene, Reference(scene), EmbreeScene(scene, RTC_SCENE_FLAG_ROBUST)));
}

// Embree transforms origin and direction into an instance's space in single precision. The bound above has
// room for these few roundings.
TEST_CASE("Embree's instances are hit as ours are, except for its rounding", "[reference][embree][placed]") {
    const auto spec = GENERATE(as<std::string>{}, "gearbox:2", "flake:2", "boughs:4", "clockwork:4",
                               "crowd:3", "flight:20");
    PlacedScene placed = make_placed(spec);
    if (!placed.motion.empty()) pose(placed, 0.7);
    const Scene flat = flat_copy(placed);
    check(spec, compare_with_embree(flat, RefInstances(placed), EmbreeInstances(placed)));
}
