#pragma once
// The work of list on one ray's leaves, without timing.
#include "model/core/payloads.hpp"
#include "model/unit/trav/order.hpp"

namespace rayclock {

/// The best hit of a ray so far, and its distance to beat. A ray to or from a light ends with the first
/// primitive in its way, but ignores its first Ray::holes cut-outs. A shadow ray also ends at t = 2^-B: see
/// t_max_of().
class BestHit {
public:
    BestHit() = default;
    BestHit(const Start& start, std::uint32_t t_max)
        : ray_(start.ray), t_best_(t_max), holes_(start.holes), any_(ends_at_any(start.kind)) {}

    /// Accepts tri's answer. `instance_line` is Closest's.
    void take(const TriRsp& tri, std::uint32_t instance_line = 0) {
        if (!tri.closer) return;
        if (tri.cutout && holes_ > 0) {
            --holes_;
            return;
        }
        best_ = {1, tri.num, tri.det, tri.prim};
        // tri's fields are 0 for an opaque primitive in the way to a light.
        found_ = {ray_, 1, tri.prim, tri.t, tri.u, tri.v, tri.back, instance_line, tri.cutout};
        t_best_ = tri.t;
    }
    const Best& best() const { return best_; }
    std::uint32_t t_best() const { return t_best_; }    ///< distance to beat
    bool stop() const { return any_ && best_.found; }   ///< the light is blocked
    Closest closest() const { return best_.found ? found_ : Closest{ray_, 0, 0, 0, 0, 0, 0, 0}; }

private:
    std::uint32_t ray_ = 0, t_best_ = 0;
    std::uint32_t holes_ = 0;   // number of cut-outs that the ray still ignores
    bool any_ = false;          // any hit ends the ray
    Best best_;
    Closest found_;
};

/// The position of a ray among the leaves that it meets in a node. `Met` describes them: size(), and for leaf
/// i near(i), first(i) and count(i). The last two are the half lines of its primitives.
struct LeafCursor {
    std::uint32_t leaf = 0, half_line = 0, end = 0;

    template <class Met> RAYCLOCK_INLINE void enter(const Met& met) {
        half_line = met.first(leaf);
        end = half_line + met.count(leaf);
    }
    /// Moves to the next primitive of the leaf, or else of the next leaf. Returns false if no other can
    /// matter.
    template <class Met, class Time> RAYCLOCK_INLINE bool advance(const Met& met, const Time& t_best) {
        if (++half_line < end) return true;
        if (++leaf == met.size() || t_best < met.near(leaf)) return false;
        enter(met);
        return true;
    }
};

/// The tests and the best hit of one ray: list without timing. For each node whose leaves trav sends, it
/// requests the leaves' triangles one by one, nearest leaf first, and none beyond the best hit. Then trav
/// gets the answer. Once a light is blocked, it tests no other primitive and reports a stop to trav. Mirror
/// of rtl/unit/list/rc_list.sv.
class RayTests {
public:
    explicit RayTests(const Config& config) {
        for (std::uint32_t kind = 0; kind < t_max_.size(); ++kind)
            t_max_[kind] = t_max_of(RayKind(kind), config);
    }

    /// Starts a new ray without a hit.
    void start(const Start& start) {
        ray_ = start.ray;
        hit_ = {start, t_max_[std::size_t(start.kind)]};
    }
    /// Accepts trav's leaves. prim() is the first to test.
    void begin(const Leaves& leaves) {
        met_ = {leaves};
        cursor_ = {};
        cursor_.enter(met_);
    }
    /// Accepts tri's answer. Returns true if there is another triangle to test.
    bool advance(const TriRsp& tri) {
        hit_.take(tri);
        return !hit_.stop() && cursor_.advance(met_, hit_.t_best());
    }

    std::uint32_t prim() const { return cursor_.half_line; }
    const Best& best() const { return hit_.best(); }
    Tested tested() const { return {ray_, hit_.stop(), hit_.t_best()}; }
    Closest closest() const { return hit_.closest(); }

private:
    struct Met {
        Leaves leaves;
        std::uint32_t size() const { return leaves.leaves; }
        std::uint32_t near(std::uint32_t i) const { return leaves.t_near[i]; }
        std::uint32_t first(std::uint32_t i) const { return 2 * leaves.base + leaves.offset[i]; }
        std::uint32_t count(std::uint32_t i) const { return leaves.count[i]; }
    };
    std::array<std::uint32_t, 4> t_max_{};   // t_max_of() for each kind
    std::uint32_t ray_ = 0;
    BestHit hit_;
    Met met_;
    LeafCursor cursor_;   // the primitive in flight
};

}   // namespace rayclock
