// The transformations of a COLLADA node.
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "sim/load/dae/transform.hpp"

namespace rayclock {
namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

glm::dmat4 matrix(const std::vector<float>& m) {
    glm::dmat4 made(1);
    for (int i = 0; i < 16; ++i) made[i % 4][i / 4] = m[static_cast<std::size_t>(i)];
    return made;
}

/// Rodrigues' rotation formula; `v` is the axis and the angle in degrees.
glm::dmat4 rotation(const std::vector<float>& v) {
    glm::dmat4 made(1);
    glm::dvec3 axis(v[0], v[1], v[2]);
    if (!(glm::length(axis) > 0)) return made;
    axis = glm::normalize(axis);
    const double c = std::cos(radians(v[3])), s = std::sin(radians(v[3]));
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 e(0);
        e[i] = 1;
        made[i] = glm::dvec4(e * c + glm::cross(axis, e) * s + axis * glm::dot(axis, e) * (1 - c), 0);
    }
    return made;
}

/// Places the origin at the eye, with -z towards the point of interest, as the node of a camera.
glm::dmat4 lookat(const std::vector<float>& v) {
    const glm::dvec3 eye(v[0], v[1], v[2]), at(v[3], v[4], v[5]), up(v[6], v[7], v[8]);
    const glm::dvec3 back = glm::normalize(eye - at), right = glm::normalize(glm::cross(up, back));
    return {glm::dvec4(right, 0), glm::dvec4(glm::cross(back, right), 0), glm::dvec4(back, 0),
            glm::dvec4(eye, 1)};
}

/// RenderMan's skew: moves points along `b`, so that vector `a` turns towards `b` by the angle v[0] in
/// degrees.
glm::dmat4 skew(const std::vector<float>& v) {
    const glm::dvec3 a = glm::normalize(glm::dvec3(v[1], v[2], v[3])),
                     b = glm::normalize(glm::dvec3(v[4], v[5], v[6])), across = a - b * glm::dot(a, b);
    const double sine = glm::length(across), between = std::atan2(sine, glm::dot(a, b)),
                 gain = 1 / std::tan(between - radians(v[0])) - 1 / std::tan(between);
    glm::dmat4 made(1);
    for (int i = 0; i < 3; ++i) made[i] += glm::dvec4(b * gain * across[i] / sine, 0);
    return made;
}

bool is_finite_matrix(const glm::dmat4& m) {
    for (int i = 0; i < 16; ++i)
        if (!std::isfinite(m[i / 4][i % 4])) return false;
    return true;
}

}   // namespace

glm::dmat4 dae_transform(const XmlElement& in, const DaeDocument& document) {
    glm::dmat4 made(1);
    if (in.name == "matrix") return matrix(document.finite(in, 16));
    if (in.name == "rotate") return rotation(document.finite(in, 4));
    if (in.name == "translate") {
        const std::vector<float> v = document.finite(in, 3);
        made[3] = {v[0], v[1], v[2], 1};
    } else if (in.name == "scale") {
        const std::vector<float> v = document.finite(in, 3);
        for (int i = 0; i < 3; ++i) made[i][i] = v[static_cast<std::size_t>(i)];
    } else if (in.name == "lookat" || in.name == "skew") {
        made = in.name == "lookat" ? lookat(document.finite(in, 9)) : skew(document.finite(in, 7));
        if (!is_finite_matrix(made)) document.refuse(in, in.name + ": its directions lie in one line");
    }
    return made;
}

}   // namespace rayclock
