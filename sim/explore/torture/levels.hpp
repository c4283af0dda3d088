#pragma once
// Memory images of two levels whose instances stand where they were put on purpose: turned by quarters,
// mirrored, turned by any angle, shrunk.
#include <string>

#include "sim/explore/torture/image.hpp"

namespace rayclock::torture {

/// What is in `prims`, on the scene's lattice, dealt to some instances, and some of it a second time
/// elsewhere. Numbers of primitives are those of the instances, one after the other. The lower structures
/// begin where they may, beyond line 256, or end with the last line that can be addressed.
MemoryImage placed_image(const std::vector<PrimData>& prims, const Config& config, Dice& dice,
                         const std::string& name, Look look);

}   // namespace rayclock::torture
