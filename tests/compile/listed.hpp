#pragma once
// A scene's primitives on the lattice of a machine, in the order of a list.
#include "model/compile/compile.hpp"
#include "model/layout/words.hpp"
#include "model/scene/builtin.hpp"
#include "sim/load/load.hpp"

namespace rayclock::test {

inline std::vector<PrimData> prims_of(const char* name, Config config, Primitives primitives) {
    config.structure = Structure::none;
    config.splits = Splits::off;
    if (primitives == Primitives::native) config.spheres = config.planes = config.shading = 1;
    Scene scene = load_scene(name, {}, primitives);
    if (!scene.camera) scene.camera = fit_camera(scene, 4.0 / 3);
    const MemoryImage image = compile_scene(scene, scene.camera->eye, config);
    std::vector<PrimData> prims;
    for (std::uint32_t i = 0; i < image.listed_primitives; ++i)
        prims.push_back(read_primitive(image, i, config));
    return prims;
}

}   // namespace rayclock::test
