// Computes the line that each instance sees, and its first hit.
#include "sim/judge/cause/seam.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/matrix.hpp>

namespace rayclock {

namespace {

constexpr std::uint32_t nowhere = oracle::PlacedRay::nowhere;
constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double of_doubles = 1e-6;   // error of a distance computed in doubles, in steps
constexpr double same_place = 1e-9;   // relative difference of two t that doubles cannot distinguish

glm::dvec3 origin_of(const oracle::SolidRay& ray) {
    return std::ldexp(1.0, -ray.frac) * glm::dvec3(ray.origin[0], ray.origin[1], ray.origin[2]);
}
glm::dvec3 direction_of(const oracle::SolidRay& ray) {
    return {ray.direction[0], ray.direction[1], ray.direction[2]};
}

/// Returns t of the closest hit.
double first_of(const oracle::Nearest& met) {
    const double flat =
        met.flat.primitive == no_primitive ? endless : double(met.flat.num) / double(met.flat.den);
    return met.sphere.primitive == no_primitive ? flat : std::min(flat, met.sphere.distance);
}

/// Returns t of the hit on a sphere or plane. Numbers of spheres come before numbers of planes.
double round_distance(const Scene& round, std::size_t number, const glm::dvec3& o, const glm::dvec3& d) {
    if (number >= round.spheres.size()) {
        const Plane& plane = round.planes[number - round.spheres.size()];
        const glm::dvec3 n = glm::cross(plane.u, plane.v);
        return glm::dot(n, plane.point - o) / glm::dot(n, d);
    }
    const Sphere& sphere = round.spheres[number];
    const glm::dvec3 from = o - sphere.centre;
    const double square = glm::dot(d, d), along = glm::dot(from, d),
                 start = glm::dot(from, from) - sphere.radius * sphere.radius,
                 root = std::sqrt(std::max(0.0, along * along - square * start));
    return start > 0 && along < 0 ? start / (root - along) : (root - along) / square;
}

}   // namespace

/// A ray and its answer.
struct SeamFinder::Question {
    oracle::PlacedRay ray;
    bool ends_at_any = false;
    double end = endless;           ///< of a shadow ray
    std::uint32_t left = nowhere;   ///< the instance that the ray leaves, or at which it ends
    LineHit answer{};
};

SeamFinder::SeamFinder(const PlacedWorld& world, const Config& config)
    : world_(world), config_(config), snapped_(world.snapped()) {
    for (const oracle::SolidPlace& place : world.solids().places()) {
        Map map;
        for (std::size_t i = 0; i < 3; ++i) {
            map.b[int(i)] = std::ldexp(double(place.b[i]), -config.map_frac());
            for (std::size_t k = 0; k < 3; ++k)
                map.a[int(k)][int(i)] = std::ldexp(double(place.a[3 * i + k]), -config.map_frac());
        }
        map.back = glm::inverse(map.a);
        maps_.push_back(map);
    }
    Scene round;
    round.spheres = snapped_.own.spheres, round.materials = snapped_.own.materials;
    ends_.emplace(round);
    round.planes = snapped_.own.planes;
    for (const SharedMesh& mesh : snapped_.meshes) {
        Scene scene;
        scene.vertices = mesh.vertices, scene.triangles = mesh.triangles;
        // Only the mesh of spheres and planes has no triangles.
        meshes_.emplace_back(mesh.triangles.empty() ? round : scene);
    }
}

SeamFinder::Line SeamFinder::line_of(std::uint32_t place, const oracle::PlacedRay& ray) const {
    if (place == nowhere) return {nowhere, origin_of(ray.ray), direction_of(ray.ray)};
    const oracle::SolidRay seen = world_.solids().seen_by(place, ray);
    const Map& map = maps_[place];
    return {place, map.back * (origin_of(seen) - map.b), map.back * direction_of(seen)};
}

/// Computes t from the plane or sphere that the line meets, because a Hit holds only a float.
SeamFinder::LineHit SeamFinder::met_by_line(const Line& line, std::uint32_t place, bool is_finite) const {
    const Map& map = maps_[place];
    const glm::dvec3 o = map.a * line.o + map.b, d = map.a * line.d;
    const std::uint32_t mesh = world_.solids().places()[place].mesh;
    const bool is_round = snapped_.meshes[mesh].triangles.empty();
    const Hit hit = (is_round && is_finite ? *ends_ : meshes_[mesh]).trace(o, d);
    if (hit.primitive == no_primitive) return {};
    if (is_round) return {place, round_distance(snapped_.own, hit.primitive, o, d)};
    const auto& v = snapped_.meshes[mesh].triangles[hit.primitive].vertex;
    const std::vector<glm::dvec3>& at = snapped_.meshes[mesh].vertices;
    const glm::dvec3 n = glm::cross(at[v[1]] - at[v[0]], at[v[2]] - at[v[0]]);
    return {place, glm::dot(n, at[v[0]] - o) / glm::dot(n, d)};
}

/// Returns true if the instance sees this line. An instance whose map is the identity sees the scene's ray.
bool SeamFinder::is_line_of(const Line& line, std::uint32_t place) const {
    return place == line.place ||
           (world_.is_same(place) && (line.place == nowhere || world_.is_same(line.place)));
}

SeamFinder::LineHit SeamFinder::met_exactly(std::uint32_t place, const Question& question) const {
    const oracle::Nearest met =
        world_.solids().mesh_of(place).nearest(world_.solids().seen_by(place, question.ray));
    const double t = first_of(met);
    return t < endless ? LineHit{place, t} : LineHit{};
}

/// Returns the nearest hit; of hits at the same t the answer's wins. Hits in the line's own instance, and in
/// the instance that the ray leaves, are decided exactly.
SeamFinder::LineHit SeamFinder::first_on(const Line& line, const Question& question) const {
    LineHit first{nowhere, question.end};
    for (std::uint32_t place = 0; place < maps_.size(); ++place) {
        LineHit met;
        const auto targets = question.ray.ray.targets;
        if (is_line_of(line, place) || place == question.left) {
            if (question.ends_at_any) continue;   // explain() has excluded a blocker there
            met = met_exactly(place, question);
        } else if (targets != oracle::SolidRay::Targets::planes) {
            met = met_by_line(line, place, targets == oracle::SolidRay::Targets::bounded);
        }
        if (met.place == nowhere) continue;
        const double gain = place == question.answer.place         ? -same_place
                            : first.place == question.answer.place ? same_place
                                                                   : 0;
        if (met.t * (1 + gain) < first.t) first = met;
    }
    return first;
}

/// Rounding moves the start of a line by half a unit, and its direction by half a step. In the instance that
/// the ray leaves, the start moves by the distance between the two origins.
bool SeamFinder::is_within_bound(const Line& line, const LineHit& met, const Question& question,
                                 double& apart) const {
    const auto rounded = [&](std::uint32_t place) {
        if (place == nowhere || world_.is_same(place)) return 0.0;
        const oracle::SolidRay seen = world_.solids().seen_by(place, question.ray);
        if (place != question.ray.home) return std::ldexp(0.5, -seen.frac) + 0.5 * met.t;
        const glm::dvec3 off =
            glm::abs(maps_[place].a * origin_of(question.ray.ray) + maps_[place].b - origin_of(seen));
        return std::max({off.x, off.y, off.z}) + 0.5 * met.t;
    };
    const Map& map = maps_[met.place];
    const oracle::SolidRay own = world_.solids().seen_by(met.place, question.ray);
    const glm::dvec3 off =
        glm::abs(map.a * (line.o + met.t * line.d) + map.b - origin_of(own) - met.t * direction_of(own));
    const glm::dmat3 between = line.place == nowhere ? glm::dmat3(0) : map.a * maps_[line.place].back;
    double share = 0;
    for (int i = 0; i < 3; ++i) {
        const double grown = std::abs(between[0][i]) + std::abs(between[1][i]) + std::abs(between[2][i]),
                     bound = rounded(met.place) + grown * rounded(line.place);
        share = std::max(share, off[i] / (bound + of_doubles));
    }
    apart = std::max(apart, share);
    return share <= 1 + 1e-6;
}

RayFinding SeamFinder::explain(const Ray& ray, const Closest& answer, double* apart) const {
    Question question{world_.ray(ray), ends_at_any(ray.kind)};
    if (question.ends_at_any && answer.found) return RayFinding::one_line;   // the blocker's line
    if (ray.kind == RayKind::shadow) question.end = std::ldexp(1.0, -config_.origin_frac());
    question.left = question.ray.home;
    if (ray.kind != RayKind::camera && question.left == nowhere)   // its map is the identity
        question.left = world_.place_of(ray.self);
    if (answer.found) {
        const oracle::PlacedHit hit = world_.solids().nearest(question.ray);
        if (hit.is_none()) return RayFinding::none;
        question.answer = {world_.place_of(answer.prim), first_of({hit.hit, hit.sphere})};
    }
    std::vector<std::uint32_t> concerned{nowhere};
    const auto add = [&](std::uint32_t place) {
        if (std::find(concerned.begin(), concerned.end(), place) == concerned.end())
            concerned.push_back(place);
    };
    add(question.answer.place);
    add(question.left);
    bool is_bounded = true;
    double most = 0;
    for (std::size_t i = 0; i < concerned.size(); ++i) {
        const Line line = line_of(concerned[i], question.ray);
        const LineHit first = first_on(line, question);
        if (first.place == question.answer.place) return RayFinding::one_line;
        if (first.place == nowhere) continue;   // the line misses every instance
        is_bounded = is_bounded && is_within_bound(line, first, question, most);
        add(first.place);
    }
    if (is_bounded && apart) *apart = std::max(*apart, most);
    return is_bounded ? RayFinding::seam : RayFinding::none;
}

}   // namespace rayclock
