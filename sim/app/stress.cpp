// rayclock stress: runs families of hard cases on many lattices, judged by the oracle.
#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/run/engine/engine.hpp"
#include "sim/files/image/image.hpp"
#include "sim/study/hard_cases.hpp"
#include "sim/view/report/text.hpp"
#include "sim/explore/stress/report.hpp"

namespace rayclock {

namespace {

struct StressOptions {
    std::string bits = "12:20:2", rays = "1e6", output, state;
    std::vector<std::string> tests, families;
    std::uint64_t seed = default_seed;
    int threads = 0;
    JsonOutput json;
};

void declare_stress(Parser& parser, StressOptions& o) {
    parser.option("--bits", o.bits, "lattices: bits of a coordinate, for example 12:20:2 or 16,18")
        .with_default();
    parser.option("--rays", o.rays, "rays for each of exact and sheared; baselines and controls get a tenth")
        .with_default();
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

int run_stress(const StressOptions& o) {
    const stress::Plan plan = make_plan(o);
    o.json.check();
    if (!o.output.empty()) check_writable(o.output);
    if (!plan.state.empty()) check_replaceable(plan.state);
    const stress::Outcome outcome = stress::run(plan, terminal_progress());
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
    return command("stress", "test numerical hard cases against the exact oracle",
                   "rayclock stress --bits 12:20:2 --rays 1e9 --state run.json    (continues after an "
                   "interruption)",
                   declare_stress, run_stress);
}

}   // namespace rayclock
