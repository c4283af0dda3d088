#pragma once
#include "model/reference/reference.hpp"
#include "sim/app/setup.hpp"
#include "sim/engine/engine.hpp"
#include "sim/report/json.hpp"

namespace rayclock {

/// What a command is asked to draw: scene, machine, and whether the finished picture is meant, as the chip shades it, or only what
/// camera rays hit. The former if one of --depth, --threshold, --aa, --jittered, --contrast, --fresnel was given, if the configuration
/// has shading=1, or if the scene has spheres or planes.
struct Request {
    Config config;
    Scene scene;
    bool finished = false;
    Whitted settings;
};

/// Loads scene and configuration. For a finished picture a configuration without shading gets the units that the scene needs, and
/// --set may change them again. Throws UserError.
Request request_of(const Options& options, FrameSize size, const Progress& progress);

} // namespace rayclock
