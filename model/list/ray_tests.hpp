#pragma once
#include "model/core/payloads.hpp"

namespace rayclock {

/// One ray's tests and its best hit: what list does, without when. Of each node that trav gives leaves of,
/// the leaves' triangles are asked for one by one, nearest leaf first and none beyond the best hit; then trav
/// is told. A ray that asks for a light ends with the first primitive in its way: no other is tested, and
/// trav is told to stop. A shadow ray also ends at t = 2^-B: see reach_of(). Mirror of rtl/list/rc_list.sv.
class RayTests {
public:
    explicit RayTests(const Config& config) {
        for (std::uint32_t kind = 0; kind < reaches_.size(); ++kind)
            reaches_[kind] = reach_of(RayKind(kind), config);
    }

    /// A new ray: nothing is hit yet.
    void start(const Start& start) {
        ray_ = start.ray;
        any_ = ends_at_any(start.kind);
        reach_ = reaches_[start.kind];
        best_ = {};
    }
    /// Trav's leaves: prim() is to be tested.
    void begin(const Leaves& leaves) {
        leaves_ = leaves;
        leaf_ = triangle_ = 0;
    }
    /// Tri's answer. True if another triangle is to be tested.
    bool advance(const TriRsp& tri);

    std::uint32_t prim() const {
        return 2 * leaves_.base + leaves_.offset[leaf_] + triangle_;
    }   ///< half line
    const Best& best() const { return best_; }
    std::uint32_t t_best() const { return best_.found ? found_.t : reach_; }
    bool stop() const { return any_ && best_.found; }   ///< the light is blocked
    Tested tested() const { return {ray_, stop(), t_best()}; }
    Closest closest() const;

private:
    std::array<std::uint32_t, 4> reaches_{};   // reach_of() each kind
    std::uint32_t ray_ = 0, reach_ = 0;
    bool any_ = false;   // any hit ends the ray
    Leaves leaves_;
    std::uint32_t leaf_ = 0, triangle_ = 0;   // under way
    Best best_;
    Closest found_;
};

}   // namespace rayclock
