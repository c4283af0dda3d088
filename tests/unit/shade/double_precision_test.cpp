// Compares the shading formulas of the model in whole numbers with double precision: reflection, refraction,
// Fresnel's term and a light's share.
#include <cmath>

#include <catch2/catch.hpp>

#include "model/unit/shade/bounce/bounce.hpp"
#include "model/fixed/rounding.hpp"
#include "model/unit/shade/light/light.hpp"
#include "model/unit/shade/pass/pass.hpp"
#include "tests/support/cases/pass_cases.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

constexpr double unit = 1 << unit_bits, share = 1 << share_bits;
using Vector = std::array<double, 3>;

Vector real(const Vec3i& v, double one) { return {v[0] / one, v[1] / one, v[2] / one}; }
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Draws a surface seen at any angle. The cosine is that of its unit vectors.
ShadeState seen_surface(Draw& draw, const Config& c) {
    Frame frame;
    frame.shade.lights = 1;
    ShadeState s = random_state(draw, frame, c);
    do {
        s.normal = draw_unit(draw), s.view = draw_unit(draw);
        if (draw.percent(20)) s.view = s.normal;
        s.cosine = clamped_dot(s.normal, s.view);
    } while (s.cosine == 0);
    for (std::size_t k = 0; k < 3; ++k) s.n[k] = s.normal[k];   // no corner normals
    s.ratio = std::uint32_t(draw.coin() ? draw.between(2048, 4096) : draw.between(4096, 10000));
    return s;
}

/// Requires that no component of a direction of M bits is further from `way` than `bound`.
void judge(const Vec3i& d, const Vector& way, double bound, const Config& c) {
    const double one = std::ldexp(1.0, c.dir_bits - 2);
    for (std::size_t k = 0; k < 3; ++k)
        if (std::abs(d[k] / one - way[k]) > bound + 0.5 / one)
            FAIL("component " << k << " is " << d[k] / one << ", not " << way[k]);
}

double schlick(const ShadeState& s) {
    return s.r0 / unit + (1 - s.r0 / unit) * std::pow(1 - s.cosine / unit, 5);
}

}   // namespace

TEST_CASE("reflected rays go where the formula says, with its weight", "[formulas]") {
    const Config c = shaded_format(GENERATE("all", "short"));
    Draw draw{1};
    for (int i = 0; i < 20000; ++i) {
        const ShadeState s = seen_surface(draw, c);
        const BounceOut out = reflect(c, s);
        const Vector n = real(s.normal, unit), v = real(s.view, unit);
        Vector way{};
        for (std::size_t k = 0; k < 3; ++k)
            way[k] = std::clamp(2 * (s.cosine / unit) * n[k] - v[k], -1.0, 1.0);
        judge(out.d, way, 0.6 / unit, c);
        if (s.cosine > 100) REQUIRE(out.goes);
        const double weight = s.mirror / unit + s.transmit / unit *
                                                    (s.total     ? 1
                                                     : s.schlick ? schlick(s)
                                                                 : 0);
        REQUIRE(std::abs(out.weight / unit - s.weight / unit * std::min(weight, 1.0)) < 4 / unit);
    }
}

TEST_CASE("refracted rays go where Snell's law says, or nowhere", "[formulas]") {
    const Config c = shaded_format(GENERATE("all", "short"));
    Draw draw{2};
    int total = 0, bent = 0;
    for (int i = 0; i < 20000; ++i) {
        const ShadeState s = seen_surface(draw, c);
        const BounceOut out = refract(c, s);
        const Vector n = real(s.normal, unit), v = real(s.view, unit);
        const double ratio = s.ratio / 4096.0, cosine = s.cosine / unit,
                     k2 = 1 - ratio * ratio * (1 - cosine * cosine);
        if (std::abs(k2) > 1e-9) REQUIRE(out.total == (k2 < 0));
        if (out.total) {
            ++total;
            continue;
        }
        ++bent;
        const double root = std::sqrt(std::max(k2, 0.0)), along = ratio * cosine - root;
        Vector way{};
        for (std::size_t k = 0; k < 3; ++k) way[k] = std::clamp(along * n[k] - ratio * v[k], -1.0, 1.0);
        judge(out.d, way, 2.1 / unit,
              // The root is rounded down after 2^-32 was added: 1. Two products: 0.5 each.
              c);
        if (root > 0.01) REQUIRE(out.goes);
        const double weight = s.transmit / unit * (s.schlick ? 1 - schlick(s) : 1);
        REQUIRE(std::abs(out.weight / unit - s.weight / unit * weight) < 4 / unit);
    }
    REQUIRE((total > 1000 && bent > 1000));
}

TEST_CASE("a light's share is Lambert's and Phong's", "[formulas]") {
    const Config c = shaded_format("all");
    Draw draw{3};
    int counted = 0;
    for (int i = 0; i < 20000; ++i) {
        const Frame frame = random_shade_frame(draw, c);
        if (frame.shade.lights == 0) continue;
        ShadeState s = seen_surface(draw, c);
        s.light = std::uint32_t(draw.below(int(frame.shade.lights)));
        s.shine = std::uint32_t(draw.below(64 << shine_frac));
        const std::size_t at = 3 * s.light;
        Vector to{};
        for (std::size_t k = 0; k < 3; ++k)
            to[k] = std::ldexp(frame.shade.place[at + k], c.origin_bits) - double(s.o[k]);
        const double length = std::sqrt(dot(to, to));
        if (length == 0) continue;
        for (double& x : to) x /= length;
        const Vector n = real(s.normal, unit), v = real(s.view, unit);
        const double lambert = std::clamp(dot(n, to), 0.0, 1.0),
                     mirrored = std::clamp(2 * lambert * s.cosine / unit - dot(to, v), 0.0, 1.0);
        const LightOut out = light(frame, c, s);
        if (std::abs(dot(n, to)) > 1e-3) REQUIRE(out.counts == (dot(n, to) > 0));
        if (!out.counts) continue;
        ++counted;
        const double phong = std::pow(mirrored, s.shine / 16.0);
        for (std::size_t k = 0; k < 3; ++k) {
            // A cosine errs by less than 6 * 2^-16, the mirrored one by three times as much. Matte and gloss
            // are rounded.
            const double strength = frame.shade.colour[at + k] / share * s.weight / unit;
            const double matte = s.diffuse / share * s.albedo[k] / share, gloss = s.highlight / share;
            const double most =
                (strength * (1 + 6 * matte + (4 + 18 * std::max(1.0, s.shine / 16.0)) * gloss) + 1) / unit;
            const double truth = std::min(1.0, strength * (matte * lambert + gloss * phong));
            CAPTURE(lambert, mirrored, phong, s.shine, strength, truth, most);
            if (s.shine >= 16)
                REQUIRE(std::abs(s.share[k] / unit - truth) <= most);   // a power below 1 is steep at 0
        }
    }
    REQUIRE(counted > 2000);
}
