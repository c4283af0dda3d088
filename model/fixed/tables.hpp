#pragma once
// Tables of the functions in this folder, computed in integers only, so that they are the same on every
// machine. They reach the RTL as constants of rc_pkg.sv.
#include <array>

#include "model/base/table_entry.hpp"

namespace rayclock {

constexpr std::size_t root_entries = 384, log_entries = 128, exp_entries = 128;
constexpr int root_value_bits = 19, root_step_bits = 10;   ///< widths in rc_pkg.sv
constexpr int log_value_bits = 18, log_step_bits = 12;
constexpr int exp_value_bits = 18, exp_step_bits = 10;

/// Returns round(2^18 / sqrt(x)), x = 1 + i / 128 from 1 to 4; falling.
const std::array<TableEntry, root_entries>& inverse_root_table();
/// Returns round(2^18 log2(1 + i / 128)); rising.
const std::array<TableEntry, log_entries>& log_table();
/// Returns round(2^17 2^(-i / 128)); falling.
const std::array<TableEntry, exp_entries>& exp_table();

}   // namespace rayclock
