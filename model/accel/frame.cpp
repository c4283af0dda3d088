// Camera registers from the camera: the pixel map in fixed point, in lattice steps.
//
// Proof that every direction fits M bits. Let V = C + x R + y D be what raygen sums for pixel (x, y), with C, R, D the
// nearest integers to scale * (corner, right, down). Each is off by at most 1/2, so V is off from scale * direction(x, y)
// by at most (1 + x + y) / 2 <= (w + h - 1) / 2. direction() is linear, so its components are largest at one of the four
// corner pixels: call that m. With scale * m <= L * 2^G - (w + h - 1) / 2 - 1, L = 2^(M-1) - 1, the 1 covering the
// rounding of the double arithmetic here (below 2^-10 for 38 bits), |V| <= L * 2^G, and
// floor((V + 2^(G-1)) / 2^G) lies in -L..L. C is the sum of pixel (0, 0) and fits; R and D are bounded apart, since in a
// picture two pixels wide a step can be twice the largest direction. A step that no pixel takes is zero.
//
// With supersampling x and y are those of a sample, from -1/2 to w - 1/2 and h - 1/2, and what is summed is 256 V, with whole
// numbers 256 x and 256 y. So m is that of the picture's corners, and V is off by at most (1 + w - 1/2 + h - 1/2) / 2 =
// (w + h) / 2; the rest holds as it stands, with 2^8 times as fine fractions.
#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include "model/accel/memory_image.hpp"
#include "model/core/error.hpp"

namespace rayclock {

namespace {

double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

Vec3l fixed(const glm::dvec3& v, double scale) {
    return {std::llround(v.x * scale), std::llround(v.y * scale), std::llround(v.z * scale)};
}

} // namespace

Frame make_frame(const Camera& camera, FrameSize size, const Lattice& lattice, const Config& config) {
    const auto need = int(std::bit_width(unsigned(std::max(size.width, size.height) - 1)));
    if (need > config.pixel_bits)
        throw UserError("a picture of " + std::to_string(size.width) + " x " + std::to_string(size.height) + " pixels needs coordinates of " +
                        std::to_string(need) + " bits, and pixel_bits is " + std::to_string(config.pixel_bits) + ": --set pixel_bits=" + std::to_string(need));
    PixelRays rays = pixel_rays(camera, size);
    for (glm::dvec3* const part : {&rays.corner, &rays.right, &rays.down}) *part = lattice.direction(*part);
    const double around = config.supersampling ? 0.5 : 0;   // from the outer pixels' middles to the outermost samples
    if (size.width == 1 && !config.supersampling) rays.right = glm::dvec3{0};
    if (size.height == 1 && !config.supersampling) rays.down = glm::dvec3{0};
    double m = std::max(largest(rays.right), largest(rays.down));
    for (const double x : {-around, size.width - 1 + around})
        for (const double y : {-around, size.height - 1 + around}) m = std::max(m, largest(rays.direction(x, y)));

    const double limit = double(((std::int64_t(1) << (config.dir_bits - 1)) - 1) << guard_bits);
    const double scale = (limit - (0.5 * (size.width + size.height - 1) + around) - 1) / m;
    Frame frame;
    frame.width = std::uint32_t(size.width);
    frame.height = std::uint32_t(size.height);
    frame.root = 0;
    frame.eye = lattice.snap(rays.eye);
    frame.corner = fixed(rays.corner, scale);
    frame.right = fixed(rays.right, scale);
    frame.down = fixed(rays.down, scale);
    return frame;
}

} // namespace rayclock
