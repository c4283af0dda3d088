// rayclock fit: finds the smallest configuration that renders a scene within an error bound, and proves that
// nothing in it overflows.
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/stopwatch.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/app/parts/fit_device.hpp"
#include "sim/explore/fit/dominant.hpp"
#include "sim/explore/fit/fit_report.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/view/report/json.hpp"
#include "sim/view/report/tables.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

using namespace fit;

struct FitOptions {
    std::string scene, size = default_size, max_error = "0.1%", max_work = "2%", output;
    std::optional<double> min_psnr;
    ConfigChoice config;
    Finish finish;
    ViewChoice view;
    FramesOptions frames;
    std::uint64_t seed = 1;
    DeviceOptions device;
    int threads = 0;
    JsonOutput json;
};

void declare_fit(Parser& parser, FitOptions& o) {
    scene_option(parser, o.scene).required();
    finished_options(parser, o.finish);
    view_options(parser, o.view);
    frames_options(parser, o.frames);
    parser.option("--seed", o.seed, "seed of --jittered").within(1, 1 << 30);
    parser
        .option("--max-error", o.max_error,
                "percentage of pixels that may hold another primitive than the reference's")
        .with_default();
    parser.option("--min-psnr", o.min_psnr, "smallest PSNR of the picture against the reference's, in dB");
    parser
        .option("--max-work", o.max_work,
                "percentage of additional nodes and triangles that narrow boxes, reciprocals and distances "
                "may cost")
        .with_default();
    size_option(parser, o.size);
    config_options(parser, o.config);
    parser.option("-o,--output", o.output, "configuration file to write").required();
    device_options(parser, o.device);
    threads_option(parser, o.threads);
    json_option(parser, o.json);
}

Goal goal_of(const FitOptions& o) {
    Goal goal;
    goal.max_error = parse_percent("--max-error", o.max_error, false);
    goal.max_work = parse_percent("--max-work", o.max_work, true);
    goal.min_psnr = o.min_psnr;
    check_psnr(o.min_psnr);
    return goal;
}

/// Returns a file name for a scene: gears:8 gives gears-8, scenes/desk.json gives desk.
std::string name_of(const std::string& scene) {
    const bool file = scene.find(':') == std::string::npos;
    std::string name = file ? std::filesystem::path(scene).stem().string() : scene;
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '-';
    return name;
}

std::string goal_text(const Goal& b) {
    return fmt::format(
        "at most {:g} % of the pixels on another primitive than the reference's{}, and {:g} % more nodes and "
        "triangles than with the widest fields",
        b.max_error, b.min_psnr ? fmt::format(", PSNR {:g} dB", *b.min_psnr) : "", b.max_work);
}

/// Returns one sentence: the best error reached, the cause of the scene's size, and a remedy.
std::string hopeless(const FitOptions& o, const Goal& goal, const Config& base, Measurer& measure,
                     const Config& closest) {
    const Measurement& best = measure(closest);
    std::string sentence = fmt::format("{}: no width keeps the bound; N = {} and M = {} come closest, ",
                                       printable(o.scene), closest.coord_bits, closest.dir_bits);
    if (!best.refused.empty())
        sentence += "and there " + best.refused;
    else
        sentence += fmt::format("with {:.3g} % of the pixels on another primitive{}", best.other_percent(),
                                goal.min_psnr ? fmt::format(" and a PSNR of {:.1f} dB", best.psnr_db) : "");
    const std::optional<Dominant> part = dominant_part(measure.scene());
    if (!part)
        return sentence + (measure.scene().triangles.empty() ? "; " : "; its extents are even, so ") +
               "only a larger bound or a camera that sees less of the scene would help";
    sentence += fmt::format(
        "; because of {} the scene is {} times as large as the rest", part->what,
        part->ratio < 100 ? fmt::format("{:.1f}", part->ratio) : grouped(std::uint64_t(part->ratio)));
    Measurer rest(part->without, measure.size(), o.threads, measure.choice());
    rest.on_measured = measure.on_measured;
    const std::optional<int> bits = Search(rest, base, goal).smallest_coord_bits();
    return sentence + (bits ? fmt::format(", and without that N = {} would do", *bits)
                            : std::string(", but without that no width would do either"));
}

constexpr const char* no_proof =
    "  no ranges are proven: the proof covers one picture of camera rays in a flat scene; rayclock verify "
    "judges every ray of this picture";

/// Returns the options of the picture as typed, for the command that verifies it.
std::string picture_words(const FitOptions& o) {
    std::string words;
    const auto add = [&](const char* option, const auto& value) {
        if (value) words += fmt::format(" {} {}", option, *value);
    };
    add("--depth", o.finish.depth);
    add("--aa", o.finish.aa);
    add("--threshold", o.finish.threshold);
    add("--contrast", o.finish.contrast);
    if (o.finish.jittered) words += " --jittered";
    if (o.finish.fresnel) words += " --fresnel";
    if (o.frames.frames > 1) words += fmt::format(" --frames {}", o.frames.frames);
    if (!o.frames.time.empty()) words += " --time " + o.frames.time;
    add("--fps", o.frames.fps);
    if (o.frames.pan != 0) words += fmt::format(" --pan {:g}", o.frames.pan);
    return words;
}

/// The result of the search, and what it needed.
struct FitResult {
    const Scene& scene;
    FrameSize size;
    const PictureChoice& picture;
    const Goal& goal;
    const Config& base;
    Fit fit;
    Config config;   ///< the configuration to write
    std::optional<DeviceFit> device;
    std::optional<Ranges> ranges;   ///< for camera rays of a flat scene
    std::size_t frames = 0;
    double seconds = 0;
};

void print(const FitOptions& o, const FitResult& f) {
    const Measurement& result = f.fit.outcome;
    fmt::print("{}, {}, {}x{}: {}\n\n", f.scene.name, primitives_text(f.scene), f.size.width, f.size.height,
               goal_text(f.goal));
    fmt::print("{}\n{}\n", parameter_table(f.fit, f.base),
               needs_text(f.fit, f.base, f.ranges.value_or(Ranges{})));
    fmt::print("{}\n", units_text(f.config));
    fmt::print("{}\n", f.ranges ? range_table(*f.ranges) : std::string(no_proof) + "\n");
    fmt::print(
        "  {} of {} pixels hold another primitive ({:.3f} %), PSNR {}; {:.1f} % more nodes and triangles "
        "than with the widest fields\n",
        grouped(result.other), grouped(result.pixels), result.other_percent(),
        std::isfinite(result.psnr_db) ? fmt::format("{:.1f} dB", result.psnr_db) : "infinite",
        100 * (double(result.work) / double(f.fit.widest.work) - 1));
    if (f.device) fmt::print("\n{}\n", text(*f.device));
    fmt::print("  {} written after {} frames in {:.1f} s; rayclock verify {}{} --size {} --config {}\n",
               printable(o.output), f.frames, f.seconds, printable(o.scene), printable(picture_words(o)),
               o.size,
               printable(o.output.find_first_of("./") == std::string::npos ? "./" + o.output : o.output));
}

nlohmann::ordered_json json_of(const FitResult& f) {
    const nlohmann::ordered_json psnr =
        f.goal.min_psnr ? nlohmann::ordered_json(*f.goal.min_psnr) : nlohmann::ordered_json(nullptr);
    nlohmann::ordered_json report{
        {"scene", scene_json(f.scene)},
        {"frame", {{"width", f.size.width}, {"height", f.size.height}}},
        {"finished", f.picture.finished},
        {"frames", f.picture.frames.frames},
        {"bounds",
         {{"max_error_percent", f.goal.max_error},
          {"min_psnr_db", psnr},
          {"max_work_percent", f.goal.max_work}}},
        {"config", config_json_object(f.config)},
        {"parameters", parameters_json(f.fit, f.base)},
        {"error", outcome_json(f.fit.outcome)},
        {"widest", outcome_json(f.fit.widest)},
        {"compile", compile_json(f.fit.outcome.compile)},
        {"needs", needs_json(f.fit, f.ranges.value_or(Ranges{}))},
        {"units", units_json(f.fit.config)},
        {"cost", {{"fitted", cost_json(f.fit.cost)}, {"base", cost_json(f.fit.base_cost)}}},
        {"ranges", f.ranges ? ranges_json(*f.ranges) : nlohmann::ordered_json(nullptr)},
        {"host", {{"seconds", f.seconds}, {"frames", f.frames}}}};
    if (f.device) report["device"] = json(*f.device);
    return report;
}

/// Runs the search. If it finds nothing, throws with a sentence.
Fit search_for(const FitOptions& o, const Goal& goal, const Config& base, Measurer& measure,
               const Progress& progress) {
    measure.on_measured = [&](const Config& c, std::size_t done) {
        constexpr std::size_t expected = 40;
        if (progress)
            progress(fmt::format("fit, N = {}, M = {}", c.coord_bits, c.dir_bits), done,
                     std::max(expected, done + 1));
    };
    Search search(measure, base, goal);
    std::optional<Fit> found = search.run();
    if (found) return *found;
    const std::string sentence = hopeless(o, goal, base, measure, search.closest());
    if (progress) progress("fit", 1, 1);
    throw std::runtime_error(sentence);
}

int run_fit(const FitOptions& o) {
    const Stopwatch watch;
    const FrameSize size = parse_size(o.size);
    const Goal goal = goal_of(o);
    const std::optional<DeviceGoal> on_device = device_goal(o.device);
    o.json.check();
    if (o.output != "-")
        check_writable(o.output);
    else if (o.json.is_alone())
        throw UserError("-o and --json cannot both go to standard output");
    const Progress progress = terminal_progress();
    const Request request = request_of(o.scene, o.config, o.finish, o.seed, size, stopping(progress), o.view);
    const Scene& scene = request.scene;
    const PictureChoice picture{request.finished, request.settings, settled_frames(o.frames, scene), o.view};
    const Config& base = request.config;
    if (base.test() != PrimitiveTest::exact)
        throw UserError("fit: primitive_test must be exact, not " + name_of(base.primitive_test) +
                        ": only exact decisions make the primitives depend on N and M alone");
    if (!base.is_bvh())
        throw UserError("fit: structure must be bvh, not " + name_of(base.structure) +
                        ": fit searches the widths of boxes");
    Measurer measure(scene, size, o.threads, picture);
    Fit fit = search_for(o, goal, base, measure, progress);
    fit.config.name = printable(name_of(o.scene), 80);
    std::optional<DeviceFit> device;
    if (on_device) device = fit_device(*on_device, scene, size, fit.config, o.threads, progress, picture);
    const Config& config = device ? device->config : fit.config;
    std::optional<Ranges> ranges;
    if (measure.is_plain() && !config.has_instances()) {
        const Job job = make_job(scene, *scene.camera, size, config);
        ranges = prove_ranges(job.image, job.frame, config);
    }
    if (progress) progress("fit", 1, 1);
    if (ranges && !ranges->proven())
        throw std::logic_error("a signal of the fitted machine may overflow:\n" + range_table(*ranges));
    write_file(o.output, config_json_object(config).dump(2) + "\n");

    const double seconds = watch.seconds();
    const FitResult found{scene,  size,   picture, goal,           base,   fit,
                          config, device, ranges,  measure.done(), seconds};
    if (!o.json.is_alone() && o.output != "-") print(o, found);
    o.json.write(json_of(found));
    return device && device->routed && !device->routed->fits() ? 1 : 0;
}

}   // namespace

Command fit_command() {
    return command(
        "fit", "find the smallest formats that draw a scene within an error",
        "rayclock fit gears:4 --max-error 0.1% -o gears.json && rayclock verify gears:4 --config gears.json",
        declare_fit, run_fit);
}

}   // namespace rayclock
