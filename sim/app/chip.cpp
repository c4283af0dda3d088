// rayclock chip: places and routes a configuration, or one of its units, on an ECP5.
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "model/base/error.hpp"
#include "model/base/interrupted.hpp"
#include "model/base/nearest.hpp"
#include "model/board/sdram_parts.hpp"
#include "model/compile/surfaces.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/app/parts/methods.hpp"
#include "sim/app/run/clock.hpp"
#include "sim/run/frame/frame.hpp"
#include "sim/run/rtl/builder.hpp"
#include "sim/silicon/chip/chip_report.hpp"
#include "sim/silicon/chip/estimate.hpp"
#include "sim/silicon/chip/floorplan_picture.hpp"
#include "sim/view/report/accounts.hpp"
#include "sim/view/report/json.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

namespace fs = std::filesystem;

struct ChipOptions {
    ConfigChoice config;
    std::vector<std::string> units;
    std::string device = "lfe5u-85", seeds = "1", output, scene, size = default_size;
    MethodOptions methods;
    std::optional<std::string> clock, sdram;
    bool fast = false, fresh = false, no_textures = false, board = false;
    JsonOutput json;
};

void declare_chip(Parser& parser, ChipOptions& o) {
    config_options(parser, o.config);
    parser.option("--unit", o.units, "route each of these units alone, separated by commas; all: every unit")
        .by_commas();
    parser.flag("--board", o.board,
                "route the chip within a ULX3S board, from pin to pin, and make its bitstream, board.bit");
    parser.option("--clock", o.clock, "with --board: the chip's clock, 75 or 62.5 MHz; 75 if not given");
    parser.option("--sdram", o.sdram,
                  "with --board: its memory, as4c32m16sb or is42s16160g; as4c32m16sb if not given");
    parser.option("--device", o.device, "lfe5u-25, lfe5u-45 or lfe5u-85").with_default();
    parser.option("--seeds", o.seeds, "seeds of the placer, as 1,2,3 or 1:8; the best result counts")
        .with_default();
    method_options(parser, o.methods, "Place and route");
    parser.flag("--fast", o.fast,
                "estimate the chip from its units instead of routing it; route them first with --unit");
    parser.option("--scene", o.scene,
                  "build only the optional units that this scene needs, and print its frames per second");
    textures_option(parser, o.no_textures);
    size_option(parser, o.size);
    parser.option("-o,--output", o.output, "folder for the report and pictures of the placement");
    fresh_option(parser, o.fresh);
    json_option(parser, o.json);
}

std::vector<std::string> tops_of(const ChipOptions& o, const Config& config) {
    if (o.board) return {chip::board_top};
    if (o.units.empty()) return {"chip"};
    std::vector<std::string> names = chip::tops(config);
    names.erase(names.begin());   // the first is the chip itself
    if (o.units == std::vector<std::string>{"all"}) return names;
    for (const std::string& unit : o.units)
        if (std::find(names.begin(), names.end(), unit) == names.end())
            throw UserError(fmt::format("--unit: no unit of '{}' is called {}{}; there are {}", config.name,
                                        shown(unit), did_you_mean(unit, names), fmt::join(names, ", ")));
    return o.units;
}

std::vector<int> seeds_of(const std::string& typed) {
    std::vector<int> seeds = parse_values("--seeds", typed);
    for (const int seed : seeds)
        if (seed < 1) throw UserError(fmt::format("--seeds: {} is not above 0, in {}", seed, shown(typed)));
    if (seeds.size() > 100) throw UserError(fmt::format("--seeds: {} seeds are more than 100", seeds.size()));
    return seeds;
}

/// An existing or new output folder. A new folder is removed again if it stays empty.
class OutputFolder {
public:
    explicit OutputFolder(const std::string& path) : path_(path) {
        if (path.empty()) return;
        std::error_code error;
        is_new_ = fs::create_directories(path_, error);
        if (error) throw UserError(fmt::format("{}: {}", printable(path), error.message()));
        check_writable((path_ / "report.txt").string());
    }
    ~OutputFolder() {
        std::error_code ignored;   // the folder is not empty
        if (is_new_) fs::remove(path_, ignored);
    }
    OutputFolder(const OutputFolder&) = delete;

private:
    fs::path path_;
    bool is_new_ = false;
};

std::string text_of(const std::vector<chip::Result>& all) {
    std::string text;
    for (const chip::Result& result : all) text += chip::text(result) + "\n";
    return all.size() > 1 ? text + chip::table(all) : text;
}

nlohmann::ordered_json json_of(const Config& config, const std::vector<chip::Result>& all) {
    nlohmann::ordered_json json;
    if (all.size() == 1) {
        json = chip::json(all[0]);
    } else {
        json["alone"] = nlohmann::ordered_json::array();
        for (const chip::Result& result : all) json["alone"].push_back(chip::json(result));
    }
    json["config"] = config_json_object(config);
    return json;
}

void write_files(const ChipOptions& o, const std::vector<chip::Result>& all, const std::string& text,
                 const nlohmann::ordered_json& json) {
    const fs::path folder = o.output;
    write_file((folder / "report.txt").string(), text);
    write_file((folder / "report.json").string(), json.dump(2) + "\n");
    for (const chip::Result& r : all) {
        if (!r.bitstream.empty()) write_file((folder / "board.bit").string(), r.bitstream);
        if (r.routes.empty()) continue;
        const std::string title =
            fmt::format("{} of '{}' on {}, {:.1f} MHz with seed {}", r.request.top, r.request.config.name,
                        r.request.device.name, r.best().fmax_mhz, r.best().seed);
        plot::write_plot((folder / (r.request.top + "-placement")).string(),
                         chip::placement(r.best(), r.request.device, title));
    }
}

/// The requested machine, and the scene to render, if one was given.
struct ChipRequest {
    Config config;
    std::optional<Request> scene;
    FrameSize size;
};
ChipRequest asked_of(const ChipOptions& o, const Progress& progress) {
    ChipRequest asked{{}, {}, parse_size(o.size)};
    if (o.scene.empty()) {
        asked.config = load_config(o.config);
    } else {
        ViewChoice view;
        view.no_textures = o.no_textures;
        asked.scene = request_of(o.scene, o.config, {}, default_seed, asked.size, progress, view);
        Config& config = asked.scene->config;
        if (config.shading)
            config = with_settings(fitted_config(asked.scene->scene, asked.scene->settings, config),
                                   o.config.set, config.name);
        asked.config = config;
    }
    check_rtl(asked.config);
    return asked;
}

/// Returns the model's frames per second on the scene at a clock.
double frames_per_second(const ChipRequest& asked, double mhz, const Progress& progress) {
    const Request& request = *asked.scene;
    const Job job = make_job(request.scene, *request.scene.camera, asked.size, request.config, progress,
                             request.settings);
    const int khz = int(1000 * mhz);   // rounds down to a clock that routing has shown
    std::vector<RecordedFrame> traces;
    const std::vector<FrameTiming> timings = record_and_replay(job, khz, traces, {}, 0, progress);
    if (interrupted())
        throw Interrupted("interrupted: the chip is kept, and the same command continues after it");
    return per_second(timings[0], khz);
}

/// Prints the report of the routed chip, and of the scene at its clock.
int print_chips(const ChipOptions& o, const ChipRequest& asked, const std::vector<chip::Result>& all,
                const Progress& progress) {
    nlohmann::ordered_json json = json_of(asked.config, all);
    std::string text = text_of(all);
    if (asked.scene && o.units.empty() && all[0].fits()) {
        const double mhz = all[0].best().fmax_mhz, fps = frames_per_second(asked, mhz, progress);
        text += fmt::format("  {}, {}: {:.2f} frames per second at the routed {:.1f} MHz\n",
                            asked.scene->scene.name, o.size, fps, mhz);
        json["scene"] = scene_json(asked.scene->scene);
        json["frame"] = {{"width", asked.size.width}, {"height", asked.size.height}};
        json["fps"] = fps;
    }
    if (o.board && all[0].fits())
        text +=
            all[0].bitstream.empty()
                ? std::string("  A clock is missed, so there is no bitstream; another seed may meet it.\n")
                : fmt::format("  bitstream: {} bytes{}\n", grouped(all[0].bitstream.size()),
                              o.output.empty() ? "; -o FOLDER writes it"
                                               : fmt::format("; load it with: openFPGALoader --board "
                                                             "ulx3s {}",
                                                             (fs::path(o.output) / "board.bit").string()));
    if (!o.json.is_alone()) fmt::print("{}", text);
    if (!o.output.empty()) write_files(o, all, text, json);
    o.json.write(json);
    return std::all_of(all.begin(), all.end(),
                       [&](const chip::Result& r) { return r.fits() && (!o.board || !r.bitstream.empty()); })
               ? 0
               : 1;
}

int print_estimate(const ChipOptions& o, const chip::Request& request, results::Cache& cache,
                   const Progress& progress) {
    const chip::Estimate estimate = chip::estimate(request, cache, progress);
    if (!o.json.is_alone()) fmt::print("{}", chip::text(estimate, request));
    o.json.write(chip::json(estimate, request));
    return 0;
}

int run_chip(const ChipOptions& o) {
    const chip::Device& device = chip::device_of(o.device);
    const std::vector<int> seeds = seeds_of(o.seeds);
    if (o.fast && !o.units.empty())
        throw UserError("--fast: an estimate covers the whole chip; leave out --unit");
    if (o.fast && !o.output.empty())
        throw UserError("--fast: an estimate has no pictures; leave out --output");
    if (o.fast && !o.methods.first().empty())
        throw UserError(fmt::format("--fast: an estimate routes nothing; leave out {}", o.methods.first()));
    const chip::Methods of_chip = methods_of(o.methods, "chip");   // throws UserError for wrong methods
    if (o.board && (o.fast || !o.units.empty() || !o.scene.empty()))
        throw UserError("--board: a board is routed as a whole; leave out --unit, --fast and --scene");
    if ((o.clock || o.sdram) && !o.board)
        throw UserError("--clock and --sdram need --board; without it, routing determines the clock");
    o.json.check();
    const Progress progress = terminal_progress();
    ChipRequest asked = asked_of(o, progress);
    const std::vector<std::string> tops = tops_of(o, asked.config);
    int khz = 0;
    if (o.board) {
        if (!asked.config.is_board())
            throw UserError("--board needs a configuration with dram=board, such as ulx3s-board");
        khz = one_clock_of(o.clock.value_or("75"), asked.config);
        chip::check_pll(khz);
        if (o.sdram) asked.config.board_sdram = sdram_part(*o.sdram).name;
    }
    const OutputFolder folder(o.output);
    results::Cache cache(rtl_cache() / "chip", o.fresh);
    if (o.fast) return print_estimate(o, {asked.config, "chip", device, seeds, of_chip}, cache, progress);
    std::vector<chip::Result> all;
    for (const std::string& top : tops)
        all.push_back(
            chip::run({asked.config, top, device, seeds, methods_of(o.methods, top), khz}, cache, progress));
    const int code = print_chips(o, asked, all, progress);
    if (!cache.trouble().empty())
        fmt::print(stderr, "rayclock: warning: nothing is kept for the next run: {}\n", cache.trouble());
    return code;
}

}   // namespace

Command chip_command() {
    return command("chip", "place and route a chip on an ECP5: area, clock, critical paths",
                   "rayclock chip --config small --device lfe5u-85 -o chip", declare_chip, run_chip);
}

}   // namespace rayclock
