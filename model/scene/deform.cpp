// Evaluates shapes, joints and normals at a time.
#include "model/scene/deform.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "model/base/error.hpp"
#include "model/scene/placed.hpp"
#include "model/scene/view.hpp"

namespace rayclock {
namespace {

/// Returns for each joint the matrix that it applies to a point of the mesh at rest.
std::vector<glm::dmat4> joint_matrices(const Deforming& deforming, const std::vector<glm::dmat4>& places) {
    std::vector<glm::dmat4> all;
    all.reserve(deforming.joints.size());
    for (const Joint& joint : deforming.joints) {
        const glm::dmat4 place = joint.node ? places[*joint.node] * joint.place : joint.place;
        all.push_back(place * joint.inverse_bind);
    }
    return all;
}

glm::dmat4 blended(const Deforming& deforming, std::size_t vertex, const std::vector<glm::dmat4>& matrices) {
    glm::dmat4 sum(0);
    for (std::uint32_t i = deforming.first_pull[vertex]; i < deforming.first_pull[vertex + 1]; ++i)
        sum += deforming.pulls[i].weight * matrices[deforming.pulls[i].joint];
    return sum;
}

/// Transforms a normal by cofactors, because normals follow the inverse transpose. A mirror image is not
/// turned inside out here, because its corners keep their order.
glm::dvec3 turned(const glm::dmat3& m, const glm::dvec3& normal) {
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    return cofactors * normal;
}

void add_targets(const Deforming& deforming, double time, SharedMesh& mesh) {
    for (const MorphTarget& target : deforming.targets) {
        const double weight = target.weight_at(time);
        if (weight == 0) continue;
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) mesh.vertices[i] += weight * target.moves[i];
        if (mesh.normals.empty() || target.turns.empty()) continue;
        for (std::size_t i = 0; i < mesh.normals.size(); ++i) mesh.normals[i] += weight * target.turns[i];
    }
}

void carry(const Deforming& deforming, const std::vector<glm::dmat4>& places, SharedMesh& mesh) {
    if (deforming.joints.empty()) return;
    const std::vector<glm::dmat4> matrices = joint_matrices(deforming, places);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const glm::dmat4 matrix = blended(deforming, i, matrices);
        mesh.vertices[i] = glm::dvec3(matrix * glm::dvec4(mesh.vertices[i], 1));
        if (!mesh.normals.empty()) mesh.normals[i] = turned(glm::dmat3(matrix), mesh.normals[i]);
    }
}

glm::dvec3 facet_normal(const SharedMesh& mesh, const Triangle& t) {
    const glm::dvec3 &a = mesh.vertices[t.vertex[0]], &b = mesh.vertices[t.vertex[1]],
                     &c = mesh.vertices[t.vertex[2]];
    return unit_or_zero(glm::cross(unit_or_zero(b - a), unit_or_zero(c - a)));
}

/// Normalises the normals. Where shapes cancel each other, the normal at rest stays. A facet without area
/// gets an arbitrary normal, since no ray meets it.
void finish_normals(const Deforming& deforming, SharedMesh& mesh) {
    for (const std::uint32_t facet : deforming.facets) {
        const Triangle& t = mesh.triangles[facet];
        const glm::dvec3 normal = facet_normal(mesh, t);
        for (const std::uint32_t v : t.vertex) mesh.normals[v] = normal;
    }
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        glm::dvec3 unit = unit_or_zero(mesh.normals[i]);
        if (unit == glm::dvec3(0)) unit = unit_or_zero(deforming.normals[i]);
        mesh.normals[i] = unit == glm::dvec3(0) ? glm::dvec3(0, 0, 1) : unit;
    }
}

}   // namespace

bool Deforming::is_still() const {
    return std::none_of(targets.begin(), targets.end(),
                        [](const MorphTarget& target) { return !target.weights.empty(); }) &&
           std::none_of(joints.begin(), joints.end(),
                        [](const Joint& joint) { return joint.node.has_value(); });
}

void deform(const Deforming& deforming, double time, const std::vector<glm::dmat4>& places,
            SharedMesh& mesh) {
    mesh.vertices = deforming.rest;
    mesh.normals = deforming.normals;
    add_targets(deforming, time, mesh);
    carry(deforming, places, mesh);
    constexpr double most = std::numeric_limits<float>::max();   // as for all coordinates from files
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        for (int k = 0; k < 3; ++k)
            if (!(std::abs(mesh.vertices[i][k]) <= most))
                throw UserError(deforming.name + " at " + text_of(time) + " s moves vertex " +
                                std::to_string(i) + " to " + text_of(mesh.vertices[i][k]) +
                                ", which is not a finite number that a scene can hold");
    finish_normals(deforming, mesh);
}

// Each weight rises from 0 to 1 and falls again, so two of them sum to 1 between two keys. The shape at rest
// is a point, so it adds nothing to a shape.
std::vector<MorphTarget> keyed_shapes(const std::vector<double>& times,
                                      std::vector<std::vector<glm::dvec3>> shapes,
                                      std::vector<std::vector<glm::dvec3>> normals) {
    std::vector<MorphTarget> targets(times.size());
    for (std::size_t k = 0; k < times.size(); ++k) {
        targets[k].moves = std::move(shapes[k]);
        if (!normals.empty()) targets[k].turns = std::move(normals[k]);
        Track<double>& track = targets[k].weights;
        const auto key = [&](std::size_t at, double weight) {
            track.times.push_back(times[at]), track.values.push_back(weight);
        };
        if (k > 0) key(k - 1, 0);
        key(k, 1);
        if (k + 1 < times.size()) key(k + 1, 0);
    }
    return targets;
}

void make_faceted(const std::vector<std::uint32_t>& facets, Deforming& deforming, SharedMesh& mesh) {
    constexpr std::uint32_t none = ~0U;
    std::vector<bool> is_facet(mesh.triangles.size(), false);
    for (const std::uint32_t facet : facets) is_facet[facet] = true;
    // `from`: the old vertex of each new one. `shared`: the new vertex of each old one.
    std::vector<std::uint32_t> from, shared(deforming.rest.size(), none);
    from.reserve(3 * mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (std::uint32_t& v : mesh.triangles[i].vertex) {
            const std::uint32_t old = v;
            v = is_facet[i] ? none : shared[old];
            if (v != none) continue;
            v = std::uint32_t(from.size());
            if (!is_facet[i]) shared[old] = v;
            from.push_back(old);
        }
    const auto gathered = [&](const std::vector<glm::dvec3>& list) {
        std::vector<glm::dvec3> out;
        out.reserve(from.size());
        for (const std::uint32_t v : from) out.push_back(list.empty() ? glm::dvec3(0) : list[v]);
        return out;
    };
    deforming.rest = gathered(deforming.rest);
    deforming.normals = gathered(deforming.normals);
    mesh.vertices = gathered(mesh.vertices);
    mesh.normals = deforming.normals;
    for (MorphTarget& target : deforming.targets) {
        target.moves = gathered(target.moves);
        if (!target.turns.empty()) target.turns = gathered(target.turns);
    }
    if (!deforming.first_pull.empty()) {
        std::vector<std::uint32_t> first{0};
        std::vector<Pull> pulls;
        for (const std::uint32_t v : from) {
            pulls.insert(pulls.end(), deforming.pulls.begin() + deforming.first_pull[v],
                         deforming.pulls.begin() + deforming.first_pull[v + 1]);
            first.push_back(std::uint32_t(pulls.size()));
        }
        deforming.first_pull = std::move(first), deforming.pulls = std::move(pulls);
    }
    deforming.facets = facets;
    finish_normals(deforming, mesh);
}

void make_faceted(Deforming& deforming, SharedMesh& mesh) {
    std::vector<std::uint32_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0U);
    make_faceted(all, deforming, mesh);
}

}   // namespace rayclock
