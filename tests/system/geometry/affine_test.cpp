// Closed surfaces of the hard cases, seen through affine maps: no ray leaks or hits twice, and every decision
// is exact for the ray as rounded for the instance.
#include <catch2/catch.hpp>

#include "model/compile/levels/levels.hpp"
#include "model/base/error.hpp"
#include "model/unit/tri/tri_test.hpp"
#include "tests/support/oracle/fractions.hpp"
#include "sim/judge/oracle/placed.hpp"
#include "sim/judge/oracle/surface.hpp"
#include "model/unit/raygen/raygen.hpp"
#include "tests/support/levels/walk.hpp"
#include "sim/explore/stress/aim.hpp"
#include "tests/support/levels/closed_instances.hpp"

using namespace rayclock;

namespace {

/// The placement of instances: the sizes of the three axes, and their shear.
struct Maps {
    const char* name;
    double least, most, shear;
};
constexpr Maps all_maps[] = {{"turned", 1, 1, 0},
                             {"scaled", 0.02, 3, 0},
                             {"sheared", 0.3, 2, 3},
                             {"a thousandth to a thousand", 1e-3, 1e3, 0},
                             {"nearly flat", 0.2, 2, 40}};
/// N from 12 to 20, with few and with many direction bits.
constexpr std::array<std::pair<int, int>, 6> formats{
    {{12, 12}, {14, 20}, {16, 16}, {18, 20}, {19, 19}, {20, 18}}};

struct Sums {
    std::uint64_t rays = 0, crossings = 0, closed = 0, leaks = 0, doubles = 0, wrong = 0, fractions = 0;
};

/// Converts a mesh of lattice points to a mesh of the scene, of unit size.
SharedMesh shared(const stress::Mesh& mesh, int coord_bits) {
    SharedMesh out{"body", {}, {}, {}};
    for (const oracle::Corners& t : mesh.triangles) {
        const auto first = std::uint32_t(out.vertices.size());
        for (const Vec3i& p : {t.a, t.b, t.c})
            out.vertices.push_back(std::ldexp(1.0, 1 - coord_bits) * glm::dvec3(p[0], p[1], p[2]));
        out.triangles.push_back({{first, first + 1, first + 2}, 0});
    }
    return out;
}

/// One placed body, for the model and for the oracle.
class Body {
public:
    Body(const PlacedScene& scene, const glm::dvec3& eye, const Config& config)
        : config_(config),
          levels_(compile_levels(scene, eye, config)),
          decoder_(levels_.image, config),
          walk_(frame_, decoder_, config),
          eye_(levels_.image.lattice.snap(eye)),
          test_(tri_test_of(config)) {
        const InstanceMap& map = levels_.maps.instances.at(0);
        for (std::size_t i = 0; i < 9; ++i) place_.a[i] = placement_.a[i] = map.a[i];
        for (std::size_t i = 0; i < 3; ++i) place_.b[i] = placement_.b[i] = map.b[i];
        const MeshClass& made = levels_.maps.classes.at(0);
        std::vector<oracle::Solid> solids;
        for (const Triangle& t : scene.meshes[0].triangles) {
            const auto corner = [&](std::size_t k) {
                return snapped_corner(made, scene.meshes[0], t.vertex[k]);
            };
            const bool turned = glm::determinant(glm::dmat3(made.before)) < 0;
            const oracle::Corners c{corner(0), corner(turned ? 2 : 1), corner(turned ? 1 : 2)};
            solids.push_back({oracle::Solid::Shape::triangle, c, {}, 0});
            corners_.push_back(c);
        }
        surface_.emplace(corners_);
        std::vector<oracle::Solids> meshes;
        meshes.emplace_back(std::move(solids));
        solids_.emplace(std::move(meshes), std::vector{place_}, config.map_frac(), config.coord_bits,
                        config.dir_bits);
        const glm::dmat3 linear = matrix();
        back_ = glm::inverse(linear);
    }

    /// Returns a ray to a corner, an edge or the inside of a triangle, in the scene's space.
    Vec3i aim(Rng& rng) const {
        const oracle::Corners& t = corners_[std::size_t(rng.below(int(corners_.size())))];
        const stress::Weights w = stress::weights(stress::Target(rng.below(4)), rng);
        glm::dvec3 at(0);
        for (const auto& [p, share] : {std::pair(t.a, w.a), std::pair(t.b, w.b), std::pair(t.c, w.c)})
            at += double(share) / (w.a + w.b + w.c) * glm::dvec3(p[0], p[1], p[2]);
        for (int k = 0; k < 3; ++k)
            at[k] -= std::ldexp(double(place_.b[std::size_t(k)]), -config_.map_frac());
        const glm::dvec3 d = back_ * at - glm::dvec3(eye_[0], eye_[1], eye_[2]);
        const double largest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z), 1e-9}),
                     length = std::ldexp(0.5 + 0.5 * double(rng.below(1 << 16)) / (1 << 16),
                                         config_.dir_bits - 1) -
                              1;
        Vec3i out{};
        for (std::size_t k = 0; k < 3; ++k) out[k] = std::int32_t(std::round(d[int(k)] * length / largest));
        return out;
    }

    void shoot(const Vec3i& d, bool in_fractions, Sums& sums) {
        const Ray ray = make_ray(eye_, d, config_);
        const Change in = xform({0, ray.o, ray.d, placement_, RayKind::camera, {}}, config_);
        const Vec3i o_right = oracle::placed_point(place_, eye_, 0, config_.map_frac()),
                    d_right = oracle::placed_direction(place_, d, config_.map_frac());
        bool agrees = in.o == o_right && in.d == d_right;
        surface_->candidates(in.o, in.d, candidates_);
        int balance = 0, hits = 0, right = 0;
        for (const std::uint32_t i : candidates_) {
            const oracle::Corners& t = corners_[i];
            TriRsp rsp;
            test_(in.o, in.d, {t.a, t.b, t.c, i}, {}, config_, rsp);
            const oracle::ExactHit hit = oracle::exact_hit(o_right, d_right, t, i);
            agrees = agrees && (rsp.closer != 0) == (hit.primitive == i);
            hits += rsp.closer != 0, right += hit.primitive == i;
            if (in_fractions) agrees = agrees && (hit.primitive == i) == is_crossed(o_right, d_right, t);
            if (!rsp.closer) continue;
            const auto towards = oracle::volume<oracle::Int128>(oracle::triple<std::int64_t>(in.d),
                                                                oracle::normal<std::int64_t>(t));
            balance += towards < 0 ? 1 : -1;
        }
        const oracle::PlacedHit nearest = solids_->nearest({{eye_, 0, d}});
        const Closest got = walk_.trace(ray);
        agrees = agrees && (got.found ? got.prim : no_primitive) == nearest.hit.primitive;
        ++sums.rays, sums.crossings += std::uint64_t(right), sums.wrong += !agrees,
            sums.fractions += in_fractions;
        if (!is_outside(in.o)) return;
        ++sums.closed;
        if (balance != 0) ++(hits > right ? sums.doubles : sums.leaks);
    }

private:
    glm::dmat3 matrix() const {
        glm::dmat3 m;
        for (std::size_t i = 0; i < 9; ++i)
            m[int(i % 3)][int(i / 3)] = std::ldexp(double(place_.a[i]), -config_.map_frac());
        return m;
    }
    static bool is_crossed(const Vec3i& o, const Vec3i& d, const oracle::Corners& t) {
        return oracle::crossing(oracle::point(o), oracle::point(d), oracle::point(t.a), oracle::point(t.b),
                                oracle::point(t.c))
            .has_value();
    }
    bool is_outside(const Vec3i& o) const {
        const oracle::Extent box = surface_->bounds();
        for (std::size_t k = 0; k < 3; ++k)
            if (o[k] < box.lo[k] || o[k] > box.hi[k]) return true;
        return false;
    }

    const Config config_;
    const Frame frame_{};
    const LevelsImage levels_;
    const Decoder decoder_;
    LevelWalk walk_;
    const Vec3i eye_;
    TriTest* test_;
    Placement placement_;
    oracle::SolidPlace place_;
    std::vector<oracle::Corners> corners_;
    std::optional<oracle::Surface> surface_;
    std::optional<oracle::PlacedSolids> solids_;
    glm::dmat3 back_{1};
    std::vector<std::uint32_t> candidates_;
};

/// Runs every closed family in `places` random places with these maps.
Sums shoot(const Maps& maps, int coord_bits, int dir_bits, int places, int rays) {
    Sums sums;
    Config config = with_two_levels(format(coord_bits, dir_bits), "the test");
    for (const stress::Family& family : stress::families()) {
        if (!family.closed || family.leaks) continue;
        for (int p = 0; p < places; ++p) {
            Rng rng{std::uint64_t(100 * p + coord_bits)};
            Draw draw{std::uint32_t(1000 * p + dir_bits)};
            PlacedScene scene;
            scene.own.materials.emplace_back();
            scene.meshes.push_back(shared(family.make(coord_bits, dir_bits, rng).mesh, coord_bits));
            scene.instances.push_back({"body", 0, random_map(draw, maps.least, maps.most, maps.shear), {}});
            try {
                Body body(scene, glm::dvec3(9, 7, 8), config);
                for (int i = 0; i < rays; ++i) body.shoot(body.aim(rng), i % 64 == 0, sums);
            } catch (const UserError&) {   // a small body vanishes on a coarse lattice
                continue;
            }
        }
    }
    return sums;
}

void check(int places, int rays) {
    const Maps maps = GENERATE(from_range(std::begin(all_maps), std::end(all_maps)));
    for (const auto& [coord_bits, dir_bits] : formats) {
        const Sums sums = shoot(maps, coord_bits, dir_bits, places, rays);
        CAPTURE(maps.name, coord_bits, dir_bits, sums.rays, sums.crossings, sums.closed, sums.fractions);
        CHECK(sums.wrong == 0);
        CHECK(sums.leaks == 0);
        CHECK(sums.doubles == 0);
        CHECK(sums.crossings > sums.rays / 10);
        CHECK(sums.closed > 0);
    }
}

}   // namespace

TEST_CASE("closed surfaces seen through affine maps are watertight, and every decision is exact",
          "[levels][affine]") {
    check(1, 100);
}

TEST_CASE("closed surfaces seen through many affine maps are watertight", "[levels][affine][slow]") {
    check(54, 4000);   // 10^8 rays
}
