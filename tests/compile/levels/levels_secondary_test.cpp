// Secondary rays of two levels. Inside the instance that a ray leaves it starts exactly on its triangle, so
// no surface shadows itself and no light leaks. No box of the scene's tree hides a primitive that a ray
// meets.
#include <map>

#include <catch2/catch.hpp>

#include "model/compile/levels/levels.hpp"
#include "model/engine/check.hpp"
#include "model/base/error.hpp"
#include "model/unit/tri/any_primitive.hpp"
#include "sim/judge/oracle/visibility.hpp"
#include "model/unit/raygen/raygen.hpp"
#include "model/unit/shade/bounce/bounce.hpp"
#include "model/fixed/rounding.hpp"
#include "model/unit/shade/light/light.hpp"
#include "model/unit/shade/surface/surf.hpp"
#include "model/fixed/unit_vector.hpp"
#include "tests/support/levels/walk.hpp"
#include "tests/compile/aim.hpp"
#include "tests/support/levels/closed_instances.hpp"

namespace rayclock::test::levels_secondary_test {

using namespace rayclock;
using oracle::Visibility;
using rayclock::Draw;   // not the one of the support

namespace {

struct Format {
    int coord_bits, dir_bits, origin_bits;
};
constexpr Format formats[] = {{12, 12, 10}, {12, 24, 12}, {14, 18, 12}, {18, 20, 12}, {20, 18, 10}};

Config shaded(const Format& f, Structure structure = Structure::bvh) {
    Config config = of_structure(format(f.coord_bits, f.dir_bits), structure);
    config.shading = 1, config.levels = 2, config.origin_bits = f.origin_bits;
    check_config(config, "the test");
    return config;
}

/// A compiled scene, and the hits of rays in it.
class World {
public:
    World(const PlacedScene& scene, const glm::dvec3& eye, const Config& config)
        : config_(config),
          levels_(compile_levels(scene, eye, config)),
          decoder_(levels_.image, config),
          walk_(frame_, decoder_, config) {
        for (std::uint32_t line = 0; line < levels_.image.first_surface_line; ++line)
            if (line_kind(levels_.image.line(line)) == LineKind::placement)
                if (const auto p = unpack<Placement>(levels_.image.line(line), config); p.here == line)
                    placements_.push_back(p);           // skip copies
        std::map<std::uint32_t, std::size_t> numbers;   // of instances, by their first primitive
        std::uint32_t first = 0;
        for (std::size_t i = 0; i < scene.instances.size(); ++i) {
            numbers[first] = i;
            first += std::uint32_t(scene.meshes[scene.instances[i].mesh].triangles.size());
        }
        for (const Placement& p : placements_) {
            instances_.push_back(numbers.at(p.first));
            meshes_.emplace_back();
            gather(p.root, meshes_.back());
            const auto by_number = [](const PrimData& a, const PrimData& b) { return a.prim < b.prim; };
            std::vector<PrimData>& mesh = meshes_.back();
            std::stable_sort(mesh.begin(), mesh.end(), by_number);   // cells may share a triangle
            mesh.erase(std::unique(mesh.begin(), mesh.end(),
                                   [](const PrimData& a, const PrimData& b) { return a.prim == b.prim; }),
                       mesh.end());
        }
    }

    const LevelsImage& levels() const { return levels_; }
    const std::vector<Placement>& placements() const { return placements_; }
    const std::vector<PrimData>& mesh(std::size_t instance) const { return meshes_[instance]; }
    Closest trace(const Ray& ray) { return walk_.trace(ray); }

    /// Tests every triangle of every instance, without a tree. Counts crossings whose point on the scene's
    /// ray is not in the instance's box.
    Closest answer_of(const Ray& ray, std::uint64_t& outside) const {
        BestHit best({0, ray.kind}, t_max_of(ray.kind, config_));
        for (std::size_t i = 0; i < placements_.size(); ++i) {
            const Change in = xform({0, ray.o, ray.d, placements_[i], ray.kind, ray.home}, config_);
            Ray moved;
            moved.kind = ray.kind, moved.o = in.o, moved.d = in.d;
            for (PrimData prim : meshes_[i]) {
                TriRsp tri;
                prim.prim += in.first;
                any_primitive_test(moved, prim, {}, config_, tri);
                if (tri.closer && tri.det > 0)
                    outside += !is_in_box(i, ray, double(tri.num) / double(tri.det));
                any_primitive_test(moved, prim, best.best(), config_, tri);
                best.take(tri, in.here);
                if (best.stop()) return best.closest();
            }
        }
        return best.closest();
    }

    /// Returns shade's state after a hit.
    ShadeState surface_of(const Ray& ray, const Closest& hit, PassIn& in) const {
        in.hit = hit, in.o = ray.o, in.d = ray.d;
        in.placement = unpack<Placement>(levels_.image.line(hit.instance_line), config_);
        const std::uint32_t line =
            (in.placement.first_surface_line + hit.prim) & ((1u << config_.addr_bits) - 1);
        in.surface = unpack<Surface>(levels_.image.line(line), config_);
        ShadeState state = fresh_state(0, 0);
        surf(in, config_, state);
        transform_surface(in, config_, state);
        return state;
    }

private:
    bool is_in_box(std::size_t placement, const Ray& ray, double t) const {
        const LatticeBox& box = levels_.maps.instances[instances_[placement]].box;
        bool is_inside = true;
        for (std::size_t k = 0; k < 3; ++k) {
            const double x = std::ldexp(double(ray.o[k]), -config_.origin_bits) + t * ray.d[k];
            is_inside = is_inside && box.lo[k] - 1e-6 <= x && x <= box.hi[k] + 1e-6;
        }
        return is_inside;
    }

    void gather(std::uint32_t line, std::vector<PrimData>& prims) const {
        const WideNode& node = decoder_.below(line);
        for (std::uint32_t i = 0; i < node.children; ++i) {
            if (node.inner_mask >> i & 1) {
                gather(node.base + i, prims);
                continue;
            }
            for (std::uint32_t k = 0; k < node.count[i]; ++k)
                prims.push_back(decoder_.prim(2 * node.base + node.offset[i] + k));
        }
    }

    const Config config_;
    const Frame frame_{};
    const LevelsImage levels_;
    const Decoder decoder_;
    LevelWalk walk_;
    std::vector<Placement> placements_;
    std::vector<std::size_t> instances_;   // their numbers
    std::vector<std::vector<PrimData>> meshes_;
};

int side_of(const Vec3l& n, const Vec3i& d) {
    const Int128 dot = Int128(n[0]) * d[0] + Int128(n[1]) * d[1] + Int128(n[2]) * d[2];
    return dot > 0 ? 1 : dot < 0 ? -1 : 0;
}

/// Judges the path in the mesh's space with the instance's own triangles.
Visibility::Answer truth(const std::vector<PrimData>& mesh, std::uint32_t own, int facing,
                         const oracle::Path& path) {
    const auto corners = [](const PrimData& p) { return oracle::Corners{p.a, p.b, p.c}; };
    const auto home =
        std::find_if(mesh.begin(), mesh.end(), [&](const PrimData& p) { return p.prim == own; });
    REQUIRE(home != mesh.end());
    REQUIRE(oracle::in_plane(path.from, corners(*home)));
    Visibility visibility(path, corners(*home), facing);
    for (const PrimData& prim : mesh)
        if (!visibility.add(corners(prim))) break;
    return visibility.answer();
}

struct Tally {
    std::uint64_t ways = 0, blocked = 0, wrong_free = 0, wrong_blocked = 0, either = 0;
    void add(bool is_blocked, Visibility::Answer right) {
        ++ways, blocked += is_blocked;
        either += right == Visibility::Answer::either;
        wrong_free += !is_blocked && right == Visibility::Answer::blocked;
        wrong_blocked += is_blocked && right == Visibility::Answer::free;
    }
};

/// Shoots shadow rays and bounces from one instance.
void try_instance(World& world, const PlacedScene& scene, const Vec3i& eye, int rays, std::uint32_t seed,
                  const Config& config, Tally& shadows, Tally& bounces, std::uint64_t& wrong_sides) {
    Aim aim(scene, world.levels().image.lattice, config, seed);
    for (int i = 0; i < rays; ++i) {
        const Ray ray = aim.camera_ray(eye);
        const Closest hit = world.trace(ray);
        if (!hit.found) continue;
        PassIn in;
        ShadeState state = world.surface_of(ray, hit, in);
        oracle::RationalPoint point;
        for (std::size_t k = 0; k < 3; ++k) point.num[k] = oracle::Int128(state.inner[k]);
        point.den = oracle::Int128(1) << config.origin_bits;
        const std::uint32_t own = hit.prim - in.placement.first;
        const int seen = hit.back ? -1 : 1;
        Frame frame;
        frame.shade.near[0] = 1;
        const Vec3i at = aim.light(state.o);
        std::copy(at.begin(), at.end(), frame.shade.place.begin());
        if (const LightOut out = light(frame, config, state, in.placement); out.counts) {
            Ray way = make_ray(ray_origin(at, config), out.d, config, RayKind::shadow);
            way.home = out.home;
            Vec3i to{};
            for (std::size_t k = 0; k < 3; ++k) to[k] = out.home.o[k] >> config.origin_bits;
            shadows.add(world.trace(way).found, truth(world.mesh(0), own, seen, {point, to, {}}));
        }
        const Vec3i d = aim.direction(state.o);
        const Home home = home_of(state, d, in.placement, config);
        const int side = side_of(state.n, home.d);
        const BounceOut mirrored = reflect(config, state, in.placement);
        wrong_sides += mirrored.goes != (side_of(state.n, mirrored.home.d) > 0);
        if (side == 0) continue;
        Vec3i o{};
        for (std::size_t k = 0; k < 3; ++k) o[k] = std::int32_t(state.o[k]);
        Ray way = make_ray(o, d, config, RayKind::bounce);
        way.home = home;
        bounces.add(world.trace(way).found, truth(world.mesh(0), own, seen * side, {point, {}, home.d}));
    }
}

}   // namespace

TEST_CASE("no instance shadows itself, and none leaks, through random maps", "[levels][secondary]") {
    struct Family {
        const char* name;
        double least, most, shear;
    };
    const Family family = GENERATE(values<Family>({{"alike", 0.5, 0.5, 0},
                                                   {"scaled", 0.02, 3, 0},
                                                   {"sheared", 0.3, 2, 3},
                                                   {"tiny and huge", 1e-3, 1e3, 0},
                                                   {"nearly flat", 0.2, 2, 40}}));
    constexpr int rays = 150;   // for each scene
    Tally shadows, bounces;
    std::uint64_t wrong_sides = 0;
    for (const Format& f : formats) {
        const Config config = shaded(f);
        for (std::uint32_t seed = 1; seed <= 4; ++seed) {
            PlacedScene scene = make_placed("gearbox:1");
            scene.own = solids(0, 1, 1, 1, 0).own;
            Draw draw{seed};
            scene.instances = {{"gear", 0, random_map(draw, family.least, family.most, family.shear), {}}};
            const glm::dvec3 eye{9, 7, 8};
            std::optional<World> world;
            try {
                world.emplace(scene, eye, config);
            } catch (const UserError&) {   // a gear of size 1/1000 vanishes on a coarse lattice
                continue;
            }
            const Vec3i at = world->levels().image.lattice.snap(eye);
            try_instance(*world, scene, at, rays, seed, config, shadows, bounces, wrong_sides);
        }
    }
    CAPTURE(family.name, shadows.ways, shadows.blocked, shadows.either, bounces.ways, bounces.blocked,
            bounces.either);
    CHECK(shadows.ways > 100);
    CHECK(bounces.ways > 300);
    CHECK(bounces.blocked > 30);
    CHECK(wrong_sides == 0);
    CHECK(shadows.wrong_blocked == 0);
    CHECK(shadows.wrong_free == 0);
    CHECK(bounces.wrong_blocked == 0);
    CHECK(bounces.wrong_free == 0);
    CHECK(20 * (shadows.either + bounces.either) <= shadows.ways + bounces.ways);
}

TEST_CASE("no box of the scene's tree hides what a secondary ray meets", "[levels][secondary][long]") {
    const auto [least, most, shear] =
        GENERATE(values<std::tuple<double, double, double>>({{0.5, 0.5, 0}, {0.1, 3, 0}, {0.3, 2, 3}}));
    const Structure structure = GENERATE(from_range(tree_structures()));
    std::uint64_t rays = 0, hits = 0, wrong = 0, shadows = 0, outside = 0;
    for (const Format& f : formats) {
        const Config config = shaded(f, structure);
        const PlacedScene scene = solids(12, 7, least, most, shear);
        const glm::dvec3 eye{9, 7, 8};
        World world(scene, eye, config);
        const Vec3i at = world.levels().image.lattice.snap(eye);
        Aim aim(scene, world.levels().image.lattice, config, 11);
        const auto is_same = [](const Closest& a, const Closest& b) {
            return a.found == b.found && a.prim == b.prim && a.t == b.t && a.instance_line == b.instance_line;
        };
        for (int i = 0; i < 200; ++i) {
            Ray ray = aim.camera_ray(at);
            for (int depth = 0; depth <= config.bounces; ++depth) {
                const Closest hit = world.trace(ray);
                ++rays, hits += hit.found, wrong += !is_same(hit, world.answer_of(ray, outside));
                if (!hit.found) break;
                PassIn in;
                ShadeState state = world.surface_of(ray, hit, in);
                Frame frame;
                frame.shade.near[0] = 1;
                const Vec3i place = aim.light(state.o);
                std::copy(place.begin(), place.end(), frame.shade.place.begin());
                if (const LightOut out = light(frame, config, state, in.placement); out.counts) {
                    Ray way = make_ray(ray_origin(place, config), out.d, config, RayKind::shadow);
                    way.home = out.home;
                    ++shadows, wrong += world.trace(way).found != world.answer_of(way, outside).found;
                }
                const Vec3i d = aim.direction(state.o);
                Vec3i o{};
                for (std::size_t k = 0; k < 3; ++k) o[k] = std::int32_t(state.o[k]);
                ray = make_ray(o, d, config, RayKind::bounce);
                ray.home = home_of(state, d, in.placement, config);
            }
        }
    }
    CAPTURE(rays, hits, shadows);
    CHECK(wrong == 0);
    CHECK(outside == 0);
    CHECK(hits > 300);
    CHECK(shadows > 50);
}

TEST_CASE("a ray's error at the exit of an instance grows with the edges and stays within the instance's box",
          "[levels][secondary]") {
    Config config = shaded({18, 24, 12});
    config.bary_bits = 12, config.bounces = 1;   // only u and v are coarse
    check_config(config, "the test");
    PlacedScene scene;
    scene.own.name = "floor";
    scene.own.materials.emplace_back();
    scene.meshes.push_back({"floor", {{-9, 0, -9}, {-9, 0, 9}, {9, 0, 9}, {9, 0, -9}}, {}, {}});
    scene.meshes[0].triangles = {{{0, 1, 2}, 0}, {{0, 2, 3}, 0}};
    const glm::dmat4 place = glm::rotate(glm::dmat4(1), 0.4, glm::normalize(glm::dvec3(1, 2, 3)));
    scene.instances.push_back({"floor", 0, place, {}});
    const glm::dvec3 eye{3, 9, 4};
    World world(scene, eye, config);
    const InstanceMap& map = world.levels().maps.instances[0];
    Aim aim(scene, world.levels().image.lattice, config, 5);
    double most = 0;
    for (int i = 0; i < 400; ++i) {
        const Ray ray = aim.camera_ray(world.levels().image.lattice.snap(eye));
        const Closest hit = world.trace(ray);
        if (!hit.found) continue;
        PassIn in;
        const ShadeState state = world.surface_of(ray, hit, in);
        for (std::size_t row = 0; row < 3; ++row) {
            double at = std::ldexp(double(map.b[row]), config.origin_bits);
            for (std::size_t k = 0; k < 3; ++k) at += double(map.a[3 * row + k]) * double(state.o[k]);
            const double off = std::ldexp(at, -config.map_frac()) - double(state.inner[row]);
            most = std::max(most, std::abs(std::ldexp(off, -config.origin_bits)));
        }
    }
    CAPTURE(most, map.off);
    CHECK(most > 20);
    CHECK(most <= map.off);
}

}   // namespace rayclock::test::levels_secondary_test
