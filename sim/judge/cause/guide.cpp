// Steers the reference tracer along the machine's path, and checks each step against its bound.
#include "sim/judge/cause/guide.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "model/compile/levels/maps.hpp"
#include "sim/judge/cause/level_error.hpp"
#include "sim/judge/cause/tie.hpp"
#include "sim/judge/paths/arithmetic.hpp"
#include "sim/judge/reference/geometry.hpp"
#include "sim/judge/reference/holes.hpp"

namespace rayclock {

namespace {

/// The largest distance of a point from its triangle in an instance that turns rays, in steps of the scene:
/// rho plus 3/4 of a step of the mesh (docs/machine/motion.md, Boxes). A step of the mesh is at most
/// max_stretch steps of the scene.
constexpr double max_turned = (8.5 + 0.75) * max_stretch;

glm::dvec3 units_of(const Lattice& lattice, const glm::dvec3& steps) {
    return lattice.centre + lattice.pitch * steps;
}

std::string name_of(std::uint32_t primitive) {
    return primitive == no_primitive ? "nothing" : "primitive " + std::to_string(primitive);
}

double chord(const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a - b); }

}   // namespace

void Guide::fail(std::string what) {
    if (finding_.fault.empty()) finding_.fault = std::move(what);
}

glm::dvec3 Guide::point(const Vec3l& p, int frac) const {
    const glm::dvec3 steps(std::ldexp(double(p[0]), -frac), std::ldexp(double(p[1]), -frac),
                           std::ldexp(double(p[2]), -frac));
    return rules_.reference.geometry().space()(units_of(rules_.inputs.lattice, steps));
}

glm::dvec3 Guide::direction(const Vec3i& d) const {
    return glm::normalize(glm::dvec3(d[0], d[1], d[2]) * rules_.inputs.lattice.pitch);
}

double Guide::step() const {
    return rules_.inputs.lattice.coarsest() * rules_.reference.geometry().space().scale;
}

bool Guide::is_turned(const MachineVisit& at) const {
    if (!rules_.placed || !at.hit.found) return false;
    const std::uint32_t place = rules_.placed->place_of(at.hit.prim);
    return place != oracle::PlacedRay::nowhere && !rules_.placed->is_same(place);
}

/// Returns the error bound of the machine's unit normal. An instance's map multiplies unit_vector()'s bound
/// by its condition number.
double Guide::normal_error(const MachineVisit& at) const {
    if (!is_turned(at)) return vector_error;
    const auto& a = rules_.placed->solids().places()[rules_.placed->place_of(at.hit.prim)].a;
    glm::dmat3 map(1);
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) map[k][i] = double(a[std::size_t(3 * i + k)]);
    const glm::dmat3 back = glm::inverse(map);
    double size = 0, other = 0;
    for (int i = 0; i < 3; ++i) size += glm::dot(map[i], map[i]), other += glm::dot(back[i], back[i]);
    return std::min(2.0, 2 * std::sqrt(size * other) * vector_error + vector_error);
}

// ---- Rays.

void Guide::begin_sample(std::uint32_t sample, RefPath& path) {
    at_.assign(1, sample < path_.samples.size() ? path_.samples[sample] : MachineVisit::none);
    const MachineVisit* at = visit();
    if (!at) return fail("the machine took fewer samples than the pixel has");
    ++visited_;
    if (!rules_.camera.goes_through(path.direction, at->ray.d))
        fail("the camera ray does not go through its sample");
    path.direction = direction(at->ray.d);
}

/// The machine compares its own colours, which lie within sample_width_ of the reference's. The register of
/// the contrast is rounded up.
bool Guide::ends_sampling(std::uint32_t samples, double difference, bool own) {
    const bool machine = path_.samples.size() <= samples;
    if (machine == own) return machine;
    if (std::abs(difference - rules_.contrast) <= 2 * sample_width_ + unit_step)
        tie();
    else
        fail(machine ? "the pixel ends although its first samples differ"
                     : "the pixel continues although its first samples are similar");
    return machine;
}

std::optional<RefClosest> Guide::find_tie(const RefPath& path, const RefClosest& own,
                                          std::uint32_t wanted) const {
    const RefGeometry& geometry = rules_.reference.geometry();
    std::optional<RefClosest> found;
    const auto is_as_deep = [&](const RefClosest& hit) {
        return std::abs(hit.depth - own.depth) <= 4 * tie_size * (1 + own.depth);
    };
    const auto is_match = [&](const RefPath& moved) {
        const RefClosest hit = geometry.closest(moved);
        if (hit.primitive != wanted) return false;
        found = hit;
        return true;
    };
    if (any_moved(path, is_match)) return found;
    if (wanted == no_primitive) return std::nullopt;
    const auto look_deep = [&](const RefPath& moved) {
        const RefClosest hit = geometry.only(moved, wanted);
        if (hit.primitive != wanted || !is_as_deep(hit)) return false;
        found = hit;
        return true;
    };
    if (look_deep(path) || any_moved(path, look_deep)) return found;
    return std::nullopt;
}

/// Returns the path from the reference's own point to the same end. The machine's point is rounded, so it may
/// lie off its sphere or beyond a crease.
RefPath Guide::from_own(const RefPath& path, double distance) const {
    // A bounce leaves the previous visit's point.
    const std::size_t depth = std::isfinite(distance) ? at_.size() : at_.size() - 1;
    RefPath moved = path;
    if (depth == 0 || depth > moved_.size()) return moved;
    moved.from -= moved_[depth - 1];
    if (std::isfinite(distance))
        moved.direction = glm::normalize(path.from + distance * path.direction - moved.from);
    return moved;
}

/// Returns the error of a hit on a sphere in lattice steps: rounding of the root, of t and of the point
/// (model/unit/tri/any_primitive.hpp). Of two hits that are closer together than this, either may win.
double Guide::sphere_error(const MachineVisit& at, std::uint32_t primitive) const {
    const Scene& scene = rules_.scene;
    const Config& config = rules_.inputs.config;
    if (primitive < scene.triangles.size() || primitive >= scene.triangles.size() + scene.spheres.size())
        return 0;
    const Vec3i& d = at.ray.d;
    const double length = std::sqrt(double(d[0]) * d[0] + double(d[1]) * d[1] + double(d[2]) * d[2]),
                 radius = scene.spheres[primitive - scene.triangles.size()].radius /
                          rules_.inputs.lattice.coarsest();
    const double tick = std::exp2(1 - config.dir_bits - config.t_frac_bits) * length,
                 point = std::exp2(-config.origin_frac());
    // The tracer moves a ray off the surface that it leaves.
    const RefUnitSpace& space = rules_.reference.geometry().space();
    const glm::dvec3 from = this->point({at.ray.o[0], at.ray.o[1], at.ray.o[2]}, config.origin_frac()),
                     to_centre = space(scene.spheres[primitive - scene.triangles.size()].centre) - from;
    const double graze =
        graze_error(to_centre, direction(d), radius * step(), off_surface_size * (1 + glm::length(from)));
    return tick + std::max(point / length, radius * std::exp2(1 - root_bits)) + 3 * point + graze / step();
}

/// Returns the error of a hit on a flat surface in lattice steps, because the tracer moves a ray off the
/// surface that it leaves. The error is large for a ray that is nearly parallel to the surface.
double Guide::flat_error(const MachineVisit& at, const glm::dvec3& normal) const {
    const double cosine = std::abs(glm::dot(normal, direction(at.ray.d))),
                 size = glm::length(
                     point({at.ray.o[0], at.ray.o[1], at.ray.o[2]}, rules_.inputs.config.origin_frac()));
    return off_surface_size * (1 + size) / (cosine * step());
}

bool Guide::is_within_root(const RefPath& path, const RefClosest& own, const MachineVisit& at) const {
    if (!at.hit.found || own.primitive == no_primitive) return false;
    const double most = (sphere_error(at, own.primitive) + sphere_error(at, at.hit.prim)) * step();
    const RefClosest other = rules_.reference.geometry().only(path, at.hit.prim);
    return most > 0 && other.primitive != no_primitive && other.depth - own.depth <= most;
}

/// Returns true if the reference's hit lies outside the lattice. A machine's ray from beyond the lattice
/// begins where it enters the lattice, so it misses all surfaces before that point.
bool Guide::is_beyond_horizon(const RefPath& path, const RefClosest& own, const MachineVisit& at) const {
    if (at.parent < 0) return false;
    const MachineVisit& from = path_.visits[std::size_t(at.parent)];
    if (!from.state.is_far || at.ray.is_partial) return false;
    const Scene& scene = rules_.scene;
    if (own.primitive == no_primitive || own.primitive < scene.triangles.size() + scene.spheres.size())
        return false;
    const double entry = glm::length(
        point({at.ray.o[0], at.ray.o[1], at.ray.o[2]}, rules_.inputs.config.origin_frac()) - path.from);
    return own.depth <= entry + step();
}

RefClosest Guide::as_machine(const RefPath& path, const MachineVisit& at) {
    is_substituted_ = true;
    if (!at.hit.found) return {};
    RefClosest hit = rules_.reference.geometry().only(path, at.hit.prim);
    if (hit.primitive != no_primitive) return hit;
    hit.primitive = at.hit.prim;
    if (at.hit.prim < rules_.scene.triangles.size()) {
        const std::array<double, 2> w = weights(at);
        hit.u = w[0], hit.v = w[1];
    }
    hit.depth = glm::length(point(at.state.o, rules_.inputs.config.origin_frac()) - path.from);
    return hit;
}

/// Returns the ray as the machine sends it if it does not meet the lattice: without the last far_drop bits of
/// its origin.
RefPath Guide::from_far(const RefPath& path, const MachineVisit& at) {
    const int frac = rules_.inputs.config.origin_frac() - far_drop;
    RefPath moved = path;
    moved.from = point({at.ray.o[0], at.ray.o[1], at.ray.o[2]}, frac);
    if (chord(moved.from, path.from) > 1.7320509 * std::exp2(-frac) * step() * (1 + tie_size))
        fail("a ray that passes by the lattice begins at another point");
    return moved;
}

RefClosest Guide::choose_hit(const RefPath& sent, const RefClosest& closest) {
    const MachineVisit* at = visit();
    const Scene& scene = rules_.scene;
    const bool is_far = at && at->ray.is_partial;
    const RefPath path = is_far ? from_far(sent, *at) : sent;
    const RefClosest own = is_far ? rules_.reference.geometry().closest(path) : closest;
    if (!at) {   // the machine sent no ray: the ray misses the lattice and gets the background
        const bool is_plane = own.primitive >= scene.triangles.size() + scene.spheres.size();
        if (own.primitive == no_primitive) return own;
        if (is_plane)
            finding_.has_horizon = true;
        else
            fail("the machine sends no ray, and one would meet " + name_of(own.primitive));
        return {};
    }
    const std::uint32_t wanted = at->hit.found ? at->hit.prim : no_primitive;
    is_substituted_ = false;
    if (own.primitive == wanted) return own;
    for (const RefPath& from : {path, from_own(path, HUGE_VAL)})
        if (const std::optional<RefClosest> hit = find_tie(from, own, wanted)) {
            tie();
            is_substituted_ = true;
            return *hit;
        }
    if (is_within_root(path, own, *at)) {
        tie();
        return rules_.reference.geometry().only(path, wanted);
    }
    if (is_beyond_horizon(path, own, *at)) {
        finding_.has_horizon = true;
        return as_machine(path, *at);
    }
    if (rules_.seams && rules_.seams->explain(at->ray, at->hit) != RayFinding::none) {
        finding_.has_seam = true;
        return as_machine(path, *at);
    }
    fail("a ray meets " + name_of(wanted) + ", and by the reference's rules " + name_of(own.primitive));
    return as_machine(path, *at);
}

// ---- Surfaces.

/// Returns true if memory turned the corner normals of a triangle of the scene to the side that its order of
/// corners makes the outside, or if doubles cannot decide. Uses the corners as given: the reference's are on
/// the lattice, where a sum of normals near the triangle's plane may lie on its other side.
bool Guide::points_outwards(const MachineVisit& at) const {
    const Scene& given = rules_.inputs.scene;
    if (at.hit.prim >= given.triangles.size()) return true;   // of an instance that is not written out
    const auto& v = given.triangles[at.hit.prim].vertex;
    const glm::dvec3 a = given.vertices[v[0]], b = given.vertices[v[1]] - a, c = given.vertices[v[2]] - a;
    glm::dvec3 sum(0);
    double lengths = 0, memory = 0;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const glm::dvec3& n = given.normals[v[corner]];
        sum += n, lengths += glm::length(n);
        for (int k = 0; k < 3; ++k) memory += n[k] * at.surface.normal[3 * corner + std::size_t(k)];
    }
    const double along = glm::dot(sum, glm::cross(b, c));
    return (along < 0) == (memory < 0) ||
           std::abs(along) <= 0x1p-48 * lengths * glm::length(b) * glm::length(c);
}

/// Rounds corner normals to corner_bits bits, in the space in which memory holds the triangle. The longest of
/// the three uses the whole range. Memory's normals of an instance are turned outwards in the mesh's space.
/// There another side may be outside if a map stretches, so PlacedWorld::holds_normals() judges that side.
void Guide::round_normals(const MachineVisit& at, std::array<glm::dvec3, 3>& normals) {
    glm::dmat3 map(1);   // x in the mesh = map x in the scene, in steps
    if (is_turned(at)) {
        const auto& a = rules_.placed->solids().places()[rules_.placed->place_of(at.hit.prim)].a;
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k)
                map[k][i] = std::ldexp(double(a[std::size_t(3 * i + k)]), -rules_.inputs.config.map_frac());
    }
    const glm::dmat3 forth = glm::transpose(map), back = glm::inverse(forth);
    double longest = 0;
    for (glm::dvec3& n : normals) n = back * n, longest = std::max(longest, glm::length(n));
    if (!(longest > 0)) return;
    const double most = std::exp2(corner_bits - 1) - 1;
    const bool is_mirrored =
        rules_.placed && rules_.placed->is_mirrored(rules_.placed->place_of(at.hit.prim));
    const auto memory_of = [&](std::size_t corner, int k) {
        const std::size_t stored = is_mirrored && corner > 0 ? 3 - corner : corner;
        return double(at.surface.normal[3 * stored + std::size_t(k)]);
    };
    double along = 0;
    for (std::size_t corner = 0; corner < 3; ++corner)
        for (int k = 0; k < 3; ++k) along += normals[corner][k] * memory_of(corner, k);
    if (along < 0) {
        if (is_turned(at) || points_outwards(at))
            tie();
        else
            fail("the normals of the corners point to the other side");
        for (glm::dvec3& n : normals) n = -n;
    }
    for (std::size_t corner = 0; corner < 3; ++corner) {
        glm::dvec3& n = normals[corner];
        n *= most / longest;
        for (int k = 0; k < 3; ++k) {
            // Doubles cannot decide which way half a unit is rounded, so either way is accepted.
            const double memory = memory_of(corner, k);
            n[k] = std::abs(n[k] - memory) <= 0.5 + tie_size * std::abs(n[k]) ? memory : std::round(n[k]);
        }
        n = forth * (n * (longest / most));
    }
}

std::array<double, 2> Guide::weights(const MachineVisit& at) const {
    const bool has_inner = rules_.placed != nullptr;
    const int frac = rules_.inputs.config.origin_frac();
    const Vec3l& p = has_inner ? at.state.inner : at.state.o;
    const auto of = [](const Vec3i& v) { return glm::dvec3(v[0], v[1], v[2]); };
    const glm::dvec3 a = of(at.surface.a), e1 = of(at.surface.b) - a, e2 = of(at.surface.c) - a,
                     way = glm::dvec3(std::ldexp(double(p[0]), -frac), std::ldexp(double(p[1]), -frac),
                                      std::ldexp(double(p[2]), -frac)) -
                           a,
                     n = glm::cross(e1, e2);
    const double square = glm::dot(n, n);
    std::array<double, 2> w{glm::dot(glm::cross(way, e2), n) / square,
                            glm::dot(glm::cross(e1, way), n) / square};
    if (rules_.placed && rules_.placed->is_mirrored(rules_.placed->place_of(at.hit.prim)))
        std::swap(w[0], w[1]);
    return w;
}

/// The machine rounds u and v down, rounds them again to origin_bits (and `fine`), and moves them off the
/// border by at most two units.
void Guide::round_corners(RefClosest& hit, std::array<glm::dvec3, 3>& normals, bool) {
    const MachineVisit* at = visit();
    if (!at || !at->hit.found || at->hit.prim != hit.primitive) return;
    const Config& config = rules_.inputs.config;
    const std::array<double, 2> w = weights(*at);
    const auto side = [&](const Vec3i& to) {
        return glm::dvec3(to[0] - at->surface.a[0], to[1] - at->surface.a[1], to[2] - at->surface.a[2]);
    };
    const glm::dvec3 b = side(at->surface.b), c = side(at->surface.c), n = glm::cross(b, c);
    const double unit = std::exp2(-config.origin_bits - int(at->surface.fine)),
                 moved = flat_error(*at, glm::normalize(n)) * std::max(glm::length(b), glm::length(c)) /
                         glm::length(n),
                 most = std::exp2(-config.bary_bits) + 2.5 * unit + tie_size + moved;
    if (!is_turned(*at) && (std::abs(w[0] - hit.u) > most || std::abs(w[1] - hit.v) > most))
        fail("rays leave from another point of the triangle than the one that was hit");
    hit.u = w[0], hit.v = w[1];
    round_normals(*at, normals);
}

glm::dvec3 Guide::plane_colour(const RefClosest& hit, const Material& material, const glm::dvec3& own) {
    const MachineVisit* at = visit();
    if (!at || !at->hit.found || at->hit.prim != hit.primitive || !material.checkered) return own;
    glm::dvec3 seen(0);
    const std::array<std::uint32_t, 3>& albedo = at->texture ? at->texture->below : at->state.albedo;
    for (int k = 0; k < 3; ++k) seen[k] = std::ldexp(double(albedo[std::size_t(k)]), -share_bits);
    const double unit = std::exp2(-share_bits);
    const auto is = [&](const glm::dvec3& colour) {
        return glm::all(glm::lessThanEqual(glm::abs(seen - colour), glm::dvec3(unit)));
    };
    if (is(own)) return own;
    // The machine counts squares in sides of the plane, each halved or doubled to fit the lattice
    // (plane.hpp), with bary_bits. Where sides end, or squares are finer than these bits, it uses the average
    // colour.
    const Scene& scene = rules_.scene;
    const Plane& plane = scene.planes[hit.primitive - scene.triangles.size() - scene.spheres.size()];
    const auto of = [](const Vec3i& v) { return glm::dvec3(v[0], v[1], v[2]); };
    const glm::dvec3 pitch = rules_.inputs.lattice.pitch;
    const double side_u = glm::length((of(at->surface.b) - of(at->surface.a)) * pitch) / glm::length(plane.u),
                 side_v = glm::length((of(at->surface.c) - of(at->surface.a)) * pitch) / glm::length(plane.v),
                 fine = std::exp2(-rules_.inputs.config.bary_bits);
    const auto is_near = [&](double x, double side) {
        return std::abs(x - std::round(x)) <= fine * side + 0x1p-36 * (1 + std::abs(x));
    };
    const bool is_average = is(0.5 * (material.colour + material.other)),
               is_either = is(material.colour) || is(material.other);
    const bool is_fine = std::max(side_u, side_v) * fine > 0.25;
    if ((is_average && (at->state.is_lost || is_fine)) ||
        (is_either && (is_near(hit.u, side_u) || is_near(hit.v, side_v)))) {
        tie();
        return seen;
    }
    fail("a plane has another square's colour");
    return own;
}

void Guide::move_ray_origin(RefSurface& surface) {
    const MachineVisit* at = visit();
    if (!at || !at->hit.found || at->hit.prim != surface.primitive) return;
    if (at->state.is_lost) {
        finding_.has_lost = true;
        return;
    }
    const Config& config = rules_.inputs.config;
    const glm::dvec3 machine = point(at->state.o, config.origin_frac());
    moved_.resize(at_.size());
    moved_.back() = machine - surface.position;
    if (is_substituted_) {
        surface.position = machine;
        return;
    }
    const double grain = std::exp2(-config.origin_frac()),
                 double_slack = 4 * tie_size * (1 + glm::length(machine));
    double most = 0;
    const auto kind = at->surface.kind;
    const auto edge = [&](const Vec3i& from, const Vec3i& to) {
        const double x = double(to[0]) - from[0], y = double(to[1]) - from[1], z = double(to[2]) - from[2];
        return std::sqrt(x * x + y * y + z * z);
    };
    const Vec3i& d = at->ray.d;
    const double length = std::sqrt(double(d[0]) * d[0] + double(d[1]) * d[1] + double(d[2]) * d[2]),
                 tick = std::exp2(1 - config.dir_bits - config.t_frac_bits) * length;
    if (is_turned(*at)) {
        // The point lies on the scene's ray. The triangle lies where the instance's ray meets it.
        const glm::dvec3 off = (machine - surface.position) / step(), way = direction(d);
        if (glm::length(off - glm::dot(off, way) * way) > 2 * grain + tick + double_slack / step() ||
            std::abs(glm::dot(off, surface.flat)) > max_turned)
            fail("rays leave from another point than the one that was hit");
        surface.position = machine;
        return;
    } else if (kind == PrimKind::sphere) {
        most = sphere_error(*at, surface.primitive);
    } else {
        const double unit =
            std::exp2(-config.bary_bits) +
            (kind == PrimKind::plane ? 0.5 : 2.5) * std::exp2(-config.origin_bits - int(at->surface.fine));
        most = unit * (edge(at->surface.a, at->surface.b) + edge(at->surface.a, at->surface.c)) + grain +
               flat_error(*at, surface.flat);
    }
    if (chord(machine, surface.position) > most * step() + double_slack)
        fail("rays leave from another point than the one that was hit");
    surface.position = machine;
    if (kind == PrimKind::sphere) {
        const Sphere& s = rules_.scene.spheres[surface.primitive - rules_.scene.triangles.size()];
        const glm::dvec3 out = glm::normalize(machine - rules_.reference.geometry().space()(s.centre));
        surface.flat = surface.normal = surface.is_inside ? -out : out;
    }
}

// ---- Lights.

bool Guide::light_counts(std::size_t light, double side, double lambert) {
    const MachineVisit* at = visit();
    const bool own = side > 0 && lambert > 0;
    if (!at) return own;
    if (light >= at->lights.size()) {
        fail("a light is left out");
        return own;
    }
    const MachineLight& seen = at->lights[light];
    const bool machine = seen.was_sent || seen.is_lit;
    if (machine == own) return own;
    const bool is_exact = !is_turned(*at) && !at->state.is_far && !(rules_.placed && at->state.is_far) &&
                          rules_.inputs.frame.shade.near[light] != 0;
    const double side_error =
        is_exact ? 4 * tie_size : 2 * vector_error + std::exp2(2 - rules_.inputs.config.dir_bits);
    const double error = normal_error(*at) + vector_error + unit_step;
    const bool is_close = std::abs(side) <= side_error || std::abs(lambert) <= error;
    if (is_close) {
        tie();
        return machine;
    }
    if (machine) {
        fail("a light counts that lies behind the surface");
        return true;
    }
    if (at->state.is_far) return true;   // the machine treats it as hidden; is_blocked() checks this
    fail("a light that the surface faces does not count");
    return own;
}

bool Guide::is_blocking_tied(const RefPath& path, double distance, bool wanted) const {
    // The machine rounds u and v down, and the cut-off to a code. With two levels a hit may move by a few
    // steps.
    const Config& config = rules_.inputs.config;
    const glm::dvec3& pitch = rules_.inputs.lattice.pitch;
    HoleSlack slack{4 * std::exp2(-config.bary_bits),
                    rules_.placed ? 4 * std::max(pitch.x, std::max(pitch.y, pitch.z)) : 0, 0.5 / 255,
                    error_of_level};
    if (rules_.placed)
        for (const auto& place : rules_.placed->solids().places())
            slack.level = std::max(slack.level, error_of_level + stretch_error(place.a));
    const auto is_match = [&](const RefPath& moved) {
        for (const double scale : {1 - 4 * tie_size, 1 + 4 * tie_size}) {
            const Hidden found = hidden_at(rules_.reference.geometry(), rules_.scene, moved, distance * scale,
                                           rules_.spread, slack);
            if (wanted ? found.possibly : !found.surely) return true;
        }
        return false;
    };
    return is_match(path) || any_moved(path, is_match);
}

/// Returns true if the machine may miss a light because the point lies beyond the lattice. For such a point
/// the machine stores only the eye's side of each plane, and for a pane the path's side. Behind another
/// transmitting plane a point may get different light (docs/proofs/origins.md, Points of a plane beyond the
/// lattice).
bool Guide::is_hidden_beyond_horizon(std::size_t light, const RefPath& path, double distance,
                                     const MachineVisit& at) const {
    const Scene& scene = rules_.scene;
    const auto transmitting =
        std::count_if(scene.planes.begin(), scene.planes.end(),
                      [&](const Plane& plane) { return scene.materials[plane.material].transmit > 0; });
    const bool is_beyond = rules_.inputs.frame.shade.near[light] == 0;
    if (at.state.is_lost || (finding_.has_horizon && (at.state.is_far || is_beyond))) return true;
    if (at.state.is_far && is_beyond && !at.lights[light].is_lit) {
        const RefClosest behind = rules_.reference.geometry().closest(path);
        if (behind.primitive != no_primitive && behind.depth > distance) return true;
    }
    const Vec3i& eye = rules_.inputs.frame.eye;
    const glm::dvec3 from = units_of(rules_.inputs.lattice, {eye[0], eye[1], eye[2]});
    const bool holds_eye = std::any_of(scene.planes.begin(), scene.planes.end(), [&](const Plane& plane) {
        const glm::dvec3 n = glm::normalize(glm::cross(plane.u, plane.v));
        return std::abs(glm::dot(n, from - plane.point)) <= tie_size * glm::length(from - plane.point);
    });
    if (holds_eye && (at.state.is_far || is_beyond) && !at.lights[light].is_lit) return true;
    if (transmitting <= rules_.inputs.config.panes || (!at.state.is_far && !is_beyond)) return false;
    const std::vector<std::uint32_t> blockers = rules_.reference.geometry().blockers(path, distance);
    return std::all_of(blockers.begin(), blockers.end(), [&](std::uint32_t primitive) {
        return primitive >= scene.triangles.size() + scene.spheres.size();
    });
}

bool Guide::is_blocked(std::size_t light, const RefPath& path, double distance, bool own) {
    const MachineVisit* at = visit();
    if (!at || light >= at->lights.size()) return own;
    const MachineLight& seen = at->lights[light];
    const bool machine = !seen.is_lit;
    if (machine == own) return own;
    if (is_blocking_tied(path, distance, machine) ||
        is_blocking_tied(from_own(path, distance), distance, machine)) {
        tie();
        return machine;
    }
    if (seen.was_sent && seen.ray.kind == RayKind::away) {
        // Its direction is a rounded unit vector. It begins at the light or at the surface.
        const bool from_light = rules_.inputs.frame.shade.near[light] != 0;
        const glm::dvec3 turned = (from_light ? -1.0 : 1.0) * direction(seen.ray.d);
        if (chord(turned, path.direction) > 2 * vector_error + std::exp2(3 - rules_.inputs.config.dir_bits)) {
            fail("a shadow ray does not lead to its light");
            return machine;
        }
        RefPath moved = path;
        if (from_light) moved.from = path.from + distance * path.direction - distance * turned;
        moved.direction = turned;
        if (is_blocking_tied(moved, distance, machine)) {
            tie();
            return machine;
        }
    }
    if (seen.was_sent && rules_.seams) {
        Closest answer;
        answer.found = machine;
        if (rules_.seams->explain(seen.ray, answer) != RayFinding::none) {
            finding_.has_seam = true;
            return machine;
        }
    }
    if (is_hidden_beyond_horizon(light, path, distance, *at)) {
        finding_.has_horizon = true;
        return machine;
    }
    fail(machine ? "a light is hidden that nothing hides by the reference's rules"
                 : "a light is seen through something that hides it by the reference's rules");
    return machine;
}

// ---- Bounces.

bool Guide::is_total(const RefSurface&, double ratio, double cosine, bool own) {
    const MachineVisit* at = visit();
    if (!at) return own;
    const bool machine = at->state.total != 0;
    if (machine == own) return own;
    const double error = normal_error(*at) + vector_error + unit_step, index = 0.5 * std::exp2(-index_frac);
    const auto rest = [](double r, double c) { return 1 - r * r * (1 - c * c); };
    const double least = rest(ratio + index, std::max(0.0, cosine - error)),
                 most = rest(std::max(0.0, ratio - index), std::min(1.0, cosine + error));
    if (least <= 0 && most >= 0)
        tie();
    else
        fail("total reflection was decided otherwise");
    return machine;
}

/// Returns the error bound of a bounce's direction. R = 2 (N . V) N - V has four times the normal's error
/// plus the view's. A refracted ray's error comes from both cosines, and is large near the critical angle.
double Guide::direction_error(const RefBounce& bounce, const MachineVisit& at) const {
    const double n = normal_error(at), full = std::exp2(rules_.inputs.config.dir_bits - 2);
    const double grain = 1.7320509 * (1.5 * unit_step + 1 / full);
    if (bounce.interaction == RefBounce::Interaction::reflected)
        return 2 * (4 * n + 2 * n * n + 2 * vector_error + grain);
    const double error = n + vector_error + unit_step, index = 0.5 * std::exp2(-index_frac) + unit_step;
    const auto bent = [&](double r, double c) {
        return r * c - std::sqrt(std::max(0.0, 1 - r * r * (1 - c * c)));
    };
    const double r = bounce.ratio, c = bounce.cosine, middle = bent(r, c);
    double wide = 0;
    for (const double dr : {-index, index})
        for (const double dc : {-error, error})
            wide =
                std::max(wide, std::abs(bent(std::max(0.0, r + dr), std::clamp(c + dc, 0.0, 1.0)) - middle));
    // Near the critical angle the root is steep, so the corners above do not bound it.
    const double root = std::sqrt(4 * r * r * error + 4 * r * index);
    const double rest = 1 - r * r * (1 - c * c);
    if (rest < 16 * r * r * error) wide = std::max(wide, root);
    return 2 * (wide + (1 + std::abs(middle)) * n + r * vector_error + index + grain);
}

bool Guide::accept_bounce(RefBounce& bounce) {
    const bool is_reflected = bounce.interaction == RefBounce::Interaction::reflected;
    const double side = (is_reflected ? 1 : -1) * glm::dot(bounce.direction, bounce.surface.flat);
    const bool own = bounce.weighs_enough && side > 0;
    const MachineVisit* at = visit();
    if (!at) return own;
    const int child = is_reflected ? at->reflected : at->refracted;
    const double error = direction_error(bounce, *at);
    const bool is_weight_close =   // docs/machine/shading.md, Weights and threshold
        std::abs(bounce.weight - rules_.inputs.frame.shade.threshold * std::exp2(-unit_bits - 1)) <=
        (4 * double(at_.size()) + 1) * unit_step;
    const bool is_side_close = std::abs(side) <= error;
    if (child == MachineVisit::none) {
        if (is_reflected ? at->is_reflected_past : at->is_refracted_past) {   // see choose_hit()
            if (rules_.inputs.config.horizon && !at->state.is_lost)
                fail("a bounce beyond the lattice is not sent");
            if (!own) tie();
            return true;
        }
        if (!own) return false;
        if (is_weight_close || is_side_close) {
            tie();
            return false;
        }
        fail(is_reflected ? "a reflected ray is missing" : "a refracted ray is missing");
        return false;
    }
    if (!own && !is_side_close && !(bounce.weighs_enough || is_weight_close)) {
        fail("a bounce of too little weight is sent");
    } else if (!own && !is_side_close && side <= 0) {
        fail("a bounce leaves on the wrong side");
    } else if (!own) {
        tie();
    }
    const glm::dvec3 machine = direction(path_.visits[std::size_t(child)].ray.d);
    if (chord(machine, bounce.direction) > error)
        fail(is_reflected ? "a reflected ray goes elsewhere" : "a refracted ray goes elsewhere");
    bounce.direction = machine;
    return true;
}

void Guide::enter(RefBounce::Interaction interaction) {
    const MachineVisit* at = visit();
    at_.push_back(!at                                                ? MachineVisit::none
                  : interaction == RefBounce::Interaction::reflected ? at->reflected
                  : interaction == RefBounce::Interaction::passed    ? at->onward
                                                                     : at->refracted);
    if (at_.back() != MachineVisit::none) ++visited_;
}

void Guide::finish() {
    if (visited_ != path_.visits.size()) fail("the machine follows a ray that the reference does not send");
}

}   // namespace rayclock
