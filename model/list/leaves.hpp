#pragma once
#include <optional>

#include "model/core/payloads.hpp"

namespace rayclock {

/// One ray's leaves and best hit: what list does, without when. Of each node that box has tested the leaves'
/// triangles are asked for one by one, nearest leaf first and none beyond the best hit; then the inner
/// children go to trav. A ray that asks for a light ends with the first primitive in its way: no other is
/// tested, and trav is told to stop. A shadow ray also ends at t = 2^-B: 2^(N+F) is its distance to beat.
/// Mirror of rtl/list/rc_list.sv.
class Leaves {
public:
    explicit Leaves(const Config& config)
        : beyond_((1u << config.t_bits()) - 1), surface_(1u << (config.coord_bits + config.t_frac_bits)) {}

    /// A new ray: nothing is hit yet.
    void clear(RayKind kind = RayKind::camera) {
        any_ = ends_at_any(std::uint32_t(kind));
        start_ = kind == RayKind::shadow ? surface_ : beyond_;
        best_ = {};
    }
    /// Box's answer. True if a triangle is to be tested: prim().
    bool begin(const BoxRsp& boxes);
    /// Tri's answer. True if another triangle is to be tested.
    bool advance(const TriRsp& tri);

    std::uint32_t prim() const {
        return 2 * group_.base + group_.offset[group_.inner + leaf_] + triangle_;
    }   ///< half line
    const BoxRsp& group() const { return group_; }
    BoxRsp& group() { return group_; }
    const Best& best() const { return best_; }
    std::uint32_t t_best() const { return best_.found ? found_.t : start_; }
    bool stop() const { return any_ && best_.found; }   ///< the light is blocked
    Step step(std::uint32_t ray) const;
    Closest closest(std::uint32_t ray) const;
    /// begin() on boxes that were written straight into group().
    bool begin();

private:
    std::uint32_t beyond_, surface_;   // t of nothing; of the surface to which a shadow ray goes
    std::uint32_t start_ = beyond_;    // the one of these that holds for the ray
    bool any_ = false;                 // any hit ends the ray
    BoxRsp group_;
    std::uint32_t leaf_ = 0, triangle_ = 0;
    Best best_;
    Closest found_;
};

}   // namespace rayclock
