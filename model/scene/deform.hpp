// Meshes whose corners move: keyed shapes, morph targets, skins. scenes/README.md has the forms in files,
// docs/motion.md what a machine does with them.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "model/scene/track.hpp"

namespace rayclock {

/// A shape that is added to the one at rest, with a weight that may move.
struct MorphTarget {
    std::vector<glm::dvec3> moves;   ///< of each vertex
    std::vector<glm::dvec3> turns;   ///< of each normal, or empty: normals stay
    double weight = 0;
    Track<double> weights{};

    double weight_at(double time) const { return weights.at(time, weight); }
};

/// A joint of a skin: where it stands in the space of a node, or in that of the mesh, and the way from the
/// mesh at rest to the joint.
struct Joint {
    std::optional<std::uint32_t> node{};   ///< of Motion::nodes
    glm::dmat4 place{1};
    glm::dmat4 inverse_bind{1};
};

/// The share that a joint has in where a vertex is.
struct Pull {
    std::uint32_t joint = 0;
    double weight = 0;   ///< those of one vertex sum to 1
};

/// How a mesh of a PlacedScene moves: the targets are added to the shape at rest, then the joints carry it.
struct Deforming {
    std::string name;                        ///< in sentences
    std::uint32_t mesh = 0;                  ///< index in PlacedScene::meshes
    std::vector<glm::dvec3> rest, normals;   ///< as in SharedMesh
    std::vector<std::uint32_t> facets;       ///< triangles that share no vertex and have their own normal
    std::vector<MorphTarget> targets;
    std::vector<Joint> joints;
    std::vector<std::uint32_t> first_pull;   ///< of each vertex, and the end; empty without joints
    std::vector<Pull> pulls;

    /// It looks the same at all times.
    bool is_still() const;
};

struct SharedMesh;

/// Gives a mesh its corners and normals at a time; `places` are those of Motion's nodes then. Throws
/// UserError with the mesh's name and the time if a corner is not finite.
void deform(const Deforming& deforming, double time, const std::vector<glm::dmat4>& places, SharedMesh& mesh);

/// Keyed shapes: at the time of a key the mesh has the key's shape, and in between each corner goes straight.
/// Each shape has as many corners; `normals` is empty or has as many lists.
std::vector<MorphTarget> keyed_shapes(const std::vector<double>& times,
                                      std::vector<std::vector<glm::dvec3>> shapes,
                                      std::vector<std::vector<glm::dvec3>> normals);

/// Gives each of these triangles corners of its own, which have the facet's normal from then on. Normals of
/// the mesh may be empty if these are all of its triangles.
void make_faceted(const std::vector<std::uint32_t>& facets, Deforming& deforming, SharedMesh& mesh);
void make_faceted(Deforming& deforming, SharedMesh& mesh);   ///< all of them

}   // namespace rayclock
