#include "sim/report/limits.hpp"

#include <fmt/format.h>

namespace rayclock {

namespace {

double other_percent(const FrameError& error) {
    return error.pixels == 0 ? 0 : 100.0 * double(error.pixels_other_primitive) / double(error.pixels);
}

}   // namespace

std::string beyond_limits(const Limits& limits, const FrameError& error) {
    std::string text;
    if (other_percent(error) > limits.max_other)
        text += fmt::format(
            "  FAR FROM THE REFERENCE: {:.3g} % of the pixels hold another primitive, and {:g} % is the "
            "limit (--max-other)\n",
            other_percent(error), limits.max_other);
    if (error.psnr_db < limits.min_psnr)
        text +=
            fmt::format("  FAR FROM THE REFERENCE: PSNR {:.1f} dB, and {:g} dB is the limit (--min-psnr)\n",
                        error.psnr_db, limits.min_psnr);
    return text;
}

nlohmann::ordered_json limits_json(const Limits& limits, const FrameError& error) {
    return {{"max_other_percent", limits.max_other},
            {"min_psnr_db", limits.min_psnr},
            {"fails", limits.fails},
            {"beyond_other", other_percent(error) > limits.max_other},
            {"beyond_psnr", error.psnr_db < limits.min_psnr}};
}

}   // namespace rayclock
