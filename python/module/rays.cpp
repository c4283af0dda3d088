// rayclock.make_rays(): streams of rays from the reference tracer.
#include <cmath>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "python/module/bindings.hpp"
#include "python/module/work.hpp"
#include "sim/run/stream/make_rays.hpp"

namespace rayclock::python {

namespace {

/// Returns the position of a word among others. Throws UserError.
int chosen(const char* option, const std::string& typed, const std::vector<std::string>& words) {
    for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i] == typed) return int(i);
    throw UserError(fmt::format("{}: {} is not one of {}", option, shown(typed), fmt::join(words, ", ")));
}

void check(const char* name, int value, int most) {
    if (value < 1 || value > most)
        throw UserError(fmt::format("{} must lie in 1..{}, not {}", name, most, value));
}

/// Returns the bytes of the .npy file that `rayclock rays` writes.
py::array made_rays(const PyScene& scene, const PyConfig& config, int width, int height,
                    const std::string& kind, const std::string& order, int bounce, int samples,
                    std::optional<double> radius, std::uint64_t seed, const ViewChoice& view, int threads) {
    RayStreamPlan plan;
    plan.kind = RayStreamKind(chosen("kind", kind, {"camera", "shadow", "mirror", "ao", "diffuse"}));
    plan.order = RayOrder(chosen("order", order, {"recorded", "morton", "random"}));
    plan.size = {width, height};
    check_frame_size(plan.size);
    check("bounce", bounce, 16);
    check("samples", samples, 1024);
    if (radius && !(*radius > 0 && std::isfinite(*radius)))
        throw UserError(fmt::format("radius must be above 0, not {}", *radius));
    plan.bounce = bounce, plan.samples = samples, plan.radius = radius.value_or(0), plan.seed = seed;
    return bytes_array(result_of([=](const Progress& stop) {
        const Config machine = load_config(config.choice);
        const Scene seen = ready_scene(*scene.scene, plan.size, view);
        const std::vector<StreamRay> rays = make_rays(seen, plan, machine, threads, stop);
        if (rays.empty())
            throw UserError(seen.name +
                            ": the stream would be empty, because no earlier ray hits a triangle");
        return rays_npy(rays);
    }));
}

}   // namespace

void bind_rays(py::module_& module) { module.def("make_rays", &made_rays); }

}   // namespace rayclock::python
