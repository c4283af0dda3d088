// rayclock.make_rays(): streams of rays from the reference tracer.
#include <pybind11/stl.h>

#include "python/module/bindings.hpp"
#include "python/module/work.hpp"
#include "sim/app/run/stream_run.hpp"
#include "sim/run/stream/make_rays.hpp"

namespace rayclock::python {

namespace {

/// Returns the bytes of the .npy file that `rayclock rays` writes.
py::array made_rays(const PyScene& scene, const PyConfig& config, int width, int height,
                    const std::string& kind, const std::string& order, int bounce, int samples,
                    std::optional<double> radius, std::uint64_t seed, const ViewChoice& view, int threads) {
    const RayStreamPlan plan =
        ray_stream_plan({kind, order, {width, height}, bounce, samples, radius, seed}, "");
    return bytes_array(result_of([=](const Progress& stop) {
        std::vector<std::string> notes;   // a setting without effect has none on the rays
        const Scene seen = ready_scene(scene.source(stop)(stream_primitives(config.choice)), plan.size, view);
        const Config machine = rays_config(config.choice, seen, notes);
        return rays_npy(make_rays(seen, plan, machine, threads, stop), seen.name);
    }));
}

}   // namespace

void bind_rays(py::module_& module) { module.def("make_rays", &made_rays); }

}   // namespace rayclock::python
