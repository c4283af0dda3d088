// Model against the double-precision reference: every pixel that differs lies where the lattice may change
// the decision.
//
// Let p be the vector of the three lattice pitches. Snapping moves a vertex by at most p_k / 2 on axis k, so
// by at most |p| / 2. The eye is a lattice point and does not move. Camera registers are rounded, and then
// the direction. Each component of the integer direction D is off by at most 1/2 (the last rounding) plus (1
// + x + y) / 2^(guard_bits + 1) < 0.01 (the registers). So a point at distance z along the ray moves sideways
// by at most z theta, theta = 0.51 |p| / |D p|, where D p multiplies axis by axis.
//
// Move everything continuously from the given scene to the snapped one. If the ray is inside a triangle
// before and outside after, it crossed the triangle's boundary on the way. So at the start it passes a point
// of one of the triangle's edges within eps = |p| / 2 + z theta. If it is inside two triangles before and
// after and their order along the ray changed, they met on the way. A distance along the ray changes by at
// most eps (1 + 1 / |cos|), where cos is the cosine between the ray and the triangle's normal. This holds to
// first order in eps; the factor of 2 below covers the rest for triangles whose normal turns little. So the
// two triangles were at most the sum of both changes apart. A pixel whose ray keeps clear of all this must
// show the same primitive.
//
// The count is then bounded by the number of pixels near an edge. An edge of l pixels in the picture decides
// 2 l eps' pixels on average, with eps' in pixels. At N = 18 and 96 x 72 pixels eps' < 0.001. Even where
// triangles are as small as pixels there are about 6 pixels of edge for every pixel: 1.2 %. Every scene must
// stay below a quarter of a percent. Ties are counted separately. Where surfaces coincide (in rings) no
// precision decides, and in the reference rounding decides.
#include <catch2/catch.hpp>

#include <glm/geometric.hpp>

#include "model/unit/raygen/raygen.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/view/report/json.hpp"
#include "tests/support/machine/frames.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

using glm::dvec3;

class Explainer {
public:
    Explainer(const Shot& shot)
        : scene_(shot.scene), job_(shot.job), rays_(pixel_rays(*shot.scene.camera, shot.job.size)) {}

    bool near_boundary(std::uint32_t primitive, int x, int y) const {
        if (primitive == no_primitive) return false;
        const Ray ray = at(x, y);
        for (std::size_t k = 0; k < 3; ++k) {
            const dvec3 a = corner(primitive, k), b = corner(primitive, (k + 1) % 3);
            if (distance_to_edge(ray, a, b) <=
                tolerance(ray, glm::max(glm::distance(a, rays_.eye), glm::distance(b, rays_.eye))))
                return true;
        }
        return false;
    }

    bool near_tie(std::uint32_t first, std::uint32_t second, int x, int y) const {
        if (first == no_primitive || second == no_primitive) return false;
        const Ray ray = at(x, y);
        double depth[2], reach = 0;
        for (int i = 0; i < 2; ++i) {
            const Plane plane = plane_of(ray, i ? second : first);
            depth[i] = plane.depth;
            reach += tolerance(ray, plane.depth) * (1 + 1 / plane.cosine);
        }
        return std::abs(depth[0] - depth[1]) <= 2 * reach;
    }

    /// Returns the largest permitted error of depth for a pixel with the right primitive. Adds t's last
    /// place, along a direction whose largest component is at least a quarter of the picture's.
    double depth_bound(std::uint32_t primitive, int x, int y) const {
        const Ray ray = at(x, y);
        const Plane plane = plane_of(ray, primitive);
        return 2 * tolerance(ray, plane.depth) * (1 + 1 / plane.cosine) +
               glm::length(job_.image.lattice.pitch) * std::ldexp(1.0, -job_.config.t_frac_bits);
    }

private:
    struct Ray {
        dvec3 unit;
        double theta;
    };
    Ray at(int x, int y) const {
        const Vec3i d = pixel_direction(std::uint32_t(x), std::uint32_t(y), job_.frame, job_.config);
        const dvec3& pitch = job_.image.lattice.pitch;
        return {glm::normalize(rays_.direction(x, y)),
                0.51 * glm::length(pitch) / glm::length(dvec3{d[0], d[1], d[2]} * pitch)};
    }
    struct Plane {
        double depth,
            /// The ray's meeting with the triangle's plane, and its positive cosine with the normal.
            cosine;
    };
    Plane plane_of(const Ray& ray, std::uint32_t primitive) const {
        const dvec3 n = glm::normalize(glm::cross(corner(primitive, 1) - corner(primitive, 0),
                                                  corner(primitive, 2) - corner(primitive, 0)));
        const double cosine = glm::dot(n, ray.unit);
        return {glm::dot(n, corner(primitive, 0) - rays_.eye) / cosine, std::abs(cosine)};
    }
    double tolerance(const Ray& ray, double z) const {
        return 0.5 * glm::length(job_.image.lattice.pitch) + ray.theta * z;
    }
    dvec3 corner(std::uint32_t primitive, std::size_t k) const {
        return scene_.vertices[scene_.triangles[primitive].vertex[k]];
    }

    /// Returns the least distance between the ray's line and the segment a..b. In the plane across the ray it
    /// is that of a point and a segment.
    double distance_to_edge(const Ray& ray, const dvec3& a, const dvec3& b) const {
        const auto across = [&](const dvec3& p) {
            return (p - rays_.eye) - glm::dot(p - rays_.eye, ray.unit) * ray.unit;
        };
        const dvec3 from = across(a), to = across(b), along = to - from;
        const double length2 = glm::dot(along, along);
        const double s = length2 > 0 ? glm::clamp(-glm::dot(from, along) / length2, 0.0, 1.0) : 0;
        return glm::length(from + s * along);
    }

    const Scene& scene_;
    const Job& job_;
    PixelRays rays_;
};

}   // namespace

TEST_CASE("pixels that differ from the reference lie within rounding of an edge or of a tie") {
    const std::string name = GENERATE("tetra:4", "mount:4", "gears:1", "gears:2", "balls:1", "balls:2",
                                      "teapot:6", "cornell", "icosphere:3", "rings:1", "tree:6");
    const int bits = GENERATE(12, 16, 18, 20);
    const FrameSize size{96, 72};
    const Config config =
        with(named_config("default"),
             {{"coord_bits", bits}, {"dir_bits", bits == 12 ? 16 : 20}, {"stack_depth", 32}});
    const Shot shot = make_shot(name, size, config);
    const HitFrame reference = Reference(shot.scene).frame(*shot.scene.camera, size);
    const HitFrame model = run_model(shot.job).hits;
    const Explainer explain(shot);
    std::size_t differ = 0, ties = 0, unexplained = 0;
    double worst = 0;   // the largest error of a depth relative to its bound
    for (std::size_t i = 0; i < model.hits.size(); ++i) {
        const std::uint32_t a = reference.hits[i].primitive, b = model.hits[i].primitive;
        const int x = int(i) % size.width, y = int(i) / size.width;
        if (a == b) {
            if (a != no_primitive)
                worst = std::max(worst, std::abs(double(reference.hits[i].depth) - model.hits[i].depth) /
                                            explain.depth_bound(a, x, y));
            continue;
        }
        ++differ;
        const bool tie = explain.near_tie(a, b, x, y);
        ties += tie;
        if (tie || explain.near_boundary(a, x, y) || explain.near_boundary(b, x, y)) continue;
        ++unexplained;
        UNSCOPED_INFO("pixel " << x << "," << y << " is " << b << ", and in the reference " << a);
    }
    INFO(name << " at " << bits << " bits: " << differ << " pixels differ, " << ties << " of them by a tie");
    CHECK(unexplained == 0);
    CHECK(worst <= 1);
    if (bits >= 18) CHECK(differ - ties <= model.hits.size() / 400);
    const FrameError error = frame_error(shot.scene, model, reference);
    CHECK(error.pixels_other_primitive == differ);
}

TEST_CASE("at 18 bits no more than one pixel in a thousand holds another primitive, at 45 dB") {
    const std::string name =
        GENERATE("balls:3", "gears:4", "mount:6", "rings:3", "teapot:12", "tetra:6", "tree:6");
    const FrameSize size{512, 384};
    const Shot shot = make_shot(name, size, with(named_config("default"), {{"stack_depth", 64}}));
    const HitFrame reference = Reference(shot.scene).frame(*shot.scene.camera, size);
    const FrameError error =
        frame_error(shot.scene, hits_of(shot.job, record_frame(shot.job, shot.job.frame)), reference);
    INFO(name << ": " << error.pixels_other_primitive << " pixels differ, " << error.psnr_db << " dB");
    // In rings a diagonal of the wall passes exactly through the centres of about 380 pixels, so any rounding
    // decides.
    CHECK(error.pixels_other_primitive <= error.pixels / (name == "rings:3" ? 900 : 1000));
    CHECK(error.psnr_db >= 45);
}
