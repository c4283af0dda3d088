#pragma once
#include <glm/mat4x4.hpp>

#include "sim/load/dae_document.hpp"

namespace rayclock {

/// A child of a node as a matrix: matrix, translate, rotate, scale, lookat or skew; of any other, the
/// identity.
glm::dmat4 dae_transform(const XmlElement& in, const DaeDocument& document);

}   // namespace rayclock
