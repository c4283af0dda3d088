// Camera registers from the camera: the pixel map in fixed point, in lattice steps. model/core/frame.hpp has
// raygen's rule for directions.
//
// Proof that every sum fits. Let V = C + x R + y D be raygen's sum for pixel (x, y), with C, R, D the nearest
// integers to scale * (corner, right, down). Each is off by at most 1/2, so V is off from scale *
// direction(x, y) by at most (1 + x + y) / 2 <= (w + h - 1) / 2. direction() is linear, so its components are
// largest at one of the four corner pixels: call that m. With L = 2^(M-1) - 1 let scale * m <= L * 2^G - (w +
// h - 1) / 2 - 1, where the 1 covers the rounding of the double arithmetic here (below 2^-10 for 38 bits).
// Then |V| <= L * 2^G < 2^(M-1+G). C is the sum of pixel (0, 0) and fits. R and D have their own bound, since
// in a picture two pixels wide a step can be twice the largest direction. A step that no pixel takes is zero.
//
// Proof that no direction is short. In the middle of a wide picture a direction is much shorter than in the
// corners. raygen shifts it up, by at most max_shift bits. All directions end in one plane, n . v = n .
// corner with n = right x down, and there |n . v| <= |n|_1 max |v_k|. So no direction's largest component is
// below l = |n . corner| / |n|_1. If scale * l - (w + h - 1) / 2 - 1 >= 2^(M-2+G-max_shift), then max
// |d_k| >= 2^(M-2) in every pixel. A camera that violates this is refused: 175 degrees in a picture 800 times
// as wide as high.
//
// With supersampling x and y are those of a sample, from -1/2 to w - 1/2 and h - 1/2. The sum is 256 V, with
// whole numbers 256 x and 256 y. So m is that of the picture's corners, and V is off by at most (1 + w - 1/2
// + h - 1/2) / 2 = (w + h) / 2. The rest holds unchanged, with fractions 2^8 times as fine.
#include "model/compile/frame.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "model/base/error.hpp"
#include "model/base/largest.hpp"
#include "model/scene/view.hpp"

namespace rayclock {

namespace {

/// Throws UserError for a camera that directions of these bits cannot represent.
[[noreturn]] void refuse_width(const Camera& camera, FrameSize size, const Config& config) {
    throw UserError("a camera of " + text_of(camera.fov_degrees) + " degrees is too wide for a picture of " +
                    std::to_string(size.width) + " x " + std::to_string(size.height) +
                    " pixels and directions of " + std::to_string(config.dir_bits) +
                    " bits (dir_bits): in its middle no direction would be left");
}

Vec3l fixed(const glm::dvec3& v, double scale) {
    return {std::llround(v.x * scale), std::llround(v.y * scale), std::llround(v.z * scale)};
}

}   // namespace

Frame make_frame(const Camera& camera, FrameSize size, const Lattice& lattice, const Config& config) {
    if (camera.window) {   // the rays of the whole picture, from the window's first pixel on
        Camera whole = camera;
        whole.window.reset();
        Frame frame = make_frame(whole, whole_size(camera.window, size), lattice, config);
        for (int k = 0; k < 3; ++k)
            frame.corner[k] += camera.window->x * frame.right[k] + camera.window->y * frame.down[k];
        frame.width = std::uint32_t(size.width);
        frame.height = std::uint32_t(size.height);
        return frame;
    }
    const auto need = int(std::bit_width(unsigned(std::max(size.width, size.height) - 1)));
    if (need > config.pixel_bits)
        throw UserError("a picture of " + std::to_string(size.width) + " x " + std::to_string(size.height) +
                        " pixels needs coordinates of " + std::to_string(need) + " bits, and pixel_bits is " +
                        std::to_string(config.pixel_bits) + ": --set pixel_bits=" + std::to_string(need));
    PixelRays rays = pixel_rays(camera, size);
    for (glm::dvec3* const part : {&rays.corner, &rays.right, &rays.down}) *part = lattice.direction(*part);
    const glm::dvec3 normal = glm::cross(rays.right, rays.down);
    const double least = std::abs(glm::dot(normal, rays.corner)) /
                         (std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z));
    // Distance from the outer pixels' middles to the outermost samples.
    const double around = config.supersampling ? 0.5 : 0;
    if (size.width == 1 && !config.supersampling) rays.right = glm::dvec3{0};
    if (size.height == 1 && !config.supersampling) rays.down = glm::dvec3{0};
    double m = std::max(largest(rays.right), largest(rays.down));
    for (const double x : {-around, size.width - 1 + around})
        for (const double y : {-around, size.height - 1 + around})
            m = std::max(m, largest(rays.direction(x, y)));

    const double limit = double(((std::int64_t(1) << (config.dir_bits - 1)) - 1) << guard_bits);
    const double off = 0.5 * (size.width + size.height - 1) + around + 1, scale = (limit - off) / m;
    if (!(scale * least - off >= std::ldexp(1.0, config.dir_bits - 2 + guard_bits - max_shift)))
        refuse_width(camera, size, config);
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

Frame make_frame(const Camera& camera, FrameSize size, const MemoryImage& image, const Config& config) {
    Frame frame = make_frame(camera, size, image.lattice, config);
    frame.listed_primitives = image.listed_primitives;
    return frame;
}

}   // namespace rayclock
