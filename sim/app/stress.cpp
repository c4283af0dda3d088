// rayclock stress: runs families of hard cases on many lattices, judged by the oracle; or a stream of rays on
// random chips, in lockstep and judged.
#include <algorithm>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/interrupted.hpp"
#include "model/base/quote.hpp"
#include "model/base/stopwatch.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/app/parts/stream_commands.hpp"
#include "sim/explore/stress/stress_report.hpp"
#include "sim/explore/torture/streamed.hpp"
#include "sim/files/image/image.hpp"
#include "sim/files/input.hpp"
#include "sim/files/process/parallel.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/run/frame/frame.hpp"
#include "sim/run/rtl/builder.hpp"
#include "sim/study/hard_cases.hpp"
#include "sim/view/report/json.hpp"
#include "sim/view/report/lockstep.hpp"
#include "sim/view/report/tables.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

constexpr const char* default_bits = "12:20:2";

struct StressOptions {
    std::string scene, bits = default_bits, rays = "1e6", output, state;
    StreamChoice stream;
    static constexpr int default_chips = 4;
    std::optional<int> chips;
    std::vector<std::string> tests, families;
    std::uint64_t seed = default_seed;
    int threads = 0;
    JsonOutput json;
};

void declare_stress(Parser& parser, StressOptions& o) {
    scene_option(parser, o.scene);
    parser.option("--bits", o.bits, "lattices: bits of a coordinate, for example 12:20:2 or 16,18")
        .with_default();
    parser
        .option("--rays", o.rays,
                "rays for each of exact and sheared; baselines and controls get a tenth; or a file of rays, "
                ".npy or .rays, that meet SCENE on random chips, model and RTL in lockstep")
        .with_default();
    treatment_options(parser, o.stream);
    parser.option("--chips", o.chips, "with a file of rays: number of random chips; 4 by default")
        .within(1, 1000);
    parser.option("--test", o.tests, "primitive test, or all; may be repeated").by_commas();
    parser.option("--family", o.families, "family of hard cases; may be repeated; all by default")
        .by_commas();
    parser.option("--seed", o.seed, "seed of the rays").within(1, 1 << 30);
    parser.option("-o,--output", o.output,
                  "page to write (Markdown), with a picture of each family in a folder next to it");
    parser.option("--state", o.state,
                  "file that stores the progress; if it exists, the run continues from it");
    threads_option(parser, o.threads);
    json_option(parser, o.json);
}

stress::Plan make_plan(const StressOptions& o) {
    stress::Plan plan;
    plan.bits = parse_values("--bits", o.bits);
    for (const int bits : plan.bits)
        if (bits < 12 || bits > 20) throw UserError(fmt::format("--bits must lie in 12..20, not {}", bits));
    plan.rays = parse_rays(o.rays);
    plan.seed = o.seed;
    plan.threads = o.threads;
    plan.state = o.state;
    plan.tests = o.tests;
    plan.families = o.families;
    if (plan.tests.empty()) plan.tests = {"exact"};
    if (plan.tests == std::vector<std::string>{"all"}) {
        plan.tests.clear();
        for (const stress::NamedTest& test : stress::named_tests()) plan.tests.push_back(test.name);
    }
    if (plan.families.empty())
        for (const stress::Family& family : stress::families()) plan.families.push_back(family.name);
    for (const std::string& name : plan.tests) stress::named_test(name);
    for (const std::string& name : plan.families) stress::family(name);
    const auto twice = [](auto list, const char* option) {
        std::sort(list.begin(), list.end());
        const auto at = std::adjacent_find(list.begin(), list.end());
        if (at != list.end()) throw UserError(fmt::format("{}: {} is given twice", option, *at));
    };
    twice(plan.tests, "--test");
    twice(plan.families, "--family");
    twice(plan.bits, "--bits");
    return plan;
}

/// Returns true if --rays names a file, and not a number.
bool names_file(const std::string& rays) {
    const std::string kind = extension(rays);
    return kind == "npy" || kind == "rays";
}

nlohmann::ordered_json chip_json(const StreamChip& chip, const StreamChipRun& run) {
    const LockstepResult& r = run.lockstep;
    nlohmann::ordered_json judge;
    if (run.judged)
        judge = {{"rays", run.judged->rays}, {"wrong", run.judged->wrong}, {"first", run.judged->first}};
    return {{"seed", chip.seed},
            {"config", config_json_object(chip.config)},
            {"mhz", chip.khz / 1e3},
            {"cycles", r.model.cycles},
            {"events_compared", r.events_compared},
            {"value_mismatches", r.value_mismatches},
            {"account_mismatches", r.account_mismatches},
            {"cycle_gap", r.cycle_gap},
            {"first_divergence", divergence_json(r.first)},
            {"first_counter", counter_json(r.counter)},
            {"judge", judge}};
}

std::string chip_line(const StreamChip& chip, const StreamChipRun& run) {
    const LockstepResult& r = run.lockstep;
    std::string text = fmt::format(
        "  chip {}, {}, coord_bits={}, contexts={}, {:g} MHz: {} cycles, {} transfers compared, {}{}\n",
        chip.seed, name_of(chip.config.structure), chip.config.coord_bits, chip.config.contexts,
        chip.khz / 1e3, grouped(r.model.cycles), grouped(r.events_compared),
        r.agrees() ? "equal" : "DIFFERENT",
        !run.judged              ? ""
        : run.judged->wrong == 0 ? "; every ray judged right"
                                 : fmt::format("; {} rays wrong; {}", run.judged->wrong, run.judged->first));
    return r.agrees() ? text : text + lockstep_lines(r);
}

/// Runs a stream of rays on random chips.
int stress_stream(const StressOptions& o) {
    if (o.scene.empty()) throw UserError("SCENE is required with a file of rays");
    o.json.check();
    const Stopwatch watch;
    const Progress progress = terminal_progress(), stop = stopping(progress);
    const std::unique_ptr<const StreamInput> input = stream_input(o.scene, {}, o.stream, stop);
    const std::vector<StreamChip> chips =
        random_stream_chips(*input, o.seed, o.chips.value_or(StressOptions::default_chips), stop);
    parallel::for_each(chips.size(), o.threads, [&](std::size_t i) { build_rtl(chips[i].config); });
    if (!o.json.is_alone())
        fmt::print("{}: {}; {}: {} rays\n", input->scene().name, primitives_text(input->scene()),
                   printable(input->rays().name()), grouped(input->rays().size()));
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    std::size_t failed = 0;
    parallel::in_order(
        o.threads, [&](std::size_t i) { return i < chips.size() && !interrupted(); },
        [&](std::size_t i) {
            try {
                return std::pair(i, run_stream_chip(*input, chips[i], stopping({})));
            } catch (const Interrupted&) {   // the chips that are done still count
                return std::pair(i, StreamChipRun{});
            }
        },
        [&](const auto& made) {
            const auto& [i, run] = made;
            if (!run.judged) return;   // interrupted
            rows.push_back(chip_json(chips[i], run));
            failed += !run.is_good();
            if (!o.json.is_alone()) fmt::print("{}", chip_line(chips[i], run));
            if (progress) progress("chips", rows.size(), chips.size());
        });
    const bool is_partial = rows.size() < chips.size(), good = failed == 0 && !is_partial;
    if (!o.json.is_alone())
        fmt::print("  {} chips, {} failed\n  {} in {:.1f} s\n", rows.size(), failed,
                   good         ? "VERIFIED"
                   : is_partial ? "PARTIAL: interrupted"
                                : "FAILED",
                   watch.seconds());
    o.json.write({{"scene", scene_json(input->scene())},
                  {"stream", {{"file", input->rays().name()}, {"rays", input->rays().size()}}},
                  {"chips", rows},
                  {"failed", failed},
                  {"partial", is_partial},
                  {"host", {{"seconds", watch.seconds()}}}});
    return good ? 0 : 1;
}

int run_stress(const StressOptions& typed) {
    StressOptions o = typed;
    if (names_file(o.rays)) o.stream.rays = o.rays;
    if (traces_stream(o.stream, no_picture_options({{!o.tests.empty(), "--test"},
                                                    {!o.families.empty(), "--family"},
                                                    {o.bits != default_bits, "--bits"},
                                                    {!o.output.empty(), "--output"},
                                                    {!o.state.empty(), "--state"}})))
        return stress_stream(o);
    if (!o.scene.empty())
        throw UserError("stress takes the scene " + shown(o.scene) +
                        " only with --rays FILE: its hard cases have their own triangles");
    if (o.chips) throw UserError("--chips needs --rays FILE, a stream of rays on random chips");
    const stress::Plan plan = make_plan(o);
    o.json.check();
    if (!o.output.empty()) check_writable(o.output);
    if (!plan.state.empty()) check_replaceable(plan.state);
    const stress::StressResult outcome = stress::run(plan, terminal_progress());
    if (!o.json.is_alone()) fmt::print("{}", stress::text(plan, outcome));
    o.json.write(stress::json(plan, outcome));
    if (outcome.partial) return 1;
    if (!o.output.empty()) stress::write_page(o.output, plan, outcome);
    bool good = true;
    for (const std::string& name : plan.tests)
        good = good && stress::meets_demand(stress::named_test(name), outcome.cells);
    return good ? 0 : 1;
}

}   // namespace

Command stress_command() {
    return command("stress", "test hard cases against the exact oracle, or a stream on random chips",
                   "rayclock stress --bits 12:20:2 --rays 1e9 --state run.json    (continues after an "
                   "interruption)",
                   declare_stress, run_stress);
}

}   // namespace rayclock
