// rayclock: the command line. Every subcommand's work is in the file of its name.
#include <cstdio>
#include <filesystem>
#include <functional>
#include <sstream>

#include <CLI/CLI.hpp>

#include "model/core/error.hpp"
#include "model/core/nearest.hpp"
#include "sim/app/commands.hpp"
#include "sim/files/streams.hpp"

namespace {

using namespace rayclock;

CLI::Option* scene_option(CLI::App& app, Options& o) {
    return app.add_option("SCENE", o.scene, "built-in name with optional size (gears:8), or file (.obj .ply .stl .glb .gltf .json)")->required();
}
void size_option(CLI::App& app, Options& o) { app.add_option("--size", o.size, "picture, WIDTHxHEIGHT")->capture_default_str(); }
void config_options(CLI::App& app, Options& o) {
    app.add_option("--config", o.config, "hardware configuration: default, small, wide, saarcor, rpu, or a JSON file")->capture_default_str();
    app.add_option("--set", o.set, "key=value: one parameter over the configuration; may be repeated");
}
void json_option(CLI::App& app, Options& o) { app.add_option("--json", o.json, "report as JSON to a file, - for standard output"); }
void clock_option(CLI::App& app, Options& o) { app.add_option("--clock", o.clock, "clock rates in MHz, with commas")->capture_default_str(); }
void judge_option(CLI::App& app, Options& o) {
    app.add_flag("--no-judge", o.no_judge, "leave out the exact judge of all rays and colours, and with it the causes of pixels that differ");
}
void threads_option(CLI::App& app, Options& o) { app.add_option("--threads", o.threads, "threads, 0 for all cores")->check(CLI::Range(0, 1024)); }
void finished_options(CLI::App& app, Options& o) {
    constexpr const char* group = "Finished picture (shadows, reflection, refraction, made by the chip)";
    app.add_option("--depth", o.depth, "bounces of a camera ray, 0..15; 5 if another option of this group is given")->group(group);
    app.add_option("--threshold", o.threshold, "a reflected or refracted ray of less weight is not traced, 0..1; 0: all are")->group(group);
    app.add_option("--aa", o.aa, "N x N samples a pixel, 1..8")->group(group);
    app.add_flag("--jittered", o.jittered, "each sample anywhere in its cell (--seed)")->group(group);
    app.add_option("--contrast", o.contrast, "after 4 samples take the rest only where a colour differs by more than this, 0..1")->group(group);
    app.add_flag("--fresnel", o.fresnel, "weigh reflection and refraction by Schlick's approximation of Fresnel's term")->group(group);
}
void frames_options(CLI::App& app, Options& o) {
    app.add_option("--frames", o.frames, "frames on one machine, one after the other: the caches are warm from the second on")->capture_default_str();
    app.add_option("--pan", o.pan, "degrees that the camera turns from frame to frame");
}
void traffic_options(CLI::App& app, Options& o) {
    app.add_option("--seed", o.seed, "seed of random traffic and of the RTL's registers at start")->check(CLI::Range(1, 1 << 30));
    app.add_option("--jitter", o.jitter, "random extra memory latency, up to this many cycles");
    app.add_option("--stall", o.stall, "percent of cycles in which memory and output accept nothing");
}

void sweep_options(CLI::App& app, Options& o) {
    app.add_flag("--fresh", o.fresh, "work everything out again; otherwise what an earlier run has finished is taken from the cache");
    app.add_flag("--no-netlist", o.no_netlist, "do not count multipliers and flip-flops (Yosys takes some ten seconds per configuration)");
}

struct Command {
    CLI::App* app;
    std::function<int(const Options&)> run;
};

std::vector<Command> add_commands(CLI::App& app, Options& o) {
    std::vector<Command> commands;
    const auto add = [&](const char* name, const char* what, const char* example, int (*run)(const Options&)) -> CLI::App& {
        CLI::App* sub = app.add_subcommand(name, what);
        sub->footer(std::string("Example: ") + example);
        commands.push_back({sub, run});
        return *sub;
    };
    json_option(add("scenes", "list the built-in scenes", "rayclock scenes", scenes_command), o);

    CLI::App& render = add("render", "make a picture with one engine", "rayclock render gears:4 --engine rtl -o gears.png", render_command);
    scene_option(render, o);
    finished_options(render, o);
    size_option(render, o);
    config_options(render, o);
    render.add_option("--engine", o.engine, "reference, model or rtl")->capture_default_str();
    render.add_option("-o,--output", o.output, "picture to write: .png, or .exr with depth and primitive number")->required();
    threads_option(render, o);
    json_option(render, o);

    CLI::App& simulate = add("simulate", "cycles, frames per second, work and accounts of a frame",
                             "rayclock simulate balls:3 --clock 66,90 --set contexts=32", simulate_command);
    scene_option(simulate, o);
    finished_options(simulate, o);
    size_option(simulate, o);
    clock_option(simulate, o);
    config_options(simulate, o);
    simulate.add_option("--engine", o.engine, "model or rtl")->capture_default_str();
    frames_options(simulate, o);
    simulate.add_flag("--no-reference", o.no_reference, "leave out the comparison with the reference");
    judge_option(simulate, o);
    threads_option(simulate, o);
    traffic_options(simulate, o);
    json_option(simulate, o);

    CLI::App& verify = add("verify", "run model and RTL in lockstep, and compare both with the reference",
                           "rayclock verify teapot:12 -o out", verify_command);
    CLI::Option* const scene = scene_option(verify, o)->required(false);
    verify.add_flag("--torture", o.torture, "no scene, but the torture set: small frames on three chips that reach the corners of the machine")
        ->excludes(scene);
    finished_options(verify, o);
    size_option(verify, o);
    clock_option(verify, o);
    config_options(verify, o);
    frames_options(verify, o);
    judge_option(verify, o);
    verify.add_option("--max-other", o.max_other, "fail if more pixels hold another primitive than the reference's, in per cent; otherwise it warns above 1%");
    verify.add_option("--min-psnr", o.min_psnr, "fail if the picture is further from the reference's, in decibel; otherwise it warns below 30");
    verify.add_option("-o,--output", o.output, "folder for the pictures of the three engines and their difference");
    threads_option(verify, o);
    traffic_options(verify, o);
    json_option(verify, o);

    CLI::App& stress = add("stress", "numerical hard cases against the exact oracle",
                           "rayclock stress --bits 12:20:2 --rays 1e9 --state run.json    (stopped and started again, it goes on)", stress_command);
    stress.add_option("--bits", o.bits, "lattices: bits of a coordinate, as 12:20:2 or 16,18")->capture_default_str();
    stress.add_option("--rays", o.rays, "rays for exact and for sheared; a tenth for baselines and controls")->capture_default_str();
    stress.add_option("--test", o.tests, "primitive test, or all; may be repeated")->delimiter(',');
    stress.add_option("--family", o.families, "family of hard cases; may be repeated; all by default")->delimiter(',');
    stress.add_option("--seed", o.seed, "seed of the rays")->check(CLI::Range(1, 1 << 30));
    stress.add_option("-o,--output", o.output, "page to write (Markdown), with a picture of each family in a folder beside it");
    stress.add_option("--state", o.state, "file that keeps what is done: go on from it if it is there");
    threads_option(stress, o);
    json_option(stress, o);

    CLI::App& sweep = add("sweep", "one scene on many configurations and clocks; what differs in timing only shares one trace",
                          "rayclock sweep gears:8 --axis node_sets=16,32,64 --axis clock=66,200", sweep_command);
    scene_option(sweep, o);
    sweep.add_option("--axis", o.axes, "key=1,2,4 or key=12:20:2: a parameter of the configuration, or clock; may be repeated")->required();
    size_option(sweep, o);
    clock_option(sweep, o);
    config_options(sweep, o);
    sweep.add_option("-o,--output", o.output, "table as CSV");
    sweep.add_option("--plot", o.plot, "writes NAME.svg and NAME.png: error against cost and against speed, with the fronts and the knee");
    sweep_options(sweep, o);
    threads_option(sweep, o);
    json_option(sweep, o);

    CLI::App& fit = add("fit", "the smallest formats that draw a scene within an error, as a configuration file, with a proof that nothing overflows",
                        "rayclock fit gears:4 --max-error 0.1% -o gears.json && rayclock verify gears:4 --config gears.json", fit_command);
    scene_option(fit, o);
    fit.add_option("--max-error", o.max_error, "most pixels that may hold another primitive than the reference's, in per cent: 0.1%")->capture_default_str();
    fit.add_option("--min-psnr", o.min_psnr, "least PSNR of the picture against the reference's, in dB");
    fit.add_option("--max-work", o.max_work, "most nodes and triangles that narrow boxes, reciprocals and distances may cost, in per cent")->capture_default_str();
    size_option(fit, o);
    config_options(fit, o);
    fit.add_option("-o,--output", o.output, "configuration file to write")->required();
    threads_option(fit, o);
    json_option(fit, o);

    CLI::App& tradeoff = add("tradeoff", "the page that says what each bit costs and brings: one width at a time, and a grid with its Pareto front",
                             "rayclock tradeoff -o docs/speed-against-error.md", tradeoff_command);
    tradeoff.add_option("-o,--output", o.output, "Markdown file to write; the plots go beside it")->required();
    o.scenes = default_tradeoff_scenes();
    tradeoff.add_option("--scenes", o.scenes, "scenes, with commas")->delimiter(',')->capture_default_str();
    size_option(tradeoff, o);
    sweep_options(tradeoff, o);
    threads_option(tradeoff, o);

    CLI::App& yardstick = add("yardstick", "the page that sets this machine beside the published figures of SaarCOR and RPU",
                              "rayclock yardstick -o docs/yardstick.md", yardstick_command);
    yardstick.add_option("-o,--output", o.output, "Markdown file to write")->required();
    threads_option(yardstick, o);

    CLI::App& figures = add("figures", "the page of the field's classic figures, drawn by all engines", "rayclock figures -o docs", figures_command);
    figures.add_option("-o,--output", o.output, "folder for figures.md, and for its pictures in figures/")->required();
    figures.add_option("--size", o.figure_size, "pictures, WIDTHxHEIGHT")->capture_default_str();
    figures.add_option("--engine", o.engines, "engines, with commas")->capture_default_str();
    threads_option(figures, o);
    json_option(figures, o);

    CLI::App& counts = add("counts", "rays of Haines' scenes by reference and model beside the published counts", "rayclock counts -o docs/spd.md", counts_command);
    o.count_scenes = published_scenes();
    counts.add_option("SCENE", o.count_scenes, "scenes, all with a published count by default");
    counts.add_option("--size", o.count_size, "picture, WIDTHxHEIGHT; the published counts are of 513x513")->capture_default_str();
    counts.add_option("-o,--output", o.output, "Markdown file to write");
    threads_option(counts, o);
    json_option(counts, o);

    CLI::App& area = add("area", "what each unit takes of an ECP5, with and without the units that a scene may need", "rayclock area -o docs/area.md", area_command);
    config_options(area, o);
    area.add_option("--unit", o.units, "only these units, with commas; then no page and no speed")->delimiter(',');
    area.add_option("-o,--output", o.output, "Markdown file to write, with the speed of simulation as well");
    area.add_flag("--fresh", o.fresh, "work everything out again; otherwise what an earlier run has finished is taken from the cache");
    threads_option(area, o);
    json_option(area, o);

    CLI::App& bench = add("bench", "speed of the simulator itself: model, RTL and reference on one frame", "rayclock bench gears:8", bench_command);
    scene_option(bench, o);
    size_option(bench, o);
    config_options(bench, o);
    threads_option(bench, o);
    json_option(bench, o);

    CLI::App& config = add("config", "print a configuration with every parameter", "rayclock config small > mine.json", config_command);
    config.add_option("NAME", o.config, "default, small, wide, saarcor, rpu, or a JSON file")->capture_default_str();
    config.add_option("--set", o.set, "key=value: one parameter over the configuration; may be repeated");

    CLI::App& rtl = add("rtl", "build the RTL of a configuration now and say where it is kept", "rayclock rtl --config small", rtl_command);
    config_options(rtl, o);

    json_option(add("doctor", "what is installed, and what a missing part disables", "rayclock doctor", doctor_command), o);
    return commands;
}

constexpr const char* help_footer =
    "Exit code: 0 good, 1 a check failed, 2 bad usage or input.\n"
    "Environment:\n"
    "  RAYCLOCK_CACHE  folder that keeps built RTL and finished figures; otherwise $XDG_CACHE_HOME/rayclock or ~/.cache/rayclock\n"
    "  RAYCLOCK_RTL    folder of Verilog sources to build instead of this project's rtl\n"
    "Start with: rayclock verify gears:4 -o out";

/// One sentence on standard error, and the exit code. What people wrote is in it: printable, and not without end.
int complain(const std::string& sentence, int code) {
    constexpr std::size_t longest = 1000;
    std::fprintf(stderr, "rayclock: %s\n", code == 2 ? printable(sentence, longest).c_str() : sentence.c_str());
    return code;
}

/// What is printed and does not arrive is an error, whatever else came of the run.
int finish(int code) {
    const std::string lost = finish_output();
    return lost.empty() ? code : complain("standard output: cannot be written: " + lost, 2);
}

/// What the parser found wrong, in one sentence that names what was typed.
std::string usage_error(const CLI::ParseError& error, const std::vector<Command>& commands, int argc, char** argv) {
    std::vector<std::string> names;
    const CLI::App* used = nullptr;
    for (const Command& command : commands) {
        names.push_back(command.app->get_name());
        if (command.app->parsed()) used = command.app;
    }
    if (!used && argc > 1 && argv[1][0] != '-')
        return "no command is called " + shown(argv[1]) + did_you_mean(argv[1], names) + " ('rayclock --help' lists them)";
    std::string text = error.what();
    for (char& c : text)
        if (c == '\n') c = ' ';
    return text + " ('rayclock " + (used ? used->get_name() + " " : "") + "--help' tells more)";
}

/// Runs what was asked for; the exit code.
int run(int argc, char** argv) {
    CLI::App app{"rayclock: a cycle-level simulator of a hardware ray tracer"};
    app.footer(help_footer);
    app.require_subcommand(1);
    app.set_version_flag("--version", RAYCLOCK_VERSION);
    Options options;
    const std::vector<Command> commands = add_commands(app, options);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        if (e.get_exit_code() == 0) {   // --help, --version
            std::ostringstream text;
            const int code = app.exit(e, text, text);
            std::fputs(text.str().c_str(), stdout);
            return code;
        }
        return complain(usage_error(e, commands, argc, argv), 2);
    }
    show_builds();
    try {
        for (const Command& command : commands)
            if (command.app->parsed()) return command.run(options);
    } catch (const UserError& e) {
        return complain(e.what(), 2);
    } catch (const std::bad_alloc&) {
        return complain("not enough memory for this scene and picture", 2);
    } catch (const std::filesystem::filesystem_error& e) {
        return complain(e.path1().string() + ": " + e.code().message(), 2);
    } catch (const std::exception& e) {
        if (std::ferror(stdout)) return 2;   // finish() says so
        return complain(e.what(), 1);
    }
    return 2;
}

} // namespace

int main(int argc, char** argv) {
    guard_streams();
    return finish(run(argc, argv));
}
