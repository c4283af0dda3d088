#pragma once
// One ray's walk by the units' pure functions.
#include "model/trace/decoder.hpp"
#include "model/trace/inside.hpp"
#include "model/trace/tree_walk.hpp"
#include "model/unit/tri/tri_test.hpp"
#include "model/unit/tri/any_primitive.hpp"

namespace rayclock {

/// Tests nodes and primitives of any structure for any ray, by the units' pure functions.
struct UnitPolicy {
    using Order = ByDistance;
    const Config& config;
    const Decoder& decoder;
    TriTest* primitive_test;
    Ray ray{};
    RayForms forms{};
    InsideRay inside{};   ///< with instances
    BestHit hit{};
    TriRsp tri{};   ///< the last answer
    WideNode page{};

    void start(const Ray& ray_) {
        ray = ray_;
        forms.take(ray, box_ray(ray), config.engine(), config);
        hit = {{ray.ray, ray.kind, ray.holes}, t_max_of(ray.kind, config)};
    }
    /// Returns the ray in the engine's form. `line` selects the space: the scene's or an instance's.
    template <class E> const typename E::RayForm& form_at(std::uint32_t line) const {
        return (in_mesh(line) ? inside.forms : forms).of<E>().form;
    }
    bool in_mesh(std::uint32_t line) const {
        return config.has_instances() && decoder.kind(line) == LineKind::mesh_node;
    }
    const WideNode& boxes(std::uint32_t line, std::uint32_t* t_near, std::uint32_t& hits) {
        if (config.is_list()) {
            page = decoder.page(line);
            std::fill_n(t_near, max_width, 0u);
            hits = page.children_mask;
            return page;
        }
        inside.enters = config.has_instances() && decoder.kind(line) == LineKind::placement;
        if (inside.enters) return inside.enter(ray, decoder.placement(line), config, t_near, hits);
        return with_engine(decoder.engine(line), [&]<class E>(E) -> const WideNode& {
            const typename E::Wide& node = decoder.node<E>(line);
            hits = E::decide(form_at<E>(line), node, config, t_near);
            return E::children(node);
        });
    }
    bool enters() const { return inside.enters; }
    /// Returns a primitive, numbered as in the scene.
    PrimData primitive(std::uint32_t half_line) const {
        PrimData prim = decoder.prim(half_line);
        if (config.has_instances()) prim.prim += inside.change.first;
        return prim;
    }
    const Vec3i& o() const { return config.has_instances() ? inside.change.o : ray.o; }   ///< as tri sees it
    const Vec3i& d() const { return config.has_instances() ? inside.change.d : ray.d; }
    bool is_list() const { return config.is_list(); }
    std::uint32_t next_page(std::uint32_t line) const { return decoder.next_page(line); }
    void test(std::uint32_t half_line) {
        tri.ray = ray.ray;
        if (config.has_homes())
            any_primitive_test(inside.moved, primitive(half_line), hit.best(), config, tri);
        else if (config.shading)
            any_primitive_test(ray, decoder.prim(half_line), hit.best(), config, tri);
        else if (config.has_instances())
            primitive_test(o(), d(), primitive(half_line), hit.best(), config, tri);
        else
            primitive_test(ray.o, ray.d, decoder.prim(half_line), hit.best(), config, tri);
        hit.take(tri, config.has_homes() ? inside.change.here : 0);
    }
    std::uint32_t t_best() const { return hit.t_best(); }
    bool stop() const { return hit.stop(); }
};

/// *What* one ray does, and the values that every link of the machine must carry for it. The sequence of
/// nodes, tests and results does not depend on *when* anything happens.
class Walk {
public:
    Walk(const Frame& frame, const Config& config, const Decoder& decoder)
        : frame_(frame), policy_{config, decoder, tri_test_of(config)}, stack_(config) {}
    Walk(const Walk&) = delete;

    /// raygen: starts the camera ray of a pixel; the next node is the root.
    const Ray& start(const Slot& slot);
    /// Starts any ray, in the form in which raygen would send it.
    const Ray& start_at(const Ray& ray);
    /// Walks to the ray's end; see TreeWalk::run().
    template <class Watch> void run(Watch&& watch) { steps_.run(frame_.root, watch); }

    std::uint32_t node() const { return steps_.line(); }   ///< the next node, or the one in flight

    /// Visits the next node, and performs trav on the answer; for a list, trav on the next page. Returns
    /// true if list has a triangle to test.
    bool visit_node() { return has_leaves_ = steps_.visit(); }
    bool has_leaves() const { return has_leaves_; }   ///< result of visit_node()
    /// Returns that node's children that the ray meets, one bit each.
    std::uint32_t met() const { return steps_.hits(); }
    NodeAnswer node_answer() const {
        return rayclock::node_answer(ray().ray, steps_.hits(), steps_.t_near(), steps_.node());
    }
    Leaves leaves() const { return leaves_of(node_answer()); }   ///< that trav sent to list
    std::uint32_t prim() const { return steps_.prim(); }
    /// Performs tri on the next triangle, and list on its answer.
    const TriRsp& test_triangle() {
        policy_.test(prim());
        return tri();
    }
    /// Advances. Returns true if there is another triangle.
    bool advance() { return steps_.advance(); }

    /// list -> trav, when no triangle is left.
    Tested tested() const { return {ray().ray, policy_.stop(), policy_.t_best()}; }
    /// trav: moves to the next node, or the ray's end. Returns the number of groups dropped on the way.
    std::uint32_t decide(bool& done) { return steps_.decide(done); }
    /// Returns the number of groups on the ray's stack.
    int stack_height() const { return stack_.height(); }

    const Ray& ray() const { return policy_.ray; }
    /// Returns the ray in the form of the engine that decides the next node.
    template <class E> const typename E::RayForm& form() const { return policy_.form_at<E>(node()); }
    bool enters() const { return policy_.enters(); }   ///< true if the node visited last is an instance
    const Change& change() const { return policy_.inside.change; }   ///< xform's answer there
    const Vec3i& o() const { return policy_.o(); }                   ///< of the ray as tri sees it
    const Vec3i& d() const { return policy_.d(); }
    /// Returns the next primitive, or the one in flight.
    PrimData primitive() const { return policy_.primitive(prim()); }
    const Best& best() const { return policy_.hit.best(); }
    const TriRsp& tri() const { return policy_.tri; }
    Closest closest() const { return policy_.hit.closest(); }

private:
    const Frame& frame_;
    UnitPolicy policy_;
    Stack stack_;
    WalkRoom<ByDistance> room_;
    TreeWalk<UnitPolicy> steps_{policy_, stack_, room_};
    bool has_leaves_ = false;
};

}   // namespace rayclock
