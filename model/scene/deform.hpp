#pragma once
// Meshes whose corners move: keyed shapes, morph targets, skins. scenes/README.md has their form in files,
// docs/machine/motion.md their use by a machine.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "model/scene/track.hpp"

namespace rayclock {

/// A shape that is added to the one at rest, with a weight that may change over time.
struct MorphTarget {
    std::vector<glm::dvec3> moves;   ///< of each vertex
    std::vector<glm::dvec3> turns;   ///< of each normal; empty if normals stay
    double weight = 0;
    Track<double> weights{};

    double weight_at(double time) const { return weights.at(time, weight); }
};

/// A joint of a skin: its place in the space of a node, or of the mesh, and the map from the mesh at rest to
/// the joint.
struct Joint {
    std::optional<std::uint32_t> node{};   ///< index in Motion::nodes
    glm::dmat4 place{1};
    glm::dmat4 inverse_bind{1};
};

/// The share of a joint in the position of a vertex.
struct Pull {
    std::uint32_t joint = 0;
    double weight = 0;   ///< the weights of a vertex sum to 1
};

/// The motion of a mesh of a PlacedScene. The targets are added to the shape at rest; then the joints move
/// it.
struct Deforming {
    std::string name;                        ///< for messages
    std::uint32_t mesh = 0;                  ///< index in PlacedScene::meshes
    std::vector<glm::dvec3> rest, normals;   ///< as in SharedMesh
    std::vector<std::uint32_t> facets;       ///< triangles without shared vertices, with their own normal
    std::vector<MorphTarget> targets;
    std::vector<Joint> joints;
    std::vector<std::uint32_t> first_pull;   ///< of each vertex, and the end; empty without joints
    std::vector<Pull> pulls;

    /// True if the mesh looks the same at all times.
    bool is_still() const;
};

struct SharedMesh;

/// Sets a mesh's corners and normals for a time; `places` are those of Motion's nodes at that time. Throws
/// UserError with the mesh's name and the time if a corner is not finite.
void deform(const Deforming& deforming, double time, const std::vector<glm::dmat4>& places, SharedMesh& mesh);

/// Returns the targets of keyed shapes. At the time of a key the mesh has the key's shape; in between each
/// corner moves in a straight line. All shapes must have the same number of corners. `normals` is empty or
/// has as many lists.
std::vector<MorphTarget> keyed_shapes(const std::vector<double>& times,
                                      std::vector<std::vector<glm::dvec3>> shapes,
                                      std::vector<std::vector<glm::dvec3>> normals);

/// Gives each of these triangles its own corners, which from then on have the facet's normal. The mesh's
/// normals may be empty if these are all of its triangles.
void make_faceted(const std::vector<std::uint32_t>& facets, Deforming& deforming, SharedMesh& mesh);
void make_faceted(Deforming& deforming, SharedMesh& mesh);   ///< all triangles

}   // namespace rayclock
