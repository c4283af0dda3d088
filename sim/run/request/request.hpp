#pragma once
// The input of a command that draws: scene, machine and settings, from the user's options.
#include <functional>

#include "model/base/progress.hpp"
#include "model/scene/builtin.hpp"
#include "model/scene/camera.hpp"
#include "model/scene/scene.hpp"
#include "model/scene/whitted.hpp"
#include "sim/load/load.hpp"
#include "sim/run/request/config_file.hpp"
#include "sim/run/request/finish.hpp"
#include "sim/run/request/view.hpp"

namespace rayclock {

/// Calls load_scene(), and prints a warning on standard error for all content that is changed or not drawn.
Scene load_noted_scene(const std::string& spec, const Progress& progress,
                       Primitives primitives = Primitives::triangles, Textures textures = Textures::drawn);

/// Throws UserError for a folded scene: one with too many placed triangles to be written out.
void refuse_folded(const Scene& scene);

/// Calls load_noted_scene(), and adds a camera for a picture of this size. Throws UserError for a folded
/// scene.
Scene ready_scene(const std::string& spec, FrameSize size, const Progress& progress,
                  const ViewChoice& view = {});

/// Adds a camera for a picture of this size to a scene that is loaded already. Throws as above.
Scene ready_scene(Scene scene, FrameSize size, const ViewChoice& view = {});

/// A request to draw a scene on a machine: either the finished picture, as the chip shades it, or only the
/// hits of camera rays. It is the finished picture in three cases. One of --depth, --threshold, --aa,
/// --jittered, --contrast, --fresnel was given; the configuration has shading=1; or the scene has spheres or
/// planes.
struct Request {
    Config config;
    Scene scene;
    bool finished = false;
    Whitted settings;
};

/// Returns the configuration with the settings, which need not be legal together: units are then fitted to
/// their widths.
Config widened(Config config, const std::vector<std::string>& set);

/// Prints notes of ineffective_settings() on standard error.
void print_ineffective(const std::vector<std::string>& sentences);

/// Loads scene and configuration. For a finished picture, a configuration without shading gets the units that
/// the scene needs, and its settings override them. `seed` is that of jittered samples. Throws UserError.
Request request_of(const std::string& scene, const ConfigChoice& config, const Finish& finish,
                   std::uint64_t seed, FrameSize size, const Progress& progress, const ViewChoice& view = {});

/// Makes the scene of a request. A built-in scene has two forms.
using SceneSource = std::function<Scene(Primitives primitives)>;
/// Does the same with a scene of any origin. Appends a sentence to `idle` for each option without effect.
Request request_of(const SceneSource& scene, const ConfigChoice& config, const Finish& finish,
                   std::uint64_t seed, FrameSize size, const ViewChoice& view,
                   std::vector<std::string>& idle);

}   // namespace rayclock
