// Writes a timeline as a waveform. All values are text, so viewers need no translation tables.
#include <algorithm>
#include <filesystem>
#include <map>

#include <fmt/format.h>

#include "sim/view/timeline/timeline.hpp"
#include "sim/view/wave/fst.hpp"
#include "sim/view/wave/gtkw.hpp"

namespace rayclock {

namespace {

constexpr std::uint64_t cycle_time = 10;

std::string unit_scope(int pipeline) {
    return pipeline < 0 ? "shared" : fmt::format("pipeline_{}", pipeline);
}
std::string context_scope(const TimelineRay& ray) { return fmt::format("context_{}", ray.context); }

/// The signals of one context: its ray, its place, its wait and its pixel.
struct ContextSignals {
    FstWriter::Signal ray = 0, place = 0, waits_for = 0, pixel = 0;
};

class Waves {
public:
    explicit Waves(const Timeline& timeline) : timeline_(timeline) {
        cycle_ = out_.add_bits("cycle", 40);
        declare_units();
        declare_contexts();
    }

    std::string bytes() {
        for (const UnitSpan& span : timeline_.units) {
            const FstWriter::Signal signal = units_.at({span.pipeline, span.unit});
            at(span.first, signal, cause_name(span.unit, span.code));
        }
        for (const TimelineRay& ray : timeline_.rays) show(ray);
        std::uint64_t next = changes_.empty() ? 0 : changes_.begin()->first;
        for (const auto& [cycle, changes] : changes_) {
            for (; next <= cycle; ++next) {
                out_.set_time(next * cycle_time);
                out_.set_value(cycle_, next);
            }
            for (const auto& [signal, text] : changes) out_.set_text(signal, text);
        }
        return out_.finish();
    }

private:
    /// Declares the signals of each pipeline in one scope.
    void declare_units() {
        std::map<int, std::vector<Unit>> by_pipeline;
        for (const UnitSpan& span : timeline_.units) {
            std::vector<Unit>& units = by_pipeline[span.pipeline];
            if (std::find(units.begin(), units.end(), span.unit) == units.end()) units.push_back(span.unit);
        }
        for (auto& [pipeline, units] : by_pipeline) {
            std::sort(units.begin(), units.end());
            out_.open_scope(unit_scope(pipeline));
            for (const Unit unit : units)
                units_[{pipeline, unit}] = out_.add_text(unit_infos[index(unit)].name);
            out_.close_scope();
        }
    }
    void declare_contexts() {
        std::map<int, std::map<std::uint32_t, const TimelineRay*>> by_pipeline;
        for (const TimelineRay& ray : timeline_.rays) by_pipeline[ray.pipeline][ray.context] = &ray;
        for (const auto& [pipeline, contexts] : by_pipeline) {
            out_.open_scope(fmt::format("rays_{}", pipeline));
            for (const auto& [context, ray] : contexts) {
                out_.open_scope(context_scope(*ray));
                ContextSignals& s = contexts_[{pipeline, context}];
                s.pixel = out_.add_text("pixel");
                s.ray = out_.add_text("ray");
                s.place = out_.add_text("place");
                s.waits_for = out_.add_text("waits_for");
                out_.close_scope();
            }
            out_.close_scope();
        }
    }

    void at(std::uint64_t cycle, FstWriter::Signal signal, std::string text) {
        changes_[cycle][signal] = std::move(text);
    }
    /// Marks the end of a value. A value that begins in the same cycle replaces the mark.
    void ends(std::uint64_t cycle, FstWriter::Signal signal) { changes_[cycle].emplace(signal, "-"); }

    void show(const TimelineRay& ray) {
        const ContextSignals& s = contexts_.at({ray.pipeline, ray.context});
        const auto width = std::uint32_t(timeline_.width());
        const std::uint64_t first = ray.stays.front().first, last = ray.stays.back().last;
        at(first, s.pixel, fmt::format("{},{}", ray.pixel % width, ray.pixel / width));
        at(first, s.ray, fmt::format("{} {}", ray.ray, purpose_names[std::size_t(ray.purpose)]));
        for (const TimelineStay& stay : ray.stays) {
            constexpr const char* outcomes[] = {"hit", "miss", "merge"};
            std::string place = place_name(stay.place);
            if (stay.lookup) place += fmt::format(" {}: {}", stay.addr, outcomes[std::size_t(*stay.lookup)]);
            at(stay.first, s.place, std::move(place));
            if (stay.wait_first < stay.last) at(stay.wait_first, s.waits_for, stay.waits_for);
            ends(stay.last, s.waits_for);
        }
        for (const FstWriter::Signal signal : {s.pixel, s.ray, s.place}) ends(last, signal);
    }

    const Timeline& timeline_;
    FstWriter out_;
    FstWriter::Signal cycle_ = 0;
    std::map<std::pair<int, Unit>, FstWriter::Signal> units_;
    std::map<std::pair<int, std::uint32_t>, ContextSignals> contexts_;
    std::map<std::uint64_t, std::map<FstWriter::Signal, std::string>> changes_;
};

}   // namespace

std::string fst(const Timeline& timeline) { return Waves(timeline).bytes(); }

std::string fst_view(const Timeline& timeline, const std::string& path) {
    std::map<int, std::map<std::string, bool>> units, contexts;
    std::uint64_t first = ~0ull;
    for (const UnitSpan& span : timeline.units) {
        units[span.pipeline][unit_infos[index(span.unit)].name] = true;
        first = std::min(first, span.first);
    }
    for (const TimelineRay& ray : timeline.rays) {
        contexts[ray.pipeline][context_scope(ray)] = true;
        first = std::min(first, ray.stays.front().first);
    }
    Gtkw view{std::filesystem::path(path).filename().string(), first * cycle_time, first * cycle_time, {}};
    view.groups.push_back({"time", {{GtkwSignal::As::decimal, ranged("cycle", 40)}}});
    const auto text = [](std::string name) { return GtkwSignal{GtkwSignal::As::text, std::move(name)}; };
    for (const auto& [pipeline, names] : units) {
        GtkwGroup group{pipeline < 0 ? "units that all share" : fmt::format("units of pipeline {}", pipeline),
                        {}};
        for (const auto& [name, ignored] : names)
            group.signals.push_back(text(unit_scope(pipeline) + "." + name));
        view.groups.push_back(std::move(group));
    }
    for (const auto& [pipeline, scopes] : contexts)
        for (const auto& [scope, ignored] : scopes) {
            GtkwGroup group{fmt::format("pipeline {}, {}", pipeline, scope), {}, contexts.size() == 1};
            for (const char* name : {"pixel", "ray", "place", "waits_for"})
                group.signals.push_back(text(fmt::format("rays_{}.{}.{}", pipeline, scope, name)));
            view.groups.push_back(std::move(group));
        }
    return gtkw_text(view);
}

}   // namespace rayclock
