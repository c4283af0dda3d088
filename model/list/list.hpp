#pragma once
#include "model/core/payloads.hpp"
#include "model/core/ring.hpp"

namespace rayclock {

/// The leaves of a node: takes the box test's answer, sends the leaves' triangles to tri one by one, nearest leaf first
/// and none beyond the best hit, and then hands the inner children to trav. Keeps each ray's best hit.
///
/// Two things may happen in a cycle: an answer of tri moves its ray on (to the next triangle or to the step), and the
/// box answer at the head of the inbox starts its ray, if the queue that it needs (prim or step) is not taken by the
/// former. One triangle of a ray is under way at a time. Mirror of rtl/list/rc_list.sv.
class List {
public:
    explicit List(const Config& config);

    bool box_ready() const { return !inbox_.full(); }
    bool prim_valid() const { return !prims_.empty(); }
    const PrimReq& prim() const { return prims_.front(); }
    bool step_valid() const { return !steps_.empty(); }
    Step step() const;
    const Ray& ray(std::uint32_t ray) const { return rays_[ray]; }
    const Best& best(std::uint32_t ray) const { return bests_[ray]; }
    /// The request that a triangle from memory makes together with its ray.
    TriReq tri_req(std::uint32_t ray, const PrimData& triangle) const;
    /// The answer for a ray that trav has finished.
    Closest closest(std::uint32_t ray) const;

    /// One clock edge: what came in (null if nothing), and which outputs were taken. A tri answer is always accepted.
    void clock(const Ray* ray, const BoxRsp* boxes, const TriRsp* tri, bool prim_taken, bool step_taken);

private:
    enum class Queue { none, prim, step };
    struct Cursor {
        std::uint32_t leaf = 0, triangle = 0;
    };

    Queue advance(const TriRsp& tri);
    void start(Queue taken);
    void fetch(std::uint32_t ray, Cursor cursor);
    std::uint32_t t_best(std::uint32_t ray) const { return bests_[ray].found ? founds_[ray].t : beyond_; }

    std::uint32_t beyond_;
    std::vector<Ray> rays_;
    std::vector<BoxRsp> groups_;
    std::vector<Cursor> cursors_;
    std::vector<Best> bests_;
    std::vector<Closest> founds_;
    Ring<BoxRsp> inbox_;
    Ring<PrimReq> prims_;
    struct Ending {
        std::uint32_t ray = 0, t_best = 0;
    };
    Ring<Ending> steps_;
};

} // namespace rayclock
