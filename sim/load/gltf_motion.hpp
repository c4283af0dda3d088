// Nodes of a glTF document that an animation moves.
#pragma once
#include <map>
#include <vector>

#include "model/scene/motion.hpp"
#include "sim/files/json_value.hpp"
#include "sim/load/gltf_buffers.hpp"
#include "sim/load/loading.hpp"

namespace rayclock {

/// Tracks of a node, and where the file says so.
struct GltfTracks {
    Track<glm::dvec3> translates, scales;
    Track<glm::dquat> turns;
    std::vector<Track<double>> weights;   ///< of all morph targets of the node's mesh, or of none

    /// It moves the node, and not its mesh alone.
    bool move_node() const { return !translates.empty() || !scales.empty() || !turns.empty(); }
};

/// The tracks of the document's first animation, by node. What is left out is noted: other animations. Throws
/// UserError.
std::map<std::uint64_t, GltfTracks> gltf_tracks(const JsonValue& document, GltfBuffers& buffers,
                                                Loading& loading, const std::string& file);

/// The places of EXT_mesh_gpu_instancing in the space of its node. `accessors`: how many the document has.
std::vector<glm::dmat4> gltf_places(const JsonValue& attributes, GltfBuffers& buffers,
                                    std::uint64_t accessors);

/// A node of the document as a node of ours, with its tracks if it has any. `matrix` is gltf_transform() of
/// it.
MotionNode gltf_node(const JsonValue& in, const glm::dmat4& matrix, const GltfTracks* tracks);

}   // namespace rayclock
