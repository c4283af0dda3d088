// A frame on the model alone: this program links rc_model, every object of it, and nothing else of the project.
#include <cstdio>

#include "model/machine.hpp"
#include "model/scene/builtin.hpp"

using namespace rayclock;

int main() {
    const Scene scene = make_builtin("teapot:3");
    const Config config = named_config("default");
    const FrameSize size{32, 24};
    const Camera camera = scene.camera ? *scene.camera : fit_camera(scene, 4.0 / 3);
    const MemoryImage image = compile_scene(scene, camera.eye, config);
    const Frame frame = make_frame(camera, size, image.lattice, config);
    Machine machine(image, frame, config);
    while (!machine.done()) machine.step();
    std::printf("%llu cycles\n", static_cast<unsigned long long>(machine.cycle()));
}
