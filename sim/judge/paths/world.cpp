// Computes the correct surfaces, lights and registers of a frame.
#include "sim/judge/paths/world.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <glm/geometric.hpp>

#include "model/base/axes.hpp"
#include "model/compile/plane.hpp"
#include "sim/judge/paths/arithmetic.hpp"
#include "sim/judge/paths/texture.hpp"

namespace rayclock {

namespace {

using oracle::Solid;

/// Returns value * 2^bits, rounded to nearest and clamped to 0..most.
std::uint32_t natural(double value, int bits, double most) {
    return std::uint32_t(std::min(std::max(0.0, std::floor(value * std::exp2(bits) + 0.5)), most));
}
std::uint32_t share(double value) { return natural(value, share_bits, std::exp2(share_bits)); }
std::array<std::uint32_t, 3> shares(const glm::dvec3& v) { return {share(v.r), share(v.g), share(v.b)}; }

/// Returns the weight of a bounce. A positive value does not become 0.
std::uint32_t weight(double value) {
    const std::uint32_t nearest = natural(value, unit_bits, std::exp2(unit_bits));
    return value > 0 && nearest == 0 ? 1 : nearest;
}

/// Sets mirror and transmit. Their sum, the weight of a total reflection, is rounded once; transmit is the
/// rest.
void put_weights(const Material& m, Surface& s) {
    s.mirror = weight(m.mirror);
    s.transmit = weight(m.transmit);
    const double sum = m.mirror + m.transmit;
    if (m.mirror <= 0 || m.transmit <= 0 || sum > 1) return;
    const std::uint32_t both = weight(sum);
    s.transmit = both > s.mirror ? both - s.mirror : 1;
}

void put_material(const Material& m, Surface& s) {
    s.checkered = m.checkered ? 1 : 0;
    s.schlick = m.schlick ? 1 : 0;
    s.colour = shares(m.colour);
    s.other = shares(m.other);
    s.ambient = share(m.ambient);
    s.diffuse = share(m.diffuse);
    s.highlight = share(m.highlight);
    put_weights(m, s);
    s.shine = natural(m.shine, shine_frac, std::exp2(shine_bits) - 1);
    const double index = m.index > 0 ? m.index : 1, reflectance = (index - 1) / (index + 1),
                 most = std::exp2(ratio_bits) - 1;
    s.r0 = weight(reflectance * reflectance);
    s.enter = natural(1 / index, index_frac, most);
    s.leave = natural(index, index_frac, most);
}

/// Returns the exponent of the largest power of two that divides all components of the edges, up to a limit.
std::uint32_t fineness(const oracle::Corners& t, const Config& c) {
    const auto most = std::uint32_t(std::clamp(c.bary_bits - c.origin_bits, 0, max_fine));
    for (std::uint32_t bits = most; bits > 0; --bits) {
        bool all = true;
        for (std::size_t k = 0; k < 3; ++k)
            all = all && (t.b[k] - t.a[k]) % (1 << bits) == 0 && (t.c[k] - t.a[k]) % (1 << bits) == 0;
        if (all) return bits;
    }
    return 0;
}

std::int32_t signed_part(std::int64_t value, int bits) {
    const std::int64_t part = value & ((std::int64_t(1) << bits) - 1);
    return std::int32_t(part >> (bits - 1) ? part - (std::int64_t(1) << bits) : part);
}

/// Marks each sphere that has the centre and the radius of an earlier one.
void mark_seconds(std::vector<Solid>& solids) {
    std::set<std::pair<Vec3i, std::int64_t>> seen;
    for (Solid& ball : solids)
        if (ball.shape == Solid::Shape::sphere)
            ball.is_second = !seen.insert({ball.centre, ball.radius_squared}).second;
}

/// True if the lattice point lies within an opaque sphere on the lattice.
bool is_shut_in(const FrameInputs& inputs, const Vec3i& point) {
    Scene round;
    round.spheres = inputs.scene.spheres, round.materials = inputs.scene.materials;
    for (const Solid& ball : solids_of(round, inputs.lattice, inputs.config.coord_bits)) {
        const oracle::SolidRay start{point, 0, {}};
        if (!ball.is_glass && !ball.is_second && oracle::ball_of(start, ball).start < 0) return true;
    }
    return false;
}

/// Returns the largest sine by which a plane may turn on the lattice: T of
/// docs/proofs/who-checks-the-rules.md, Planes on the lattice.
double max_turn(const Plane& plane, const PlaneOnLattice& on, const Lattice& lattice) {
    const glm::dvec3 p = std::ldexp(1.0, -on.level[0]) * plane.u / lattice.pitch,
                     q = std::ldexp(1.0, -on.level[1]) * plane.v / lattice.pitch;
    const double a = glm::length(p), b = glm::length(q), half = 0.5 * std::sqrt(3.0);
    return half * (a + b + half) / glm::length(glm::cross(p, q));
}

/// Checks the stated planes between eye and light. The light is not clear if one of them is not a pane, a
/// plane contains the eye, or an opaque sphere encloses the light. If rounding decides on which side of a
/// plane the eye or the light lies, both answers pass. `light` must lie within the registers' range.
bool is_between_as_stated(const FrameInputs& inputs, const glm::dvec3& light, bool is_shut, bool stated,
                          std::uint32_t cell) {
    if (!inputs.scene.camera) return !is_shut == stated && cell == 0;
    const std::size_t first = primitive_count(inputs.scene) - inputs.scene.planes.size();
    bool clear = !is_shut, is_sure = true;
    std::uint32_t panes = 0, unsure = 0;
    for (std::size_t i = 0; i < inputs.scene.planes.size(); ++i) {
        const Plane& plane = inputs.scene.planes[i];
        const std::uint32_t pane = pane_bit(inputs, first + i);
        const glm::dvec3 n = glm::cross(plane.u, plane.v), to_eye = inputs.scene.camera->eye - plane.point,
                         to_light = light - plane.point;
        const PlaneOnLattice on = plane_on_lattice(plane, inputs.lattice);
        const double turn = max_turn(plane, on, inputs.lattice), step = inputs.lattice.coarsest();
        const glm::dvec3 a = inputs.lattice.centre + inputs.lattice.pitch * vector_of(on.a);
        // The bound of docs/proofs/who-checks-the-rules.md.
        const auto is_open = [&](double height, const glm::dvec3& point) {
            return std::abs(height) <= glm::length(n) * ((2 + turn) * step + turn * glm::length(point - a));
        };
        const double eye = glm::dot(n, to_eye), other = glm::dot(n, to_light);
        if (is_open(eye, inputs.scene.camera->eye) || is_open(other, light)) {
            is_sure = false;
            unsure |= pane;
        } else if ((eye > 0) != (other > 0)) {
            panes |= pane;
            clear = clear && pane != 0;
        }
    }
    return ((cell ^ panes) & ~unsure) == 0 && (clear == stated || (clear && !is_sure));
}

void judge_lights(const FrameInputs& inputs, std::vector<std::string>& wrong) {
    const ShadeFrame& frame = inputs.frame.shade;
    const Config& c = inputs.config;
    if (frame.lights != inputs.scene.lights.size())
        wrong.push_back("the frame has another number of lights than the scene");
    const double within = std::exp2(c.coord_bits - 1) - 1, reach = std::exp2(c.light_bits() - 1) - 1;
    for (std::size_t i = 0; i < inputs.scene.lights.size(); ++i) {
        const Light& light = inputs.scene.lights[i];
        const glm::dvec3 at = (light.position - inputs.lattice.centre) / inputs.lattice.pitch;
        const double size = std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)}),
                     scale = std::min(1.0, reach / std::max(size, 1.0));
        const bool is_near = std::round(size) <= within;
        const glm::dvec3 there = inputs.lattice.centre + scale * (light.position - inputs.lattice.centre);
        const Vec3i place{frame.place[3 * i], frame.place[3 * i + 1], frame.place[3 * i + 2]};
        bool good = (frame.near[i] != 0) == is_near &&
                    is_between_as_stated(inputs, there, is_near && is_shut_in(inputs, place),
                                         frame.clear[i] != 0, frame.cell[i]);
        for (std::size_t k = 0; k < 3; ++k) {
            good = good && std::abs(at[int(k)] * scale - frame.place[3 * i + k]) <= 0.5 + 1e-6;
            good = good && frame.colour[3 * i + k] ==
                               natural(light.colour[int(k)], share_bits, std::exp2(strength_bits) - 1);
        }
        if (!good) wrong.push_back("light " + std::to_string(i) + " is not the scene's");
    }
}

}   // namespace

const Material& material_of(const Scene& scene, std::size_t i) {
    const std::size_t triangles = scene.triangles.size(), spheres = scene.spheres.size();
    const std::uint32_t number = i < triangles             ? scene.triangles[i].material
                                 : i < triangles + spheres ? scene.spheres[i - triangles].material
                                                           : scene.planes[i - triangles - spheres].material;
    return scene.materials[number];
}

std::uint32_t pane_bit(const FrameInputs& inputs, std::size_t primitive) {
    const std::vector<Plane>& planes = inputs.scene.planes;
    const std::size_t first = primitive_count(inputs.scene) - planes.size();
    std::vector<oracle::Corners> panes;
    std::size_t pane = 0;
    for (std::size_t i = first; i <= primitive; ++i) {
        const PlaneOnLattice on = plane_on_lattice(planes[i - first], inputs.lattice);
        const auto holds = [&](const oracle::Corners& c, const Vec3i& p) {
            const auto from_corner = by_axis([&](std::size_t k) { return std::int64_t(p[k]) - c.a[k]; });
            return dot(from_corner, oracle::normal<std::int64_t>(c)) == 0;
        };
        for (pane = 0; pane < panes.size(); ++pane)
            if (holds(panes[pane], on.a) && holds(panes[pane], on.b) && holds(panes[pane], on.c)) break;
        const bool is_new = pane == panes.size() && pane < std::size_t(inputs.config.panes);
        if (is_new && inputs.scene.materials[planes[i - first].material].transmit > 0)
            panes.push_back({on.a, on.b, on.c});
    }
    return primitive >= first && pane < panes.size() ? std::uint32_t(1) << pane : 0;
}

std::vector<Solid> solids_of(const Scene& scene, const Lattice& lattice, int coord_bits) {
    std::vector<Solid> solids;
    solids.reserve(primitive_count(scene));
    const auto corner = [&](const Triangle& t, std::size_t k) {
        return lattice.snap(scene.vertices[t.vertex[k]]);
    };
    for (const Triangle& t : scene.triangles)
        solids.push_back({Solid::Shape::triangle, {corner(t, 0), corner(t, 1), corner(t, 2)}, {}, 0});
    for (const Sphere& s : scene.spheres) {
        const double radius = s.radius / lattice.pitch.x;
        const double square = std::min(std::round(radius * radius), std::exp2(2 * coord_bits) - 1);
        solids.push_back({Solid::Shape::sphere,
                          {},
                          lattice.snap(s.centre),
                          std::int64_t(square),
                          scene.materials[s.material].transmit > 0});
    }
    mark_seconds(solids);
    for (const Plane& p : scene.planes) {
        const PlaneOnLattice on = plane_on_lattice(p, lattice);
        solids.push_back({Solid::Shape::plane, {on.a, on.b, on.c}, {}, 0});
    }
    return solids;
}

std::vector<double> corner_bounds(const Scene& scene, const Lattice& lattice, const Config& config) {
    std::vector<double> shortest(scene.vertices.size(), HUGE_VAL);
    for (const Triangle& t : scene.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = t.vertex[i], to = t.vertex[(i + 1) % 3];
            const double edge = glm::length((scene.vertices[to] - scene.vertices[from]) / lattice.pitch);
            for (const std::uint32_t v : t.vertex) shortest[v] = std::min(shortest[v], edge);
        }
    for (double& bound : shortest)
        if (std::isfinite(bound)) bound = 0.5 + lattice_slack + (config.shading ? std::ldexp(bound, -13) : 0);
    return shortest;
}

double corner_error(const Lattice& lattice, const Vec3i& steps, const glm::dvec3& given) {
    double most = 0;
    for (int k = 0; k < 3; ++k) {
        const double size = std::abs(given[k]) + std::abs(lattice.centre[k]);
        most = std::max(most,
                        std::abs(steps[std::size_t(k)] - (given[k] - lattice.centre[k]) / lattice.pitch[k]) -
                            0x1p-50 * size / lattice.pitch[k]);
    }
    return most;
}

void snap_round(const Lattice& lattice, Scene& scene) {
    for (Sphere& s : scene.spheres) {
        const double radius = s.radius / lattice.pitch.x;
        const Vec3i centre = lattice.snap(s.centre);
        s.centre = {centre[0], centre[1], centre[2]};
        s.radius = std::sqrt(std::max(1.0, std::round(radius * radius)));
    }
    for (Plane& p : scene.planes) p = snapped_plane(p, lattice);
}

Surface expected_surface(const Scene& scene, const std::vector<Solid>& solids, const Config& config,
                         std::size_t i) {
    return expected_surface(scene, solids, config, i, material_of(scene, i));
}

Surface expected_surface(const Scene& scene, const std::vector<Solid>& solids, const Config& config,
                         std::size_t i, const Material& material) {
    const Solid& solid = solids[i];
    Surface s;
    s.a = solid.corners.a, s.b = solid.corners.b, s.c = solid.corners.c;
    switch (solid.shape) {
        case Solid::Shape::triangle:
            s.kind = PrimKind::triangle;
            s.fine = fineness(solid.corners, config);
            s.smooth = config.smooth && !scene.normals.empty();
            break;
        case Solid::Shape::sphere:
            s.kind = PrimKind::sphere;
            s.a = solid.centre;
            s.b = {signed_part(solid.radius_squared, config.coord_bits),
                   signed_part(solid.radius_squared >> config.coord_bits, config.coord_bits),
                   solid.is_glass ? 1 : 0};
            break;
        case Solid::Shape::plane: s.kind = PrimKind::plane; break;
    }
    put_material(material, s);
    if (solid.shape != Solid::Shape::plane) s.checkered = 0;   // no other surface has squares
    return s;
}

// If a number lies half-way between two, either passes, since the host computes in its own doubles. Either
// side passes if the sum of the normals lies in the triangle's plane.
bool holds_normals(const Scene& scene, std::size_t i, const Surface& seen) {
    const auto& v = scene.triangles[i].vertex;
    const glm::dvec3 b = scene.vertices[v[1]] - scene.vertices[v[0]],
                     c = scene.vertices[v[2]] - scene.vertices[v[0]], flat = glm::cross(b, c);
    const glm::dvec3 sum = scene.normals[v[0]] + scene.normals[v[1]] + scene.normals[v[2]];
    double longest = 0;
    for (const std::uint32_t corner : v) longest = std::max(longest, glm::length(scene.normals[corner]));
    const double along = glm::dot(sum, flat), most = std::exp2(corner_bits - 1) - 1,
                 scale = longest > 0 ? most / longest : 0;
    const auto holds = [&](double turn) {
        for (std::size_t corner = 0; corner < 3; ++corner)
            for (int k = 0; k < 3; ++k)
                if (std::abs(turn * scene.normals[v[corner]][k] * scale -
                             seen.normal[3 * corner + std::size_t(k)]) > 0.5 + 1e-9)
                    return false;
        return true;
    };
    const bool is_open = std::abs(along) <= 0x1p-48 * 3 * longest * glm::length(b) * glm::length(c);
    return holds(along < 0 ? -1 : 1) || (is_open && holds(along < 0 ? 1 : -1));
}

std::vector<std::string> judge_registers(const FrameInputs& inputs, const Whitted& settings) {
    std::vector<std::string> wrong;
    const Frame& frame = inputs.frame;
    const ShadeFrame& shade = frame.shade;
    const auto demand = [&](bool holds, const char* what) {
        if (!holds) wrong.push_back(std::string("the register for the frame's ") + what + " is wrong");
    };
    demand(frame.eye == inputs.lattice.snap(inputs.camera.eye), "eye");
    if (!inputs.config.shading) return wrong;
    const auto samples = std::uint32_t(settings.aa * settings.aa);
    demand(shade.depth == std::uint32_t(settings.depth), "depth");
    demand(shade.threshold ==
               std::uint32_t(std::floor(std::clamp(settings.threshold, 0.0, 1.0) * std::exp2(unit_bits + 1))),
           "threshold");
    demand(shade.side == std::uint32_t(settings.aa) && shade.stride == sample_stride(settings.aa), "samples");
    demand((shade.jitter != 0) == settings.jitter && (!settings.jitter || shade.seed == settings.seed),
           "jitter");
    demand(shade.share == natural(1.0 / samples, unit_bits, std::exp2(unit_bits)), "share of a sample");
    demand(
        shade.first_share == natural(1.0 / std::min(first_samples, samples), unit_bits, std::exp2(unit_bits)),
        "share of a first sample");
    for (int k = 0; k < 3; ++k)
        demand(shade.background[std::size_t(k)] ==
                   natural(inputs.scene.background[k], unit_bits, std::exp2(unit_bits)),
               "background");
    if (inputs.config.has_textures()) demand(is_spread(inputs, settings.aa), "spread of samples");
    judge_lights(inputs, wrong);
    return wrong;
}

}   // namespace rayclock
