// A frame on the model alone: this program links rc_model, every object of it, and nothing else of the
// project.
#include <cstdio>

#include "model/compile/compile.hpp"
#include "model/compile/frame.hpp"
#include "model/machine/machine.hpp"
#include "model/scene/builtin.hpp"

using namespace rayclock;

int main() {
    const Scene scene = make_builtin("teapot:3");
    const Config config = named_config("default");
    const FrameSize size{32, 24};
    const Camera camera = scene.camera ? *scene.camera : fit_camera(scene, 4.0 / 3);
    const MemoryImage image = compile_scene(scene, camera.eye, config);
    const Frame frame = make_frame(camera, size, image.lattice, config);
    const Trace trace = record_trace(image, frame, config);
    Machine machine(config, 66000);
    machine.start(frame, trace);
    machine.run(~std::uint64_t(0));
    std::printf("%llu cycles\n", static_cast<unsigned long long>(machine.cycle()));
}
