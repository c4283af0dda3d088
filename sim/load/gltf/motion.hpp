#pragma once
// Nodes of a glTF document that an animation moves.
#include <map>
#include <vector>

#include "model/scene/motion.hpp"
#include "sim/files/json_value.hpp"
#include "sim/load/gltf/buffers.hpp"
#include "sim/load/loading.hpp"

namespace rayclock {

/// The tracks of a node.
struct GltfTracks {
    Track<glm::dvec3> translates, scales;
    Track<glm::dquat> rotations;
    std::vector<Track<double>> weights;   ///< one for each morph target of the node's mesh, or empty

    /// Returns true if the animation moves the node itself, and not only the shape of its mesh.
    bool move_node() const { return !translates.empty() || !scales.empty() || !rotations.empty(); }
};

/// Returns the tracks of the document's first animation by node. Notes that other animations are left out.
/// Throws UserError if the document is wrong.
std::map<std::uint64_t, GltfTracks> gltf_tracks(const JsonValue& document, GltfBuffers& buffers,
                                                Loading& loading, const std::string& file);

/// Returns the transforms of EXT_mesh_gpu_instancing in the space of their node. `accessors` is the number of
/// accessors in the document. Throws UserError if the document is wrong.
std::vector<glm::dmat4> gltf_places(const JsonValue& attributes, GltfBuffers& buffers,
                                    std::uint64_t accessors);

/// Returns a node of the document as a MotionNode, with its tracks if it has any. `matrix` is the node's
/// gltf_transform(). Throws UserError if the node has both a matrix and tracks.
MotionNode gltf_node(const JsonValue& in, const glm::dmat4& matrix, const GltfTracks* tracks);

}   // namespace rayclock
