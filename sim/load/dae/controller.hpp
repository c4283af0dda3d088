#pragma once
// Controllers of COLLADA: a mesh that blends several meshes (morph) or follows joints (skin). The file's
// nodes and weights give one fixed pose; animations do not move it.
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "sim/load/dae/document.hpp"

namespace rayclock {

/// The vertices of a geometry after its controllers.
struct DaePose {
    const XmlElement* geometry = nullptr;   ///< null if there is nothing to draw
    std::vector<glm::dvec3> positions;      ///< replace the geometry's positions; empty: keep those
    /// The transform of each vertex into the scene's space. Empty: the vertices move with their node.
    std::vector<glm::dmat4> moves;
};

/// Counts of parts of controllers that are ignored or changed.
struct DaePoseFaults {
    std::uint64_t morph_normals = 0, other_targets = 0, lost_joints = 0, odd_weights = 0;
};

/// Computes the poses of the controllers of a document.
class DaeControllers {
public:
    /// The place of each node, with the document's up axis turned to y.
    using NodePlaces = std::map<const XmlElement*, glm::dmat4>;

    DaeControllers(DaeDocument& document, const NodePlaces& places) : document_(document), places_(places) {}

    /// Returns the pose of an <instance_controller>. Throws UserError if the document is wrong.
    DaePose pose(const XmlElement& instance);
    const DaePoseFaults& faults() const { return faults_; }

private:
    using Names = std::map<std::string, const XmlElement*>;

    void apply(const XmlElement& controller, const XmlElement& instance, DaePose& pose, int depth);
    void morph(const XmlElement& in, DaePose& pose);
    void skin(const XmlElement& in, const XmlElement& instance, DaePose& pose);
    void carry(const XmlElement& weights, const std::vector<glm::dmat4>& joints, const glm::dmat4& shape,
               DaePose& pose);
    std::vector<glm::dmat4> joints(const XmlElement& skin, const XmlElement& instance,
                                   const glm::dmat4& shape);
    const XmlElement* node(const std::string& name, const XmlElement& instance);
    const Names& names_below(const XmlElement& root);
    std::vector<std::string> words(const XmlElement& input);
    const DaePoints* positions(const XmlElement* geometry);

    DaeDocument& document_;
    const NodePlaces& places_;
    DaePoseFaults faults_;
    std::map<const XmlElement*, Names> names_;   ///< nodes by their sids, below a root
};

}   // namespace rayclock
