// Powers by tables of logarithms and exponentials.
#include "model/fixed/power.hpp"

#include <bit>

#include "model/fixed/tables.hpp"

namespace rayclock {

std::uint32_t power(std::uint32_t c, std::uint32_t n) {
    if (c == 0) return 0;
    const int len = int(std::bit_width(c));
    const std::uint32_t m = c << (17 - len);   // 1..2, 16 fraction bits
    const TableEntry& log = log_table()[m >> 9 & 127];
    const std::uint32_t lg = log.value + (log.step * (m & 511) >> 9);
    const std::uint32_t neg = (std::uint32_t(17 - len) << 18) - lg;   // -log2(c), 18 fraction bits
    const std::uint64_t y = std::uint64_t(neg) * n >> 4;
    const std::uint64_t whole = y >> 18;
    if (whole > 17) return 0;
    const TableEntry& exp = exp_table()[y >> 11 & 127];
    const std::uint32_t g = exp.value - (exp.step * std::uint32_t(y & 2047) >> 11);   // 17 fraction bits
    return (g + (1u << whole)) >> (whole + 1);
}

}   // namespace rayclock
