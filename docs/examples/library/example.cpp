// Simulates a frame of gears:4 on a chip with larger caches, and traces three rays.
#include <cstdio>

#include <rayclock/rayclock.hpp>

namespace rc = rayclock::library;

int main() {
    try {
        const rc::Scene gears = rc::Scene::load("gears:4");
        const rc::Config chip = rc::Config("default").set("node_sets", "128");
        std::printf("%s: %zu triangles\n", gears.name().c_str(), gears.triangles());

        rc::FrameOptions frame;
        frame.width = 256, frame.height = 192, frame.mhz = {66, 200};
        for (const rc::ClockReport& clock : rc::simulate(gears, chip, frame).clocks)
            std::printf("%g MHz: %llu cycles, %.2f frames per second\n", clock.mhz,
                        static_cast<unsigned long long>(clock.cycles), clock.fps);

        const rc::Ray rays[] = {
            {.origin = {0, 0, 9}, .direction = {0, 0, -1}},
            {.origin = {0.5, 0.2, 9}, .direction = {0, 0, -1}},
            {.origin = {0, 0, 9}, .direction = {0, 0, 1}},
        };
        for (const rc::Hit& hit : rc::trace(gears, chip, rays))
            if (hit.hit)
                std::printf("triangle %u at t = %.4f\n", hit.primitive, hit.t);
            else
                std::printf("no hit\n");
    } catch (const rc::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
