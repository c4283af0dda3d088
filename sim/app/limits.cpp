#include "sim/app/limits.hpp"

#include <fmt/format.h>

namespace rayclock {

namespace {

double other_percent(const FrameError& error) { return error.pixels == 0 ? 0 : 100.0 * double(error.pixels_other_primitive) / double(error.pixels); }

} // namespace

Limits limits_of(const Options& o) {
    check_psnr(o);
    Limits limits;
    if (o.max_other) limits.max_other = parse_percent("--max-other", *o.max_other, true);
    if (o.min_psnr) limits.min_psnr = *o.min_psnr;
    limits.fails = o.max_other || o.min_psnr;
    return limits;
}

std::string beyond_limits(const Limits& limits, const FrameError& error) {
    std::string text;
    if (other_percent(error) > limits.max_other)
        text += fmt::format("  FAR FROM THE REFERENCE: {:.3g} % of the pixels hold another primitive, and {:g} % is the limit (--max-other)\n",
                            other_percent(error), limits.max_other);
    if (error.psnr_db < limits.min_psnr)
        text += fmt::format("  FAR FROM THE REFERENCE: PSNR {:.1f} dB, and {:g} dB is the limit (--min-psnr)\n", error.psnr_db, limits.min_psnr);
    return text;
}

nlohmann::ordered_json limits_json(const Limits& limits, const FrameError& error) {
    return {{"max_other_percent", limits.max_other}, {"min_psnr_db", limits.min_psnr}, {"fails", limits.fails},
            {"beyond_other", other_percent(error) > limits.max_other}, {"beyond_psnr", error.psnr_db < limits.min_psnr}};
}

} // namespace rayclock
