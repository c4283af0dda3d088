// rayclock.make_rays(): streams of rays from the reference tracer.
#include <pybind11/stl.h>

#include "python/module/bindings.hpp"
#include "python/module/work.hpp"
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
        const Config machine = load_config(config.choice);
        const Scene seen = ready_scene(*scene.scene, plan.size, view);
        return rays_npy(make_rays(seen, plan, machine, threads, stop), seen.name);
    }));
}

}   // namespace

void bind_rays(py::module_& module) { module.def("make_rays", &made_rays); }

}   // namespace rayclock::python
