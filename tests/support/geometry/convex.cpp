// Computes surfaces of convex bodies by clipping each plane's square with all others.
#include "tests/support/geometry/convex.hpp"

#include <glm/geometric.hpp>

namespace rayclock::test {

namespace {

using Corners = std::vector<glm::dvec3>;

constexpr double half_side = 1 << 20;   // of a square that covers any face of a body in the lattice
constexpr double close = 1e-5;          // tolerance for n . x, above its rounding

glm::dvec3 point(const Vec3i& p) { return {p[0], p[1], p[2]}; }

Corners clipped(const Corners& from, const glm::dvec3& normal, double at) {
    Corners to;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const glm::dvec3 &a = from[i], &b = from[(i + 1) % from.size()];
        const double over_a = glm::dot(normal, a) - at, over_b = glm::dot(normal, b) - at;
        const bool in = over_a <= close, next_in = over_b <= close;
        if (in) to.push_back(a);
        if (in != next_in) to.push_back(a + (b - a) * ((over_a - close) / (over_a - over_b)));
    }
    return to;
}

}   // namespace

void Convex::above(const Vec3i& normal, std::int64_t at) { below({-normal[0], -normal[1], -normal[2]}, -at); }

void Convex::within(const Vec3i& lo, const Vec3i& hi) {
    for (std::size_t k = 0; k < 3; ++k) {
        Vec3i axis{};
        axis[k] = 1;
        below(axis, hi[k]);
        above(axis, lo[k]);
    }
}

bool Convex::same(const Plane& a, const Plane& b) {
    std::int64_t along = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        along += std::int64_t(a.normal[k]) * b.normal[k];
        if (std::int64_t(a.normal[k]) * b.normal[next] != std::int64_t(a.normal[next]) * b.normal[k] ||
            a.normal[k] * b.at != b.normal[k] * a.at)
            return false;
    }
    return along > 0;
}

double Convex::face(std::size_t plane) const {
    const glm::dvec3 n = point(planes_[plane].normal),
                     foot = n * (double(planes_[plane].at) / glm::dot(n, n)), size = glm::abs(n),
                     some = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                            : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                                 : glm::dvec3(0, 0, 1),
                     u = glm::normalize(glm::cross(n, some)) * half_side,
                     v = glm::normalize(glm::cross(n, u)) * half_side;
    Corners corners{foot + u + v, foot - u + v, foot - u - v, foot + u - v};
    for (std::size_t i = 0; i < planes_.size() && !corners.empty(); ++i)
        if (i != plane) corners = clipped(corners, point(planes_[i].normal), double(planes_[i].at));
    glm::dvec3 twice(0);
    for (std::size_t i = 2; i < corners.size(); ++i)
        twice += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    return glm::length(twice) / 2;
}

double Convex::surface() const {
    double sum = 0;
    for (std::size_t i = 0; i < planes_.size(); ++i) {
        bool is_new = true;
        for (std::size_t j = 0; j < i; ++j) is_new = is_new && !same(planes_[i], planes_[j]);
        if (is_new) sum += face(i);
    }
    return sum;
}

}   // namespace rayclock::test
