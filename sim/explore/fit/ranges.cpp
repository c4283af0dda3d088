// Combines the range proofs of the units.
#include "sim/explore/fit/ranges.hpp"

namespace rayclock::fit {

Ranges prove_ranges(const MemoryImage& image, const Frame& frame, const Config& config) {
    const Extremes e = extremes(image, frame, config);
    Ranges ranges;
    raygen_ranges(e, frame, config, ranges.signals);
    box_ranges(e, config, ranges.signals);
    tri_ranges(e, config, ranges.signals);
    walk_ranges(e, image.report, config, ranges.signals);
    return ranges;
}

bool Ranges::proven() const {
    return std::all_of(signals.begin(), signals.end(),
                       [](const Signal& s) { return s.fits() || s.excess != Excess::never; });
}

std::vector<RecipClass> recip_classes(const Interval& direction, const Config& config) {
    std::vector<RecipClass> classes;
    const int m = config.dir_bits;
    if (direction.holds(0)) classes.push_back({false, 0, point(0), point(0), point(1)});
    for (const bool negative : {false, true}) {
        const Interval size = negative ? -direction : direction;
        for (int len = 1; len <= m; ++len) {
            const Interval part = meet(size, {Int128(1) << (len - 1), (Int128(1) << len) - 1});
            if (part.empty()) continue;
            const Interval aligned = left(part, m - len);
            const Int128 power = Int128(1) << (m + config.recip_bits - 1);
            classes.push_back({negative, len, part, aligned, {power / aligned.hi, power / aligned.lo}});
        }
    }
    return classes;
}

void raygen_ranges(const Extremes& e, const Frame& frame, const Config& c, std::vector<Signal>& out) {
    const auto all = [](const Extremes::Axes& axes) { return hull(hull(axes[0], axes[1]), axes[2]); };
    const auto add = [&](const char* name, const Interval& range, bool is_signed, int there,
                         Excess excess = Excess::never) {
        out.push_back({"raygen", name, range, is_signed, there, excess});
    };
    const int g = c.guard_dir_bits();
    add("frame.width", point(frame.width), false, c.pixel_bits + 1);
    add("frame.height", point(frame.height), false, c.pixel_bits + 1);
    add("x", {0, Int128(frame.width) - 1}, false, c.pixel_bits);
    add("y", {0, Int128(frame.height) - 1}, false, c.pixel_bits);
    add("eye", all(e.eye), true, c.coord_bits);
    add("corner", all(e.corner), true, g);
    add("right", all(e.right), true, g);
    add("down", all(e.down), true, g);
    add("s1_right", e.right_x, true, g, Excess::wraps);
    add("s1_down", e.down_y, true, g, Excess::wraps);
    add("s1_sum", all(e.sum), true, g);
    add("d", all(e.direction), true, c.dir_bits);
    Interval size, len, aligned, recip;
    for (const Interval& axis : e.direction)
        for (const RecipClass& r : recip_classes(axis, c)) {
            size = hull(size, r.size);
            len = hull(len, point(r.len));
            aligned = hull(aligned, r.aligned);
            recip = hull(recip, r.recip);
        }
    add("s0_mag", size, false, c.dir_bits);
    add("s0_m", aligned, false, c.dir_bits);
    add("recip", recip, false, c.recip_bits + 1);
    add("len", len, false, exp_bits);
}

}   // namespace rayclock::fit
