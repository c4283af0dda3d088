// The nearest lattice point. Plain double arithmetic in a fixed order (-ffp-contract=off) gives the same
// point on every machine.
#include "model/layout/lattice.hpp"

#include <algorithm>
#include <cmath>

namespace rayclock {

double Lattice::coarsest() const { return std::max({pitch.x, pitch.y, pitch.z}); }

Vec3i Lattice::snap(const glm::dvec3& point) const {
    const double largest = largest_coordinate(coord_bits);
    Vec3i snapped{};
    for (int k = 0; k < 3; ++k)
        snapped[std::size_t(k)] =
            std::int32_t(std::clamp(std::round((point[k] - centre[k]) / pitch[k]), -largest, largest));
    return snapped;
}

}   // namespace rayclock
