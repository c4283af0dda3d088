// Writes docs/measured/hard-cases.md from a stress run.
#include "sim/study/hard_cases.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "sim/explore/stress/sketch.hpp"
#include "sim/explore/stress/stress_report.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock::stress {

namespace {

namespace fs = std::filesystem;

constexpr const char* beginning = R"(# Hard cases

{} rays in families made to break ray-triangle tests, on lattices of {} bits a coordinate, each family at
several scales. The exact oracle judges each ray. Made by

    {}

which gives the same figures every time. `rayclock stress --rays 1e9 --state run.json` is a long run that can
be stopped and continued.

## What is counted

Both the test and the oracle judge every triangle that a ray may meet. The oracle (`sim/judge/oracle`)
computes signed volumes in 128 bits, and its own search provably skips no triangle. 256-bit integers and
fractions judge the oracle in turn.

- **leak**: a ray crosses a closed surface, and the test finds no hit in the same sense on the crossed
  triangle or on one that shares a corner with it.
- **double hit**: a hit without a crossing. Two of opposite sense that share a corner cancel: the ray grazes.
- **Sum of crossings**, independent of the oracle's decisions: inward minus outward crossings must be minus
  the number of bodies around the origin. `sheared` moves corners by up to a lattice step, so only this sum
  judges it, with origins clear of the surface.
- **oracle mismatch**: a decision about a triangle that differs from the exact one, or (every 16th ray)
  another closest hit at the end of the machine's own walk through the tree.
- **false shadow, light leak**: a secondary ray from the surface, by the machine's scheme of origins, that is
  blocked although its way is free, or the reverse. There is one for every 64 rays. [origins.md](../proofs/origins.md)
  has the scheme and its proof.
- **extra boxes**: child boxes that a walk visits although the ray misses them, divided by those that the ray
  meets; for rays whose direction fills its bits. A walk must not leave out a box that the ray meets.
  [boxes.md](../proofs/boxes.md) has the proof and the cost on real scenes.

In integers a zero component of a direction has no sign, so -0 gives the same ray as 0.

)";

std::string per_million(std::uint64_t count, std::uint64_t rays) {
    if (rays == 0) return "";
    return count == 0 ? "0"
                      : fmt::format("{:.{}f}", 1e6 * double(count) / double(rays),
                                    1e6 * double(count) / double(rays) < 10 ? 1 : 0);
}

/// Returns leaks and double hits of each test on selected families.
std::string tests_table(const Plan& plan, const StressResult& outcome) {
    const std::vector<std::pair<const char*, std::vector<std::string>>> groups{
        {"random", {"random"}},          {"edges", {"edges"}},
        {"corners", {"corners"}},        {"needles", {"needles", "slivers"}},
        {"stadium", {"stadium", "far"}}, {"all closed", {}}};
    std::vector<std::string> head{"test"};
    for (const auto& group : groups) head.emplace_back(group.first);
    head.insert(head.end(), {"not exact", "verdict"});
    Table table(head, Table::words_only);
    for (const std::string& name : plan.tests) {
        const NamedTest& test = named_test(name);
        std::vector<std::string> row{name};
        for (const auto& group : groups) {
            const Counts c = sum(outcome.cells, [&](const Cell& cell) {
                if (cell.test != name || !family(cell.family).closed || family(cell.family).leaks)
                    return false;
                return group.second.empty() ||
                       std::find(group.second.begin(), group.second.end(), cell.family) != group.second.end();
            });
            row.push_back(
                fmt::format("{} / {}", per_million(c.leaks, c.rays), per_million(c.double_hits, c.rays)));
        }
        const Counts all = sum(
            outcome.cells, [&](const Cell& cell) { return cell.test == name && !family(cell.family).leaks; });
        row.push_back(per_million(all.oracle_mismatches, all.rays));
        row.emplace_back(verdict(test, outcome.cells));
        table.add(row);
    }
    std::string out =
        "## The tests\n\nLeaks / double hits per million rays, and decisions that differ from the exact "
        "ones. Baselines and controls get a tenth of the rays of exact and sheared. The run must detect the "
        "fault in each control.\n\n" +
        table.markdown() + "\n";
    for (const std::string& name : plan.tests)
        out += fmt::format("- `{}`: {}\n", name, named_test(name).what);
    return out +
           "\n`t_junction`, a surface with seams that do not fit, is left out of this table: it must leak "
           "under every test.\n\n";
}

std::string bits_table(const Plan& plan, const StressResult& outcome, const std::string& test) {
    Table table({"N", "rays", "leaks", "double hits", "oracle mismatches", "false shadows", "light leaks",
                 "extra boxes"},
                Table::words_only);
    const auto add = [&](const std::string& name, const Counts& c, const std::string& shadows) {
        table.add({name, grouped(c.rays), std::to_string(c.leaks), std::to_string(c.double_hits),
                   std::to_string(c.oracle_mismatches), shadows, std::to_string(c.light_leaks),
                   extra_boxes(c)});
    };
    for (const int bits : plan.bits) {
        const Counts c = sum(outcome.cells, [&](const Cell& cell) {
            return cell.test == test && cell.bits == bits && !family(cell.family).leaks;
        });
        add(std::to_string(bits), c, std::to_string(c.false_shadows));
    }
    const Counts c =
        sum(outcome.cells, [&](const Cell& cell) { return cell.test == test && !family(cell.family).leaks; });
    add("all", c, fmt::format("{} of {}", c.false_shadows, grouped(c.shadow_rays)));
    return fmt::format("## The {} test, by lattice\n\n{}\n", test, table.markdown());
}

std::string family_part(const Family& which, const StressResult& outcome, const std::string& test,
                        const std::string& picture) {
    const Counts c =
        sum(outcome.cells, [&](const Cell& cell) { return cell.test == test && cell.family == which.name; });
    std::string what = which.what;
    what[0] = char(std::toupper(what[0]));
    const std::string crossings =
        which.closed ? fmt::format("{} leaks, {} double hits", grouped(c.leaks), grouped(c.double_hits))
                     : "an open surface, whose leaks and double hits are not counted";
    return fmt::format("### {}\n\n{}.\n\n![{}]({})\n\n{} rays: {}, {} oracle mismatches{}{}.\n\n", which.name,
                       what, which.name, picture, grouped(c.rays), crossings, grouped(c.oracle_mismatches),
                       c.shadow_rays > 0
                           ? fmt::format("; {} of {} secondary rays wrong", c.false_shadows + c.light_leaks,
                                         grouped(c.shadow_rays))
                           : "",
                       c.boxes > 0 ? fmt::format("; {} extra boxes", extra_boxes(c)) : "");
}

std::string command_of(const Plan& plan) {
    std::string bits;
    for (const int b : plan.bits) bits += (bits.empty() ? "" : ",") + std::to_string(b);
    std::string tests;
    for (const std::string& t : plan.tests) tests += (tests.empty() ? "" : ",") + t;
    return fmt::format(
        "rayclock stress --test {} --bits {} --rays {} --seed {} -o docs/measured/hard-cases.md",
        plan.tests.size() == named_tests().size() ? "all" : tests, bits, plan.rays, plan.seed);
}

}   // namespace

void write_page(const std::string& path, const Plan& plan, const StressResult& outcome) {
    const fs::path page(path);
    const std::string folder_name = page.stem().string();
    const fs::path folder = page.parent_path() / folder_name;
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw UserError(folder.string() + ": cannot be made (" + error.message() + ")");
    std::string out =
        fmt::format(beginning, grouped(outcome.rays), fmt::join(plan.bits, ", "), command_of(plan));
    out += tests_table(plan, outcome);
    const std::string& first = plan.tests.front();
    out += bits_table(plan, outcome, first);
    out += fmt::format(
        "## The families\n\nLeft: the surface with some of the family's rays. Right: the point where one of "
        "them hits. The generators drew both at N = 16. Dots are crossings, filled where the ray enters. The "
        "figures are those of the {} test.\n\n",
        first);
    for (const std::string& name : plan.families) {
        write_file((folder / (name + ".svg")).string(), sketch(family(name)));
        out += family_part(family(name), outcome, first, folder_name + "/" + name + ".svg");
    }
    write_file(path, out.substr(0, out.size() - 1));
}

}   // namespace rayclock::stress
