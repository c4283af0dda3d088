// Computes the registers of torture frames.
#include "sim/explore/torture/frames.hpp"

#include <cmath>
#include <cstdlib>

#include <glm/vec3.hpp>

#include "model/base/axes.hpp"
#include "model/base/largest.hpp"
#include "model/scene/whitted.hpp"

namespace rayclock::torture {

namespace {

/// Sets the pixel map so that no direction and no single step exceeds 2^(M-1) - 1, even half a pixel beyond
/// the picture.
void aim(Frame& frame, const glm::dvec3& middle, const glm::dvec3& right, const glm::dvec3& down,
         double shrink, const Config& config) {
    const glm::dvec3 corner = middle - 0.5 * (frame.width - 1) * right - 0.5 * (frame.height - 1) * down;
    double m = std::max({largest(right), largest(down), 1e-9});
    for (const double x : {-0.5, frame.width - 0.5})
        for (const double y : {-0.5, frame.height - 0.5})
            m = std::max(m, largest(corner + x * right + y * down));
    const double limit =
        double(std::int64_t(max_of(config.dir_bits)) << guard_bits) - frame.width - frame.height;
    const double scale = limit / m * shrink;
    const auto fixed = [&](const glm::dvec3& v) {
        return by_axis([&](std::size_t k) { return std::int64_t(std::llround(v[int(k)] * scale)); });
    };
    frame.corner = fixed(corner);
    if (frame.width > 1 || config.supersampling) frame.right = fixed(right);
    if (frame.height > 1 || config.supersampling) frame.down = fixed(down);
}

}   // namespace

Frame view(const std::vector<PrimData>& prims, const Config& config, Size size, int shorter, Dice& dice) {
    const std::int32_t most = max_of(config.coord_bits);
    Frame frame;
    frame.width = size.width, frame.height = size.height;
    frame.eye = dice.point(most);
    const auto any_corner = [&] { return prims[std::size_t(dice.below(int(prims.size())))].a; };
    if (dice.percent(20)) frame.eye = any_corner();
    const bool at_the_end = dice.percent(25);
    if (at_the_end)
        for (auto& x : frame.eye) x = dice.percent(50) ? most : -most;
    const Vec3i target = any_corner();
    glm::dvec3 middle(target[0] - frame.eye[0], target[1] - frame.eye[1], target[2] - frame.eye[2]), right,
        down;
    if (largest(middle) == 0) middle = {1, 0, 0};
    const double spread =
        largest(middle) * std::ldexp(1.0, at_the_end ? 2 : dice.between(-4, 2)) / size.width;
    for (int k = 0; k < 3; ++k) {
        right[k] = spread * dice.between(-16, 16) / 16;
        down[k] = spread * dice.between(-16, 16) / 16;
    }
    if (dice.percent(30)) right = {spread, 0, 0}, down = {0, spread, 0};
    aim(frame, middle, right, down, std::ldexp(1.0, shorter > 0 ? -shorter - max_shift : 0), config);
    return frame;
}

Frame corner_view(const Config& config, Size size, std::int32_t step) {
    Frame frame;
    frame.width = size.width, frame.height = size.height;
    std::int32_t height = 1;
    while (height * 4 <= max_of(config.coord_bits) && height * 2 <= max_of(config.dir_bits)) height *= 2;
    frame.eye = {0, 0, height};
    const auto steps = [&](std::uint32_t pixels) {
        return -std::int64_t(pixels / 2) * step * (std::int64_t(1) << guard_bits);
    };
    frame.corner = {steps(size.width), steps(size.height), -(std::int64_t(height) << guard_bits)};
    frame.right = {std::int64_t(step) << guard_bits, 0, 0};
    frame.down = {0, std::int64_t(step) << guard_bits, 0};
    return frame;
}

Frame diagonal_view(const Vec3i& eye, std::int64_t unit) {
    Frame frame;
    frame.width = frame.height = 9;
    frame.eye = eye;
    unit <<= guard_bits;
    frame.corner = {-4 * unit, -4 * unit, -2 * unit};
    frame.right = {unit, 0, 0};
    frame.down = {0, unit, 0};
    return frame;
}

Frame brim_view(const Vec3i& eye, const Config& config) {
    Frame frame = diagonal_view(eye, 1 << (config.dir_bits - 5));
    const std::int64_t brim = (std::int64_t(1) << (config.dir_bits - 2 + guard_bits)) - 1;
    frame.corner = {-brim, brim - (std::int64_t(4) << guard_bits), -brim};
    frame.right = {0, std::int64_t(1) << (guard_bits - 1), 0};
    frame.down = {0, 0, std::int64_t(1) << (guard_bits - 3)};
    return frame;
}

Vec3i mirror_place(const Config& config, std::int32_t at) {
    const std::int32_t step = max_of(config.coord_bits) / 2;
    return {at * step, at * step, -step};
}

Frame mirror_view(const Config& config, Size size, const Vec3i& normal, std::int32_t at) {
    // A ray along v is reflected along z if v + z is a multiple of the normal.
    const std::int32_t square = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
    const Vec3i v{2 * normal[2] * normal[0], 2 * normal[2] * normal[1], 2 * normal[2] * normal[2] - square};
    Frame frame;
    frame.width = size.width, frame.height = size.height;
    frame.eye = mirror_place(config, at);
    const std::int32_t away = max_of(config.coord_bits) / 64;
    for (std::size_t k = 0; k < 3; ++k) frame.eye[k] += v[k] * away / 4;
    const double spread = 1e-4 * largest({double(v[0]), double(v[1]), double(v[2])});
    aim(frame, {double(-v[0]), double(-v[1]), double(-v[2])}, {spread / size.width, 0, 0},
        {0, spread / size.height, 0}, 1, config);
    return frame;
}

Frame pane_view(const Config& config, Size size, double spread) {
    Frame frame;
    frame.width = size.width, frame.height = size.height;
    const std::int32_t most = max_of(config.coord_bits);
    frame.eye = {most / 16, -most / 16, most - most / 8};
    aim(frame, {0, 0, -1}, {spread / size.width, 0, 0}, {0, spread / size.height, 0}, 1, config);
    return frame;
}

RayRecord random_record(const std::vector<PrimData>& prims, const Config& config, Dice& dice) {
    const int frac = config.origin_frac();
    const std::int32_t most = (1 << (config.coord_bits - 1)) - 1, far = (1 << (config.dir_bits - 1)) - 1;
    const PrimData& prim = prims[std::size_t(dice.below(int(prims.size())))];
    const Vec3i target = dice.near(prim.a, dice.below(3), most), point = dice.point(most);
    const RayKind kinds[] = {RayKind::bounce, RayKind::shadow, RayKind::away};
    RayRecord record{kinds[dice.below(3)], {}, {}};
    const bool shadow = record.kind == RayKind::shadow, aims = dice.below(3) > 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int32_t part = shadow ? 0 : dice.below(1 << frac);
        record.o[k] = point[k] * (1 << frac) + part;
        if (shadow)
            record.d[k] =
                (aims ? target[k] : dice.number(most)) * (1 << frac) + dice.below(1 << frac) - record.o[k];
        else
            record.d[k] = aims ? std::clamp(target[k] - point[k], -far, far) : dice.number(far);
    }
    if (record.d == Vec3i{}) record.d[0] = 1;
    return record;
}

ShadeFrame settings(const MemoryImage& image, const Config& config, int samples, Dice& dice) {
    ShadeFrame s;
    const int all = samples * samples;
    const double one = 1 << unit_bits;
    s.first_surface_line = image.first_surface_line;
    s.depth = std::uint32_t(dice.between(1, config.refraction ? config.bounces : 15));
    s.threshold = dice.percent(40) ? 0 : dice.share(unit_bits + 1) >> dice.between(0, 8);
    s.side = std::uint32_t(samples);
    s.stride = sample_stride(samples);
    s.jitter = config.supersampling && dice.percent(50);
    s.contrast = all > 4 ? dice.share(unit_bits) : 0;
    s.share = std::uint32_t(std::round(one / all));
    s.first_share = std::uint32_t(std::round(one / std::min(int(first_samples), all)));
    s.seed = std::uint32_t(dice.below(1 << 30));
    s.background = dice.colour(unit_bits);
    s.lights = std::uint32_t(dice.between(1, config.lights));
    if (config.has_textures()) {
        Dice own = dice.branch();
        // Within one octave of 0, within eight octaves of 0, or any number.
        const std::int32_t octaves[] = {1, 8}, kind = own.below(3);
        const std::int32_t most = kind < 2 ? octaves[kind] << level_frac : 0;
        s.spread = kind < 2 ? own.between(-most, most) : own.signed_number(level_bits);
    }
    // Lights beyond the frame's number exist, but do not shine.
    for (std::size_t i = 0; i < std::size_t(config.lights); ++i) {
        s.near[i] = dice.percent(60), s.clear[i] = dice.percent(50);
        if (config.panes > 0) s.cell[i] = std::uint32_t(dice.below(1 << config.panes));
        const Vec3i place = dice.point(max_of(s.near[i] ? config.coord_bits : config.light_bits()));
        std::copy(place.begin(), place.end(), s.place.begin() + std::ptrdiff_t(3 * i));
        for (std::size_t k = 0; k < 3; ++k)
            s.colour[3 * i + k] = std::min(dice.share(strength_bits), (1u << strength_bits) - 1);
    }
    return s;
}

}   // namespace rayclock::torture
