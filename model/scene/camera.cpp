// Maps pixels to rays, and finds a camera for scenes without one. All this happens once per frame, in double
// precision. Vectors are scaled before they are squared, so no size that a double can hold overflows on the
// way.
#include "model/scene/camera.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "model/base/error.hpp"
#include "model/base/largest.hpp"
#include "model/scene/view.hpp"

namespace rayclock {
namespace {

/// Moves the eye back until all given points and spheres are inside the picture. Lengths are in units of
/// `scale`.
class Fitting {
public:
    Fitting(const View& view, const glm::dvec3& middle, double scale, double aspect)
        : view_(view),
          middle_(middle),
          scale_(scale),
          half_height_(view.half_height / margin),
          half_width_(half_height_ * aspect) {}

    void point(const glm::dvec3& position) {
        const glm::dvec3 p = (position - middle_) / scale_;
        const double x = std::abs(glm::dot(p, view_.right)), y = std::abs(glm::dot(p, view_.up));
        distance_ = std::max(
            distance_, std::max({x / half_width_, y / half_height_, nearest}) - glm::dot(p, view_.forward));
    }

    /// Adds a sphere. It is inside the four planes through the eye if its centre is a radius away from each.
    void sphere(const Sphere& sphere) {
        const glm::dvec3 p = (sphere.centre - middle_) / scale_;
        const double r = sphere.radius / scale_;
        const double x = std::abs(glm::dot(p, view_.right)) + r * std::sqrt(1 + half_width_ * half_width_);
        const double y = std::abs(glm::dot(p, view_.up)) + r * std::sqrt(1 + half_height_ * half_height_);
        distance_ = std::max(distance_, std::max({x / half_width_, y / half_height_, r + nearest}) -
                                            glm::dot(p, view_.forward));
    }

    double distance() const { return distance_; }

private:
    static constexpr double margin = 1.05;   // the scene fills at most 1/1.05 of the picture
    static constexpr double nearest = 0.1;   // least distance from the eye
    View view_;
    glm::dvec3 middle_;
    double scale_, half_height_, half_width_, distance_ = 0;
};

/// Adds the scene. Of planes, only the part in bounds() must be visible.
void show(Fitting& fitting, const Scene& scene, const Bounds& box) {
    for (const Triangle& triangle : scene.triangles)
        for (const std::uint32_t index : triangle.vertex) fitting.point(scene.vertices[index]);
    for (const Sphere& sphere : scene.spheres) fitting.sphere(sphere);
    if (!scene.triangles.empty() || !scene.spheres.empty()) return;
    for (const double x : {box.lo.x, box.hi.x})
        for (const double y : {box.lo.y, box.hi.y})
            for (const double z : {box.lo.z, box.hi.z}) fitting.point({x, y, z});
}

}   // namespace

glm::dvec3 unit_of(const glm::dvec3& v) {
    const glm::dvec3 scaled = v / largest(v);
    return scaled / glm::length(scaled);
}

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

std::string text_of(double x) {
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, x).ptr};
}

std::string text_of(const glm::dvec3& v) {
    std::string text(1, '(');
    text.append(text_of(v.x))
        .append(", ")
        .append(text_of(v.y))
        .append(", ")
        .append(text_of(v.z))
        .append(1, ')');
    return text;
}

void check_frame_size(FrameSize size) {
    if (size.width < 1 || size.height < 1 || size.width > max_frame_side || size.height > max_frame_side)
        throw UserError("a picture must be 1 to " + std::to_string(max_frame_side) +
                        " pixels wide and high, not " + std::to_string(size.width) + " x " +
                        std::to_string(size.height));
}

View view_of(const Camera& camera, const std::string& where) {
    const auto refuse = [&](const std::string& sentence) { throw UserError(where + ": " + sentence); };
    if (!is_finite(camera.eye)) refuse("the camera's eye " + text_of(camera.eye) + " is not a finite point");
    if (!is_finite(camera.at))
        refuse("the camera looks at " + text_of(camera.at) + ", which is not a finite point");
    if (!is_finite(camera.up)) refuse("the camera's up " + text_of(camera.up) + " is not a finite direction");
    if (!(camera.fov_degrees > 0 && camera.fov_degrees < 180))
        refuse("the camera's angle must lie between 0 and 180 degrees, not " + text_of(camera.fov_degrees));
    const glm::dvec3 gaze = camera.at - camera.eye;
    if (largest(gaze) == 0)
        refuse("the camera's eye and the point it looks at are the same, " + text_of(camera.eye));
    if (!is_finite(gaze))
        refuse("the camera's eye " + text_of(camera.eye) + " is too far from " + text_of(camera.at));
    if (largest(camera.up) == 0) refuse("the camera's up " + text_of(camera.up) + " has no direction");
    View view;
    view.forward = unit_of(gaze);
    const glm::dvec3 across = glm::cross(view.forward, unit_of(camera.up));
    // Below this the direction of `across` is mostly rounding.
    if (!(glm::length(across) > 1e-9))
        refuse("the camera's up " + text_of(camera.up) + " points along its line of sight");
    view.right = unit_of(across);
    view.up = glm::cross(view.right, view.forward);
    view.half_height = std::tan(camera.fov_degrees * (std::numbers::pi / 360));
    return view;
}

PixelRays pixel_rays(const Camera& camera, FrameSize size) {
    const FrameSize whole = whole_size(camera.window, size);
    check_frame_size(size);
    check_frame_size(whole);
    const View view = view_of(camera, "camera");
    const double spacing = 2 * view.half_height / whole.height;
    PixelRays rays;
    rays.eye = camera.eye;
    rays.right = spacing * view.right;
    rays.down = -spacing * view.up;
    rays.corner = view.forward - 0.5 * (whole.width - 1) * rays.right - 0.5 * (whole.height - 1) * rays.down;
    if (camera.window) rays.corner = rays.direction(camera.window->x, camera.window->y);
    return rays;
}

double sample_spread(const Camera& camera, FrameSize size, int samples_per_side) {
    const int height = whole_size(camera.window, size).height;
    return 2 * std::tan(glm::radians(camera.fov_degrees) / 2) / height / samples_per_side;
}

Camera fit_camera(const Scene& scene, double aspect) {
    if (!(aspect > 0) || !std::isfinite(aspect))
        throw UserError("a picture cannot have the aspect " + text_of(aspect));
    const Bounds box = bounds(scene);
    Camera camera;
    camera.at = 0.5 * box.lo + 0.5 * box.hi;
    const glm::dvec3 towards_eye = unit_of({0.6, 0.5, 1});
    // A mesh smaller than the rounding of its coordinates is treated as larger; a point is treated as of size
    // 1.
    double scale = std::max(largest(box.hi - box.lo), 1e-9 * std::max(largest(box.lo), largest(box.hi)));
    if (scale < 1e-200) scale = 1;
    const View view = view_of({towards_eye, glm::dvec3(0), camera.up, camera.fov_degrees}, "camera");
    Fitting fitting(view, camera.at, scale, aspect);
    show(fitting, scene, box);
    camera.eye = camera.at + fitting.distance() * scale * towards_eye;
    if (!is_finite(camera.eye) || !is_finite(camera.at - camera.eye))
        throw UserError(scene.name + ": the scene reaches from " + text_of(box.lo) + " to " +
                        text_of(box.hi) + ", too large to be seen whole");
    return camera;
}

}   // namespace rayclock
