#pragma once
// The list of golden pictures, shared by the program that makes them and the test that checks them.
#include <array>

#include "sim/judge/reference/reference.hpp"
#include "model/scene/builtin.hpp"
#include "model/scene/hit_shading.hpp"

namespace rayclock {

constexpr std::array golden_scenes{"tetra:6",   "mount:6", "gears:4", "balls:2",
                                   "teapot:12", "rings:2", "cornell", "icosphere:4"};
constexpr FrameSize golden_size{128, 96};

/// Returns a built-in scene with its camera set.
inline Scene golden_scene(const char* spec) {
    Scene scene = make_builtin(spec);
    if (!scene.camera)
        scene.camera = fit_camera(scene, static_cast<double>(golden_size.width) / golden_size.height);
    return scene;
}

}   // namespace rayclock
