// Builds trees of planes in any direction.
#include "model/engine/bsp/build.hpp"

#include "model/engine/bsp/facets.hpp"
#include "model/engine/cells/build.hpp"

namespace rayclock::bsp {

cells::CellPtr build(const cells::Pieces& pieces, const std::vector<PrimData>& prims, const Config& config) {
    const Facets facets(prims, pieces, config);
    return cells::build(pieces, config,
                        [&](const cells::Items& items, const cells::Region& region, cells::Split& best) {
                            facets.best_split(items, region, best);
                        });
}

}   // namespace rayclock::bsp
