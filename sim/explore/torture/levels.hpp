#pragma once
// Memory images of two levels with chosen instances: turned by quarters, mirrored, turned by any angle,
// shrunk.
#include <string>

#include "sim/explore/torture/image.hpp"

namespace rayclock::torture {

/// Distributes `prims`, which lie on the scene's lattice, among some instances, and repeats some of them
/// elsewhere. Primitives are numbered instance by instance. The lower structures begin beyond line 256, or
/// end at the last address.
MemoryImage placed_image(const std::vector<PrimData>& prims, const Config& config, Dice& dice,
                         const std::string& name, SurfaceStyle style);

}   // namespace rayclock::torture
