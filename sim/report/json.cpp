#include "sim/report/json.hpp"

#include <cmath>

#include <fmt/format.h>

#include "sim/report/accounts.hpp"

namespace rayclock {

using nlohmann::ordered_json;

FrameError frame_error(const Scene& scene, const HitFrame& frame, const HitFrame& reference) {
    FrameError error;
    error.pixels = frame.hits.size();
    for (std::size_t i = 0; i < frame.hits.size(); ++i) {
        const Hit &a = frame.hits[i], &b = reference.hits[i];
        if (a.primitive != b.primitive) ++error.pixels_other_primitive;
        else error.max_abs_depth = std::max(error.max_abs_depth, double(std::fabs(a.depth - b.depth)));
    }
    error.psnr_db = compare(shade(scene, frame), shade(scene, reference)).psnr_db;
    return error;
}

ordered_json scene_json(const Scene& scene) {
    return {{"name", scene.name}, {"triangles", scene.triangles.size()}, {"spheres", 0}, {"planes", 0}};
}

ordered_json config_json_object(const Config& config) {
    ordered_json json{{"name", config.name}};
    for (const Parameter& p : parameters()) json[p.key] = config.*p.member;
    return json;
}

ordered_json compile_json(const CompileReport& r) {
    return {{"triangles", r.triangles}, {"collapsed", r.collapsed}, {"nodes", r.nodes}, {"leaves", r.leaves}, {"depth", r.depth},
            {"stack_need", r.stack_need}, {"bytes", r.bytes}, {"pitch", r.pitch}, {"seconds", r.seconds}};
}

ordered_json work_json(const FrameRun& run) {
    return {{"node_steps", node_steps(run)}, {"box_tests", run.box_tests}, {"triangle_tests", triangle_tests(run)}};
}

ordered_json clocks_json(const FrameRun& run, const std::vector<double>& clocks) {
    ordered_json json = ordered_json::array();
    for (const double mhz : clocks) {
        const double fps = mhz * 1e6 / double(run.cycles);
        json.push_back({{"mhz", mhz}, {"cycles", run.cycles}, {"fps", fps}, {"mrays_per_s", fps * double(run.hits.hits.size()) / 1e6},
                        {"dram_bytes", bytes_read(run)}, {"dram_gb_per_s", fps * double(bytes_read(run)) / 1e9}, {"bound", bound_of(run).unit}});
    }
    return json;
}

ordered_json units_json(const FrameRun& run) {
    ordered_json json = ordered_json::object();
    for (const UnitAccount& a : unit_accounts(run.counts, run.cycles))
        json[a.unit] = {{"count", a.count}, {"busy", a.busy}, {"starved", a.starved}, {"stalled", {{a.cause, a.stalled}}}};
    return json;
}

ordered_json memory_json(const FrameRun& run) {
    // No caches yet: every access goes to the memory port.
    const std::uint64_t nodes = node_steps(run), prims = run.counts[index(Channel::prim_req)].moved;
    return {{"node_cache", {{"accesses", nodes}, {"hits", 0}}}, {"prim_cache", {{"accesses", prims}, {"hits", 0}}},
            {"dram", {{"reads", nodes + prims}, {"row_hits", 0}}}};
}

ordered_json decibel(double psnr_db) { return std::isfinite(psnr_db) ? ordered_json(psnr_db) : ordered_json(nullptr); }

ordered_json error_json(const std::optional<FrameError>& e) {
    if (!e) return nullptr;
    return {{"pixels", e->pixels}, {"pixels_other_primitive", e->pixels_other_primitive}, {"psnr_db", decibel(e->psnr_db)},
            {"max_abs_depth", e->max_abs_depth}};
}

ordered_json divergence_json(const std::optional<Divergence>& d) {
    if (!d) return nullptr;
    return {{"cycle", d->cycle}, {"unit", d->unit}, {"channel", d->channel}, {"ray", d->ray}, {"pixel", {d->x, d->y}},
            {"expected", d->expected}, {"got", d->got}, {"wave", nullptr}};
}

std::string digest_text(std::uint64_t digest) { return fmt::format("{:016x}", digest); }

} // namespace rayclock
