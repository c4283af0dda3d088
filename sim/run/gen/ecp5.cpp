// The commands for Yosys.
#include "sim/run/gen/ecp5.hpp"

#include <fmt/format.h>

namespace rayclock {

namespace {
constexpr int fewest_reset = 16;   // least number of flip-flops in a unit that share a reset
}

std::string ecp5_steps(const std::string& until) {
    // These are the types of flip-flops that synth_ecp5 itself legalises in its next step.
    return fmt::format(
        "synth_ecp5 -nowidelut -run :map_ffs\nopt_clean\n"
        "dfflegalize -minsrst {} -cell $_DFF_?_ 01 -cell $_DFF_?P?_ r -cell $_SDFF_?P?_ r -cell $_DFFE_??_ "
        "01 "
        "-cell $_DFFE_?P??_ r -cell $_SDFFE_?P??_ r -cell $_DLATCH_?_ x\n"
        "opt_merge\nopt_clean\n"
        "synth_ecp5 -nowidelut -run map_ffs:{}\n",
        fewest_reset, until);
}

}   // namespace rayclock
