#pragma once
// The decision of a node whose planes cut its cell: which exits a ray meets.
#include "model/engine/box_ray.hpp"
#include "model/engine/node_answer.hpp"

namespace rayclock {

/// The exits of a treelet (or a slant, model/engine/bsp) unpacked for the model. They have the form of a
/// node's children, inner ones first, so trav and list do not depend on the structure. `exit` gives the
/// position of each.
struct WideExits {
    WideNode exits;                               ///< planes, org and exp are unused
    std::array<std::uint8_t, max_width> exit{};   ///< [child]
    bool open = false;                            ///< has no box
    Vec3i lo{}, hi{};

    WideExits() = default;
    template <class Line> WideExits(const Line& line, int node_width)
        : open(line.open != 0), lo(line.lo), hi(line.hi) {
        place(line.base, line.kind, std::size_t(node_width));
    }

private:
    void place(std::uint32_t base, const std::array<std::uint32_t, max_width>& kind, std::size_t width);
};

/// A ray and a plane: on which sides the ray may be, and bounds on t where it leaves the near side and enters
/// the far side. The near side is the one that the ray meets first.
struct PlaneSides {
    bool near = true, far = true;   ///< true if the ray may be on this side
    bool turned = false;            ///< the ray meets the upper side first
    std::uint32_t near_to = 0;      ///< the ray is not on the near side beyond this t
    std::uint32_t far_from = 0;     ///< the ray is not on the far side before this t
};
PlaneSides plane_sides(const BoxRay& ray, std::uint32_t axis, std::int32_t at, const Config& config);

/// The sides of all planes of a treelet, in heap order.
using AllSides = std::array<PlaneSides, max_width - 1>;
/// Returns the exits that are met within the box, one bit each, and writes t_near by child.
std::uint32_t exits_met(const BoxRay& ray, const WideExits& treelet, const AllSides& sides,
                        const Config& config, std::uint32_t* t_near);

}   // namespace rayclock
