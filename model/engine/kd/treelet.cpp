// The unit treelet: the exits that a ray meets.
#include "model/engine/kd/treelet.hpp"

namespace rayclock {

WideTreelet widen(const Treelet& treelet, int node_width) {
    WideTreelet wide(treelet, node_width);
    for (std::size_t i = 0; i + 1 < std::size_t(node_width); ++i) {
        wide.axis[i] = std::uint8_t(treelet.axis[i]);
        wide.at[i] = treelet.at[i];
    }
    return wide;
}

std::uint32_t treelet_exits(const BoxRay& ray, const WideTreelet& treelet, const Config& c,
                            std::uint32_t* t_near) {
    AllSides sides;
    for (std::size_t i = 0; i + 1 < std::size_t(c.node_width); ++i)
        sides[i] = plane_sides(ray, treelet.axis[i], treelet.at[i], c);
    return exits_met(ray, treelet, sides, c, t_near);
}

}   // namespace rayclock
