#include "sim/app/tables.hpp"

#include <cmath>

#include <fmt/format.h>

#include "sim/report/accounts.hpp"
#include "sim/report/text.hpp"

namespace rayclock {

std::string heading(const Scene& scene, FrameSize size, const Job& job) {
    const CompileReport& r = job.image.report;
    std::string text = fmt::format("{}: {} triangles, {}x{} pixels, configuration {}\n", scene.name, grouped(scene.triangles.size()), size.width,
                                   size.height, job.config.name);
    text += fmt::format("  memory image {} bytes: {} nodes, depth {}, stack {} of {}; lattice pitch {:.3g} scene units at {} bits", grouped(r.bytes),
                        grouped(r.nodes), r.depth, r.stack_need, job.config.stack_depth, r.pitch, job.config.coord_bits);
    if (r.collapsed) text += fmt::format("; {} triangles have no area on it and are left out", grouped(r.collapsed));
    return text + "\n";
}

std::string work_table(const FrameRun& run) {
    const double rays = double(run.hits.hits.size());
    const Bound bound = bound_of(run);
    const auto per_ray = [&](std::uint64_t n) { return fmt::format("{:.2f}", double(n) / rays); };
    Table table({"work", "frame", "per ray"});
    table.add({"rays", grouped(run.hits.hits.size()), "1"});
    table.add({"cycles", grouped(run.cycles), per_ray(run.cycles)});
    table.add({"node visits", grouped(node_steps(run)), per_ray(node_steps(run))});
    table.add({"box tests", grouped(run.box_tests), per_ray(run.box_tests)});
    table.add({"triangle tests", grouped(triangle_tests(run)), per_ray(triangle_tests(run))});
    table.add({"bytes read", grouped(bytes_read(run)), per_ray(bytes_read(run))});
    return table.text() + fmt::format("  bound: {} {}, {:.0f} % of it reached\n", grouped(bound.cycles),
                                      bound.unit == "trav" ? "node visits" : "triangle tests", bound.reached * 100);
}

std::string clock_table(const FrameRun& run, const std::vector<double>& clocks) {
    Table table({"clock MHz", "cycles", "fps", "Mrays/s", "memory GB/s"});
    for (const double mhz : clocks) {
        const double fps = mhz * 1e6 / double(run.cycles);
        table.add({fmt::format("{:g}", mhz), grouped(run.cycles), fmt::format("{:.2f}", fps),
                   fmt::format("{:.2f}", fps * double(run.hits.hits.size()) / 1e6), fmt::format("{:.3f}", fps * double(bytes_read(run)) / 1e9)});
    }
    return table.text();
}

std::string unit_table(const FrameRun& run) {
    const auto percent = [&](std::uint64_t n) { return fmt::format("{:.1f} %", 100 * double(n) / double(run.cycles)); };
    Table table({"unit", "count", "busy", "starved", "stalled", "by"});
    for (const UnitAccount& a : unit_accounts(run.counts, run.cycles))
        table.add({a.unit, grouped(a.count), percent(a.busy), percent(a.starved), percent(a.stalled), a.stalled ? a.cause : ""});
    return table.text();
}

std::string error_line(const char* who, const FrameError& e) {
    return fmt::format("  {}: {} of {} pixels hold another primitive ({:.3f} %), PSNR {}, largest depth error {:.3g} scene units\n", who,
                       grouped(e.pixels_other_primitive), grouped(e.pixels), 100 * double(e.pixels_other_primitive) / double(e.pixels),
                       std::isfinite(e.psnr_db) ? fmt::format("{:.1f} dB", e.psnr_db) : "infinite (equal)", e.max_abs_depth);
}

} // namespace rayclock
