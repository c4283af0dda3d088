// Fuzzes the command line: main() of the program and the options that commands share, with commands that only
// read them.
//
// An input has one word per line. Commands do nothing after they have read their options, so nothing is
// written, built or drawn.
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "model/scene/builtin.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/run/film/film.hpp"
#include "sim/files/streams.hpp"
#include "sim/view/report/builds.hpp"
#include "sim/run/request/view.hpp"
#include "sim/explore/sweep/axes.hpp"
#include "tests/fuzz/program/targets.hpp"

int rayclock_main(int argc, char** argv);   // sim/app/main.cpp

namespace rayclock {

namespace {

/// The options that commands share, and those of single commands with values parsed from text.
struct Options {
    std::string scene, size = default_size, clocks = default_clocks, rays = "1e6", bits = "12:20:2",
                       max_error = "0.1%", max_work = "0%", max_other = "1%";
    std::vector<std::string> axes;
    std::optional<std::string> shard, lines, pixels, cycles;
    std::optional<double> min_psnr;
    ConfigChoice config;
    Finish finish;
    FramesOptions frames;
    DisturbanceOptions disturbance;
    ViewChoice view;
    JsonOutput json;
    int threads = 0;
    bool no_judge = false, fresh = false, no_netlist = false;
};

void declare(Parser& parser, Options& o) {
    scene_option(parser, o.scene);
    size_option(parser, o.size);
    clock_option(parser, o.clocks);
    threads_option(parser, o.threads);
    config_options(parser, o.config);
    finished_options(parser, o.finish);
    judge_option(parser, o.no_judge);
    fresh_option(parser, o.fresh);
    netlist_option(parser, o.no_netlist);
    frames_options(parser, o.frames);
    disturbance_options(parser, o.disturbance);
    view_options(parser, o.view);
    json_option(parser, o.json);
    parser.option("--axis", o.axes, "");
    parser.option("--shard", o.shard, "");
    parser.option("--lines", o.lines, "");
    parser.option("--pixels", o.pixels, "");
    parser.option("--cycles", o.cycles, "");
    parser.option("--rays", o.rays, "");
    parser.option("--bits", o.bits, "");
    parser.option("--max-error", o.max_error, "");
    parser.option("--max-work", o.max_work, "");
    parser.option("--max-other", o.max_other, "");
    parser.option("--min-psnr", o.min_psnr, "");
}

int clock_khz(const std::string& text) { return parse_clocks(text).at(0); }

/// Reads all options. Each refusal must be a sentence; throws the last one.
int read_options(const Options& o) {
    std::string refused;
    const auto read = [&](const auto& part) {
        try {
            part();
        } catch (const UserError& error) {
            fuzz::check_sentence(refused = error.what());
        }
    };
    read([&] {
        const FrameSize frame = parse_size(o.size);
        const bool sensible =
            frame.width > 0 && frame.height > 0 && std::int64_t{frame.width} * frame.height <= 1 << 26;
        fuzz::demand(sensible, "a picture has a sensible size");
    });
    read([&] {
        for (const int khz : parse_clocks(o.clocks))
            fuzz::demand(khz >= 1000 && khz <= 100'000'000, "a clock is in range");
    });
    read([&] {
        const Config config = load_config(o.config);
        std::vector<sweep::Axis> axes;
        for (const std::string& axis : o.axes) axes.push_back(sweep::parse_axis(axis));
        if (!axes.empty()) sweep::make_points(axes, config, 66000, clock_khz);
    });
    read([&] {
        if (!o.shard) return;
        const sweep::Shard shard = sweep::parse_shard(*o.shard);
        fuzz::demand(1 <= shard.part && shard.part <= shard.of, "a part is one of its parts");
    });
    read([&] {
        if (o.lines) fuzz::demand(parse_lines(*o.lines).second > 0, "there is a line");
    });
    read([&] {
        ViewChoice view;
        const FrameSize part = parse_part(o.size, o.pixels, view);
        if (!view.window) return;
        const PictureWindow& w = *view.window;
        fuzz::demand(w.x >= 0 && w.y >= 0 && part.width > 0 && part.height > 0 &&
                         w.x + part.width <= w.whole_width && w.y + part.height <= w.whole_height,
                     "a part lies in its picture");
    });
    read([&] {
        if (!o.cycles) return;
        const CycleRange range = parse_cycles(*o.cycles);
        fuzz::demand(range.first < range.last, "there is a cycle");
    });
    read([&] { parse_values("--bits", o.bits); });
    read([&] { fuzz::demand(parse_rays(o.rays) >= 1, "there is a ray"); });
    read([&] {
        fuzz::demand(parse_percent("--max-error", o.max_error, false) > 0, "an error may be above 0");
    });
    read([&] { parse_percent("--max-work", o.max_work, true); });
    read([&] { parse_percent("--max-other", o.max_other, true); });
    read([&] { check_psnr(o.min_psnr); });
    read([&] { disturbance_of(o.disturbance); });
    read([&] {
        for (const double time : frame_times(o.frames, true).times)
            fuzz::demand(time >= 0 && std::isfinite(time), "a frame has a time");
    });
    read([&] {
        const Camera seen = chosen_camera(Camera{}, o.view, {512, 384});
        fuzz::demand(std::isfinite(glm::length(seen.at - seen.eye)), "an eye has a place");
    });
    read([&] {
        if (is_builtin(o.scene))
            builtin_counts(o.scene, o.finish.fresnel ? Primitives::native : Primitives::triangles);
    });
    if (!refused.empty()) throw UserError(refused);
    return 0;
}

}   // namespace

#define COMMAND(name) \
    Command name##_command() { return command<Options>(#name, "", "", declare, read_options); }
COMMAND(scenes)
COMMAND(render)
COMMAND(simulate)
COMMAND(rays)
COMMAND(verify)
COMMAND(template)
COMMAND(stress)
COMMAND(explain)
COMMAND(trace)
COMMAND(compare)
COMMAND(sweep)
COMMAND(merge)
COMMAND(fit)
COMMAND(textures)
COMMAND(board)
COMMAND(tradeoff)
COMMAND(yardstick)
COMMAND(figures)
COMMAND(counts)
COMMAND(sampling)
COMMAND(scale)
COMMAND(streams)
COMMAND(structures)
COMMAND(gigahertz)
COMMAND(area)
COMMAND(chip)
COMMAND(bench)
COMMAND(config)
COMMAND(export)
COMMAND(rtl)
COMMAND(doctor)

void show_builds() {}

// The streams stay as libFuzzer uses them.
void guard_streams() {}
void write_output(std::string_view) {}
std::string finish_output() { return {}; }

}   // namespace rayclock

namespace rayclock::fuzz {

void options(std::string_view bytes) {
    constexpr std::size_t most = 200;
    std::vector<std::string> words{"rayclock"};
    for (const char c : bytes) {
        if (c == '\n' && words.size() < most)
            words.emplace_back();
        else if (words.size() == 1)
            words.push_back(c == '\0' ? std::string{} : std::string(1, c));
        else if (c != '\0')
            words.back() += c;
    }
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const int code = rayclock_main(static_cast<int>(words.size()), arguments.data());
    demand(code == 0 || code == 2, "options are good, or refused as a UserError");
}

}   // namespace rayclock::fuzz
