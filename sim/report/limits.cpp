#include "sim/report/limits.hpp"

#include <vector>

#include <fmt/format.h>

namespace rayclock {

using nlohmann::ordered_json;

namespace {

double other_percent(const FrameError& error) {
    return error.pixels == 0 ? 0 : 100.0 * double(error.pixels_other_primitive) / double(error.pixels);
}
double depth_percent(const FrameError& error) { return 100 * error.max_relative_depth; }

bool is_beyond_other(const Limits& limits, const FrameError& error) {
    return other_percent(error) > limits.max_other;
}
bool is_beyond_psnr(const Limits& limits, const FrameError& error) { return error.psnr_db < limits.min_psnr; }
bool is_beyond_depth(const Limits& limits, const FrameError& error) {
    return depth_percent(error) > limits.max_depth_error;
}

}   // namespace

std::string far_from_reference(const Limits& limits, const FrameError& error) {
    std::vector<std::string> beyond;
    if (is_beyond_other(limits, error))
        beyond.push_back(
            fmt::format("{:.3g} % of the pixels hold another primitive (limit {:g} %, --max-other)",
                        other_percent(error), limits.max_other));
    if (is_beyond_psnr(limits, error))
        beyond.push_back(
            fmt::format("PSNR {:.1f} dB (limit {:g} dB, --min-psnr)", error.psnr_db, limits.min_psnr));
    if (is_beyond_depth(limits, error))
        beyond.push_back(fmt::format("a pixel's depth is off by {:.3g} % (limit {:g} %, --max-depth-error)",
                                     depth_percent(error), limits.max_depth_error));
    return beyond.empty() ? "" : fmt::format("FAR FROM THE REFERENCE: {}", fmt::join(beyond, "; "));
}

ordered_json limit_values_json(const Limits& limits) {
    return {{"max_other_percent", limits.max_other},
            {"min_psnr_db", limits.min_psnr},
            {"max_depth_error_percent", limits.max_depth_error}};
}

ordered_json limits_json(const Limits& limits, const std::optional<FrameError>& error) {
    if (!error) return nullptr;
    const std::string sentence = far_from_reference(limits, *error);
    ordered_json json = limit_values_json(limits);
    json["beyond_other"] = is_beyond_other(limits, *error);
    json["beyond_psnr"] = is_beyond_psnr(limits, *error);
    json["beyond_depth"] = is_beyond_depth(limits, *error);
    json["far"] = !sentence.empty();
    json["sentence"] = sentence.empty() ? ordered_json(nullptr) : ordered_json(sentence);
    return json;
}

}   // namespace rayclock
