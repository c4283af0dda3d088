// Joining vertices by a hash table, and normals of facets.
#include "sim/load/part_builder.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace rayclock {
namespace {

constexpr std::uint32_t no_vertex = std::numeric_limits<std::uint32_t>::max();

/// Turns -0 into +0, so that equal numbers have equal bits.
glm::dvec3 tidy(glm::dvec3 v) { return v + glm::dvec3(0); }

std::uint64_t hash(const glm::dvec3& p, const glm::dvec3& n) {
    std::uint64_t h = 0x9e3779b97f4a7c15;
    for (const double x : {p.x, p.y, p.z, n.x, n.y, n.z}) {
        h = (h ^ std::bit_cast<std::uint64_t>(x)) * 0xbf58476d1ce4e5b9;
        h ^= h >> 31;
    }
    return h;
}

/// Returns the normal of a triangle. A triangle without area gets an arbitrary one, because no ray hits it.
glm::dvec3 facet_normal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 n = unit_or_zero(glm::cross(unit_or_zero(b - a), unit_or_zero(c - a)));
    return n == glm::dvec3(0) ? glm::dvec3(0, 0, 1) : n;
}

}   // namespace

bool clamp_colour(glm::vec3& colour) {
    const glm::vec3 given = colour;
    colour = glm::clamp(colour, 0.0f, 1.0f);
    return colour != given;
}

void FaceColour::add(const std::optional<glm::vec3>& colour) {
    if (!colour) is_whole_ = false;
    if (!is_whole_) return;
    if (corners_++ == 0) first_ = *colour;
    varies_ = varies_ || *colour != first_;
    sum_ += glm::dvec3(*colour);
}

std::optional<glm::vec3> FaceColour::mean() const {
    if (!is_whole_ || corners_ == 0) return std::nullopt;
    return varies_ ? glm::vec3(sum_ / double(corners_)) : first_;
}

PartBuilder::PartBuilder(std::size_t triangles, bool is_smooth)
    : is_smooth_(is_smooth), table_(std::bit_ceil(2 * triangles + 16), no_vertex) {
    part_.triangles.reserve(triangles);
}

/// Returns the slot of an equal vertex, or the free slot for a new one.
std::size_t PartBuilder::slot(const glm::dvec3& position, const glm::dvec3& normal) const {
    const std::size_t mask = table_.size() - 1;
    std::size_t slot = hash(position, normal) & mask;
    for (; table_[slot] != no_vertex; slot = (slot + 1) & mask) {
        const std::uint32_t known = table_[slot];
        if (part_.vertices[known] == position && (!is_smooth_ || part_.normals[known] == normal)) break;
    }
    return slot;
}

void PartBuilder::grow() {
    table_.assign(2 * table_.size(), no_vertex);
    for (std::uint32_t v = 0; v < part_.vertices.size(); ++v)
        table_[slot(part_.vertices[v], is_smooth_ ? part_.normals[v] : glm::dvec3(0))] = v;
}

std::uint32_t PartBuilder::vertex(const Corner& corner) {
    if (3 * (part_.vertices.size() + 1) > 2 * table_.size()) grow();
    std::uint32_t& entry = table_[slot(corner.position, corner.normal)];
    if (entry != no_vertex) return entry;
    entry = static_cast<std::uint32_t>(part_.vertices.size());
    part_.vertices.push_back(corner.position);
    if (is_smooth_) part_.normals.push_back(corner.normal);
    return entry;
}

std::uint32_t PartBuilder::colour(const std::optional<glm::vec3>& colour) {
    if (!colour) return 0;
    const auto [found, is_new] =
        colour_numbers_.try_emplace({colour->r, colour->g, colour->b}, std::uint32_t(colours_.size() + 1));
    if (is_new) colours_.push_back(*colour);
    return found->second;
}

void PartBuilder::add(const Corner& a, const Corner& b, const Corner& c, std::uint32_t material) {
    if (a.position == b.position || b.position == c.position || c.position == a.position) {
        ++dropped_;
        return;
    }
    Triangle triangle{.vertex = {}, .material = material};
    const Corner* corners[3] = {&a, &b, &c};
    for (std::size_t i = 0; i < 3; ++i) {
        Corner corner{tidy(corners[i]->position), glm::dvec3(0)};
        if (is_smooth_) corner.normal = tidy(unit_or_zero(corners[i]->normal));
        if (is_smooth_ && corner.normal == glm::dvec3(0))
            corner.normal = tidy(facet_normal(a.position, b.position, c.position));
        triangle.vertex[i] = vertex(corner);
    }
    add_coordinates({a.st, b.st, c.st});
    part_.triangles.push_back(triangle);
}

/// Stores coordinates, starting with the first triangle that has them.
void PartBuilder::add_coordinates(const CornerCoordinates& corners) {
    const bool has_some =
        std::any_of(corners.begin(), corners.end(), [](const glm::dvec2& st) { return !std::isnan(st.x); });
    if (!has_some && part_.coordinates.empty()) return;
    part_.coordinates.resize(part_.triangles.size(), {no_coordinates, no_coordinates, no_coordinates});
    part_.coordinates.push_back(corners);
}

void append_part(Scene& scene, const Scene& part, const glm::dmat4& place,
                 std::optional<std::uint32_t> material, std::uint32_t material_base) {
    const std::size_t before = scene.triangles.size();
    const bool had = !scene.coordinates.empty();
    append(scene, part, place, material, material_base);
    if (scene.coordinates.empty()) return;
    const auto known = scene.coordinates.begin() + std::ptrdiff_t(before);
    constexpr CornerCoordinates none{no_coordinates, no_coordinates, no_coordinates};
    if (!had) std::fill(scene.coordinates.begin(), known, none);
    if (part.coordinates.empty()) std::fill(known, scene.coordinates.end(), none);
}

void make_smooth(Scene& part) {
    if (!part.normals.empty()) return;
    PartBuilder builder(part.triangles.size(), true);
    for (std::size_t i = 0; i < part.triangles.size(); ++i) {
        const Triangle& t = part.triangles[i];
        const auto corner = [&](std::size_t k) {
            return Corner{part.vertices[t.vertex[k]], glm::dvec3(0),
                          part.coordinates.empty() ? no_coordinates : part.coordinates[i][k]};
        };
        builder.add(corner(0), corner(1), corner(2), t.material);
    }
    Scene smooth = builder.take();
    part.vertices = std::move(smooth.vertices);
    part.normals = std::move(smooth.normals);
    part.triangles = std::move(smooth.triangles);
    part.coordinates = std::move(smooth.coordinates);
}

void make_smooth(PlacedScene& part) {
    make_smooth(part.own);
    // A deforming mesh recomputes the normals of its facets in every frame.
    for (Deforming& deforming : part.motion.deforming)
        if (SharedMesh& mesh = part.meshes[deforming.mesh]; mesh.normals.empty())
            make_faceted(deforming, mesh);
    for (SharedMesh& mesh : part.meshes) {
        if (!mesh.normals.empty()) continue;
        Scene alone;
        alone.vertices.swap(mesh.vertices), alone.normals.swap(mesh.normals);
        alone.triangles.swap(mesh.triangles), alone.coordinates.swap(mesh.coordinates);
        make_smooth(alone);
        alone.vertices.swap(mesh.vertices), alone.normals.swap(mesh.normals);
        alone.triangles.swap(mesh.triangles), alone.coordinates.swap(mesh.coordinates);
    }
}

bool has_normals(const PlacedScene& part) {
    return !part.own.normals.empty() ||
           std::any_of(part.meshes.begin(), part.meshes.end(),
                       [](const SharedMesh& mesh) { return !mesh.normals.empty(); });
}

}   // namespace rayclock
