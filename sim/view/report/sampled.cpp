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
    Figures(const Config& config, int khz) : config_(config), hertz_(khz * 1e3) {}

    void add(const char* key, const char* unit, const Figure& figure, Work by = Work::least_cycles) {
        all.push_back({key, unit, [=](const Sampled& s) { return s.total(figure, by); },
                       [=](const FrameResult& f) { return figure(f); }});
    }
    void add_rate(const char* key, const char* unit) {
        const double hertz = hertz_;
        all.push_back({key, unit,
                       [=](const Sampled& s) {
                           const Estimate cycles = s.total(cycles_of);
                           return Estimate{hertz / cycles.value, hertz / cycles.value * cycles.relative()};
                       },
                       [=](const FrameResult& f) { return hertz / double(f.cycles); }});
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
    double hertz_;
};

/// Writes a number with the digits that are useful for its unit.
std::string number(double value, const std::string& unit) {
    if (unit == "share") return fmt::format("{:.2f} %", 100 * value);
    if (unit == "fps") return fmt::format("{:.2f}", value);
    return grouped(std::uint64_t(value + 0.5));
}

}   // namespace

std::vector<SampledFigure> sampled_figures(const Config& config, int khz) {
    Figures figures(config, khz);
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

std::string sampled_table(const Config& config, const std::vector<Sampled>& clocks) {
    std::vector<std::string> head{"sampled, with 95 % interval"};
    for (const Sampled& s : clocks) head.push_back(fmt::format("{:g} MHz", s.khz() / 1e3));
    Table table(head);
    const std::vector<SampledFigure> figures = sampled_figures(config, clocks[0].khz());
    for (std::size_t i = 0; i < figures.size(); ++i) {
        std::vector<std::string> row{figures[i].key};
        bool matters = false;
        for (const Sampled& s : clocks) {
            const SampledFigure figure = sampled_figures(config, s.khz())[i];
            const Estimate e = figure.estimate(s);
            const double cycles = s.total(Figures::cycles_of).value;
            matters = matters || figure.unit != "cycles" || e.value >= 0.0005 * cycles;
            row.push_back(fmt::format("{} +-{}", number(e.value, figure.unit),
                                      figure.unit == "share" ? number(e.half_width, figure.unit)
                                                             : fmt::format("{:.2f} %", 100 * e.relative())));
        }
        if (matters) table.add(std::move(row));
    }
    return table.text();
}

std::string sampled_lines(const sample::Effort& e) {
    const auto percent = [&](std::uint64_t n) { return 100 * double(n) / double(e.pixels); };
    return fmt::format(
        "  sampled: {} of {} parts were measured, {:.1f} % of the pixels; {:.1f} % were replayed with "
        "warm-up; {} single pixels were walked\n"
        "  left out: the picture, its comparison with the reference, the judge and the digest\n",
        e.measured, grouped(e.parts), percent(e.measured_pixels), percent(e.replayed_pixels),
        grouped(e.single_pixels));
}

nlohmann::ordered_json sampling_json(const Config& config, const sample::Ask& ask,
                                     const std::vector<Sampled>& clocks) {
    const sample::Effort& e = clocks[0].effort();
    nlohmann::ordered_json by_clock = nlohmann::ordered_json::array();
    for (const Sampled& s : clocks) {
        nlohmann::ordered_json figures = nlohmann::ordered_json::object();
        for (const SampledFigure& figure : sampled_figures(config, s.khz())) {
            const Estimate estimate = figure.estimate(s);
            figures[figure.key] = {{"estimate", estimate.value}, {"half_width", estimate.half_width}};
        }
        by_clock.push_back({{"mhz", s.khz() / 1e3}, {"figures", figures}});
    }
    std::vector<std::string> exact{"scene", "config", "frame", "camera", "compile"};
    if (!config.has_shade())
        exact.push_back("rays");
    else if (!config.supersampling)
        exact.push_back("rays.primary");
    return {{"confidence", 0.95},
            {"share", ask.share},
            {"seed", ask.seed},
            {"parts", e.parts},
            {"parts_measured", e.measured},
            {"strata", e.strata},
            {"pixels_measured", e.measured_pixels},
            {"pixels_replayed", e.replayed_pixels},
            {"single_pixels", e.single_pixels},
            {"exact", exact},
            {"clocks", by_clock}};
}

}   // namespace rayclock
