// Parsing the view options, and turning the camera.
#include "sim/run/request/view.hpp"

#include <charconv>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/split.hpp"

namespace rayclock {

namespace {

glm::dvec3 point_of(const char* option, const std::string& typed) {
    const std::vector<std::string> parts = split(typed, ',');
    glm::dvec3 point{0};
    bool good = parts.size() == 3;
    for (int k = 0; good && k < 3; ++k) {
        const std::string& part = parts[std::size_t(k)];
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), point[k]);
        good = error == std::errc{} && end == part.data() + part.size() && std::isfinite(point[k]);
    }
    if (!good) throw UserError(fmt::format("{}: {} is not a point x,y,z", option, shown(typed)));
    return point;
}

}   // namespace

Camera chosen_camera(const Camera& camera, const ViewChoice& view, FrameSize size) {
    Camera chosen = camera;
    if (view.eye) chosen.eye = point_of("--eye", *view.eye);
    if (view.at) chosen.at = point_of("--at", *view.at);
    if (view.fov) {
        if (!(*view.fov > 0 && *view.fov < 180))
            throw UserError(fmt::format("--fov must lie between 0 and 180 degrees, not {}", *view.fov));
        chosen.fov_degrees = *view.fov;
    }
    if (view.orbit) {
        if (!(std::abs(*view.orbit) <= 360))
            throw UserError(fmt::format("--orbit must lie in -360..360 degrees, not {}", *view.orbit));
        // Rodrigues' rotation formula.
        const double angle = *view.orbit * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
        const glm::dvec3 axis = glm::normalize(chosen.up), arm = chosen.eye - chosen.at;
        chosen.eye = chosen.at + arm * c + glm::cross(axis, arm) * s + axis * glm::dot(axis, arm) * (1 - c);
    }
    pixel_rays(chosen, size);   // throws UserError for an invalid view
    return chosen;
}

}   // namespace rayclock
