#pragma once
// Small scenes that test the compiler: random, flat, needle-like, coincident, huge.
#include <random>

#include "model/scene/scene.hpp"

namespace rayclock {

/// Uniform in -1..1. The standard distributions differ between libraries.
class Draw {
public:
    explicit Draw(std::uint32_t seed) : engine_(seed) {}
    double operator()() { return double(engine_()) / 2147483648.0 - 1; }
    glm::dvec3 point() { return {(*this)(), (*this)(), (*this)()}; }

private:
    std::mt19937 engine_;
};

inline void add(Scene& scene, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const auto first = std::uint32_t(scene.vertices.size());
    scene.vertices.insert(scene.vertices.end(), {a, b, c});
    scene.triangles.push_back({{first, first + 1, first + 2}, 0});
}

inline Scene named(const char* name) {
    Scene scene;
    scene.name = name;
    scene.materials.emplace_back();
    return scene;
}

/// Returns n triangles of about the given size in a cube from -1 to 1.
inline Scene soup(int n, double size, std::uint32_t seed) {
    Scene scene = named("soup");
    Draw draw{seed};
    for (int i = 0; i < n; ++i) {
        const glm::dvec3 at = draw.point();
        add(scene, at, at + size * draw.point(), at + size * draw.point());
    }
    return scene;
}

/// Returns n by n squares in a plane of constant z.
inline Scene sheet(int n) {
    Scene scene = named("sheet");
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double x = i, y = j;
            add(scene, {x, y, 3}, {x + 1, y, 3}, {x, y + 1, 3});
            add(scene, {x + 1, y + 1, 3}, {x, y + 1, 3}, {x + 1, y, 3});
        }
    return scene;
}

inline Scene single() {
    Scene scene = named("single");
    add(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    return scene;
}

inline Scene coincident(int n) {
    Scene scene = named("coincident");
    for (int i = 0; i < n; ++i) add(scene, {0, 0, 0}, {1, 0.25, 0}, {0, 1, 0.5});
    return scene;
}

/// Returns long thin intersecting triangles, many of them across the whole scene.
inline Scene needles(int n, std::uint32_t seed) {
    Scene scene = named("needles");
    Draw draw{seed};
    for (int i = 0; i < n; ++i) {
        const glm::dvec3 a = draw.point();
        add(scene, a, draw.point(), a + 1e-3 * draw.point());
    }
    return scene;
}

/// Returns triangles between the corners of the scene's cube, with the largest possible coordinates.
inline Scene extremes() {
    Scene scene = named("extremes");
    const auto corner = [](int i) {
        return 1e9 * glm::dvec3{i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1};
    };
    for (int a = 0; a < 8; ++a)
        for (int b = a + 1; b < 8; ++b)
            for (int c = b + 1; c < 8; ++c) add(scene, corner(a), corner(b), corner(c));
    return scene;
}

/// Returns a fan of shrinking triangles towards a corner, which gives deep, one-sided trees.
inline Scene vanishing(int n) {
    Scene scene = named("vanishing");
    double size = 1;
    for (int i = 0; i < n; ++i, size *= 0.9)
        add(scene, {0, 0, 0}, {size, 0, 0.1 * size}, {0, size, 0.2 * size});
    return scene;
}

}   // namespace rayclock
