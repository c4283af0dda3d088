// Compares errors with the limits and words the sentence for frames beyond them.
#include "sim/view/report/limits.hpp"

#include <algorithm>

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

std::string far_from_reference(const Limits& limits, const std::vector<NamedError>& errors, std::size_t all,
                               const char* what) {
    std::size_t far = 0;
    const NamedError* farthest = nullptr;
    for (const NamedError& e : errors) {
        if (far_from_reference(limits, e.error).empty()) continue;
        ++far;
        if (!farthest || e.error.psnr_db < farthest->error.psnr_db) farthest = &e;
    }
    if (!farthest) return {};
    return fmt::format("{} ({}; {} of {} {} are far)", far_from_reference(limits, farthest->error),
                       farthest->name, far, all, what);
}

std::string far_frames(const Limits& limits, const std::vector<FrameError>& frames) {
    if (frames.size() == 1) return far_from_reference(limits, frames[0]);
    std::vector<NamedError> named;
    for (std::size_t f = 0; f < frames.size(); ++f)
        named.push_back({fmt::format("frame {}", f + 1), frames[f]});
    return far_from_reference(limits, named, frames.size(), "frames");
}

ordered_json limit_values_json(const Limits& limits) {
    return {{"max_other_percent", limits.max_other},
            {"min_psnr_db", limits.min_psnr},
            {"max_depth_error_percent", limits.max_depth_error}};
}

ordered_json limits_json(const Limits& limits, const std::vector<FrameError>& frames) {
    if (frames.empty()) return nullptr;
    const auto any = [&](bool (*is_beyond)(const Limits&, const FrameError&)) {
        return std::any_of(frames.begin(), frames.end(),
                           [&](const FrameError& error) { return is_beyond(limits, error); });
    };
    const std::string sentence = far_frames(limits, frames);
    ordered_json json = limit_values_json(limits);
    json["beyond_other"] = any(is_beyond_other);
    json["beyond_psnr"] = any(is_beyond_psnr);
    json["beyond_depth"] = any(is_beyond_depth);
    json["far"] = !sentence.empty();
    json["sentence"] = sentence.empty() ? ordered_json(nullptr) : ordered_json(sentence);
    return json;
}

}   // namespace rayclock
