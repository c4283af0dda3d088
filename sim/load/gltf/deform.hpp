#pragma once
// Meshes of a glTF document that deform: morph targets and skins.
#include <functional>
#include <optional>

#include "model/scene/motion.hpp"
#include "sim/load/gltf/buffers.hpp"
#include "sim/load/gltf/motion.hpp"
#include "sim/load/json/motion.hpp"

namespace rayclock {

/// Returns the number of morph targets of a mesh, which all of its primitives share. Throws UserError if they
/// differ.
std::size_t gltf_target_count(const JsonValue& mesh);

/// Builds the Deforming of a node. The caller must keep the document and the buffers alive.
class GltfDeformer {
public:
    /// Returns the place of a node in the scene, or nothing if the node is not in it.
    using WhereOf = std::function<std::optional<NodePlace>(std::uint64_t node)>;

    GltfDeformer(const JsonValue& document, GltfBuffers& buffers, Loading& loading, Warnings& warnings,
                 WhereOf where_of)
        : document_(document),
          buffers_(buffers),
          loading_(loading),
          warnings_(warnings),
          where_of_(std::move(where_of)) {}

    /// Returns true if a node's mesh may differ in shape from the stored one.
    static bool deforms(const JsonValue& node, const JsonValue& mesh, const GltfTracks* tracks);

    /// Returns the deforming mesh of a node: the vertices of its triangle primitives, one primitive after the
    /// other. `smooth` means that some primitives have normals; vertices of the others get normals of 0.
    /// Throws UserError if the document is wrong.
    Deforming make(const JsonValue& node, const JsonValue& mesh, const GltfTracks* tracks, bool smooth);

private:
    /// Returns true if a triangle of the primitive uses a vertex.
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
