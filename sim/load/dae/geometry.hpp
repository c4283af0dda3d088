#pragma once
// Converts geometries of COLLADA into parts of a scene.
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/load/dae/controller.hpp"
#include "sim/load/dae/document.hpp"
#include "sim/load/mesh/mesh_file.hpp"

namespace rayclock {

/// The triangles of a mesh with one material. `symbol` is the mesh's name for the material.
struct DaePart {
    std::size_t number;   ///< index of the part in the assembly
    std::string symbol;
};

/// Cuts meshes into triangles. Throws UserError if the document is wrong.
class DaeGeometries {
public:
    DaeGeometries(DaeDocument& document, Assembly& assembly) : document_(document), assembly_(assembly) {}

    /// Adds the parts of a <geometry> in a pose to the assembly. Cuts each <mesh> again at each call. Returns
    /// no parts if it has no mesh.
    std::vector<DaePart> parts(const XmlElement& geometry, const DaePose& pose);
    std::uint64_t triangles() const { return triangles_; }
    /// Adds notes to the loading about everything that was left out.
    void say_left_out() const;

private:
    /// The sources of a primitive's corners, and the position of their indices in a corner.
    struct Inputs {
        std::optional<DaeTriples> positions, normals;
        std::uint64_t position_at = 0, normal_at = 0, stride = 1;
    };
    using Corners = std::vector<Corner>;

    Inputs inputs_of(const XmlElement& primitive);
    const Inputs& vertices(const XmlElement& in);
    Corners corners_of(const XmlElement& list, const Inputs& inputs, const DaePose& pose);
    glm::dvec3 entry(const XmlElement& list, const DaeTriples& source, std::uint64_t index,
                     const char* what) const;
    std::size_t primitive(const XmlElement& in, const DaePose& pose);
    void cut_list(const XmlElement& in, const Corners& corners, std::vector<Corners>& faces) const;
    void face(const XmlElement& in, PartBuilder& builder, const Corners& corners);

    DaeDocument& document_;
    Assembly& assembly_;
    std::map<const XmlElement*, Inputs> vertices_;   // by <vertices>
    std::uint64_t triangles_ = 0, shapeless_ = 0, lines_ = 0, colours_ = 0, lost_normals_ = 0;
};

}   // namespace rayclock
