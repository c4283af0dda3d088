// Builds kd-trees.
#include "model/engine/kd/build.hpp"

#include "model/engine/cells/build.hpp"

namespace rayclock::kd {

cells::CellPtr build(const std::vector<PrimData>& prims, const Config& config) {
    return build(cells::Pieces(prims, config), config);
}

cells::CellPtr build(const cells::Pieces& pieces, const Config& config) {
    return cells::build(pieces, config,
                        [](const cells::Items& items, const cells::Region& region, cells::Split& best) {
                            cells::try_axes(items, region.box, 2 * items.size(), best);
                        });
}

}   // namespace rayclock::kd
