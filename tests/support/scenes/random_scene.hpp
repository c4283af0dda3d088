#pragma once
// Small random scenes that compare the machine with the reference: spheres, planes and meshes of every
// material, nested and touching, with lights and the eye on any side of them.
#include <array>
#include <cmath>
#include <random>
#include <string>

#include <glm/gtc/matrix_transform.hpp>

#include "model/layout/memory_image.hpp"
#include "model/scene/placed.hpp"
#include "model/scene/whitted.hpp"

namespace rayclock::test {

struct RandomScene {
    PlacedScene placed;
    Whitted settings;
    Config config;
};

/// Draws half of all numbers from a few simple ones, so that surfaces touch and rays run along axes.
class SceneDice {
public:
    explicit SceneDice(std::uint64_t seed) : engine_(seed * 0x9e3779b97f4a7c15u + 1) {}

    int below(int n) { return int(engine_() % std::uint64_t(n)); }
    int within(int least, int most) { return least + below(most - least + 1); }
    bool percent(int p) { return below(100) < p; }
    double real(double least, double most) {
        return least + (most - least) * (double(engine_() >> 11) * 0x1p-53);
    }
    double number(double least, double most) {
        return percent(50) ? least + (most - least) * within(0, 8) / 8 : real(least, most);
    }
    glm::dvec3 point(double reach) {
        glm::dvec3 p;
        for (int k = 0; k < 3; ++k) p[k] = number(-reach, reach);
        return p;
    }
    glm::dvec3 unit() {
        if (percent(50)) {
            glm::dvec3 axis(0);
            axis[below(3)] = percent(50) ? 1 : -1;
            return axis;
        }
        for (;;) {
            const glm::dvec3 v(real(-1, 1), real(-1, 1), real(-1, 1));
            if (const double square = glm::dot(v, v); square > 0.01 && square <= 1)
                return v / std::sqrt(square);
        }
    }

private:
    std::mt19937_64 engine_;
};

class SceneDrawer {
public:
    explicit SceneDrawer(std::uint64_t seed) : dice_(seed) {
        out_.placed.own.name = "random scene " + std::to_string(seed);
    }

    RandomScene operator()() {
        draw_materials();
        for (int n = dice_.within(0, 4); n > 0; --n) draw_sphere();
        for (int n = dice_.percent(50) ? 0 : dice_.within(1, 3); n > 0; --n) draw_plane();
        if (dice_.percent(50)) draw_meshes();
        PlacedScene& scene = out_.placed;
        if (scene.own.spheres.empty() && scene.own.planes.empty() && scene.instances.empty()) draw_sphere();
        for (int n = dice_.within(0, 3); n > 0; --n) draw_light();
        draw_view();
        return std::move(out_);
    }

private:
    void draw_materials() {
        for (int n = dice_.within(2, 5); n > 0; --n) {
            Material m;
            m.name = "m" + std::to_string(n);
            m.colour = {dice_.number(0, 1), dice_.number(0, 1), dice_.number(0, 1)};
            m.other = {dice_.number(0, 1), dice_.number(0, 1), dice_.number(0, 1)};
            m.ambient = dice_.number(0, 0.3), m.diffuse = dice_.number(0, 1);
            if (dice_.percent(30)) m.highlight = dice_.number(0, 1), m.shine = dice_.number(1, 100);
            if (dice_.percent(30)) m.mirror = dice_.number(0, 1);
            if (dice_.percent(40)) {
                m.transmit = dice_.number(0, 1);
                m.index = dice_.percent(30) ? 1 : dice_.number(0.5, 2.5);
                m.schlick = dice_.percent(20);
            }
            m.checkered = dice_.percent(50);
            out_.placed.own.materials.push_back(m);
        }
    }
    std::uint32_t material() { return std::uint32_t(dice_.below(int(out_.placed.own.materials.size()))); }

    /// Draws a sphere. A third of them are concentric with the previous one, or touch it.
    void draw_sphere() {
        std::vector<Sphere>& spheres = out_.placed.own.spheres;
        Sphere s{dice_.point(2), dice_.number(0.25, 1.5), material()};
        if (!spheres.empty() && dice_.percent(33)) {
            const Sphere& other = spheres.back();
            s.centre = other.centre;
            if (dice_.percent(50))
                s.centre += (other.radius + (dice_.percent(50) ? s.radius : -s.radius)) * dice_.unit();
            else
                s.radius = other.radius * dice_.number(0.25, 0.75);
        }
        spheres.push_back(s);
    }

    void draw_plane() {
        const glm::dvec3 n = dice_.unit();
        const glm::dvec3 other = std::abs(n.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        const glm::dvec3 u = glm::normalize(glm::cross(n, other));
        out_.placed.own.planes.push_back({dice_.point(3), u * dice_.number(0.25, 2),
                                          glm::cross(n, u) * dice_.number(0.25, 2), material()});
    }

    /// Returns an octahedron or a cube of side 2, with radial normals if it is smooth.
    SharedMesh solid(bool is_cube, bool smooth) {
        SharedMesh mesh;
        if (is_cube) {
            for (int i = 0; i < 8; ++i)
                mesh.vertices.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
            const std::array<std::array<std::uint32_t, 4>, 6> sides{
                {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
            for (const auto& s : sides) {
                mesh.triangles.push_back({{s[0], s[1], s[2]}, 0});
                mesh.triangles.push_back({{s[0], s[2], s[3]}, 0});
            }
        } else {
            mesh.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
            for (int i = 0; i < 8; ++i) {
                const std::uint32_t a = i & 1 ? 1 : 0, b = i & 2 ? 3 : 2, c = i & 4 ? 5 : 4;
                const bool turned = ((i & 1) + (i >> 1 & 1) + (i >> 2 & 1)) % 2 != 0;
                mesh.triangles.push_back({{a, turned ? c : b, turned ? b : c}, 0});
            }
        }
        if (smooth)
            for (const glm::dvec3& v : mesh.vertices) mesh.normals.push_back(glm::normalize(v));
        for (Triangle& t : mesh.triangles) t.material = material();
        return mesh;
    }

    void draw_meshes() {
        PlacedScene& scene = out_.placed;
        const bool smooth = dice_.percent(50);
        for (int n = dice_.within(1, 2); n > 0; --n) scene.meshes.push_back(solid(dice_.percent(50), smooth));
        for (int n = dice_.within(1, 3); n > 0; --n) {
            glm::dmat4 place = glm::translate(glm::dmat4(1), dice_.point(2));
            if (dice_.percent(70)) place = glm::rotate(place, dice_.number(0, 3.14159), dice_.unit());
            const double size = dice_.number(0.25, 1.5);
            glm::dvec3 scale(size);
            if (dice_.percent(25)) scale = {size, size * dice_.number(0.5, 2), size};
            if (dice_.percent(15)) scale.x = -scale.x;
            place = glm::scale(place, scale);
            if (dice_.percent(10)) {
                glm::dmat4 shear(1);
                shear[1][0] = dice_.number(-0.5, 0.5);
                place = place * shear;
            }
            Instance instance{"i" + std::to_string(n), std::uint32_t(dice_.below(int(scene.meshes.size()))),
                              place, std::nullopt};
            if (dice_.percent(50)) instance.material = material();
            scene.instances.push_back(instance);
        }
    }

    /// Draws a light anywhere, also inside spheres; a few are far away.
    void draw_light() {
        Light light{dice_.point(dice_.percent(20) ? 200 : 4), glm::dvec3(dice_.number(0.25, 1))};
        if (const auto& spheres = out_.placed.own.spheres; !spheres.empty() && dice_.percent(15))
            light.position = spheres.back().centre + 0.5 * spheres.back().radius * dice_.unit();
        out_.placed.own.lights.push_back(light);
    }

    void draw_view() {
        Camera camera;
        camera.eye = dice_.percent(80) ? 6.0 * dice_.unit() + dice_.point(1) : dice_.point(1.5);
        camera.at = dice_.point(0.5);
        const glm::dvec3 way = camera.at - camera.eye;
        if (glm::length(way) < 0.1) camera.at = camera.eye + glm::dvec3(0, 0, -1);
        if (glm::length(glm::cross(camera.at - camera.eye, camera.up)) <
            1e-3 * glm::length(camera.at - camera.eye))
            camera.up = {1, 0, 0};
        camera.fov_degrees = dice_.number(20, 100);
        out_.placed.own.camera = camera;
        out_.placed.own.background = {0.1, 0.2, 0.4};
        out_.settings.depth = dice_.within(0, 5);
        if (dice_.percent(20)) out_.settings.threshold = dice_.number(0, 0.3);
        if (dice_.percent(15)) out_.settings.aa = 2;
        out_.config = named_config("default");
        const int bits = dice_.percent(70) ? 18 : dice_.percent(50) ? 16 : 20;
        out_.config.coord_bits = bits;
        out_.config.dir_bits = std::min(bits + 2, 22);
        out_.config.stack_depth = 64;
        if (!out_.placed.instances.empty() && dice_.percent(60)) out_.config.levels = 2;
    }

    SceneDice dice_;
    RandomScene out_;
};

inline RandomScene random_scene(std::uint64_t seed) { return SceneDrawer(seed)(); }

}   // namespace rayclock::test
