#include "sim/app/picture.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "model/core/error.hpp"

namespace rayclock {

namespace {

Whitted settings_of(const Options& o) {
    Whitted w;
    const auto within = [](const char* option, double value, double lo, double hi) {
        if (!(value >= lo && value <= hi)) throw UserError(fmt::format("{} must lie in {}..{}, not {}", option, lo, hi, value));
    };
    if (o.depth) within("--depth", *o.depth, 0, most_depth), w.depth = *o.depth;
    if (o.aa) within("--aa", *o.aa, 1, most_aa), w.aa = *o.aa;
    if (o.threshold) within("--threshold", *o.threshold, 0, 1), w.threshold = *o.threshold;
    if (o.contrast) within("--contrast", *o.contrast, 0, 1), w.contrast = *o.contrast;
    w.jitter = o.jittered;
    w.seed = std::uint32_t(o.seed);
    return w;
}

bool asks_for_finished(const Options& o) { return o.depth || o.aa || o.threshold || o.contrast || o.jittered || o.fresnel; }

} // namespace

Request request_of(const Options& o, FrameSize size, const Progress& progress) {
    Request r;
    r.settings = settings_of(o);
    // --set may name units that only a chip with shading has: they are set once it is known to be one.
    const bool by_hand = std::any_of(o.set.begin(), o.set.end(), [](const std::string& item) { return item.starts_with("shading="); });
    r.config = load_config(o.config, asks_for_finished(o) && !by_hand ? std::vector<std::string>{} : o.set);
    r.finished = asks_for_finished(o) || r.config.shading;
    r.scene = told_scene(o.scene, progress, r.finished ? Primitives::native : Primitives::triangles);
    r.finished = r.finished || !r.scene.spheres.empty() || !r.scene.planes.empty();
    if (!r.scene.camera) r.scene.camera = fit_camera(r.scene, double(size.width) / size.height);
    if (o.fresnel)
        for (Material& m : r.scene.materials) m.schlick = true;
    if (!r.finished || r.config.shading || by_hand) return r;
    // The units that the scene needs; what was set by hand is set again.
    Config config = fitted_config(r.scene, r.settings, r.config);
    r.config = with_settings(config, o.set, config.name);
    return r;
}

} // namespace rayclock
