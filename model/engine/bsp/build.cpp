// Builds trees of planes in any direction.
#include "model/engine/bsp/build.hpp"

#include "model/engine/bsp/facets.hpp"
#include "model/engine/space_cells/build.hpp"

namespace rayclock::bsp {

space_cells::CellPtr build(const space_cells::Pieces& pieces, const std::vector<PrimData>& prims,
                           const Config& config) {
    const Facets facets(prims, pieces, config);
    return space_cells::build(pieces, config,
                              [&](const space_cells::Items& items, const space_cells::Region& region,
                                  space_cells::Split& best) { facets.best_split(items, region, best); });
}

}   // namespace rayclock::bsp
