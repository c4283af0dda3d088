#pragma once
// The engines that walk a ray through an acceleration structure: one row each. Higher layers iterate over
// these rows, or look up the descriptor of an engine. A new engine needs no other change there.
//
// A descriptor has
// - structure: the value of the parameter that selects the engine;
// - Node: its line in memory, and node_name, the line's name in rc_pkg.sv and in tables;
// - Request: what trav sends to the node unit. All node units answer with a NodeAnswer;
// - RayForm, form(): a ray in the form in which the unit takes it, from the ray and from its box form;
// - Wide, Reader: a node in the model's own form, and the function that reads it from a line;
// - latency(): of the unit in cycles, without its result queue;
// - request(): the payload of a request;
// - decide(): the children that a ray meets, one bit each, and t_near of each. Mirror of the unit's RTL;
// - children(): the places of a node's children in memory;
// - answer(): the unit's answer to a request, for tests and tools that look at the unit alone;
// - has_cells: true if its builder makes cells (space_cells/cell.hpp), which the compiler writes as lines.
//   Such an engine also has build(), which returns the cells of a scene, put(), which writes a plane of a
//   cell into a node, and put_none(), which writes a missing plane.
//
// It is the struct Engine in the engine's namespace, which has the name of the engine's folder and also holds
// the builder. Node, request and decision are in rayclock, as all payloads and functions of units are.
#include <algorithm>
#include <array>
#include <tuple>

#include "model/engine/bih/engine.hpp"
#include "model/engine/bsp/engine.hpp"
#include "model/engine/bvh/engine.hpp"
#include "model/engine/kd/engine.hpp"
#include "model/engine/spheres/engine.hpp"

namespace rayclock {

// Columns: the structure, its node unit, the descriptor. `with` is passed on.
#define RAYCLOCK_ENGINES(ENGINE, with)            \
    ENGINE(with, bvh, box, bvh::Engine)           \
    ENGINE(with, kd, treelet, kd::Engine)         \
    ENGINE(with, spheres, globe, spheres::Engine) \
    ENGINE(with, bih, bih, bih::Engine)           \
    ENGINE(with, bsp, slant, bsp::Engine)

#define RAYCLOCK_CHECK(with, tree, unit, Engine) static_assert(Engine::structure == Structure::tree);
RAYCLOCK_ENGINES(RAYCLOCK_CHECK, )
#undef RAYCLOCK_CHECK
#define RAYCLOCK_DESCRIPTOR(with, structure, unit, Engine) , std::tuple<Engine>()
/// All descriptors, in the order of their rows.
using Engines = decltype(std::tuple_cat(std::tuple<>() RAYCLOCK_ENGINES(RAYCLOCK_DESCRIPTOR, )));
#undef RAYCLOCK_DESCRIPTOR

/// Calls `work` with the descriptor of an engine (Config::engine_of(), so never octree). A list has no nodes;
/// then `work` gets bvh::Engine.
template <class Work> decltype(auto) with_engine(Structure engine, Work&& work) {
    switch (engine) {
#define RAYCLOCK_CASE(with, structure, unit, Engine) \
    case Structure::structure: return work(Engine{});
        RAYCLOCK_ENGINES(RAYCLOCK_CASE, )
#undef RAYCLOCK_CASE
        default: return work(bvh::Engine{});
    }
}
/// Calls `work` with every descriptor.
template <class Work> void for_each_engine(Work&& work) {
    std::apply([&](auto... engines) { (work(engines), ...); }, Engines{});
}

/// Holds one `Of<Engine>` for each engine.
template <template <class> class Of, class List = Engines> struct PerEngine;
template <template <class> class Of, class... Engine> struct PerEngine<Of, std::tuple<Engine...>>
    : Of<Engine>... {
    PerEngine() = default;
    template <class First, class... More> explicit PerEngine(const First& first, const More&... more)
        : Of<Engine>(first, more...)... {}
    template <class E> Of<E>& of() { return *this; }
    template <class E> const Of<E>& of() const { return *this; }
};

/// A ray in the form of one engine.
template <class Engine> struct FormOf { typename Engine::RayForm form{}; };
/// A ray in the forms of the engines that walk it.
struct RayForms : PerEngine<FormOf> {
    /// Computes the form of one engine.
    void take(const Ray& ray, const BoxRay& box, Structure engine, const Config& config) {
        with_engine(engine, [&]<class E>(E) { of<E>().form = E::form(ray, box, config); });
    }
};

/// Returns the bits of a node in its line.
inline int node_bits(const Config& config, Structure engine) {
    return with_engine(engine, [&]<class E>(E) { return bits_of<typename E::Node>(config); });
}
/// Return the latency of a node's decision: of one engine, or of the machine. With two engines both take the
/// latency of the slower one.
inline int node_latency(const Config& config, Structure engine) {
    return with_engine(engine, [&]<class E>(E) { return E::latency(config); });
}
inline int node_latency(const Config& config) {
    return std::max(node_latency(config, config.engine()), node_latency(config, config.lower_engine()));
}
/// True if the scene's tree consists of cells.
inline bool has_cells(const Config& config) {
    return !config.is_list() && with_engine(config.engine(), []<class E>(E) { return E::has_cells; });
}

template <class Engine> struct NodeOf { typename Engine::Node node{}; };
/// Node memory -> trav or xform.
struct NodeRsp : PerEngine<NodeOf> {
    std::uint32_t ray = 0;
    std::uint32_t what = 0;   ///< LineKind, if there are instances
    /// The upper bits of a line that is wider than a node of the scene's tree: an instance or a mesh's node.
    /// One entry per bit. The node's fields follow.
    std::array<std::uint32_t, line_bits> beyond{};
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        if (c.has_instances()) {
            v("what", what, line_kind_bits);
            const int most = std::max(bits_of<Placement>(c), node_bits(c, c.lower_engine()));
            const int more = most - node_bits(c, c.engine());
            if (more > 0) v("beyond", beyond, 1, more);
        }
        with_engine(c.engine(), [&]<class E>(E) { of<E>().node.fields(v, c); });
    }
};

}   // namespace rayclock
