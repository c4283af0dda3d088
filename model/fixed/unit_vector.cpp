// Unit vectors by a table of inverse square roots.
#include "model/fixed/unit_vector.hpp"

#include <algorithm>
#include <bit>
#include <cassert>

#include "model/fixed/tables.hpp"

namespace rayclock {

std::uint32_t inverse_root(std::uint32_t sum) {
    const TableEntry& entry = inverse_root_table()[sum >> 10];
    return entry.value - (entry.step * (sum & 1023) >> 10);
}

Vec3i unit_vector(const Vec3l& v) {
    std::array<std::uint64_t, 3> a{};
    for (std::size_t k = 0; k < 3; ++k) a[k] = v[k] < 0 ? 0 - std::uint64_t(v[k]) : std::uint64_t(v[k]);
    const int len = int(std::bit_width(a[0] | a[1] | a[2]));
    if (len == 0) return {};
    // The longest component gets 17 bits, so the sum of the squares has 33 to 36.
    for (auto& x : a) x = len > 17 ? x >> (len - 17) : x << (17 - len);
    std::uint64_t sum = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
    const int e = sum >> 34 == 0;
    sum <<= 2 * e;
    assert(sum >> 34 >= 1 && sum >> 34 <= 3 && "a sum of squares between 2^32 and 3 * 2^34");
    const std::uint64_t r = inverse_root(std::uint32_t(sum >> 17) - (1u << 17));
    Vec3i u{};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto size =
            std::int32_t(std::min<std::uint64_t>(((a[k] * r << e) + (1u << 18)) >> 19, 1u << 16));
        u[k] = v[k] < 0 ? -size : size;
    }
    return u;
}

}   // namespace rayclock
