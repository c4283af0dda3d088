// Meshes of a glTF document whose corners move: morph targets and skins.
#pragma once
#include <functional>
#include <optional>

#include "model/scene/motion.hpp"
#include "sim/load/gltf_buffers.hpp"
#include "sim/load/gltf_motion.hpp"
#include "sim/load/json_motion.hpp"

namespace rayclock {

/// How many morph targets a mesh of the document has: each of its primitives has as many. Throws UserError.
std::size_t gltf_target_count(const JsonValue& mesh);

/// Makes Deforming of nodes. The document and the buffers must outlive it.
class GltfDeformer {
public:
    /// Where a node stands in the scene; nothing if it is not in it.
    using WhereOf = std::function<std::optional<Where>(std::uint64_t node)>;

    GltfDeformer(const JsonValue& document, GltfBuffers& buffers, Loading& loading, Warnings& warnings,
                 WhereOf where_of)
        : document_(document),
          buffers_(buffers),
          loading_(loading),
          warnings_(warnings),
          where_of_(std::move(where_of)) {}

    /// Whether a node's mesh has another shape than that in which it is stored.
    static bool deforms(const JsonValue& node, const JsonValue& mesh, const GltfTracks* tracks);

    /// The mesh of the node: vertices of its primitives of triangles, one after the other. `smooth`: some of
    /// them have normals; the others' are 0. Throws UserError.
    Deforming make(const JsonValue& node, const JsonValue& mesh, const GltfTracks* tracks, bool smooth);

private:
    /// Whether a triangle of the primitive uses a vertex.
    using Used = std::function<bool(std::size_t vertex)>;
    Used used_by(const JsonValue& primitive);
    void add_primitive(const JsonValue& in, bool is_skinned, bool smooth, Deforming& to);
    void add_pulls(const JsonValue& attributes, std::size_t vertices, const Used& used, Deforming& to);
    void normalise(std::size_t vertex, std::size_t first, double sum, double joint, Deforming& to);
    void add_joints(const JsonValue& skin, Deforming& to);
    std::vector<double> fours(const JsonValue& attribute, std::size_t vertices);
    std::vector<glm::dvec3> triples(const JsonValue& attribute, std::size_t count, bool are_normals,
                                    const Used& used);
    JsonValue accessor(std::uint64_t index) const { return document_.at("accessors")[index]; }
    std::uint64_t accessor_of(const JsonValue& reference) const {
        return reference.whole(document_.at("accessors").array().size());
    }

    JsonValue document_;
    GltfBuffers& buffers_;
    Loading& loading_;
    Warnings& warnings_;
    WhereOf where_of_;
};

}   // namespace rayclock
