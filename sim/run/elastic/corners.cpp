// Moves recorded requests to corners.
#include "sim/run/elastic/corners.hpp"

#include "model/unit/tri/sheared.hpp"

namespace rayclock {

void to_corner(TriReq& request, const Config& config, std::mt19937_64& random) {
    PrimData& t = request.triangle;
    const auto move = [&](Vec3i& v, int bits) {
        const std::int32_t most = std::int32_t((std::int64_t(1) << (bits - 1)) - 1);
        for (std::size_t k = 0; k < 3; ++k) {
            if (random() % 4 > 0) continue;
            const std::int32_t corners[] = {
                0, 1, -1, most, -most - 1, most - 1, -most, v[(k + 1) % 3], t.a[k], t.b[k]};
            const std::int32_t value = corners[random() % std::size(corners)];
            if (value <= most && value >= -most - 1) v[k] = value;
        }
    };
    for (Vec3i* v : {&request.o, &t.a, &t.b, &t.c}) move(*v, config.coord_bits);
    move(request.d, config.dir_bits);
    if (config.is_sheared()) request.shear = shear_of(request.d, config);
}

}   // namespace rayclock
