#pragma once
// Phong's highlight: powers in fixed point. Mirror of rtl/fixed/rc_power.sv.
#include <cstdint>

namespace rayclock {

/// Returns c^(n / 16). c is 0..2^16 with unit_bits fraction bits. n has shine_bits, shine_frac of them
/// fraction. The result is 0..2^16. c = 0 gives 0, also for n = 0; any other c gives 1 for n = 0.
///
/// Logarithm and power are tables of 128 entries with linear interpolation. -log2(c) errs by -0.5..4 units of
/// 2^-18. So for the true value p the result lies between (1 - 1.1e-2 n / 2^14) p - 2^-16 and (1 + 1.4e-3 n /
/// 2^14) p + 2 * 2^-16. Near c = 1, where large n matter, the logarithm errs by half of that, so the loss
/// never exceeds 2^-8 (tests/unit/fixed/power_test.cpp).
std::uint32_t power(std::uint32_t c, std::uint32_t n);

}   // namespace rayclock
