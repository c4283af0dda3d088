#pragma once
// What is to be drawn: scene, machine and settings, from what was asked for.
#include "model/base/progress.hpp"
#include "model/scene/builtin.hpp"
#include "model/scene/camera.hpp"
#include "model/scene/scene.hpp"
#include "model/scene/whitted.hpp"
#include "sim/run/request/config_file.hpp"
#include "sim/run/request/finish.hpp"
#include "sim/run/request/view.hpp"

namespace rayclock {

/// load_scene(), with a warning on standard error for whatever a file holds and is not drawn as it stands
/// there.
Scene told_scene(const std::string& spec, const Progress& progress,
                 Primitives primitives = Primitives::triangles);

/// The same with a camera, for a picture of this size.
Scene ready_scene(const std::string& spec, FrameSize size, const Progress& progress,
                  const ViewChoice& view = {});

/// What a command is asked to draw: scene, machine, and whether the finished picture is meant, as the chip
/// shades it, or only what camera rays hit. The former if one of --depth, --threshold, --aa, --jittered,
/// --contrast, --fresnel was given, if the configuration has shading=1, or if the scene has spheres or
/// planes.
struct Request {
    Config config;
    Scene scene;
    bool finished = false;
    Whitted settings;
};

/// Loads scene and configuration. For a finished picture a configuration without shading gets the units that
/// the scene needs, and its settings may change them again. `seed` is that of jittered samples. Throws
/// UserError.
Request request_of(const std::string& scene, const ConfigChoice& config, const Finish& finish,
                   std::uint64_t seed, FrameSize size, const Progress& progress, const ViewChoice& view = {});

}   // namespace rayclock
