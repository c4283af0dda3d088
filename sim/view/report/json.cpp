// Converts results to the JSON of reports.
#include "sim/view/report/json.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "model/core/parameters.hpp"
#include "model/scene/folded.hpp"
#include "sim/run/memory/memory_file.hpp"
#include "sim/view/report/accounts.hpp"

namespace rayclock {

using nlohmann::ordered_json;

FrameError frame_error(const HitFrame& frame, const Picture& picture, const HitFrame& reference,
                       const Picture& reference_picture) {
    FrameError error;
    error.pixels = frame.hits.size();
    for (std::size_t i = 0; i < frame.hits.size(); ++i) {
        const Hit &a = frame.hits[i], &b = reference.hits[i];
        if (a.primitive != b.primitive) ++error.pixels_other_primitive;
        if (a.primitive != b.primitive || a.primitive == no_primitive || !std::isfinite(a.depth)) continue;
        ++error.depth_pixels;
        const double off = std::fabs(double(a.depth) - double(b.depth));
        error.max_abs_depth = std::max(error.max_abs_depth, off);
        if (b.depth > 0) error.max_relative_depth = std::max(error.max_relative_depth, off / double(b.depth));
    }
    error.psnr_db = compare(picture, reference_picture).psnr_db;
    return error;
}
FrameError frame_error(const Scene& scene, const HitFrame& frame, const HitFrame& reference) {
    return frame_error(frame, shade(scene, frame), reference, shade(scene, reference));
}

ordered_json scene_json(const Scene& scene) {
    return {{"name", scene.name},
            {"triangles", triangle_count(scene)},
            {"spheres", scene.spheres.size()},
            {"planes", scene.planes.size()}};
}

ordered_json window_json(const std::optional<PictureWindow>& window) {
    if (!window) return nullptr;
    return {{"x", window->x},
            {"y", window->y},
            {"whole_width", window->whole_width},
            {"whole_height", window->whole_height}};
}

ordered_json camera_json(const Camera& camera) {
    const auto point = [](const glm::dvec3& p) { return ordered_json{p.x, p.y, p.z}; };
    return {{"eye", point(camera.eye)},
            {"at", point(camera.at)},
            {"up", point(camera.up)},
            {"fov_degrees", camera.fov_degrees},
            {"window", window_json(camera.window)}};
}

ordered_json config_json_object(const Config& config) {
    ordered_json json{{"name", config.name}};
    for (const Parameter& p : parameters())
        json[p.key] = p.names ? ordered_json(value_text(config, p)) : ordered_json(p.get(config));
    if (config.own_dram) json["dram"] = memory_file_json(*config.own_dram);
    return json;
}

ordered_json compile_json(const CompileReport& r) {
    return {{"triangles", r.triangles},
            {"collapsed", r.collapsed},
            {"coincident", r.coincident},
            {"nodes", r.nodes},
            {"leaves", r.leaves},
            {"depth", r.depth},
            {"stack_need", r.stack_need},
            {"bytes", r.bytes},
            {"pitch", std::max({r.pitch.x, r.pitch.y, r.pitch.z})},
            {"pitches", {r.pitch.x, r.pitch.y, r.pitch.z}},
            {"seconds", r.seconds}};
}

ordered_json rays_json(const RayCounts& rays) {
    return {{"primary", rays.primary},
            {"shadow", rays.shadow},
            {"reflection", rays.reflection},
            {"refraction", rays.refraction}};
}

ordered_json work_json(const FrameResult& run) {
    return {{"node_steps", run.visits}, {"box_tests", run.box_tests}, {"triangle_tests", run.triangle_tests}};
}

ordered_json clock_json(const Config& config, const FramesAtClock& run) {
    const FrameResult& frame = run.last();
    const double fps = per_second(frame, run.khz), gb = fps * double(bytes_read(frame)) / 1e9;
    const Bound bound = bound_of(config, run.khz, frame);
    ordered_json frames = ordered_json::array();
    for (const FrameResult& f : run.frames)
        frames.push_back({{"cycles", f.cycles},
                          {"upload_cycles", f.upload.cycles},
                          {"reset_cycles", f.upload.reset},
                          {"bytes_written", f.upload.lines * 64},
                          {"fps", per_second(f, run.khz)},
                          {"dram_bytes", bytes_read(f)},
                          {"node_hit_rate", cache_account(f, Unit::node_cache).hit_rate()},
                          {"prim_hit_rate", cache_account(f, Unit::prim_cache).hit_rate()}});
    return {{"mhz", run.khz / 1e3},
            {"cycles", frame.cycles},
            {"fps", fps},
            {"mrays_per_s", fps * rays_of(frame) / 1e6},
            {"dram_bytes", bytes_read(frame)},
            {"dram_gb_per_s", gb},
            {"dram_share_of_peak", gb * 1e9 / peak_bytes_per_second(config, run.khz)},
            {"bytes_per_ray", rays_of(frame) > 0 ? double(bytes_read(frame)) / rays_of(frame) : 0},
            {"bound", bound.unit},
            {"bounds",
             {{"trav", bound.nodes},
              {"tri", bound.triangles},
              {"shade", bound.passes},
              {"raygen", bound.rays},
              {"memory", bound.memory}}},
            {"bound_reached", bound.reached},
            {"bottleneck", bottleneck(config, run.khz, frame)},
            {"units", units_json(config, frame)},
            {"memory", memory_json(config, run.khz, frame)},
            {"frames", frames}};
}

ordered_json units_json(const Config& config, const FrameResult& run) {
    ordered_json json = ordered_json::object();
    const auto parts = [](const std::vector<UnitAccount::Part>& list) {
        ordered_json object = ordered_json::object();
        for (const UnitAccount::Part& part : list) object[part.cause] = part.cycles;
        return object;
    };
    for (const UnitAccount& a : unit_accounts(config, run))
        json[a.unit] = {{"instances", a.instances},
                        {"count", a.count},
                        {"busy", a.busy},
                        {"starved", a.starved},
                        {"stalled", parts(a.stalled_by)},
                        {"busy_with", parts(a.busy_by)},
                        {"starved_by", parts(a.starved_by)}};
    return json;
}

ordered_json memory_json(const Config& config, int khz, const FrameResult& run) {
    ordered_json json;
    const auto add = [&](const char* name, Unit unit) {
        const CacheAccount c = cache_account(run, unit);
        json[name] = {{"accesses", c.accesses}, {"hits", c.hits}, {"merged", c.merged}};
    };
    add("node_cache", Unit::node_cache);
    add("prim_cache", Unit::prim_cache);
    if (config.has_shade()) add("surf_cache", Unit::surf_cache);
    if (config.has_textures()) add("tex_cache", Unit::tex_cache);
    if (config.is_stream()) add("stream", Unit::stream);
    if (config.l2_sets > 0) add("l2", Unit::l2);
    const DramPart* part = config.dram_part();
    json["dram"] = {{"name", part ? part->name : "ideal"},
                    {"description", part ? part->description : "answers after a fixed number of cycles"},
                    {"channels", part ? config.dram_channels : 1},
                    {"reads", run.memory.reads},
                    {"row_hits", run.memory.row_hits},
                    {"row_conflicts", run.memory.row_conflicts},
                    {"refreshes", run.memory.refreshes},
                    {"writes", run.memory.writes},
                    {"peak_gb_per_s", peak_bytes_per_second(config, khz) / 1e9}};
    if (config.is_board())
        json["dram"]["scan_out"] = {{"reads", run.memory.scanned}, {"underruns", run.memory.underruns}};
    else if (config.scan_out)
        json["dram"]["scan_out"] = {{"reads", run.memory.scanned}, {"backlog", run.memory.backlog}};
    if (config.pixel_writes) json["dram"]["pixel_writes"] = run.memory.pixel_writes;
    return json;
}

ordered_json decibel(double psnr_db) {
    return std::isfinite(psnr_db) ? ordered_json(psnr_db) : ordered_json(nullptr);
}

ordered_json causes_json(const PixelCauses& causes) {
    ordered_json json;
    for (std::size_t k = 0; k < pixel_causes; ++k) json[cause_info(PixelCause(k)).key] = causes[k];
    return json;
}

ordered_json error_json(const std::optional<FrameError>& e, const std::optional<Judgement>& j) {
    if (!e) return nullptr;
    ordered_json json{{"pixels", e->pixels},
                      {"pixels_other_primitive", e->pixels_other_primitive},
                      {"psnr_db", decibel(e->psnr_db)},
                      {"depth_pixels", e->depth_pixels},
                      {"max_abs_depth", e->max_abs_depth},
                      {"max_relative_depth", e->max_relative_depth}};
    if (!j) return json;
    json["pixels_on_edge"] = j->on_edge;
    json["causes"] = causes_json(j->causes);
    json["causes_other_primitive"] = causes_json(j->causes_other);
    json["ties"] = j->ties;
    json["oracle"] = {{"pixels", j->pixels.size()}, {"wrong", j->wrong}};
    return json;
}

ordered_json judge_json(const std::optional<Judgement>& j) {
    if (!j) return nullptr;
    ordered_json faults = ordered_json::array();
    for (const PictureFault& f : j->faults)
        faults.push_back({{"pixel", {f.x, f.y}}, {"ray", f.ray}, {"what", f.what}});
    return {{"rays",
             {{"camera", j->rays.primary},
              {"shadow", j->rays.shadow},
              {"reflection", j->rays.reflection},
              {"refraction", j->rays.refraction}}},
            {"colours", j->colours},
            {"wrong", j->wrong},
            {"widest_colour_bound", j->widest * std::exp2(-unit_bits)},
            {"faults", faults},
            {"seconds", j->seconds}};
}

ordered_json divergence_json(const std::optional<Divergence>& d) {
    if (!d) return nullptr;
    return {{"cycle", d->cycle},
            {"unit", d->unit},
            {"channel", d->link},
            {"ray", d->ray},
            {"pixel", {d->x, d->y}},
            {"expected", d->expected},
            {"got", d->got},
            {"later", d->later.empty() ? ordered_json(nullptr) : ordered_json(d->later)},
            {"wave", d->wave.empty() ? ordered_json(nullptr) : ordered_json(d->wave)}};
}

ordered_json counter_json(const std::optional<CounterDifference>& c) {
    if (!c) return nullptr;
    return {
        {"unit", c->unit}, {"cause", c->cause}, {"model", c->model}, {"rtl", c->rtl}, {"others", c->others}};
}

std::string digest_text(std::uint64_t digest) { return fmt::format("{:016x}", digest); }

}   // namespace rayclock
