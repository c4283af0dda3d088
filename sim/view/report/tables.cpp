// Formats reports as text tables.
#include "sim/view/report/tables.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "model/scene/folded.hpp"
#include "sim/view/report/accounts.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

std::string primitives_text(const PrimitiveCounts& counts) {
    std::string text;
    const auto add = [&](std::uint64_t n, const char* one, const char* many) {
        if (n > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", grouped(n), n == 1 ? one : many);
    };
    add(counts.triangles, "triangle", "triangles");
    add(counts.spheres, "sphere", "spheres");
    add(counts.planes, "plane", "planes");
    return text;
}

std::string primitives_text(const Scene& scene) {
    return primitives_text(PrimitiveCounts{triangle_count(scene), scene.spheres.size(), scene.planes.size()});
}

std::string heading(const Scene& scene, FrameSize size, const Job& job) {
    const CompileReport& r = job.image.report;
    std::string part;
    if (const auto& w = scene.camera->window)
        part = fmt::format(", at {},{} in a picture of {}x{}", w->x, w->y, w->whole_width, w->whole_height);
    std::string text = fmt::format("{}: {}, {}x{} pixels{}, configuration {}\n", scene.name,
                                   primitives_text(scene), size.width, size.height, part, job.config.name);
    text += fmt::format(
        "  memory image {} bytes: {} nodes, depth {}, stack {} of {}; lattice pitches {:.3g}, {:.3g}, {:.3g} "
        "scene units at {} bits",
        grouped(r.bytes), grouped(r.nodes), r.depth, r.stack_need, job.config.stack_depth, r.pitch.x,
        r.pitch.y, r.pitch.z, job.config.coord_bits);
    if (r.collapsed)
        text += fmt::format("; {} triangles have no area on it and are left out", grouped(r.collapsed));
    if (r.coincident)
        text += fmt::format("; {} coincide{} with another and {} left out",
                            r.coincident == 1 ? "1 sphere" : grouped(r.coincident) + " spheres",
                            r.coincident == 1 ? "s" : "", r.coincident == 1 ? "is" : "are");
    return text + "\n";
}

std::string work_table(const Config& config, const FramesAtClock& run) {
    const FrameResult& frame = run.last();
    const double rays = std::max(1.0, rays_of(frame));
    Table table({"work", "frame", "per ray"});
    const auto add = [&](const char* what, std::uint64_t n) {
        table.add({what, grouped(n), fmt::format("{:.2f}", double(n) / rays)});
    };
    if (frame.finished_picture) {
        const RayCounts& r = frame.rays;
        table.add({"pixels", grouped(frame.pixels), ""});
        add("camera rays", r.primary);
        add("shadow rays", r.shadow);
        add("reflected rays", r.reflection);
        add("refracted rays", r.refraction);
    }
    table.add({"rays", grouped(std::uint64_t(rays_of(frame))), "1"});
    add("node visits", frame.visits);
    add("box tests", frame.box_tests);
    add("triangle tests", frame.triangle_tests);
    add("bytes from memory", bytes_read(frame));
    return table.text() +
           fmt::format("  at {:g} MHz {}\n", run.khz / 1e3, bottleneck(config, run.khz, frame));
}

std::string clock_table(const Config& config, const std::vector<FramesAtClock>& runs) {
    Table table({"clock MHz", "frame", "cycles", "fps", "Mrays/s", "cycles/ray", "node hits", "tri hits",
                 "bytes/ray", "memory GB/s", "of peak", "bound", "reached"});
    const auto row = [&](const FramesAtClock& run, std::size_t i) {
        const FrameResult& f = run.frames[i];
        const double fps = per_second(f, run.khz), bytes = double(bytes_read(f)),
                     rays = std::max(1.0, rays_of(f));
        const Bound bound = bound_of(config, run.khz, f);
        const auto percent = [](double share) { return fmt::format("{:.1f} %", share * 100); };
        table.add({fmt::format("{:g}", run.khz / 1e3),
                   std::to_string(i + 1) + (f.partial ? " (partial)" : ""), grouped(f.cycles),
                   fmt::format("{:.2f}", fps), fmt::format("{:.2f}", fps * rays_of(f) / 1e6),
                   fmt::format("{:.2f}", double(f.cycles) / rays),
                   percent(cache_account(f, Unit::node_cache).hit_rate()),
                   percent(cache_account(f, Unit::prim_cache).hit_rate()),
                   fmt::format("{:.1f}", bytes / rays), fmt::format("{:.3f}", fps * bytes / 1e9),
                   percent(fps * bytes / peak_bytes_per_second(config, run.khz)), bound.unit,
                   fmt::format("{:.0f} %", bound.reached * 100)});
    };
    for (const FramesAtClock& run : runs)
        for (std::size_t i = 0; i < run.frames.size(); ++i) row(run, i);
    return table.text();
}

std::string unit_table(const Config& config, const std::vector<FramesAtClock>& runs) {
    std::vector<std::string> head{"unit", "cycles spent"};
    for (const FramesAtClock& run : runs) head.push_back(fmt::format("{:g} MHz", run.khz / 1e3));
    Table table(head, 2);
    std::vector<std::vector<UnitAccount>> accounts;
    for (const FramesAtClock& run : runs) accounts.push_back(unit_accounts(config, run.last()));
    for (std::size_t u = 0; u < accounts[0].size(); ++u) {
        bool named = false;
        const auto row = [&](const std::string& what, auto cycles) {
            std::vector<std::string> cells{named ? "" : accounts[0][u].unit, what};
            bool matters = false;
            for (std::size_t r = 0; r < runs.size(); ++r) {
                const double share = double(cycles(accounts[r][u])) /
                                     std::max(1.0, double(runs[r].last().cycles) * accounts[r][u].instances);
                matters = matters || share >= 0.0005;
                cells.push_back(fmt::format("{:.1f} %", 100 * share));
            }
            if (!matters) return;
            table.add(cells);
            named = true;
        };
        row("busy", [](const UnitAccount& a) { return a.busy; });
        for (std::size_t i = 0; i < accounts[0][u].starved_by.size(); ++i)
            row("starved by " + accounts[0][u].starved_by[i].cause,
                [&](const UnitAccount& a) { return a.starved_by[i].cycles; });
        for (std::size_t i = 0; i < accounts[0][u].stalled_by.size(); ++i)
            row("stalled by " + accounts[0][u].stalled_by[i].cause,
                [&](const UnitAccount& a) { return a.stalled_by[i].cycles; });
    }
    return table.text();
}

std::string error_line(const char* who, const FrameError& e) {
    return fmt::format(
        "  {}: {} of {} pixels hold another primitive ({:.3f} %), PSNR {}, "
        "largest depth error {:.3g} scene units over {} pixels that hold the same primitive\n",
        who, grouped(e.pixels_other_primitive), grouped(e.pixels),
        100 * double(e.pixels_other_primitive) / double(e.pixels),
        std::isfinite(e.psnr_db) ? fmt::format("{:.1f} dB", e.psnr_db) : "infinite (equal)", e.max_abs_depth,
        grouped(e.depth_pixels));
}

std::string cause_lines(const Judgement& j) {
    const auto list = [](const PixelCauses& causes) {
        std::string text;
        for (std::size_t k = 0; k < pixel_causes; ++k) {
            const bool is_rare = PixelCause(k) == PixelCause::primitive_test ||
                                 PixelCause(k) == PixelCause::seam || PixelCause(k) == PixelCause::texture ||
                                 PixelCause(k) == PixelCause::horizon;
            if (is_rare && causes[k] == 0) continue;
            std::string name = cause_info(PixelCause(k)).key;
            std::replace(name.begin(), name.end(), '_', ' ');
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", grouped(causes[k]), name);
        }
        return text;
    };
    std::string text = fmt::format("  causes: {}\n    where another primitive is held: {}", list(j.causes),
                                   list(j.causes_other));
    if (j.on_edge) text += fmt::format("; {} of these rays meet an edge exactly", grouped(j.on_edge));
    if (j.ties) text += fmt::format("; {} ties", grouped(j.ties));
    text += fmt::format("\n  judge: {} camera", grouped(j.rays.primary));
    const std::pair<const char*, std::uint64_t> kinds[] = {
        {"shadow", j.rays.shadow}, {"reflected", j.rays.reflection}, {"refracted", j.rays.refraction}};
    for (const auto& [name, rays] : kinds)
        if (rays > 0) text += fmt::format(", {} {}", grouped(rays), name);
    text += " rays";
    if (j.colours > 0)
        text += fmt::format(" and {} colours (bounds of at most +-{:.2f} %)", grouped(j.colours),
                            100 * std::ldexp(j.widest, -unit_bits));
    text += fmt::format(" judged in {:.2f} s, {} wrong\n", j.seconds, grouped(j.wrong));
    for (std::size_t i = 0; i < std::min<std::size_t>(j.faults.size(), 5); ++i)
        text += fmt::format("    WRONG at pixel ({}, {}), after ray {}: {}\n", j.faults[i].x, j.faults[i].y,
                            j.faults[i].ray, j.faults[i].what);
    return text;
}

}   // namespace rayclock
