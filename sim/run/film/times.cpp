// Parsing of --time, --fps and --frames into the times of frames.
#include <charconv>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/run/film/film.hpp"

namespace rayclock {
namespace {

constexpr double latest = 1e6;

double seconds_of(std::string_view text, const std::string& typed) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !(value >= 0 && value <= latest))
        throw UserError(
            fmt::format("--time: {} is not a time or two with a colon between them, like 1.5 or 0:4, from "
                        "0 to {:.0f} s",
                        shown(typed), latest));
    return value;
}

/// Evenly spaced frames from `begin` to `end`. The end itself is not a frame, so that a periodic motion
/// continues at its beginning.
struct Span {
    double begin = 0, end = 0;
    bool has_end = false;
};
Span span_of(const std::string& typed) {
    Span span;
    if (typed.empty()) return span;
    const std::size_t colon = typed.find(':');
    span.begin = seconds_of(typed.substr(0, colon), typed);
    span.has_end = colon != typed.npos;
    if (!span.has_end) return span;
    span.end = seconds_of(typed.substr(colon + 1), typed);
    if (!(span.end > span.begin))
        throw UserError(fmt::format("--time: {} ends before it begins, or has the length 0", shown(typed)));
    return span;
}

int count_of(const FramesOptions& o, const Span& span, double fps) {
    if (!span.has_end || o.frames > 1) return o.frames;
    const double count = std::round((span.end - span.begin) * fps);
    if (count > max_frames)
        throw UserError(fmt::format("--time {} at {} frames a second would be {:.0f} frames; the most is {}",
                                    o.time, fps, count, max_frames));
    return std::max(1, int(count));
}

}   // namespace

FrameTimes frame_times(const FramesOptions& o, bool moves) {
    if (o.frames < 1 || o.frames > max_frames)
        throw UserError(fmt::format("--frames must lie in 1..{}, not {}", max_frames, o.frames));
    if (!(std::abs(o.pan) <= 360))
        throw UserError(fmt::format("--pan must lie in -360..360 degrees, not {}", o.pan));
    if (o.fps && !(*o.fps >= 0.001 && *o.fps <= 10'000))
        throw UserError(fmt::format("--fps must lie in 0.001..10000, not {}", *o.fps));
    const Span span = span_of(o.time);
    if (span.has_end && o.frames > 1 && o.fps)
        throw UserError(
            "--time with two times, --frames and --fps say the same twice: leave one of them out");
    FrameTimes out;
    out.is_given = o.fps || !o.time.empty();
    out.fps = o.fps.value_or(usual_fps);
    const int count = count_of(o, span, out.fps);
    if (span.has_end && o.frames > 1) out.fps = o.frames / (span.end - span.begin);
    for (int i = 0; i < count; ++i) out.times.push_back(span.begin + i / out.fps);
    if (!moves && out.is_given)
        std::fprintf(stderr,
                     "rayclock: note: nothing moves in this scene: --time and --fps have no effect\n");
    if (o.pan != 0 && count == 1)
        std::fprintf(stderr, "rayclock: note: --pan has no effect with --frames 1\n");
    return out;
}

}   // namespace rayclock
