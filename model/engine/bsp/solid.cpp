// Areas and cuts of a convex solid.
#include "model/engine/bsp/solid.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace rayclock::bsp {

namespace {

/// Calls add() with the corners of the part of a polygon that is not above a plane, and met() where its edges
/// cross the plane.
template <class Add, class Met>
void clip(const std::vector<glm::dvec3>& corners, const glm::dvec3& normal, double at, Add&& add, Met&& met) {
    glm::dvec3 a = corners.back();
    double above = glm::dot(normal, a) - at;
    for (const glm::dvec3& b : corners) {
        const double next = glm::dot(normal, b) - at;
        if ((above <= 0) != (next <= 0)) {
            const glm::dvec3 crossing = a + (b - a) * (above / (above - next));
            add(crossing);
            met(crossing);
        }
        if (next <= 0) add(b);
        a = b, above = next;
    }
}

}   // namespace

Solid::Solid(const LatticeBox& box) {
    const auto corner = [&](int i) {
        return glm::dvec3(i & 1 ? box.hi[0] : box.lo[0], i & 2 ? box.hi[1] : box.lo[1],
                          i & 4 ? box.hi[2] : box.lo[2]);
    };
    for (const auto& face : {std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}, std::array{0, 1, 5, 4},
                             std::array{2, 6, 7, 3}, std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}}) {
        Corners corners;
        for (const int i : face) corners.push_back(corner(i));
        const glm::dvec3 outward = outward_of(corners);
        faces_.push_back({std::move(corners), outward});
    }
    measure();
}

glm::dvec3 Solid::outward_of(const Corners& corners) {
    glm::dvec3 sum(0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return sum / 2.0;
}

void Solid::measure() {
    area_ = 0;
    for (const Face& face : faces_) area_ += glm::length(face.outward);
}

/// The outward vectors of all faces sum to zero. So those of a part give the size of its face on the plane.
Solid::Halves Solid::halves(const glm::dvec3& normal, double at) const {
    Halves halves;
    glm::dvec3 lid(0);
    for (const Face& face : faces_) {
        glm::dvec3 first(0), last(0), sum(0);
        std::size_t count = 0;
        clip(
            face.corners, normal, at,
            [&](const glm::dvec3& c) {
                if (count == 0) first = c;
                if (count > 1) sum += glm::cross(last - first, c - first);
                last = c;
                ++count;
            },
            [](const glm::dvec3&) {});
        sum /= 2.0;
        lid += sum;
        halves.lower += glm::length(sum);
        halves.upper += glm::length(face.outward - sum);
    }
    halves.lower += glm::length(lid);
    halves.upper += glm::length(lid);
    return halves;
}

void Solid::cut(const glm::dvec3& normal, double at, bool upper) {
    const glm::dvec3 n = upper ? -normal : normal;
    const double bound = upper ? -at : at;
    std::vector<Face> faces;
    Corners lid;
    for (const Face& face : faces_) {
        Face part;
        clip(
            face.corners, n, bound, [&](const glm::dvec3& c) { part.corners.push_back(c); },
            [&](const glm::dvec3& c) { lid.push_back(c); });
        if (part.corners.size() < 3) continue;
        part.outward = outward_of(part.corners);
        faces.push_back(std::move(part));
    }
    if (lid.size() >= 3) {
        glm::dvec3 middle(0);
        for (const glm::dvec3& c : lid) middle += c / double(lid.size());
        const glm::dvec3 size = glm::abs(n), some = size.x < size.y && size.x < size.z ? glm::dvec3(1, 0, 0)
                                                    : size.y < size.z                  ? glm::dvec3(0, 1, 0)
                                                                                       : glm::dvec3(0, 0, 1);
        const glm::dvec3 u = glm::normalize(glm::cross(n, some)), v = glm::normalize(glm::cross(n, u));
        const auto angle = [&](const glm::dvec3& c) {
            return std::atan2(glm::dot(c - middle, v), glm::dot(c - middle, u));
        };
        std::sort(lid.begin(), lid.end(),
                  [&](const glm::dvec3& a, const glm::dvec3& b) { return angle(a) < angle(b); });
        const glm::dvec3 outward = outward_of(lid);
        faces.push_back({std::move(lid), outward});
    }
    faces_ = std::move(faces);
    measure();
}

}   // namespace rayclock::bsp
