// Builds kd-trees.
#include "model/engine/kd/build.hpp"

#include "model/engine/space_cells/build.hpp"

namespace rayclock::kd {

space_cells::CellPtr build(const std::vector<PrimData>& prims, const Config& config) {
    return build(space_cells::Pieces(prims, config), config);
}

space_cells::CellPtr build(const space_cells::Pieces& pieces, const Config& config) {
    return space_cells::build(
        pieces, config,
        [](const space_cells::Items& items, const space_cells::Region& region, space_cells::Split& best) {
            space_cells::try_axes(items, region.box, 2 * items.size(), best);
        });
}

}   // namespace rayclock::kd
