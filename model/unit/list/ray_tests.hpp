#pragma once
#include "model/unit/trav/order.hpp"
#include "model/core/payloads.hpp"

namespace rayclock {

/// The best hit of a ray so far, and the distance to beat. A ray that asks for a light ends with the first
/// primitive in its way. A shadow ray also ends at t = 2^-B: see reach_of().
class BestHit {
public:
    BestHit() = default;
    BestHit(const Start& start, std::uint32_t reach)
        : ray_(start.ray), reach_(reach), any_(ends_at_any(start.kind)) {}

    /// Tri's answer; `place` is Closest's.
    void take(const TriRsp& tri, std::uint32_t place = 0) {
        if (!tri.closer) return;
        best_ = {1, tri.num, tri.det, tri.prim};
        found_ = {ray_, 1, tri.prim, tri.t, tri.u, tri.v, tri.back, place};   // zeros, if any hit will do
        reach_ = tri.t;
    }
    const Best& best() const { return best_; }
    std::uint32_t t() const { return reach_; }          ///< to beat
    bool stop() const { return any_ && best_.found; }   ///< the light is blocked
    Closest closest() const { return best_.found ? found_ : Closest{ray_, 0, 0, 0, 0, 0, 0, 0}; }

private:
    std::uint32_t ray_ = 0, reach_ = 0;
    bool any_ = false;   // any hit ends the ray
    Best best_;
    Closest found_;
};

/// Where a ray is among the leaves that it meets of a node. `Met` says what they are: size(), and of leaf i
/// near(i), first(i) and count(i), the half lines of its primitives.
struct LeafCursor {
    std::uint32_t leaf = 0, half_line = 0, end = 0;

    template <class Met> RAYCLOCK_INLINE void enter(const Met& met) {
        half_line = met.first(leaf);
        end = half_line + met.count(leaf);
    }
    /// To the next primitive of the leaf, or else of the next leaf. False if there is none that can matter.
    template <class Met, class Time> RAYCLOCK_INLINE bool advance(const Met& met, const Time& t_best) {
        if (++half_line < end) return true;
        if (++leaf == met.size() || t_best < met.near(leaf)) return false;
        enter(met);
        return true;
    }
};

/// One ray's tests and its best hit: what list does, without when. Of each node that trav gives leaves of,
/// the leaves' triangles are asked for one by one, nearest leaf first and none beyond the best hit; then trav
/// is told. If a light is blocked, no other primitive is tested, and trav is told to stop. Mirror of
/// rtl/unit/list/rc_list.sv.
class RayTests {
public:
    explicit RayTests(const Config& config) {
        for (std::uint32_t kind = 0; kind < reaches_.size(); ++kind)
            reaches_[kind] = reach_of(RayKind(kind), config);
    }

    /// A new ray: nothing is hit yet.
    void start(const Start& start) {
        ray_ = start.ray;
        hit_ = {start, reaches_[start.kind]};
    }
    /// Trav's leaves: prim() is to be tested.
    void begin(const Leaves& leaves) {
        met_ = {leaves};
        cursor_ = {};
        cursor_.enter(met_);
    }
    /// Tri's answer. True if another triangle is to be tested.
    bool advance(const TriRsp& tri) {
        hit_.take(tri);
        return !hit_.stop() && cursor_.advance(met_, hit_.t());
    }

    std::uint32_t prim() const { return cursor_.half_line; }
    const Best& best() const { return hit_.best(); }
    Tested tested() const { return {ray_, hit_.stop(), hit_.t()}; }
    Closest closest() const { return hit_.closest(); }

private:
    struct Met {
        Leaves leaves;
        std::uint32_t size() const { return leaves.leaves; }
        std::uint32_t near(std::uint32_t i) const { return leaves.t_near[i]; }
        std::uint32_t first(std::uint32_t i) const { return 2 * leaves.base + leaves.offset[i]; }
        std::uint32_t count(std::uint32_t i) const { return leaves.count[i]; }
    };
    std::array<std::uint32_t, 4> reaches_{};   // reach_of() each kind
    std::uint32_t ray_ = 0;
    BestHit hit_;
    Met met_;
    LeafCursor cursor_;   // under way
};

}   // namespace rayclock
