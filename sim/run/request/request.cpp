// Combining the options of a command.
#include "sim/run/request/request.hpp"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/compile/surfaces.hpp"
#include "model/core/settled.hpp"
#include "model/scene/folded.hpp"
#include "sim/run/frame/frame.hpp"
#include "sim/run/memory/memory_file.hpp"
#include "sim/run/request/ground.hpp"
#include "sim/run/request/ineffective.hpp"
#include "sim/run/request/levels.hpp"
#include "sim/run/request/material.hpp"

namespace rayclock {

namespace {

Whitted settings_of(const Finish& f, std::uint64_t seed) {
    Whitted w;
    const auto within = [](const char* option, double value, double lo, double hi) {
        if (!(value >= lo && value <= hi))
            throw UserError(fmt::format("{} must lie in {}..{}, not {}", option, lo, hi, value));
    };
    if (f.depth) within("--depth", *f.depth, 0, max_depth), w.depth = *f.depth;
    if (f.aa) within("--aa", *f.aa, 1, max_aa), w.aa = *f.aa;
    if (f.threshold) within("--threshold", *f.threshold, 0, 1), w.threshold = *f.threshold;
    if (f.contrast) within("--contrast", *f.contrast, 0, 1), w.contrast = *f.contrast;
    w.jitter = f.jittered;
    w.seed = std::uint32_t(seed);
    return w;
}

void print_notes(const std::vector<std::string>& notes) {
    constexpr std::size_t most = 20;
    for (std::size_t i = 0; i < std::min(notes.size(), most); ++i)
        std::fprintf(stderr, "rayclock: warning: %s\n", notes[i].c_str());
    if (notes.size() > most)
        std::fprintf(stderr, "rayclock: warning: %zu more warnings\n", notes.size() - most);
}

}   // namespace

Config widened(Config config, const std::vector<std::string>& set) {
    for (const std::string& item : set)
        if (const std::size_t equals = item.find('='); equals != std::string::npos)
            set_value(config, item.substr(0, equals), item.substr(equals + 1), "--set");
    return config;
}

void print_ineffective(const std::vector<std::string>& sentences) {
    for (const std::string& sentence : sentences)
        std::fprintf(stderr, "rayclock: note: %s\n", sentence.c_str());
}

namespace {

Textures textures_of(const ViewChoice& view) {
    return view.no_textures ? Textures::averaged : Textures::drawn;
}

/// A chip for streams draws no picture.
void refuse_stream(const Config& config) {
    if (config.is_stream())
        throw UserError("source=stream has no camera: use simulate or verify with --rays");
}

/// Adds a camera for a picture of this size, and applies the view options.
void apply_view(Scene& scene, FrameSize size, const ViewChoice& view) {
    const FrameSize whole = whole_size(view.window, size);
    if (!scene.camera) scene.camera = fit_camera(scene, double(whole.width) / whole.height);
    if (view.is_given()) scene.camera = chosen_camera(*scene.camera, view, whole);
    scene.camera->window = view.window;
    if (view.material) give_material(scene, *view.material);
    if (view.ground) lay_ground(scene);
}

}   // namespace

Scene load_noted_scene(const std::string& spec, const Progress& progress, Primitives primitives,
                       Textures textures) {
    std::vector<std::string> notes;
    Scene scene = load_scene(spec, progress, primitives, &notes, textures);
    print_notes(notes);
    return scene;
}

void refuse_folded(const Scene& scene) {
    if (is_folded(scene))
        throw UserError(
            fmt::format("{}: {} placed triangles are too many to be written out, which this command does",
                        scene.name, numbered_primitives(scene)));
}

Scene ready_scene(const std::string& spec, FrameSize size, const Progress& progress, const ViewChoice& view) {
    return ready_scene(load_noted_scene(spec, progress, Primitives::triangles, textures_of(view)), size,
                       view);
}

Scene ready_scene(Scene scene, FrameSize size, const ViewChoice& view) {
    refuse_folded(scene);
    apply_view(scene, size, view);
    return scene;
}

void check_levels(const Scene& scene, const Config& config, bool finished, bool ground) {
    if (is_folded(scene) && (!config.has_instances() || finished))
        throw UserError(
            fmt::format("{}: {} placed triangles are too many to be written out: only camera rays of a chip "
                        "with levels=2 "
                        "(--set levels=2) can draw them",
                        scene.name, numbered_primitives(scene)));
    if (ground && config.has_instances())
        throw UserError(
            "--ground adds triangles next to the instances, which levels=2 does not take; use levels=1");
}

Request request_of(const SceneSource& scene, const ConfigChoice& config, const Finish& finish,
                   std::uint64_t seed, FrameSize size, const ViewChoice& view,
                   std::vector<std::string>& idle) {
    Request r;
    r.settings = settings_of(finish, seed);
    // A setting may concern units that only a shading chip has. So apply the settings once that is decided.
    const bool by_hand = std::any_of(config.set.begin(), config.set.end(),
                                     [](const std::string& item) { return item.starts_with("shading="); });
    const bool may_wait = finish.is_given() && !by_hand;
    r.config = load_config({config.name, may_wait ? decltype(config.set){} : config.set});
    if (may_wait && r.config.shading) r.config = with_settings(r.config, config.set, r.config.name);
    refuse_stream(r.config);
    r.finished = finish.is_given() || r.config.shading;
    r.scene = scene(r.finished ? Primitives::native : Primitives::triangles);
    check_levels(r.scene, r.config, r.finished, false);   // before any more work
    r.finished = r.finished || !r.scene.spheres.empty() || !r.scene.planes.empty();
    apply_view(r.scene, size, view);
    if (finish.fresnel)
        for (Material& m : r.scene.materials) m.schlick = true;
    if (r.finished && !r.config.shading && !by_hand) {
        // Add the units that the scene needs, for the widths that were set. Then apply the user's settings
        // again.
        Config fitted = fitted_config(r.scene, r.settings, widened(r.config, config.set));
        const Config set = settled(widened(fitted, config.set));
        fitted.panes = set.panes, fitted.horizon = set.horizon;
        r.config = with_settings(fitted, config.set, fitted.name);
    }
    refuse_stream(r.config);
    check_levels(r.scene, r.config, r.finished, view.ground);
    for (const std::string& sentence : ineffective_settings(r.config, config.set)) idle.push_back(sentence);
    for (const std::string& sentence : ineffective_finish(finish, r.settings, r.scene))
        idle.push_back(sentence);
    return r;
}

Request request_of(const std::string& scene, const ConfigChoice& config, const Finish& finish,
                   std::uint64_t seed, FrameSize size, const Progress& progress, const ViewChoice& view) {
    std::vector<std::string> idle;
    const auto load = [&](Primitives primitives) {
        return load_noted_scene(scene, progress, primitives, textures_of(view));
    };
    Request r = request_of(SceneSource(load), config, finish, seed, size, view, idle);
    print_ineffective(idle);
    return r;
}

}   // namespace rayclock
