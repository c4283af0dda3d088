// rayclock trace: writes part of a frame's timeline for viewers.
#include <filesystem>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/split.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/app/run/clock.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/run/frame/frame.hpp"
#include "sim/view/observe/replay.hpp"
#include "sim/view/report/json.hpp"
#include "sim/view/report/text.hpp"
#include "sim/view/timeline/timeline.hpp"

namespace rayclock {

namespace {

struct TraceOptions {
    std::string scene, cycles, pixels, rays, output, size = default_size, clock = "66";
    ConfigChoice config;
    Finish finish;
    ViewChoice view;
    FramesOptions frames;
    DisturbanceOptions disturbance;
    int threads = 0;
    JsonOutput json;
};

void declare_trace(Parser& parser, TraceOptions& o) {
    scene_option(parser, o.scene).required();
    parser.option("--cycles", o.cycles, "cycles of the frame, FIRST:LAST, LAST excluded");
    parser.option("--pixels", o.pixels, (std::string("only these pixels, ") + pixels_forms).c_str());
    parser.option("--rays", o.rays,
                  "only rays of these kinds, separated by commas: camera, shadow, reflection, refraction");
    parser
        .option("-o,--output", o.output,
                "the file: .kanata for Konata, .pftrace for Perfetto, .fst for GTKWave, which opens the "
                ".gtkw next to it")
        .required();
    finished_options(parser, o.finish);
    view_options(parser, o.view);
    size_option(parser, o.size);
    one_clock_option(parser, o.clock);
    config_options(parser, o.config);
    frames_options(parser, o.frames);
    threads_option(parser, o.threads);
    disturbance_options(parser, o.disturbance);
    json_option(parser, o.json);
}

void choose_cycles(TimelineChoice& choice, const std::string& typed) {
    constexpr std::uint64_t most = 1'000'000;
    const CycleRange range = parse_cycles(typed);
    if (range.last - range.first > most)
        throw UserError(fmt::format("--cycles: {} are more than {} cycles", shown(typed), most));
    choice.first = range.first;
    choice.last = range.last;
    choice.whole_frame = false;
}

void choose_pixels(TimelineChoice& choice, const std::string& typed, FrameSize size) {
    const PixelRect rect = parse_pixels(typed, size);
    choice.x0 = std::uint32_t(rect.x), choice.y0 = std::uint32_t(rect.y);
    choice.x1 = choice.x0 + std::uint32_t(rect.size.width) - 1;
    choice.y1 = choice.y0 + std::uint32_t(rect.size.height) - 1;
}

void choose_rays(TimelineChoice& choice, const std::string& typed) {
    choice.purposes = {};
    for (const std::string& name : split(typed, ',')) {
        const auto at = std::find(purpose_names.begin(), purpose_names.end(), name);
        if (at == purpose_names.end())
            throw UserError("--rays: " + shown(name) + " is not camera, shadow, reflection or refraction");
        choice.purposes[std::size_t(at - purpose_names.begin())] = true;
    }
}

TimelineChoice choice_of(const TraceOptions& o, FrameSize size) {
    if (o.cycles.empty() && o.pixels.empty())
        throw UserError("trace needs --cycles FIRST:LAST, or --pixels X,Y..X,Y, or both");
    TimelineChoice choice;
    if (!o.cycles.empty()) choose_cycles(choice, o.cycles);
    if (!o.pixels.empty()) choose_pixels(choice, o.pixels, size);
    if (!o.rays.empty()) choose_rays(choice, o.rays);
    if (o.cycles.empty() && std::uint64_t(choice.x1 - choice.x0 + 1) * (choice.y1 - choice.y0 + 1) > 10'000)
        throw UserError("--pixels: " + shown(o.pixels) + " are more than 10000 pixels");
    return choice;
}

/// Returns the path of a waveform's save file, next to it; empty for other formats.
std::string view_of(const std::string& output) {
    std::filesystem::path path = output;
    return path.extension() == ".fst" ? path.replace_extension(".gtkw").string() : "";
}

int run_trace(const TraceOptions& o) {
    const FrameSize size = parse_size(o.size);
    const TimelineChoice choice = choice_of(o, size);
    const auto writer = timeline_writer(o.output);
    const Disturbance disturbance = disturbance_of(o.disturbance);
    check_writable(o.output);
    const std::string view = view_of(o.output);
    if (!view.empty()) check_writable(view);
    o.json.check();
    const Progress progress = terminal_progress();
    Request asked =
        request_of(o.scene, o.config, o.finish, o.disturbance.seed, size, stopping(progress), o.view);
    if (!asked.finished && !choice.purposes[std::size_t(RayPurpose::camera)])
        throw UserError("--rays: this picture has only camera rays; use --depth for a picture with others");
    Film film(std::move(asked), o.frames, o.view.is_given(), size, stopping(progress));
    std::vector<RecordedFrame> traces;
    while (traces.size() < film.frames()) {
        film.next();
        traces.push_back(film.record(o.threads, stopping(progress)));
    }
    const Request& request = film.request();
    const int khz = one_clock_of(o.clock, request.config);

    Timeline timeline(request.config, size, choice);
    const FrameCosts costs = observe(request.config, khz, traces, disturbance, 0, &timeline, progress);
    if (interrupted()) throw Interrupted("interrupted: nothing is written");
    if (choice.first >= costs.cycles)
        throw UserError(fmt::format("--cycles: the frame ends after {} cycles, before {} begins",
                                    costs.cycles, shown(o.cycles)));
    timeline.finish();
    write_bytes(o.output, writer(timeline));
    if (!view.empty()) write_bytes(view, fst_view(timeline, o.output));
    std::size_t stays = 0;
    for (const TimelineRay& ray : timeline.rays) stays += ray.stays.size();
    if (!o.json.is_alone())
        fmt::print("{}: {} rays, {} stays in units, {} spans of units -> {}\n", request.scene.name,
                   timeline.rays.size(), stays, timeline.units.size(), printable(o.output));
    o.json.write({{"scene", scene_json(request.scene)},
                  {"config", config_json_object(request.config)},
                  {"frame", {{"width", size.width}, {"height", size.height}}},
                  {"mhz", khz / 1e3},
                  {"rays", timeline.rays.size()},
                  {"stays", stays},
                  {"unit_spans", timeline.units.size()}});
    return 0;
}

}   // namespace

Command trace_command() {
    return command("trace", "write some cycles of a frame for Konata, Perfetto or GTKWave",
                   "rayclock trace gears:8 --cycles 2000:3000 -o gears.pftrace", declare_trace, run_trace);
}

}   // namespace rayclock
