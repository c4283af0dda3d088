// rayclock stress: families of hard cases, on many lattices, judged by the oracle.
#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "model/core/error.hpp"
#include "sim/app/commands.hpp"
#include "sim/engine/engine.hpp"
#include "sim/image/image.hpp"
#include "sim/report/text.hpp"
#include "sim/stress/page.hpp"
#include "sim/stress/report.hpp"

namespace rayclock {

namespace {

stress::Plan make_plan(const Options& o) {
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
        if (at != list.end()) throw UserError(fmt::format("{}: {} stands there twice", option, *at));
    };
    twice(plan.tests, "--test");
    twice(plan.families, "--family");
    twice(plan.bits, "--bits");
    return plan;
}

} // namespace

int stress_command(const Options& o) {
    catch_interrupts();
    const stress::Plan plan = make_plan(o);
    check_outputs(o);
    if (!o.output.empty()) check_writable(o.output);
    if (!plan.state.empty()) check_replaceable(plan.state);
    const stress::Outcome outcome = stress::run(plan, terminal_progress());
    if (o.json != "-") fmt::print("{}", stress::text(plan, outcome));
    if (!o.json.empty()) write_file(o.json, stress::json(plan, outcome).dump(2) + "\n");
    if (outcome.partial) return 1;
    if (!o.output.empty()) stress::write_page(o.output, plan, outcome);
    bool good = true;
    for (const std::string& name : plan.tests) good = good && stress::meets_demand(stress::named_test(name), outcome.cells);
    return good ? 0 : 1;
}

} // namespace rayclock
