// Draws fronts and columns of a sweep.
#include "sim/explore/sweep/plot.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "sim/explore/sweep/table.hpp"

namespace rayclock::sweep {

namespace {

/// The label and the scale of a measure on an axis.
struct Side {
    std::string label;
    double factor = 1;   ///< multiplies the measure's value
};

Side side_of(const Measure& m, double pixels) {
    if (m.key == "pixels_other_primitive") return {"pixels with another primitive, %", 100 / pixels};
    if (m.key == "fps") return {"frames per second", 1};
    if (m.key == "mrays_per_s") return {"million rays per second", 1};
    if (m.key == "chip_luts") return {"LUTs of the chip", 1};
    if (m.key == "chip_block_rams") return {"block RAMs of the chip", 1};
    if (m.key == "chip_memory_bits") return {"memory on the chip, Mbit", 1e-6};
    if (m.key == "memory_bytes") return {"memory image, MB", 1e-6};
    return {"multipliers, 18x18 bits", 1};
}

/// Returns the title of a drawing. A stream of rays has no size.
std::string title_of(const std::string& scene, FrameSize size, std::size_t points) {
    const std::string traced =
        size.width > 0 ? fmt::format("{}x{} pixels", size.width, size.height) : "a stream of rays";
    return fmt::format("{}, {}, {} configurations", scene, traced, points);
}

std::string label_of(const Result& r) { return fmt::format("{}", fmt::join(r.point.values, " / ")); }

plot::Panel panel_of(const std::vector<Result>& results, const Front& front, std::size_t x, std::size_t y) {
    const Measure &across = front.measures[x], &up = front.measures[y];
    double pixels = 1;
    for (const Result& r : results)
        if (r.complete()) pixels = double(r.picture->error.pixels);
    const Side horizontal = side_of(across, pixels), vertical = side_of(up, pixels);
    std::vector<Figures> figures = figures_in(results, {across, up});
    const std::vector<Figures> all = figures_in(results, front.measures);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (!all[i]) figures[i].reset();   // the point has no hardware
    const std::vector<bool> on = sweep::front(figures);
    plot::Panel panel{"", horizontal.label, vertical.label, y == 0, {}};
    for (std::size_t i = 0; i < results.size(); ++i) {
        const auto a = across.value(results[i]), b = up.value(results[i]);
        if (!a || !b) continue;
        panel.marks.push_back({*a * horizontal.factor, *b * vertical.factor, label_of(results[i]), on[i],
                               front.knee && front.knee->point == i});
    }
    return panel;
}

bool differ(const std::vector<Result>& results, const Measure& m) {
    std::optional<double> first;
    for (const Result& r : results)
        if (const auto v = m.value(r)) {
            if (first && *v != *first) return true;
            first = v;
        }
    return false;
}

}   // namespace

plot::Drawing column_plot(const std::string& scene, FrameSize size, const std::vector<Axis>& axes,
                          const std::vector<Result>& results, const Front& front, const std::string& x,
                          const std::string& y) {
    const std::vector<std::optional<double>> across = column_values(axes, results, front, x),
                                             up = column_values(axes, results, front, y);
    plot::Panel panel{y + " against " + x, x, y, false, {}};
    for (std::size_t i = 0; i < results.size(); ++i)
        if (across[i] && up[i])
            panel.marks.push_back({*across[i], *up[i], label_of(results[i]), false, false});
    std::vector<std::string> keys;
    for (const Axis& axis : axes) keys.push_back(axis.key);
    return plot::chart(title_of(scene, size, results.size()),
                       fmt::format("labels: {}", fmt::join(keys, " / ")), {panel});
}

plot::Drawing front_plot(const std::string& scene, FrameSize size, const std::vector<Axis>& axes,
                         const std::vector<Result>& results, const Front& front) {
    std::vector<std::string> keys;
    for (const Axis& axis : axes) keys.push_back(axis.key);
    std::vector<plot::Panel> panels;
    if (differ(results, front.measures[0])) {
        panels.push_back(panel_of(results, front, 1, 0));
        panels.back().title = "error against cost";
        panels.push_back(panel_of(results, front, 2, 0));
        panels.back().title = "error against speed";
    } else {
        panels.push_back(panel_of(results, front, 1, 2));
        panels.back().title = "speed against cost";
    }
    std::string note = fmt::format("labels: {}; line: the panel's own front", fmt::join(keys, " / "));
    if (front.knee) note += fmt::format("; ring: the knee, {}", name_of(axes, results[front.knee->point]));
    return plot::chart(title_of(scene, size, results.size()), note, panels);
}

}   // namespace rayclock::sweep
