// Computes the tables of tables.hpp.
#include "model/engine/spheres/tables.hpp"

#include <algorithm>

namespace rayclock {

namespace {

/// Returns the greatest correct value at z = x / 2^16.
std::uint32_t max_at(std::uint64_t x) {
    return std::uint32_t(((std::uint64_t(1) << 33) - (std::uint64_t(1) << 17)) / x);
}

std::array<TableEntry, near_inverse_entries> make_near_inverse() {
    std::array<TableEntry, near_inverse_entries> table;
    for (std::uint32_t i = 0; i < table.size(); ++i) {
        const std::uint32_t z = (128 + i) << 9;
        TableEntry& entry = table[i];
        entry.value = max_at(z + 1);
        entry.step = entry.value - max_at(z + 513);
        std::uint32_t excess = 0;   // a chord lies above the curve
        for (std::uint32_t f = 0; f < 512; ++f) {
            const std::uint32_t value = entry.value - (entry.step * f >> 9), most = max_at(z + f + 1);
            excess = std::max(excess, value - std::min(value, most));
        }
        entry.value -= excess;
    }
    return table;
}

std::array<TableEntry, root_up_entries> make_root_up() {
    std::array<TableEntry, root_up_entries> table;
    for (std::uint32_t i = 0; i < table.size(); ++i)
        while (table[i].value * table[i].value < (i + 65) << 10) ++table[i].value;
    return table;
}

}   // namespace

const std::array<TableEntry, near_inverse_entries>& near_inverse_table() {
    static const auto table = make_near_inverse();
    return table;
}
const std::array<TableEntry, root_up_entries>& root_up_table() {
    static const auto table = make_root_up();
    return table;
}

}   // namespace rayclock
