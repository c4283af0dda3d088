#pragma once
// Transformations of COLLADA nodes.
#include <glm/mat4x4.hpp>

#include "sim/load/dae/document.hpp"

namespace rayclock {

/// Returns the matrix of a node's child: matrix, translate, rotate, scale, lookat or skew. Returns the
/// identity for any other element. Throws UserError if its numbers are wrong.
glm::dmat4 dae_transform(const XmlElement& in, const DaeDocument& document);

}   // namespace rayclock
