// Two levels in the model: maps, memory, walk. The judge transforms rays with its own integer arithmetic and
// tests every triangle of every instance with the oracle.
#include <cmath>
#include <deque>

#include <catch2/catch.hpp>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "model/compile/levels/levels.hpp"
#include "model/base/error.hpp"
#include "sim/judge/oracle/surface.hpp"
#include "model/unit/raygen/raygen.hpp"
#include "tests/support/levels/walk.hpp"
#include "tests/support/levels/closed_instances.hpp"

namespace rayclock::test::levels_test {

using namespace rayclock;
using rayclock::Draw;   // not the one of the support

namespace {

__extension__ using Int = __int128;

/// Returns n / 2^frac rounded to the nearest whole number, halves up.
Int nearest(Int n, int frac) {
    const Int unit = Int(1) << frac;
    const Int twice = 2 * n + unit;   // floor((2n + unit) / (2 unit))
    Int quotient = twice / (2 * unit);
    if (twice < 0 && quotient * 2 * unit != twice) --quotient;
    return quotient;
}

Vec3i moved(const InstanceMap& map, const Vec3i& v, bool is_point, int frac) {
    Vec3i out;
    for (std::size_t i = 0; i < 3; ++i) {
        Int sum = is_point ? Int(map.b[i]) : 0;
        for (std::size_t k = 0; k < 3; ++k) sum += Int(map.a[3 * i + k]) * v[k];
        out[i] = std::int32_t(nearest(sum, frac));
    }
    return out;
}

/// The correct closest hit of a ray over all instances, from the oracle in each instance's own space.
class Truth {
public:
    Truth(const PlacedScene& scene, const LevelsImage& levels, const Config& config)
        : levels_(levels), config_(config) {
        std::uint32_t number = 0;
        if (!scene.own.triangles.empty()) {
            firsts_.push_back(0);
            number = std::uint32_t(scene.own.triangles.size());
        }
        for (const Instance& instance : scene.instances) {
            firsts_.push_back(number);
            number += std::uint32_t(scene.meshes[instance.mesh].triangles.size());
        }
        const bool has_own = !scene.own.triangles.empty();
        for (const MeshClass& made : levels.maps.classes) {
            Scene mesh;
            if (has_own && made.mesh == 0) {
                mesh.vertices = scene.own.vertices, mesh.triangles = scene.own.triangles;
            } else {
                const SharedMesh& shared = scene.meshes[made.mesh - has_own];
                mesh.vertices = shared.vertices, mesh.triangles = shared.triangles;
            }
            for (glm::dvec3& v : mesh.vertices) v = glm::dvec3(made.before * glm::dvec4(v, 1));
            surfaces_.emplace_back(oracle::snapped(mesh, made.lattice));
        }
    }

    oracle::ExactHit closest(const Ray& ray) const {
        oracle::ExactHit best;
        for (std::size_t i = 0; i < levels_.maps.instances.size(); ++i) {
            const InstanceMap& map = levels_.maps.instances[i];
            const int frac = config_.coord_bits + 3;
            oracle::ExactHit hit = surfaces_[map.mesh_class].closest(moved(map, ray.o, true, frac),
                                                                     moved(map, ray.d, false, frac));
            if (hit.primitive == no_primitive) continue;
            hit.primitive += firsts_[i];
            if (hit.before(best)) best = hit;
        }
        return best;
    }
    /// Returns crossings inwards minus crossings outwards of one instance: 0 for an origin outside a closed
    /// mesh. Adds to `outside` the crossings whose point on the scene's ray is not in the instance's box.
    int balance(const Ray& ray, std::size_t instance, std::uint64_t& crossings,
                std::uint64_t& outside) const {
        const InstanceMap& map = levels_.maps.instances[instance];
        const int frac = config_.coord_bits + 3;
        const Vec3i o = moved(map, ray.o, true, frac), d = moved(map, ray.d, false, frac);
        int sum = 0;
        std::vector<std::uint32_t> found;
        const oracle::Surface& surface = surfaces_[map.mesh_class];
        surface.candidates(o, d, found);
        for (const std::uint32_t i : found)
            if (const auto hit = oracle::exact_hit(o, d, surface.triangles()[i], i); hit.primitive == i) {
                sum += hit.sense, ++crossings;
                bool is_inside = true;
                for (std::size_t k = 0; k < 3; ++k) {
                    const Int x = Int(ray.o[k]) * hit.den + Int(ray.d[k]) * hit.num;
                    is_inside = is_inside && map.box.lo[k] * hit.den <= x && x <= map.box.hi[k] * hit.den;
                }
                outside += !is_inside;
            }
        return sum;
    }

private:
    const LevelsImage& levels_;
    const Config& config_;
    std::vector<oracle::Surface> surfaces_;   // by class
    std::vector<std::uint32_t> firsts_;
};

/// Draws directions of full length: towards corners and edges of instances, into their boxes, or anywhere.
class Aim {
public:
    Aim(const PlacedScene& scene, const LevelsImage& levels, const Vec3i& o, const Config& config,
        std::uint32_t seed)
        : maps_(levels.maps), o_(o), most_(std::ldexp(1, config.dir_bits - 1) - 1), draw_(seed) {
        const Lattice& lattice = levels.image.lattice;
        for (const Instance& instance : scene.instances)
            for (const glm::dvec3& v : scene.meshes[instance.mesh].vertices)
                corners_.push_back((glm::dvec3(instance.place * glm::dvec4(v, 1)) - lattice.centre) /
                                   lattice.pitch);
    }

    Vec3i operator()() {
        const double kind = draw_();
        const glm::dvec3 corner = corners_[below(corners_.size())], eye(o_[0], o_[1], o_[2]);
        glm::dvec3 d = draw_.point();
        if (kind < 0) {
            d = corner - eye;
        } else if (kind < 0.3) {
            d = glm::mix(corner, corners_[below(corners_.size())], 0.5) - eye;
        } else if (kind < 0.7) {
            const LatticeBox& box = maps_.instances[below(maps_.instances.size())].box;
            for (std::size_t k = 0; k < 3; ++k)
                d[int(k)] = box.lo[k] + (0.5 + 0.5 * draw_()) * (box.hi[k] - box.lo[k]) - o_[k];
        } else if (kind > 0.9) {
            d[int(below(3))] = 0;
        }
        const double largest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z), 1e-9});
        const glm::dvec3 full = d * (most_ * (0.76 + 0.24 * draw_()) / largest);
        const Vec3i out{std::int32_t(full.x), std::int32_t(full.y), std::int32_t(full.z)};
        return out == Vec3i{} ? Vec3i{std::int32_t(most_), 0, 0} : out;
    }

private:
    std::size_t below(std::size_t n) {
        return std::min(n - 1, std::size_t((0.5 + 0.5 * draw_()) * double(n)));
    }

    const LevelMaps& maps_;
    const Vec3i o_;
    const double most_;
    Draw draw_;
    std::vector<glm::dvec3> corners_;   // on the scene's lattice, not rounded
};

struct Tally {
    std::uint64_t rays = 0, hits = 0, wrong = 0, unbalanced = 0, crossings = 0, outside = 0, entered = 0;
};

/// A compiled scene with one structure, and its walk.
struct Machine {
    const Config config;
    const LevelsImage levels;
    const Decoder decoder;
    const Frame frame{};
    LevelWalk walk;
    Machine(const PlacedScene& scene, const glm::dvec3& eye, const Config& config_)
        : config(with_two_levels(config_, "the test")),
          levels(compile_levels(scene, eye, config)),
          decoder(levels.image, config),
          walk(frame, decoder, config) {}
};

/// Judges all structures. Maps do not depend on the structure, so the correct answer is the same for all.
Tally judge(const PlacedScene& scene, const Config& config, const glm::dvec3& eye, int rays,
            std::uint32_t seed) {
    std::deque<Machine> machines;
    for (const Structure structure : tree_structures())
        machines.emplace_back(scene, eye, of_structure(config, structure));
    const LevelsImage& levels = machines[0].levels;
    const Truth truth(scene, levels, config);
    Tally tally;
    const Vec3i o = levels.image.lattice.snap(eye);
    Aim aim(scene, levels, o, config, seed);
    for (int i = 0; i < rays; ++i) {
        const Ray ray = make_ray(o, aim(), config);
        const oracle::ExactHit want = truth.closest(ray);
        ++tally.rays;
        tally.hits += want.primitive != no_primitive;
        for (Machine& machine : machines) {
            const Closest got = machine.walk.trace(ray);
            const Best& best = machine.walk.best();
            tally.wrong += (got.found != 0) != (want.primitive != no_primitive) ||
                           (got.found && (got.prim != want.primitive ||
                                          Int(best.num) * want.den != Int(want.num) * best.det));
        }
        for (std::size_t k = 0; k < levels.maps.instances.size(); ++k)
            tally.unbalanced += truth.balance(ray, k, tally.crossings, tally.outside) != 0;
    }
    for (Machine& machine : machines) tally.entered += machine.walk.counts().changes;
    return tally;
}

}   // namespace

TEST_CASE("rays through random maps find what the oracle finds, in every format and structure",
          "[levels][long]") {
    struct Family {
        const char* name;
        double least, most, shear;
    };
    const Family family = GENERATE(values<Family>({{"alike", 0.5, 0.5, 0},
                                                   {"scaled", 0.02, 3, 0},
                                                   {"sheared", 0.3, 2, 3},
                                                   {"tiny and huge", 1e-3, 1e3, 0},
                                                   {"nearly flat", 0.2, 2, 40}}));
    const auto [coord_bits, dir_bits] =
        GENERATE(values<std::pair<int, int>>({{12, 12}, {12, 24}, {14, 18}, {18, 20}, {20, 18}}));
    CAPTURE(family.name, coord_bits, dir_bits);
    const Config config = format(coord_bits, dir_bits);
    const PlacedScene scene = solids(12, 7, family.least, family.most, family.shear);
    const Tally tally = judge(scene, config, {9, 7, 8}, 1500, 3);
    CAPTURE(tally.hits, tally.crossings, tally.entered);
    CHECK(tally.wrong == 0);
    CHECK(tally.outside == 0);
    CHECK(tally.hits > 50);
    // The eye is outside of instances that are not huge, and closed meshes are watertight.
    if (family.most < 10) CHECK(tally.unbalanced == 0);
}

TEST_CASE("instances that no map places well are written out", "[levels]") {
    const Config config = format(18, 20);
    PlacedScene scene = solids(3, 2, 1, 1, 0);
    glm::dmat4 flat(1);
    flat[1][0] = 3, flat[1][1] = 1e-3, flat[2][0] = -2;
    scene.instances[1].place = flat;
    const LevelsImage levels = compile_levels(scene, {9, 7, 8}, config);
    REQUIRE(levels.maps.classes.size() == 2);
    CHECK(levels.maps.classes[0].before == glm::dmat4(1));
    CHECK(levels.maps.classes[1].before == flat);
    CHECK(levels.maps.instances[1].is_whole);
    CHECK(levels.maps.instances[0].mesh_class == levels.maps.instances[2].mesh_class);
    CHECK(judge(scene, config, {9, 7, 8}, 500, 1).wrong == 0);
}

TEST_CASE("instances of one size share a lower structure, however they are turned", "[levels]") {
    const Config config = format(18, 20);
    PlacedScene scene;
    scene.own.materials.emplace_back();
    scene.meshes.push_back(cube());
    Draw draw{4};
    for (int i = 0; i < 30; ++i) scene.instances.push_back({"", 0, random_map(draw, 0.7, 0.7, 0), {}});
    CHECK(compile_levels(scene, {9, 7, 8}, config).maps.classes.size() == 1);
    for (int i = 0; i < 30; ++i) {
        glm::dmat4& place = scene.instances[std::size_t(i)].place;
        place = place * glm::scale(glm::dmat4(1), glm::dvec3(i % 2 == 0 ? 1.0 : 0.1));
    }
    CHECK(compile_levels(scene, {9, 7, 8}, config).maps.classes.size() == 2);
}

}   // namespace rayclock::test::levels_test
