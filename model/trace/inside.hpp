#pragma once
// A ray in the space of the instance that it entered last.
#include "model/engine/engines.hpp"
#include "model/unit/xform/xform.hpp"

namespace rayclock {

/// A ray in the space of the instance that it entered last. For the walk an instance's line is a node with
/// one child, the root of its mesh, which every ray meets immediately. A later node's line determines its
/// space, regardless of the ray's earlier visits. So a ray that returns from an instance needs no restoring.
struct InsideRay {
    Change change;
    RayForms forms;
    Ray moved{};   ///< the ray in the form of any_primitive_test()
    WideNode entry;
    bool enters = false;   ///< the line read last is an instance

    /// Moves the ray into the instance. Its best hit and its distance to beat stay.
    const WideNode& enter(const Ray& ray, const Placement& placement, const Config& config,
                          std::uint32_t* t_near, std::uint32_t& hits) {
        change = xform({ray.ray, ray.o, ray.d, placement, ray.kind, ray.home}, config);
        moved.kind = ray.kind, moved.o = change.o, moved.d = change.d;
        moved.self = ray.self, moved.is_inside = ray.is_inside, moved.is_partial = ray.is_partial;
        forms.take(moved, box_ray(change), config.lower_engine(), config);
        entry.base = change.root;
        entry.children = entry.children_mask = entry.inner_mask = 1;
        t_near[0] = 0;
        hits = 1;
        return entry;
    }
};

}   // namespace rayclock
