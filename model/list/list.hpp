#pragma once
#include "model/core/payloads.hpp"
#include "model/core/ring.hpp"

namespace rayclock {

/// The leaves of a node: takes the box test's answer, sends the leaves' triangles to tri one by one, nearest leaf first
/// and none beyond the best hit, and then hands the inner children to trav. Keeps each ray's best hit.
///
/// A box answer and a tri answer are accepted in every cycle. Each sends its ray to one of two links, prim or step, and has
/// a queue of its own for each, so that neither waits for the other; on the link tri's rays go first. One triangle of a ray
/// is under way at a time. Mirror of rtl/list/rc_list.sv.
class List {
public:
    explicit List(const Config& config);

    bool prim_valid() const { return !next_.empty() || !first_.empty(); }
    const PrimReq& prim() const { return starting() ? first_.front() : next_.front(); }
    bool step_valid() const { return !tested_.empty() || !leafless_.empty(); }
    Step step() const;
    const Ray& ray(std::uint32_t ray) const { return rays_[ray]; }
    const Best& best(std::uint32_t ray) const { return bests_[ray]; }
    /// The request that a triangle from memory makes together with its ray.
    TriReq tri_req(std::uint32_t ray, const PrimData& triangle) const;
    /// The answer for a ray that trav has finished.
    Closest closest(std::uint32_t ray) const;

    /// One clock edge: what came in (null if nothing), and which outputs were taken. Everything that comes is accepted.
    void clock(const Ray* ray, const BoxRsp* boxes, const TriRsp* tri, bool prim_taken, bool step_taken);

private:
    struct Cursor {
        std::uint32_t leaf = 0, triangle = 0;
    };
    struct Ending {
        std::uint32_t ray = 0, t_best = 0;
    };

    void begin(const BoxRsp& boxes);
    void advance(const TriRsp& tri);
    PrimReq fetch(std::uint32_t ray, Cursor cursor);
    bool starting() const { return prim_link_.second(!next_.empty()); }
    bool leaving() const { return step_link_.second(!tested_.empty()); }
    std::uint32_t t_best(std::uint32_t ray) const { return bests_[ray].found ? founds_[ray].t : beyond_; }

    std::uint32_t beyond_;
    std::vector<Ray> rays_;
    std::vector<BoxRsp> groups_;
    std::vector<Cursor> cursors_;
    std::vector<Best> bests_;
    std::vector<Closest> founds_;
    Ring<PrimReq> next_, first_;          // after tri's answer; first of a node
    Ring<Ending> tested_, leafless_;      // after tri's answer; straight from box
    Merge prim_link_, step_link_;
};

} // namespace rayclock
