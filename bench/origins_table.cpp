// Measures how often each scheme of secondary-ray origins errs, and the bits it needs: the tables at the end
// of docs/proofs/origins.md.
//
// rc_origins PAGE [rays per scheme, scene and width]: replaces everything after the page's line `<!--
// measured -->` with the tables.
#include <charconv>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "model/unit/tri/origin.hpp"
#include "sim/explore/stress/shadow_scenes.hpp"
#include "sim/explore/stress/shadows.hpp"
#include "sim/files/process/parallel.hpp"
#include "sim/view/report/text.hpp"

using namespace rayclock;

namespace {

using Method = OriginScheme::Method;
const std::vector<OriginScheme> schemes{{Method::excluded, 0}, {Method::pushed, 0},  {Method::epsilon, 16},
                                        {Method::surface, 4},  {Method::surface, 6}, {Method::surface, 8},
                                        {Method::surface, 12}, {Method::surface, 16}};
constexpr std::array bits{12, 14, 16, 18, 20};

/// counts[scheme][scene][width]
using Counts = std::vector<std::vector<std::array<ShadowCounts, bits.size()>>>;

Counts count_all(std::uint64_t rays) {
    const auto& scenes = shadow_scenes();
    Counts counts(schemes.size(), std::vector<std::array<ShadowCounts, bits.size()>>(scenes.size()));
    parallel::for_each(scenes.size() * bits.size(), 0, [&](std::size_t job) {
        const std::size_t scene = job / bits.size(), width = job % bits.size();
        const Shadows world(scenes[scene].make(bits[width]), bits[width]);
        for (std::size_t s = 0; s < schemes.size(); ++s)
            counts[s][scene][width] = world.count(1000 + job, rays, schemes[s]);
        fmt::print(stderr, "{}, N = {}\n", scenes[scene].name, bits[width]);
    });
    return counts;
}

double per_million(std::uint64_t count, std::uint64_t rays) {
    return rays == 0 ? 0 : 1e6 * double(count) / double(rays);
}
ShadowCounts sum_of(const std::array<ShadowCounts, bits.size()>& all) {
    ShadowCounts sum;
    for (const ShadowCounts& c : all) sum += c;
    return sum;
}

std::vector<std::string> row(const std::string& name, const ShadowCounts& c, bool surface) {
    const auto moved = [&](std::uint64_t count) {
        return surface ? fmt::format("{:.0f}", per_million(count, c.rays)) : "-";
    };
    return {name,
            std::to_string(c.rays),
            std::to_string(c.false_shadows),
            std::to_string(c.light_leaks),
            fmt::format("{:.1f}", per_million(c.either, c.rays)),
            moved(c.moved_shadows),
            moved(c.moved_leaks)};
}
Table table_by(const char* what) {
    return Table({what, "rays", "false shadows", "light leaks", "either, per million",
                  "moved shadows, per million", "moved leaks, per million"},
                 Table::words_only);
}

/// Returns false shadows and light leaks of each scheme, by scene.
Table table_by_scene(const Counts& counts) {
    std::vector<std::string> head{"scene"};
    for (const OriginScheme& s : schemes) head.push_back(s.name());
    Table table(head, Table::words_only);
    const auto& scenes = shadow_scenes();
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        std::vector<std::string> cells{fmt::format("{}: {}", scenes[i].name, scenes[i].what)};
        for (std::size_t s = 0; s < schemes.size(); ++s) {
            const ShadowCounts sum = sum_of(counts[s][i]);
            cells.push_back(fmt::format("{:.0f}, {:.0f}", per_million(sum.false_shadows, sum.rays),
                                        per_million(sum.light_leaks, sum.rays)));
        }
        table.add(cells);
    }
    return table;
}

std::string measured(const Counts& counts) {
    const auto& scenes = shadow_scenes();
    Table by_scheme = table_by("scheme"), by_scene = table_by("on the surface, B = 12, by scene");
    for (std::size_t s = 0; s < schemes.size(); ++s) {
        ShadowCounts sum;
        for (const auto& scene : counts[s]) sum += sum_of(scene);
        by_scheme.add(row(schemes[s].name(), sum, schemes[s].method == Method::surface));
    }
    for (std::size_t i = 0; i < scenes.size(); ++i)
        by_scene.add(row(scenes[i].name, sum_of(counts[6][i]), true));
    return "\n" + by_scheme.markdown() + "\n" + by_scene.markdown() +
           "\nFalse shadows, light leaks per million rays, by scene:\n\n" + table_by_scene(counts).markdown();
}

/// Returns the number of 18 x 18 multipliers for a signed product. Each multiplier takes 17 bits of a number;
/// the highest one takes 18.
int multipliers(int one, int other) { return ((one - 2) / 17 + 1) * ((other - 2) / 17 + 1); }
/// P1, P2: 12 products of d and e. u, v: 6 of P and s. e1 x e2: 6. num: 3 of that cross product and s.
int multipliers(int coord_bits, const RayWidths& w) {
    const int e = coord_bits + 1, p = w.direction + e;
    return 12 * multipliers(w.direction, e) + 6 * multipliers(p, w.offset) + 6 * multipliers(e, e) +
           3 * multipliers(2 * e, w.offset);
}

std::string widths() {
    Table table({"N", "B", "O", "bounce: s", "u, v, w", "num", "num det'", "shadow: d", "u, v, w", "num",
                 "multipliers"},
                Table::words_only);
    for (const int n : bits)
        for (const int b : {4, 6, 8, 10, 12, 16}) {
            const RayWidths camera = bounce_widths(n, n + 2, 0), bounce = bounce_widths(n, n + 2, b),
                            shadow = shadow_widths(n, b);
            std::vector<std::string> cells;
            for (const int width : {n, b, bounce.point, bounce.offset, bounce.edge, bounce.num,
                                    bounce.num + bounce.det, shadow.direction, shadow.edge, shadow.num})
                cells.push_back(std::to_string(width));
            cells.push_back(fmt::format("{}, {}, {}", multipliers(n, camera), multipliers(n, bounce),
                                        multipliers(n, shadow)));
            table.add(cells);
        }
    return "\nBits, with M = N + 2; 18 x 18 multipliers of the triangle test with a camera ray, a bounce and "
           "a shadow ray:\n\n" +
           table.markdown();
}

}   // namespace

int main(int argc, char** argv) {
    std::uint64_t rays = 40000;
    const std::string count = argc > 2 ? argv[2] : "40000", marker = "<!-- measured -->\n";
    const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), rays);
    if (argc < 2 || argc > 3 || error != std::errc() || end != count.data() + count.size()) {
        fmt::print(stderr, "usage: rc_origins PAGE [rays per scheme, scene and width]\n");
        return 2;
    }
    std::stringstream text;
    text << std::ifstream(argv[1]).rdbuf();
    const std::size_t at = text.str().find(marker);
    if (at == std::string::npos) {
        fmt::print(stderr, "{}: there is no line {}", argv[1], marker);
        return 2;
    }
    const Counts counts = count_all(rays);
    std::ofstream page(argv[1]);
    page << text.str().substr(0, at + marker.size()) << measured(counts) << widths();
    return page.flush() ? 0 : 2;
}
