#pragma once
// The unit bih: nodes of pairs of planes.
#include "model/engine/bih/node.hpp"
#include "model/engine/space_cells/decide.hpp"

namespace rayclock {

/// A node of a bounding interval hierarchy unpacked for the model.
struct WideBih : WideExits {
    using WideExits::WideExits;
    std::array<std::uint8_t, max_width - 1> axis{};
    std::array<std::int32_t, max_width - 1> lower_to{}, upper_from{};
};
WideBih widen(const BihNode& node, int node_width);

/// Returns the position of a ray relative to a pair of planes, conservatively. The half that the ray meets
/// first ends at one plane, and the other half starts at the other plane. So the bounds of a treelet's plane
/// (space_cells/decide.hpp) hold for each of the two.
PlaneSides pair_sides(const BoxRay& ray, std::uint32_t axis, std::int32_t lower_to, std::int32_t upper_from,
                      const Config& config);

/// Returns the exits that a ray meets, as treelet_exits() (kd/treelet.hpp) does for a treelet: one bit each,
/// and t_near by child. Mirror of rtl/engine/bih/rc_bih.sv, latency bih::Engine::latency() + 1, one node per
/// cycle.
std::uint32_t bih_exits(const BoxRay& ray, const WideBih& node, const Config& config, std::uint32_t* t_near);
/// Returns the unit's answer.
NodeAnswer bih_answer(const BihReq& req, const Config& config);

}   // namespace rayclock
