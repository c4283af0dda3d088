// Reports the place of every ray.
#include "model/machine/stuck_rays.hpp"

#include "model/machine/machine.hpp"

namespace rayclock {

std::string describe_stuck_rays(const Machine& machine) {
    std::string text;
    for (int p = 0; p < machine.config().pipelines; ++p)
        for (std::uint32_t ray = 0; ray < std::uint32_t(machine.config().contexts); ++ray) {
            const std::string place = machine.where(p, ray);
            if (place.empty()) continue;
            const Slot& pixel = machine.pixel(p, ray);
            text += "  pipeline " + std::to_string(p) + " ray " + std::to_string(ray) + " pixel (" +
                    std::to_string(pixel.x) + ", " + std::to_string(pixel.y) + "): " + place + "\n";
        }
    return text.empty() ? "  no ray is under way\n" : text;
}

}   // namespace rayclock
