// The stage in which test cases judge the faults that the torture set has missed.
#include <chrono>
#include <cstdlib>
#include <sys/wait.h>

#include <fmt/format.h>

#include "tests/meta/campaign/copies.hpp"
#include "tests/meta/campaign/stages.hpp"
#include "tests/meta/campaign/state.hpp"

namespace rayclock::campaign {

namespace fs = std::filesystem;

namespace {

/// Tags of the unit tests that are about a file, by how its name begins; the first that fits counts.
struct Fitting {
    const char *file, *tags;
};
constexpr Fitting fitting[] = {
    {"rtl/unit/trav/rc_stack", "trav"},
    {"rtl/unit/trav/rc_trav", "trav"},
    {"rtl/engine/rc_tree", "machine"},
    {"rtl/engine/rc_node_answer", "globe"},
    {"rtl/engine/space_cells/", "treelet"},
    {"rtl/engine/bsp/", "slant"},
    {"rtl/engine/bvh/", "box"},
    {"rtl/engine/spheres/", "globe"},
    {"rtl/engine/kd/", "treelet"},
    {"rtl/engine/none/", "machine"},
    {"rtl/unit/tri/", "tri"},
    {"rtl/unit/list/", "list"},
    {"rtl/mem/rc_arbiter", "machine"},
    {"rtl/mem/", "cache"},
    {"rtl/unit/raygen/", "raygen"},
    {"rtl/unit/sched/rc_dispatch", "dispatch"},
    {"rtl/unit/sched/", "sched"},
    {"rtl/fixed/rc_unit_vector", "unit_vector"},
    {"rtl/fixed/rc_power", "power"},
    {"rtl/fixed/rc_t_best", "trav"},
    {"rtl/fixed/rc_recip", "raygen"},
    {"rtl/fixed/", "tri"},
    {"rtl/unit/xform/", "xform"},
    {"rtl/unit/shade/rc_shade", "shade"},
    {"rtl/unit/shade/pass/rc_contexts", "shade"},
    {"rtl/unit/shade/", "pass"},
    {"rtl/unit/tex/", "tex"},
    {"rtl/cells/delays/rc_delay_ram", "pass"},
    {"rtl/cells/", "list"},
    {"rtl/", "machine"},
    {"model/engine/box_ray", "box"},
    {"model/engine/node_answer", "box"},
    {"model/engine/space_cells/decide", "treelet"},
    {"model/engine/space_cells/", "machine"},
    {"model/engine/bvh/box", "box"},
    {"model/engine/bvh/slab", "box"},
    {"model/engine/bvh/", "trav"},
    {"model/engine/bsp/", "slant"},
    {"model/engine/spheres/", "globe"},
    {"model/engine/kd/treelet", "treelet"},
    {"model/engine/kd/", "machine"},
    {"model/engine/octree/", "machine"},
    {"model/engine/none/", "machine"},
    {"model/unit/tri/origin", "origin"},
    {"model/unit/tri/any_primitive", "any"},
    {"model/unit/tri/", "tri"},
    {"model/unit/list/", "list"},
    {"model/unit/raygen/", "raygen"},
    {"model/unit/xform/xform", "xform"},
    {"model/unit/shade/light/approach", "approach"},
    {"model/fixed/unit", "unit_vector"},
    {"model/fixed/power", "power"},
    {"model/fixed/square", "square_root"},
    {"model/unit/shade/", "pass"},
    {"model/unit/tex/", "tex"},
};

std::string tag_of(const std::string& file) {
    for (const Fitting& f : fitting)
        if (file.starts_with(f.file)) return f.tags;
    // The tests of another engine have the tag of its folder.
    for (const std::string_view rooms : {"rtl/engine/", "model/engine/"})
        if (file.starts_with(rooms))
            return file.substr(rooms.size(), file.find('/', rooms.size()) - rooms.size());
    return "machine";
}

struct Step {
    std::string program, cases;
};

/// Returns the cases that run on a fault in `file`, the likeliest first. `slow`: the cases tagged [slow];
/// otherwise all others.
std::vector<Step> steps_for(const std::string& file, bool slow) {
    const std::string tag = tag_of(file);
    if (slow)
        return {{"rc_unit_tests", fmt::format("[{}][slow]", tag)},
                {"rc_system_tests", "[slow]"},
                {"rc_unit_tests", "[slow]"}};
    if (!file.starts_with("rtl/"))   // what needs no RTL first
        return {{"rc_unit_tests", fmt::format("[{}]~[slow]~[lockstep]~*Rtl*", tag)},
                {"rc_unit_tests", "~[slow]~[lockstep]~[rtl]~*Rtl*"},
                {"rc_unit_tests", fmt::format("[{}]~[slow]", tag)},
                {"rc_system_tests", "~[slow]"}};
    return {{"rc_unit_tests", fmt::format("[{}]~[slow]", tag)},
            {"rc_unit_tests", "~[slow]"},
            {"rc_system_tests", "~[slow]"}};
}

class Runner {
public:
    Runner(fs::path folder, fs::path programs, bool is_rtl)
        : folder_(std::move(folder)), programs_(std::move(programs)), is_rtl_(is_rtl) {}

    /// Runs the steps until one fails. Time is the processor's, so that a busy machine changes no verdict.
    Verdict operator()(int number, const std::vector<Step>& steps) const {
        const auto start = std::chrono::steady_clock::now();
        Verdict verdict;
        if (is_rtl_)
            caller_of(folder_).call(number);
        else
            setenv("RC_FAULT", std::to_string(number).c_str(), 1);
        for (const Step& step : steps) {
            const int status =
                shell(fmt::format("ulimit -t 1200; '{}/{}' '{}' --abort > '{}/log' 2>&1", programs_.string(),
                                  step.program, step.cases, folder_.string()));
            verdict.noticed = status != 0;
            verdict.by = fmt::format("{} {}: {}", step.program, step.cases, failed_case());
            if (text_of(folder_ / "log").find("No test") != std::string::npos && status == 0) continue;
            if (verdict.noticed) break;
        }
        if (is_rtl_) caller_of(folder_).call(0);
        verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return verdict;
    }

private:
    /// The name of the case that failed, as Catch2 prints it between two lines of dashes.
    std::string failed_case() const {
        const std::string log = text_of(folder_ / "log");
        const std::size_t line = log.find("\n---"), from = log.find('\n', line + 1);
        if (line == std::string::npos || from == std::string::npos) return "";
        return log.substr(from + 1, log.find('\n', from + 1) - from - 1);
    }

    fs::path folder_, programs_;
    bool is_rtl_;
};

}   // namespace

void test_survivors(const fs::path& folder, const fs::path& build, const fs::path& page, bool slow) {
    const bool is_rtl = fs::exists(folder / "rtl");
    const Lines mutants = lines_of(folder / "mutants"), tortured = lines_of(folder / "torture"),
                quick = lines_of(folder / "quick");
    const fs::path results = folder / (slow ? "slow" : "quick");
    const Lines done = lines_of(results);
    if (is_rtl)
        use_rtl_copy(folder);
    else
        for (const char* program : {"tests/rc_unit_tests", "tests/rc_system_tests"})
            if (!fs::exists(folder / fs::path(program).filename())) link_with_faults(folder, build, program);
    const std::set<std::string> same = argued(page);
    const Runner run(folder, is_rtl ? build / "tests" : folder, is_rtl);
    std::set<std::string> sound;   // tests that pass with every fault asleep
    for (const auto& [number, mutant] : mutants) {
        if (number > first_row || !tortured.contains(number) || is_noticed(tortured, number) ||
            done.contains(number))
            continue;
        if ((slow && is_noticed(quick, number)) || same.contains(description(mutant))) continue;
        const std::vector<Step> steps = steps_for(mutant[1], slow);
        for (const Step& step : steps) {
            if (!sound.insert(step.program + step.cases).second) continue;
            if (const Verdict v = run(0, {step}); v.noticed)
                throw std::runtime_error("with every fault asleep this fails: " + v.by);
            else
                fmt::print("sound in {:.1f} s: {} {}\n", v.seconds, step.program, step.cases);
            std::fflush(stdout);
        }
        const Verdict verdict = run(number, steps);
        append(results, number, verdict);
        fmt::print("{} in {:.1f} s: {} {}\n", verdict.noticed ? "noticed" : "SURVIVED", verdict.seconds,
                   description(mutant), verdict.noticed ? verdict.by : "");
        std::fflush(stdout);
    }
}

}   // namespace rayclock::campaign
