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
    std::string fault;   ///< the message about the first wrong texture coordinate, or empty
};

/// For each symbol whose material shows a picture, the number of the set of coordinates that the picture
/// uses; nothing if the file does not choose one: then the first set.
using DaeSets = std::map<std::string, std::optional<std::uint64_t>>;

/// Cuts meshes into triangles. Throws UserError if the document is wrong.
class DaeGeometries {
public:
    DaeGeometries(DaeDocument& document, Assembly& assembly) : document_(document), assembly_(assembly) {}

    /// Adds the parts of a <geometry> in a pose to the assembly. Cuts each <mesh> again at each call. Returns
    /// no parts if it has no mesh. A wrong texture coordinate becomes a fault of its part, because only a
    /// picture that can be read needs it.
    std::vector<DaePart> parts(const XmlElement& geometry, const DaePose& pose, const DaeSets& sets);
    std::uint64_t triangles() const { return triangles_; }
    /// Adds notes to the loading about everything that was left out.
    void say_left_out() const;

private:
    /// The sources of a primitive's corners, and the position of their indices in a corner.
    struct Inputs {
        std::optional<DaePoints> positions, normals, coordinates;
        std::uint64_t position_at = 0, normal_at = 0, coordinate_at = 0, stride = 1;
        const XmlElement* per_vertex = nullptr;   ///< the texture coordinates of <vertices>
        std::string fault;                        ///< see DaePart
    };
    using Corners = std::vector<Corner>;

    Inputs inputs_of(const XmlElement& primitive, const DaeSets& sets);
    void choose_coordinates(const XmlElement& primitive, std::optional<std::uint64_t> set, Inputs& inputs);
    const Inputs& vertices(const XmlElement& in);
    Corners corners_of(const XmlElement& list, Inputs& inputs, const DaePose& pose);
    glm::dvec2 on_picture(const XmlElement& list, Inputs& inputs, std::uint64_t index) const;
    glm::dvec3 entry(const XmlElement& list, const DaePoints& source, std::uint64_t index,
                     const char* what) const;
    DaePart primitive(const XmlElement& in, const DaePose& pose, const DaeSets& sets);
    void cut_list(const XmlElement& in, const Corners& corners, std::vector<Corners>& faces) const;
    void face(const XmlElement& in, PartBuilder& builder, const Corners& corners);

    DaeDocument& document_;
    Assembly& assembly_;
    std::map<const XmlElement*, Inputs> vertices_;   // by <vertices>
    std::uint64_t triangles_ = 0, shapeless_ = 0, lines_ = 0, colours_ = 0, lost_normals_ = 0, unchosen_ = 0;
};

}   // namespace rayclock
