#include "sim/cause/snapped.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "model/accel/levels/maps.hpp"
#include "model/accel/surfaces.hpp"

namespace rayclock {

namespace {

constexpr double slack = 1e-6;   // of a step: doubles on the way to the lattice

glm::dvec3 units(const Lattice& lattice, const glm::dvec3& steps) {
    return lattice.centre + lattice.pitch * steps;
}

double rounded(double value, int bits) { return std::ldexp(std::round(std::ldexp(value, bits)), -bits); }
double share(double value) { return rounded(std::clamp(value, 0.0, 1.0), share_bits); }
glm::dvec3 shares(const glm::dvec3& v) { return {share(v.x), share(v.y), share(v.z)}; }

/// A weight of 0 stays 0, and no other becomes it; docs/shading.md, Weights and threshold.
double weight(double value) {
    return value > 0 ? std::max(rounded(std::min(value, 1.0), unit_bits), std::ldexp(1.0, -unit_bits)) : 0;
}

void round_material(Material& m) {
    const double sum = m.mirror + m.transmit;
    m.colour = shares(m.colour), m.other = shares(m.other);
    m.ambient = share(m.ambient), m.diffuse = share(m.diffuse), m.highlight = share(m.highlight);
    const double mirror = weight(m.mirror), transmit = weight(m.transmit);
    if (mirror > 0 && transmit > 0 && sum <= 1)
        m.transmit = std::max(weight(sum) - mirror, std::ldexp(1.0, -unit_bits));
    else
        m.transmit = transmit;
    m.mirror = mirror;
    m.shine = std::min(rounded(m.shine, shine_frac), std::ldexp(std::exp2(shine_bits) - 1, -shine_frac));
}

/// Steps, for each vertex: the shortest edge of its triangles.
std::vector<double> shortest_edges(const Scene& scene, const Lattice& lattice) {
    std::vector<double> shortest(scene.vertices.size(), HUGE_VAL);
    for (const Triangle& t : scene.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 edge =
                (scene.vertices[t.vertex[(i + 1) % 3]] - scene.vertices[t.vertex[i]]) / lattice.pitch;
            const double length = std::sqrt(glm::dot(edge, edge));
            for (const std::uint32_t v : t.vertex) shortest[v] = std::min(shortest[v], length);
        }
    return shortest;
}

class Snapper {
public:
    Snapper(const Asked& asked, const PlacedWorld* placed)
        : asked_(asked), placed_(placed), out_{asked.scene, {}} {}

    SnappedScene operator()() {
        move_corners();
        move_round();
        const Vec3i& eye = asked_.frame.eye;
        const glm::dvec3 off = glm::abs(
            (units(asked_.lattice, {eye[0], eye[1], eye[2]}) - asked_.camera.eye) / asked_.lattice.pitch);
        demand(std::max({off.x, off.y, off.z}) <= 0.5 + slack,
               "the eye lies further from the camera's than it may");
        if (asked_.config.shading) move_lights();
        for (Material& m : out_.scene.materials) round_material(m);
        for (int k = 0; k < 3; ++k)
            out_.scene.background[k] = rounded(std::clamp(out_.scene.background[k], 0.0, 1.0), unit_bits);
        return std::move(out_);
    }

private:
    void demand(bool holds, const char* sentence) {
        if (!holds && std::find(out_.faults.begin(), out_.faults.end(), sentence) == out_.faults.end())
            out_.faults.emplace_back(sentence);
    }

    /// Half a step, and of a chip that shades 2^-14 of the shortest edge: 2^-13 at the end of the lattice
    /// (aligned()).
    void move_corners() {
        const Lattice& lattice = asked_.lattice;
        if (placed_) {
            const Scene flat = flat_copy(placed_->snapped());
            if (flat.vertices.size() != out_.scene.vertices.size()) {
                demand(false, "the machine's instances have another number of corners than the scene's");
                return;
            }
            for (std::size_t i = 0; i < flat.vertices.size(); ++i)
                out_.scene.vertices[i] = units(lattice, flat.vertices[i]);
            return;
        }
        const std::optional<Scene> moved =
            asked_.config.shading ? aligned(asked_.scene, lattice) : std::nullopt;
        const std::vector<double> shortest = shortest_edges(asked_.scene, lattice);
        const std::vector<glm::dvec3>& given = asked_.scene.vertices;
        for (std::size_t i = 0; i < given.size(); ++i) {
            const Vec3i at = lattice.snap(moved ? moved->vertices[i] : given[i]);
            out_.scene.vertices[i] = units(lattice, {at[0], at[1], at[2]});
            if (std::isinf(shortest[i])) continue;   // no triangle has it
            const glm::dvec3 off = glm::abs((out_.scene.vertices[i] - given[i]) / lattice.pitch);
            const double most = 0.5 + slack + (asked_.config.shading ? std::ldexp(shortest[i], -13) : 0);
            demand(std::max({off.x, off.y, off.z}) <= most,
                   "a corner lies further from the scene's than it may");
        }
    }

    /// A sphere's centre by half a step, the square of its radius by half a step's; a plane passes where it
    /// did, turned by 2^-(N-5) at most.
    void move_round() {
        const Lattice& lattice = asked_.lattice;
        Scene& scene = out_.scene;
        snap_round(lattice, scene);
        for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
            Sphere& s = scene.spheres[i];
            s.centre = units(lattice, s.centre);
            s.radius *= lattice.pitch.x;
            const Sphere& given = asked_.scene.spheres[i];
            const glm::dvec3 off = glm::abs((s.centre - given.centre) / lattice.pitch);
            const double radius = given.radius / lattice.pitch.x, square = std::max(radius * radius, 1.0),
                         got = s.radius / lattice.pitch.x;
            demand(std::max({off.x, off.y, off.z}) <= 0.5 + slack,
                   "a sphere's centre lies further from the scene's than it may");
            demand(std::abs(got * got - square) <= 0.5 + slack * (1 + radius),
                   "a sphere's radius is not the scene's");
        }
        const double turn = std::exp2(6 - asked_.config.coord_bits);
        for (std::size_t i = 0; i < scene.planes.size(); ++i) {
            Plane& p = scene.planes[i];
            p.point = units(lattice, p.point), p.u *= lattice.pitch, p.v *= lattice.pitch;
            const Plane& given = asked_.scene.planes[i];
            const glm::dvec3 n = glm::normalize(glm::cross(glm::normalize(p.u), glm::normalize(p.v))),
                             m = glm::normalize(glm::cross(glm::normalize(given.u), glm::normalize(given.v)));
            demand(glm::length(n - m) <= 2 * turn, "a plane is turned further than it may");
            // Both pass a lattice point that is as near to the middle as whole sides of squares allow.
            const glm::dvec3 middle = lattice.centre - glm::dot(n, lattice.centre - p.point) * n;
            const double side = std::exp2(asked_.config.coord_bits - 4);
            demand(std::abs(glm::dot(m, (middle - given.point) / lattice.pitch)) <= 1 + 6 * turn * side,
                   "a plane lies further from the scene's than it may");
        }
    }

    /// By half a step; of a light beyond the reach of the registers that much at their end.
    void move_lights() {
        const Lattice& lattice = asked_.lattice;
        const double reach = std::exp2(asked_.config.light_bits() - 1) - 1;
        for (std::size_t i = 0; i < out_.scene.lights.size(); ++i) {
            Light& light = out_.scene.lights[i];
            const std::int32_t* place = &asked_.frame.shade.place[3 * i];
            const glm::dvec3 given = (light.position - lattice.centre) / lattice.pitch;
            const double far = std::max({std::abs(given.x), std::abs(given.y), std::abs(given.z)});
            const glm::dvec3 there = far > reach ? given * (reach / far) : given,
                             off = glm::abs(glm::dvec3(place[0], place[1], place[2]) - there);
            demand(std::max({off.x, off.y, off.z}) <= 0.5 + slack * (1 + far / reach),
                   "a light lies further from the scene's than it may");
            light.position = units(lattice, {place[0], place[1], place[2]});
            for (int k = 0; k < 3; ++k) light.colour[k] = rounded(light.colour[k], share_bits);
        }
    }

    const Asked& asked_;
    const PlacedWorld* placed_;
    SnappedScene out_;
};

}   // namespace

SnappedScene snapped_scene(const Asked& asked, const PlacedWorld* placed) { return Snapper(asked, placed)(); }

Camera snapped_camera(const Asked& asked) {
    Camera camera = asked.camera;
    const Vec3i& eye = asked.frame.eye;
    const glm::dvec3 moved = units(asked.lattice, {eye[0], eye[1], eye[2]}) - camera.eye;
    camera.eye += moved, camera.at += moved;
    return camera;
}

}   // namespace rayclock
