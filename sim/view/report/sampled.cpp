// The figures of a sampled frame.
#include "sim/view/report/sampled.hpp"

#include <fmt/format.h>

#include "sim/files/table.hpp"
#include "sim/view/report/accounts.hpp"

namespace rayclock {

namespace {

using sample::Estimate;
using sample::Figure;
using sample::Sampled;
using sample::Work;

class Figures {
public:
    Figures(const Config& config, int khz, std::uint64_t waits)
        : config_(config), hertz_(khz * 1e3), waits_(double(waits)) {}

    void add(const char* key, const char* unit, const Figure& figure, Work by = Work::expected_cycles) {
        all.push_back({key, unit, [=](const Sampled& s) { return s.total(figure, by); },
                       [=](const FrameResult& f) { return figure(f); }});
    }
    void add_rate(const char* key, const char* unit) {
        const double hertz = hertz_, waits = waits_;
        all.push_back({key, unit,
                       [=](const Sampled& s) {
                           const Estimate cycles = s.total(cycles_of);
                           const double all = cycles.value + waits, fps = hertz / all;
                           Estimate rate = cycles.times(fps / all);   // the derivative of the rate
                           rate.value = fps;
                           return rate;
                       },
                       [=](const FrameResult& f) { return hertz / double(f.all_cycles()); }});
    }
    void add_work(const char* key, const char* unit, Work kind,
                  const std::function<std::uint64_t(const FrameResult&)>& exact) {
        all.push_back({key, unit, [=](const Sampled& s) { return s.work(kind); },
                       [=](const FrameResult& f) { return double(exact(f)); }});
    }
    void add_hit_rate(const char* key, Unit cache) {
        const auto outcomes = [=](const FrameTiming& t, std::size_t count) {
            double sum = 0;   // hit, miss, merge: see CacheOutcome
            for (std::size_t c = 0; c < count; ++c) sum += double(t.accounts.units[index(cache)][c]);
            return sum;
        };
        all.push_back({key, "share",
                       [=](const Sampled& s) {
                           return s.ratio([=](const FrameTiming& t) { return outcomes(t, 1); },
                                          [=](const FrameTiming& t) { return outcomes(t, 3); },
                                          sample::work_of(cache));
                       },
                       [=](const FrameResult& f) { return cache_account(f, cache).hit_rate(); }});
    }
    void add_account(Unit unit) {
        const UnitInfo& info = unit_infos[index(unit)];
        for (std::size_t c = 0; c < cause_count; ++c) {
            const Cause& cause = info.causes[c];
            if (cause.kind == CauseKind::none) continue;
            const char* group = cause.kind == CauseKind::busy      ? "busy_with"
                                : cause.kind == CauseKind::starved ? "starved_by"
                                                                   : "stalled";
            all.push_back(
                {fmt::format("units.{}.{}.{}", info.name, group, cause.name), "cycles",
                 [unit, c, config = config_](const Sampled& s) { return s.account(config, unit, c); },
                 [=](const FrameResult& f) { return double(f.accounts.units[index(unit)][c]); }});
        }
    }
    static double cycles_of(const FrameTiming& t) { return double(t.cycles); }

    std::vector<SampledFigure> all;

private:
    const Config& config_;
    double hertz_, waits_;
};

/// Writes a number with the digits that are useful for its unit.
std::string number(double value, const std::string& unit) {
    if (unit == "share") return fmt::format("{:.2f} %", 100 * value);
    if (unit == "fps") return fmt::format("{:.2f}", value);
    return grouped(std::uint64_t(value + 0.5));
}
std::string with_interval(const Estimate& e, const std::string& unit) {
    return fmt::format(
        "{} +-{}", number(e.value, unit),
        unit == "share" ? number(e.half_width, unit) : fmt::format("{:.2f} %", 100 * e.relative()));
}

bool is_additive(const SampledFigure& figure) { return figure.unit != "share" && figure.unit != "fps"; }

/// Returns the mean of a figure over the frames of a film.
Estimate mean_of(const std::vector<SampledFrame>& frames, std::size_t clock, std::size_t figure) {
    std::vector<Estimate> all;
    for (const SampledFrame& frame : frames) all.push_back(frame.estimates[clock][figure]);
    return sample::mean(all);
}

}   // namespace

std::vector<SampledFigure> sampled_figures(const Config& config, int khz, std::uint64_t waits) {
    Figures figures(config, khz, waits);
    figures.add("cycles", "cycles", Figures::cycles_of);
    figures.add_rate("fps", "fps");
    if (config.supersampling)
        figures.add_work("rays.primary", "rays", Work::primary, [](const auto& f) { return f.rays.primary; });
    if (config.has_shade()) {
        figures.add_work("rays.shadow", "rays", Work::shadow, [](const auto& f) { return f.rays.shadow; });
        figures.add_work("rays.reflection", "rays", Work::reflection,
                         [](const auto& f) { return f.rays.reflection; });
        figures.add_work("rays.refraction", "rays", Work::refraction,
                         [](const auto& f) { return f.rays.refraction; });
    }
    figures.add_work("work.node_steps", "visits", Work::visits, [](const auto& f) { return f.visits; });
    figures.add_work("work.box_tests", "tests", Work::box_tests, [](const auto& f) { return f.box_tests; });
    figures.add_work("work.triangle_tests", "tests", Work::triangle_tests,
                     [](const auto& f) { return f.triangle_tests; });
    figures.add("dram_bytes", "bytes", [](const FrameTiming& t) { return 64 * double(t.memory.reads); });
    if (!config.is_list()) figures.add_hit_rate("node_hit_rate", Unit::node_cache);
    figures.add_hit_rate("prim_hit_rate", Unit::prim_cache);
    if (config.has_shade()) figures.add_hit_rate("surf_hit_rate", Unit::surf_cache);
    if (config.has_textures()) figures.add_hit_rate("tex_hit_rate", Unit::tex_cache);
    if (config.l2_sets > 0) figures.add_hit_rate("l2_hit_rate", Unit::l2);
    for (std::size_t u = 0; u < unit_count; ++u)
        if (is_there(Unit(u), config)) figures.add_account(Unit(u));
    return std::move(figures.all);
}

double widest_of(const SampledFrame& frame) {
    double widest = 0;
    for (const std::vector<Estimate>& clock : frame.estimates) widest = std::max(widest, clock[0].relative());
    return widest;
}

std::string sampled_table(const Config& config, const std::vector<int>& khz,
                          const std::vector<SampledFrame>& frames) {
    std::vector<std::string> head{
        fmt::format("sampled{}, with 95 % interval", frames.size() > 1 ? ", mean of all frames" : "")};
    for (const int k : khz) head.push_back(fmt::format("{:g} MHz", k / 1e3));
    Table table(head);
    const std::vector<SampledFigure> figures = sampled_figures(config, khz[0]);
    for (std::size_t i = 0; i < figures.size(); ++i) {
        std::vector<std::string> row{figures[i].key};
        bool matters = false;
        for (std::size_t k = 0; k < khz.size(); ++k) {
            const Estimate e = mean_of(frames, k, i);
            matters =
                matters || figures[i].unit != "cycles" || e.value >= 0.0005 * mean_of(frames, k, 0).value;
            row.push_back(with_interval(e, figures[i].unit));
        }
        if (matters) table.add(std::move(row));
    }
    return table.text();
}

std::string sampled_film_table(const Config& config, const std::vector<int>& khz,
                               const std::vector<SampledFrame>& frames) {
    if (frames.size() == 1) return {};
    std::vector<std::string> head{"frame", "time s", "seed"}, mean{"mean", "", ""}, sum{"sum", "", ""};
    std::vector<std::pair<std::size_t, std::string>> columns;   // figure and its unit
    const std::vector<SampledFigure> figures = sampled_figures(config, khz[0]);
    for (std::size_t i = 0; i < figures.size(); ++i) {
        const SampledFigure& figure = figures[i];
        if (figure.key.starts_with("units.") || figure.key.starts_with("work.")) continue;
        columns.emplace_back(i, figure.unit);
        head.push_back(figure.key);
        const Estimate e = mean_of(frames, 0, i);
        mean.push_back(with_interval(e, figure.unit));
        sum.push_back(is_additive(figure) ? with_interval(e.times(double(frames.size())), figure.unit) : "");
    }
    Table table(head);
    for (std::size_t f = 0; f < frames.size(); ++f) {
        std::vector<std::string> row{std::to_string(f + 1), fmt::format("{:.3f}", frames[f].time),
                                     std::to_string(frames[f].ask.seed)};
        for (const auto& [i, unit] : columns) row.push_back(with_interval(frames[f].estimates[0][i], unit));
        table.add(row);
    }
    table.add(mean);
    table.add(sum);
    return fmt::format("\n  sampled frames at {:g} MHz, with 95 % intervals\n{}", khz[0] / 1e3, table.text());
}

namespace {

sample::Effort sum_of(const std::vector<SampledFrame>& frames) {
    sample::Effort sum;
    for (const SampledFrame& frame : frames) sum += frame.effort;
    return sum;
}

}   // namespace

std::string sampled_lines(const std::vector<SampledFrame>& frames) {
    const sample::Effort e = sum_of(frames);
    const auto percent = [&](std::uint64_t n) { return 100 * double(n) / double(e.pixels); };
    return fmt::format(
        "  sampled: {} of {} parts were measured, {:.1f} % of the pixels; {:.1f} % were replayed with "
        "warm-up; {} single pixels were walked\n"
        "  left out: the picture, its comparison with the reference, the judge and the digest\n",
        grouped(e.measured), grouped(e.parts), percent(e.measured_pixels), percent(e.replayed_pixels),
        grouped(e.single_pixels));
}

nlohmann::ordered_json sampling_json(const Config& config, const std::vector<int>& khz,
                                     const std::vector<SampledFrame>& frames, bool moves) {
    using nlohmann::ordered_json;
    const sample::Effort e = sum_of(frames);
    const std::vector<SampledFigure> figures = sampled_figures(config, khz[0]);
    const auto clocks_json = [&](const auto& figure_json) {
        ordered_json clocks = ordered_json::array();
        for (std::size_t k = 0; k < khz.size(); ++k) {
            ordered_json all = ordered_json::object();
            for (std::size_t i = 0; i < figures.size(); ++i) all[figures[i].key] = figure_json(k, i);
            clocks.push_back({{"mhz", khz[k] / 1e3}, {"figures", all}});
        }
        return clocks;
    };
    const auto frame_json = [&](const SampledFrame& frame) {
        return clocks_json([&](std::size_t k, std::size_t i) -> ordered_json {
            const Estimate& one = frame.estimates[k][i];
            return {{"estimate", one.value}, {"half_width", one.half_width}};
        });
    };
    ordered_json each = nullptr, film = nullptr;
    if (frames.size() > 1) {
        each = ordered_json::array();
        for (const SampledFrame& frame : frames)
            each.push_back({{"time", frame.time},
                            {"share", frame.ask.share},
                            {"seed", frame.ask.seed},
                            {"clocks", frame_json(frame)}});
        film = clocks_json([&](std::size_t k, std::size_t i) {
            const Estimate mean = mean_of(frames, k, i), sum = mean.times(double(frames.size()));
            ordered_json figure{{"mean", mean.value}, {"mean_half_width", mean.half_width}};
            if (is_additive(figures[i])) {
                figure["sum"] = sum.value;
                figure["sum_half_width"] = sum.half_width;
            }
            return figure;
        });
    }
    std::vector<std::string> exact{"scene", "config", "frame", "camera", "compile"};
    if (!config.has_shade())
        exact.push_back("rays");
    else if (!config.supersampling)
        exact.push_back("rays.primary");
    if (moves)
        for (const char* key : {"clocks[].frames[].reset_cycles", "clocks[].frames[].bytes_written",
                                "film.clocks[].frames[].time", "film.clocks[].frames[].reset_cycles",
                                "film.clocks[].frames[].bytes_written", "film.clocks[].frames[].host_*"})
            exact.emplace_back(key);
    return {{"confidence", 0.95},
            {"share", frames.back().ask.share},
            {"seed", frames.front().ask.seed},
            {"parts", e.parts},
            {"parts_measured", e.measured},
            {"strata", e.strata},
            {"pixels_measured", e.measured_pixels},
            {"pixels_replayed", e.replayed_pixels},
            {"single_pixels", e.single_pixels},
            {"exact", exact},
            {"clocks", frame_json(frames.back())},
            {"frames", each},
            {"film", film}};
}

}   // namespace rayclock
