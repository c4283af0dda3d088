// Builds the scene with the machine's rounded vertices for the reference.
#include "sim/judge/cause/snapped.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "model/compile/plane.hpp"
#include "model/compile/surfaces.hpp"

namespace rayclock {

namespace {

constexpr double slack = lattice_slack;

glm::dvec3 units(const Lattice& lattice, const glm::dvec3& steps) {
    return lattice.centre + lattice.pitch * steps;
}

constexpr const char* far_eye = "the eye lies further from the camera's than it may";
constexpr const char* far_corner = "a corner lies further from the scene's than it may";

bool is_eye_near(const FrameInputs& inputs) {
    return corner_error(inputs.lattice, inputs.frame.eye, inputs.camera.eye) <= 0.5 + slack;
}

double rounded(double value, int bits) { return std::ldexp(std::round(std::ldexp(value, bits)), -bits); }
double share(double value) { return rounded(std::clamp(value, 0.0, 1.0), share_bits); }
glm::dvec3 shares(const glm::dvec3& v) { return {share(v.x), share(v.y), share(v.z)}; }

/// A weight of 0 stays 0, and no other weight becomes 0 (docs/machine/shading.md, Weights and threshold).
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

/// Returns the pyramid with its codes rounded to 5, 6 and 5 bits, and expanded to 8 bits.
std::shared_ptr<const Pyramid> with_short_codes(Pyramid pyramid) {
    const auto shortened = [](std::uint8_t code, int most) {
        const double few = std::round(double(code) * most / 255);
        return std::uint8_t(most == 31 ? few * 8 + std::floor(few / 4) : few * 4 + std::floor(few / 16));
    };
    for (TexelLevel& level : pyramid.levels)
        for (auto& [red, green, blue, alpha] : level.texels)
            red = shortened(red, 31), green = shortened(green, 63), blue = shortened(blue, 31),
            alpha = alpha >= 128 ? 255 : 0;
    return std::make_shared<const Pyramid>(std::move(pyramid));
}

class Snapper {
public:
    Snapper(const FrameInputs& inputs, const PlacedWorld* placed)
        : inputs_(inputs), placed_(placed), out_{inputs.scene, {}} {}

    SnappedScene operator()() {
        move_corners();
        move_round();
        demand(is_eye_near(inputs_), far_eye);
        if (inputs_.config.shading) move_lights();
        for (Material& m : out_.scene.materials) round_material(m);
        if (inputs_.config.has_textures() && inputs_.config.texels == TexelFormat::rgb565)
            for (Texture& t : out_.scene.textures) t.pyramid = with_short_codes(*t.pyramid);
        for (int k = 0; k < 3; ++k)
            out_.scene.background[k] = rounded(std::clamp(out_.scene.background[k], 0.0, 1.0), unit_bits);
        return std::move(out_);
    }

private:
    void demand(bool holds, const char* sentence) {
        if (!holds && std::find(out_.faults.begin(), out_.faults.end(), sentence) == out_.faults.end())
            out_.faults.emplace_back(sentence);
    }

    /// PlacedWorld compares the corners of instances with their bound, mesh by mesh.
    void move_corners() {
        const Lattice& lattice = inputs_.lattice;
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
            inputs_.config.shading ? align_large_triangles(inputs_.scene, lattice) : std::nullopt;
        const std::vector<double> most = corner_bounds(inputs_.scene, lattice, inputs_.config);
        const std::vector<glm::dvec3>& given = inputs_.scene.vertices;
        for (std::size_t i = 0; i < given.size(); ++i) {
            const Vec3i at = lattice.snap(moved ? moved->vertices[i] : given[i]);
            out_.scene.vertices[i] = units(lattice, {at[0], at[1], at[2]});
            demand(corner_error(lattice, at, given[i]) <= most[i], far_corner);
        }
    }

    /// A sphere's centre may move by half a step on each axis, the square of its radius by half the square of
    /// a step.
    void move_round() {
        const Lattice& lattice = inputs_.lattice;
        Scene& scene = out_.scene;
        snap_round(lattice, scene);
        for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
            Sphere& s = scene.spheres[i];
            s.centre = units(lattice, s.centre);
            s.radius *= lattice.pitch.x;
            const Sphere& given = inputs_.scene.spheres[i];
            const double radius = given.radius / lattice.pitch.x, square = std::max(radius * radius, 1.0),
                         got = s.radius / lattice.pitch.x;
            demand(corner_error(lattice, lattice.snap(given.centre), given.centre) <= 0.5 + slack,
                   "a sphere's centre lies further from the scene's than it may");
            demand(std::abs(got * got - square) <= 0.5 + slack * (1 + radius),
                   "a sphere's radius is not the scene's");
        }
        for (std::size_t i = 0; i < scene.planes.size(); ++i) {
            Plane& p = scene.planes[i];
            p.point = units(lattice, p.point), p.u *= lattice.pitch, p.v *= lattice.pitch;
            demand_plane(inputs_.scene.planes[i], p);
        }
    }

    /// A plane's sides may change by half a step. Its lattice point may lie half a step from a point that is
    /// whole sides away from the scene's. docs/proofs/who-checks-the-rules.md derives how far the plane may
    /// turn, how far its points may lie from the given plane, and where squares begin.
    void demand_plane(const Plane& given, const Plane& machine) {
        const Lattice& lattice = inputs_.lattice;
        const PlaneOnLattice on = plane_on_lattice(given, lattice);
        const auto steps = [](const Vec3i& p) { return glm::dvec3(p[0], p[1], p[2]); };
        const auto is_near = [](const glm::dvec3& a, const glm::dvec3& b, double error) {
            const glm::dvec3 off = glm::abs(a - b);
            return std::max({off.x, off.y, off.z}) <= 0.5 + error;
        };
        const glm::dvec3 a = steps(on.a), whole[2] = {given.u, given.v},
                         side[2] = {steps(on.b) - a, steps(on.c) - a}, counted[2] = {machine.u, machine.v};
        glm::dvec3 g = (given.point - lattice.centre) / lattice.pitch, corner = a;
        double far =
            glm::length(g) + (glm::length(given.point) + glm::length(lattice.centre)) / lattice.pitch.x;
        for (std::size_t i = 0; i < 2; ++i) {
            const double size = std::ldexp(1.0, -on.level[i]);
            const glm::dvec3 part = size * whole[i] / lattice.pitch;
            demand(is_near(side[i], part, slack), "a plane's sides are not the scene's");
            demand(on.at[i] == std::round(on.at[i]) && glm::length(counted[i] * size / lattice.pitch -
                                                                   side[i]) <= slack * glm::length(side[i]),
                   "a plane's squares are not the scene's");
            g += on.at[i] * part, corner -= on.at[i] * side[i];
            far = std::max(far, glm::length(g)) + std::abs(on.at[i]) * glm::length(part);
        }
        const double rounding = slack + 0x1p-48 * far;   // of doubles, in the computation of g
        demand(is_near(a, g, rounding), "a plane lies further from the scene's than it may");
        const glm::dvec3 begin = (machine.point - lattice.centre) / lattice.pitch;
        demand(glm::length(begin - corner) <= rounding, "a plane's squares begin elsewhere than the scene's");
    }

    /// A light may move by half a step. A light beyond the range of the registers is compared at the end of
    /// the range.
    void move_lights() {
        const Lattice& lattice = inputs_.lattice;
        const double reach = std::exp2(inputs_.config.light_bits() - 1) - 1;
        for (std::size_t i = 0; i < out_.scene.lights.size(); ++i) {
            Light& light = out_.scene.lights[i];
            const std::int32_t* place = &inputs_.frame.shade.place[3 * i];
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

    const FrameInputs& inputs_;
    const PlacedWorld* placed_;
    SnappedScene out_;
};

}   // namespace

SnappedScene snapped_scene(const FrameInputs& inputs, const PlacedWorld* placed) {
    return Snapper(inputs, placed)();
}

std::vector<std::string> snapping_faults(const FrameInputs& inputs, const PlacedWorld* placed) {
    std::vector<std::string> faults;
    if (!is_eye_near(inputs)) faults.emplace_back(far_eye);
    if (placed) return faults;
    const std::vector<double> most = corner_bounds(inputs.scene, inputs.lattice, inputs.config);
    for (std::size_t i = 0; i < most.size(); ++i) {
        const Vec3i at = inputs.lattice.snap(inputs.scene.vertices[i]);
        if (corner_error(inputs.lattice, at, inputs.scene.vertices[i]) > most[i]) {
            faults.emplace_back(far_corner);
            break;
        }
    }
    return faults;
}

Camera snapped_camera(const FrameInputs& inputs) {
    Camera camera = inputs.camera;
    const Vec3i& eye = inputs.frame.eye;
    const glm::dvec3 moved = units(inputs.lattice, {eye[0], eye[1], eye[2]}) - camera.eye;
    camera.eye += moved, camera.at += moved;
    return camera;
}

}   // namespace rayclock
