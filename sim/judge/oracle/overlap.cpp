// The latest entry of the three axes, compared with each exit.
#include "sim/judge/oracle/overlap.hpp"

namespace rayclock::oracle {

std::optional<Fraction> overlap(const LatticeVec& o, const LatticeVec& d, const LatticeVec& lo,
                                const LatticeVec& hi) {
    Fraction enter{0, 1};   // the largest so far; starts at s = 0
    std::array<Fraction, 3> leave;
    std::size_t leaves = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        if (d[k] == 0) {
            if (o[k] < lo[k] || o[k] > hi[k]) return std::nullopt;
            continue;
        }
        const bool ahead = d[k] > 0;
        const std::int64_t size = ahead ? d[k] : -d[k];
        const Fraction in{ahead ? lo[k] - o[k] : o[k] - hi[k], size};
        leave[leaves++] = {ahead ? hi[k] - o[k] : o[k] - lo[k], size};
        if (less(enter, in)) enter = in;
    }
    for (std::size_t i = 0; i < leaves; ++i)
        if (less(leave[i], enter)) return std::nullopt;
    return enter;
}

}   // namespace rayclock::oracle
