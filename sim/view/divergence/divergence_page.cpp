// Formats a divergence as an HTML page.
#include "sim/view/divergence/divergence_page.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "sim/view/divergence/cone.hpp"
#include "sim/view/divergence/fields.hpp"
#include "sim/view/divergence/waveform.hpp"
#include "sim/view/observe/replay.hpp"
#include "sim/view/observe/story.hpp"
#include "sim/view/page/html.hpp"

namespace rayclock {

using html::escaped;

namespace {

constexpr const char* head = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>First divergence</title><style>
body { margin: 0 auto; max-width: 1180px; padding: 0 24px 64px; color: #1c2430;
  font: 15px/1.5 system-ui, "DejaVu Sans", sans-serif; }
h1 { font-size: 26px; margin: 28px 0 4px; } h2 { font-size: 19px; margin: 32px 0 8px; }
table { border-collapse: collapse; font-size: 13px; font-variant-numeric: tabular-nums; }
th, td { padding: 3px 8px; border: 1px solid #d9dee5; text-align: right; white-space: nowrap; }
.word, tbody th { text-align: left; } .wide { overflow-x: auto; } .here { background: #eef3fa; }
.differs { background: #ffd9cc; font-weight: 600; } .quiet { color: #5d6875; } code { font-size: 13px; }
dt { color: #5d6875; } dd { margin: 0 0 6px 0; font-weight: 600; }
</style></head><body>
)";

/// The cycles around the divergence, in columns.
class LinkTable {
public:
    LinkTable(const DivergedRun& d, const Capture& capture) : capture_(capture), cycle_(d.first.cycle) {
        constexpr std::uint64_t before = 8, after = 6;
        first_ = std::max(capture.first, cycle_ - std::min(cycle_, before));
        last_ = std::min(capture.first + capture.cycles.size(), cycle_ + after);
        for (std::size_t i = 0; i < capture.links.size(); ++i)
            if (capture.links[i].link == d.first.on &&
                (capture.links[i].pipeline == d.first.pipeline || index(*d.first.on) >= pipeline_links))
                link_ = i;
    }

    std::string text(const Config& config) {
        text_ = "<div class=\"wide\"><table><thead><tr><th class=\"word\">cycle</th>";
        for (std::uint64_t c = first_; c < last_; ++c)
            text_ += fmt::format("<th{}>{}</th>", c == cycle_ ? " class=\"here\"" : "", c);
        text_ += "</tr></thead><tbody>\n";
        rows(
            "offered", [](const LinkCycle& c) { return std::string(c.model_valid ? "yes" : "·"); },
            [](const LinkCycle& c) { return std::string(c.rtl_valid ? "yes" : "·"); });
        rows(
            "transfer", [](const LinkCycle& c) { return std::string(c.model_fires ? "yes" : "·"); },
            [](const LinkCycle& c) { return std::string(c.rtl_fires ? "yes" : "·"); });
        for (const PayloadField& field : payload_fields(capture_.links[link_].link, config))
            rows(
                field.name,
                [&](const LinkCycle& c) { return c.model_fires ? field_text(field, c.model) : "·"; },
                [&](const LinkCycle& c) { return c.rtl_fires ? field_text(field, c.rtl) : "·"; });
        return text_ + "</tbody></table></div>\n";
    }

private:
    template <class Model, class Rtl> void rows(const std::string& name, Model model, Rtl rtl) {
        const auto row = [&](const char* who, auto value) {
            text_ += fmt::format("<tr><th>{} <span class=\"quiet\">{}</span></th>", escaped(name), who);
            for (std::uint64_t c = first_; c < last_; ++c) {
                const LinkCycle& state = capture_.cycles[c - capture_.first][link_];
                const char* mark = model(state) != rtl(state) ? " class=\"differs\""
                                   : c == cycle_              ? " class=\"here\""
                                                              : "";
                text_ += fmt::format("<td{}>{}</td>", mark, escaped(value(state)));
            }
            text_ += "</tr>\n";
        };
        row("model", model);
        row("RTL", rtl);
    }

    const Capture& capture_;
    std::uint64_t cycle_, first_ = 0, last_ = 0;
    std::size_t link_ = 0;
    std::string text_;
};

/// Keeps the steps of one pixel up to a cycle of the frame.
class StepsUntil final : public EventSink {
public:
    StepsUntil(std::uint32_t pixel, std::uint64_t last) : pixel_(pixel), last_(last) {}
    bool wants(std::uint32_t pixel) override { return pixel == pixel_; }
    void event(const RayEvent& event) override {
        if (event.cycle <= last_) events.push_back(event);
    }
    bool done() const override { return now_ > last_; }
    void cycle_done(std::uint64_t cycle, const Machine&) override { now_ = cycle; }
    std::vector<RayEvent> events;

private:
    std::uint32_t pixel_;
    std::uint64_t last_, now_ = 0;
};

/// What the pixel's rays did in the model until the divergence.
std::string story(const DivergedRun& d) {
    const std::uint64_t before = d.first.frame_begins;
    const std::uint32_t width = d.job.frame.width;
    StepsUntil steps(d.first.y * width + d.first.x, d.first.cycle - before);
    observe(d.job.config, d.job.khz, std::span(d.frames).first(d.first.frame + 1), d.disturbance, 0, &steps);
    if (steps.events.empty()) return "<p>No ray of this pixel had begun.</p>\n";
    constexpr const char* outcomes[] = {"hit", "miss", "merge"};
    std::vector<std::vector<std::string>> rows;
    for (const RayEvent& event : steps.events) {
        const LinkInfo& info = link_infos[index(event.link)];
        const bool looked = event.type == RayEvent::Type::lookup;
        rows.push_back({fmt::format("{}", before + event.cycle), fmt::format("{}", event.ray),
                        purpose_names[std::size_t(event.purpose)],
                        looked ? fmt::format("{} looks up line {}: {}", info.to, event.addr,
                                             outcomes[std::size_t(event.outcome)])
                               : fmt::format("{} from {} to {}", info.name, info.from, info.to)});
    }
    constexpr std::size_t most = 200;
    std::string text;
    if (rows.size() > most) {
        text = fmt::format("<p class=\"quiet\">The last {} of {} steps.</p>\n", most, rows.size());
        rows.erase(rows.begin(), rows.end() - most);
    }
    for (std::vector<std::string>& row : rows) std::rotate(row.begin(), row.begin() + 2, row.end());
    return text + html::table("", {"kind", "what it did", "cycle", "ray"}, rows, 2);
}

/// The unit's signals in the cycles around the divergence.
std::string signal_table(const Divergence& f, const Capture& capture, const std::string& rtl_wave) {
    constexpr std::uint64_t before = 8, after = 3;
    constexpr std::size_t longest = 24;
    const std::uint64_t first = std::max(capture.first, f.cycle - std::min(f.cycle, before)),
                        last = std::min(capture.first + capture.cycles.size(), f.cycle + after);
    const std::string unit = f.unit.substr(0, f.unit.find('['));
    const std::vector<UnitSignal> signals = unit_signals(rtl_wave, unit, f.pipeline, first, last);
    if (signals.empty()) return {};
    std::string text = fmt::format(
        "<h2>Signals of the RTL's {}</h2>\n<p class=\"quiet\">Those that change in these "
        "cycles, in hexadecimal; long ones are cut at the left.</p>\n<div class=\"wide\">"
        "<table><thead><tr><th class=\"word\">cycle</th>",
        escaped(unit));
    for (std::uint64_t c = first; c < last; ++c)
        text += fmt::format("<th{}>{}</th>", c == f.cycle ? " class=\"here\"" : "", c);
    text += "</tr></thead><tbody>\n";
    for (const UnitSignal& signal : signals) {
        text += "<tr><th>" + escaped(signal.name) + "</th>";
        for (std::uint64_t c = first; c < last; ++c) {
            const std::string& value = signal.values[c - first];
            const bool cut = value.size() > longest;
            text += fmt::format("<td{}>{}{}</td>", c == f.cycle ? " class=\"here\"" : "", cut ? "…" : "",
                                cut ? value.substr(value.size() - longest) : value);
        }
        text += "</tr>\n";
    }
    return text + "</tbody></table></div>\n";
}

/// Where the value that differs is made, and the first register that holds it.
std::string cone_lines(const std::vector<ConeStep>& steps) {
    if (steps.empty()) return {};
    const auto place = [](const SourceLine& source) {
        return fmt::format("rtl/{}:{} <code>{}</code>", escaped(source.file), source.line,
                           escaped(source.text));
    };
    const auto line = [&](const char* what, const ConeStep& step) {
        std::string text = fmt::format("<dt>{}</dt><dd>{}", what, place(step.source));
        for (const SourceLine& other : step.others) text += " or " + place(other);
        return text + fmt::format(", signal {}, cycle {}</dd>", escaped(step.signal), step.cycle);
    };
    std::string text = line("made by", steps.back());
    const auto first =
        std::find_if(steps.rbegin(), steps.rend(), [](const ConeStep& s) { return s.is_register; });
    if (first != steps.rend()) text += line("first register that holds it", *first);
    return text;
}

/// The way of the value that differs, from where it is made.
std::string cone_table(std::vector<ConeStep> steps) {
    if (steps.empty()) return {};
    std::reverse(steps.begin(), steps.end());
    std::vector<std::vector<std::string>> rows;
    for (const ConeStep& step : steps)
        rows.push_back({fmt::format("rtl/{}:{}", step.source.file, step.source.line), step.source.text,
                        step.signal + (step.is_register ? " (register)" : ""),
                        fmt::format("{}", step.cycle)});
    return "<h2>Where the value comes from</h2>\n<p class=\"quiet\">Each line passes on what the line above "
           "gives "
           "it. The first line makes the value: none of the signals that it reads holds it. A value of few "
           "bits may "
           "be followed wrongly.</p>\n" +
           html::table("", {"source", "statement", "signal", "cycle"}, rows, 3);
}

std::string name_of(const std::string& path) { return std::filesystem::path(path).filename().string(); }

}   // namespace

std::string verdict_of(const Divergence& d) {
    if (d.unit == "host") return "The RTL reports the beginning or the end of the frame in the wrong cycle.";
    if (!d.on) return "An assertion of the RTL failed.";
    if (!d.later.empty()) return d.later + ".";
    if (d.expected == "no offer" || d.got == "no offer" || d.expected == "a transfer" ||
        d.got == "a transfer")
        return "One machine offers or accepts what the other does not.";
    return "The transfer came in the right cycle, with another payload.";
}

std::string divergence_page(const DivergedRun& d, const Capture& capture, const SourceLine& source,
                            const DivergenceFiles& files, const std::string& rtl_wave) {
    const Divergence& f = d.first;
    std::string text = head;
    text += fmt::format("<h1>First divergence: cycle {}, unit {}, link {}</h1>\n<p>{}</p>\n", f.cycle,
                        escaped(f.unit), escaped(f.link), escaped(verdict_of(f)));
    text += fmt::format(
        "<dl><dt>expected, by the model</dt><dd>{}</dd><dt>got, from the RTL</dt><dd>{}</dd>"
        "<dt>pixel and context</dt><dd>({}, {}), {}</dd><dt>scene</dt><dd>{}</dd>",
        escaped(f.expected), escaped(f.got), f.x, f.y, f.ray, escaped(d.scene));
    if (!source.file.empty())
        text += fmt::format("<dt>driven by</dt><dd>rtl/{}:{} <code>{}</code></dd>", escaped(source.file),
                            source.line, escaped(source.text));
    const std::vector<ConeStep> cone = f.on && !capture.cycles.empty()
                                           ? cone_of(f, d.job.config, capture, rtl_wave)
                                           : std::vector<ConeStep>{};
    text += cone_lines(cone);
    text +=
        fmt::format("<dt>waveform</dt><dd><code>gtkwave {}</code></dd></dl>\n", escaped(name_of(files.view)));
    if (!files.note.empty()) text += "<p class=\"differs\">" + escaped(files.note) + "</p>\n";
    if (f.on && !capture.cycles.empty())
        text += "<h2>The link on both machines</h2>\n" + LinkTable(d, capture).text(d.job.config);
    if (f.on && link_infos[index(*f.on)].carries_ray)
        text += "<h2>What the pixel's rays did until then</h2>\n" + story(d);
    if (f.on && !capture.cycles.empty()) text += cone_table(cone) + signal_table(f, capture, rtl_wave);
    return text + "<p class=\"quiet\"><code>" + escaped(d.command) + "</code></p>\n</body></html>\n";
}

}   // namespace rayclock
