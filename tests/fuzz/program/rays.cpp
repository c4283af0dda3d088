// Fuzzes files of rays.
#include <cmath>

#include "sim/load/rays/rays.hpp"
#include "tests/fuzz/program/scratch.hpp"
#include "tests/fuzz/program/targets.hpp"

namespace rayclock::fuzz {

void rays(std::string_view bytes) {
    for (const char* name : {"fuzzed.npy", "fuzzed.rays"}) {
        const std::string path = scratch_file(name, bytes);
        passes([&] {
            const RayFile read(path);
            demand(read.size() > 0 && read.size() <= bytes.size() / 24, "a ray has at least 24 bytes");
            for (std::size_t i = 0; i < read.size(); ++i) {
                const StreamRay ray = read[i];
                demand(ray.t_min <= ray.t_max, "t_min is at most t_max");
                for (int k = 0; k < 3; ++k)
                    demand(std::isfinite(ray.origin[k]) && std::isfinite(ray.direction[k]),
                           "a ray is finite");
            }
        });
    }
}

}   // namespace rayclock::fuzz
