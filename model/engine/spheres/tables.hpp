#pragma once
// Tables of the unit globe, computed in integers only. They reach the RTL as constants of rc_pkg.sv.
#include <array>

#include "model/base/table_entry.hpp"

namespace rayclock {

constexpr std::size_t near_inverse_entries = 128, root_up_entries = 192;
constexpr int near_inverse_bits = 17, near_inverse_step_bits = 10;   ///< widths in rc_pkg.sv
constexpr int root_up_bits = 10;

/// 2^17 / z from below, z = 1 + i / 128 from 1 to 2. With a fraction f of 9 bits, value - floor(step f / 2^9)
/// is at most 2^17 (1 - 2^-16) / z for every z below 1 + i / 128 + (f + 1) / 2^16.
const std::array<TableEntry, near_inverse_entries>& near_inverse_table();
/// 2^8 sqrt(y) from above, for every y up to (i + 1) / 64, i from 64 to 255, at entry i - 64. Steps are
/// unused.
const std::array<TableEntry, root_up_entries>& root_up_table();

}   // namespace rayclock
