// Traces Haines' scenes and writes docs/measured/ray-counts.md.
#include "sim/study/spd.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/stopwatch.hpp"
#include "model/compile/surfaces.hpp"
#include "model/scene/builtin.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/run/frame/frame.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock::spd {

namespace {

constexpr FrameSize published_size{513, 513};
constexpr int depth = 4;   // the eye ray has depth 1 in the published rules, and 5 is the deepest
constexpr double max_from_table = 0.10, max_from_reference = 0.01;

constexpr std::array<const char*, 4> kind_names{"eye rays that hit", "reflected", "refracted", "shadow"};

struct PublishedCounts {
    const char* scene;
    RaysByKind rays;
};
/// Haines 1987, and the README of his package, version 3.14.
constexpr PublishedCounts published_counts[] = {
    {"balls:4", {263169, 175095, 0, 954368}},
    {"gears:4", {245086, 304643, 207564, 2246955}},
    {"mount:6", {173125, 354769, 354769, 412922}},
    {"teapot:12", {161120, 225248, 0, 407656}},
    {"tetra:6", {49788, 0, 0, 46112}},
    // Cones and cylinders have so many sides that doubling them changes no count by more than 0.2 %.
    {"rings:7:96", {263169, 315236, 0, 1085002}},
    {"tree:11:48", {169836, 0, 0, 1097419}},
};

RaysByKind kinds_of(const RayCounts& c) { return {c.primary_hits, c.reflection, c.refraction, c.shadow}; }

/// Returns a camera with one ray through each corner of 512 x 512 pixels, where `spacings` spacings span the
/// scene's angle. The picture extends half a spacing beyond the 512 on each side. Smaller pictures show the
/// same view.
Camera corner_rays(Camera camera, int spacings) {
    const double half = std::tan(camera.fov_degrees * std::numbers::pi / 360) * 513 / spacings;
    camera.fov_degrees = std::atan(half) * 360 / std::numbers::pi;
    return camera;
}
constexpr int between_centres = 511, between_corners = 512;   // Haines', Havran's

/// Returns a / b - 1. A count where none should be deviates infinitely.
double deviation(std::uint64_t a, std::uint64_t b) {
    if (b == 0) return a == 0 ? 0 : HUGE_VAL;
    return double(a) / double(b) - 1;
}
double largest(const RaysByKind& a, const RaysByKind& b) {
    double most = 0;
    for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, std::abs(deviation(a[k], b[k])));
    return most;
}
std::string signed_per_cent(double share) {
    return std::isfinite(share) ? fmt::format("{:+.3f} %", 100 * share) : "not 0";
}

std::vector<std::string> row_of(const Counted& c, std::size_t k) {
    std::vector<std::string> row{c.scene, kind_names[k]};
    if (c.published)
        row.push_back(grouped((*c.published)[k]));
    else
        row.emplace_back();
    row.push_back(grouped(c.reference[k]));
    row.push_back(grouped(c.model[k]));
    for (const RaysByKind* mine : {&c.reference, &c.model})
        row.push_back(c.published ? signed_per_cent(deviation((*mine)[k], (*c.published)[k])) : "");
    row.push_back(signed_per_cent(deviation(c.model[k], c.reference[k])));
    return row;
}

Table table_of(const std::vector<Counted>& all) {
    Table table({"scene", "rays", "published", "reference", "model", "reference, off", "model, off",
                 "model from reference"},
                2);
    for (const Counted& c : all)
        for (std::size_t k = 0; k < kind_names.size(); ++k) table.add(row_of(c, k));
    return table;
}

constexpr const char* counts_intro = R"(# Rays of the Standard Procedural Databases

Made by `{}`. This page compares the rays that the reference and the model trace in Haines' scenes with his
counts ("A Proposal for Standard Graphics Environments", IEEE CG&A 7(11), 1987, and his package, version
3.14). The counts show whether a ray tracer follows the same rays as others. Haines expects a ray
tracer to stay within about 10 % of each count.

Rules:

- {}x{} eye rays. 513x513 means one ray through each corner of 512x512 pixels. No anti-aliasing, no
  threshold.
- The eye ray has depth 1. A hit at depth 5 sends shadow rays, but no reflected or refracted rays
  (`--depth 4` here).
- Spheres are native. Cones and cylinders are cut into sides with smooth normals. The last number of their
  scenes' names is the number of sides; doubling it hardly changes the reference's counts. All other
  primitives are polygons as given.
- A surface that mirrors or transmits sends a reflected ray. A total reflection also counts as a refracted
  ray. A shadow ray is counted for each light on the side from which the surface is seen.

)";

nlohmann::ordered_json json_of(const Counted& c) {
    const auto rays = [](const RaysByKind& k) {
        return nlohmann::ordered_json{
            {"primary_hits", k[0]}, {"reflection", k[1]}, {"refraction", k[2]}, {"shadow", k[3]}};
    };
    nlohmann::ordered_json json{{"scene", c.scene},
                                {"published", nullptr},
                                {"reference", rays(c.reference)},
                                {"model", rays(c.model)}};
    if (c.published) json["published"] = rays(*c.published);
    json["model_from_reference"] = std::isfinite(largest(c.model, c.reference))
                                       ? nlohmann::ordered_json(largest(c.model, c.reference))
                                       : nlohmann::ordered_json(nullptr);
    json["octrees"] = octree_json(c);
    json["good"] = is_good(c);
    json["host"] = {
        {"reference_seconds", c.reference_seconds}, {"record_seconds", c.model_seconds}, {"rays", c.rays}};
    return json;
}

}   // namespace

std::vector<std::string> published_scenes() {
    std::vector<std::string> names;
    for (const PublishedCounts& p : published_counts) names.emplace_back(p.scene);
    return names;
}

bool is_good(const Counted& c) {
    if (largest(c.model, c.reference) > max_from_reference) return false;
    return !c.published || (largest(c.reference, *c.published) <= max_from_table &&
                            largest(c.model, *c.published) <= max_from_table);
}

Counted count(const std::string& name, FrameSize size, int threads, const Progress& progress) {
    Counted c;
    c.scene = name;
    for (const PublishedCounts& p : published_counts)
        if (name == p.scene && size == published_size) c.published = p.rays;
    if (!is_builtin(name)) throw UserError(shown(name) + " is not a built-in scene; only those are counted");
    const Scene scene = make_builtin(name, Primitives::native);
    const Camera given = scene.camera ? *scene.camera : fit_camera(scene, double(size.width) / size.height);
    const Camera camera = corner_rays(given, between_centres);
    const Whitted settings{.depth = depth};
    const Stopwatch watch;
    c.reference = kinds_of(Reference(scene).whitted(camera, size, settings, threads, progress).rays);
    c.reference_seconds = watch.seconds();
    count_octrees(c, scene, corner_rays(given, between_corners), size, settings, threads, progress);
    const Job job = make_job(scene, camera, size, fitted_config(scene, settings, named_config("default")),
                             progress, settings);
    const RecordedFrame frame = record_frame(job, job.frame, threads, progress);
    c.model = kinds_of(frame.trace.counts);
    c.rays = frame.trace.counts.all();
    c.model_seconds = frame.trace.seconds;
    return c;
}

std::string text(const std::vector<Counted>& all) {
    std::string lines =
        table_of(all).text() + "\n" + havran_table(all).text() + "\n" + octree_table(all).text();
    for (const Counted& c : all)
        lines +=
            fmt::format("  {}: {} rays; reference {:.1f} s, model recorded in {:.1f} s, {:.2f} M rays/s{}\n",
                        c.scene, grouped(c.rays), c.reference_seconds, c.model_seconds,
                        double(c.rays) / c.model_seconds / 1e6, is_good(c) ? "" : "; TOO FAR OFF");
    return lines;
}

std::string page(const std::vector<Counted>& all, FrameSize size, const std::string& command) {
    std::string text = fmt::format(fmt::runtime(counts_intro), command, size.width, size.height);
    text += table_of(all).markdown();
    double from_table = 0, between = 0;
    bool has_published = false;
    for (const Counted& c : all) {
        between = std::max(between, largest(c.model, c.reference));
        if (!c.published) continue;
        has_published = true;
        from_table =
            std::max({from_table, largest(c.reference, *c.published), largest(c.model, *c.published)});
    }
    text += fmt::format("\nLargest deviation of the model from the reference: {:.3f} % (allowed: {:.0f} %).",
                        100 * between, 100 * max_from_reference);
    if (has_published)
        text += fmt::format(" Largest of either from the published counts: {:.3f} % (allowed: {:.0f} %).",
                            100 * from_table, 100 * max_from_table);
    return text + octree_page(all);
}

nlohmann::ordered_json json(const std::vector<Counted>& all, FrameSize size) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Counted& c : all) list.push_back(json_of(c));
    return {{"frame", {{"width", size.width}, {"height", size.height}}},
            {"depth", depth},
            {"scenes", list},
            {"good", std::all_of(all.begin(), all.end(), is_good)}};
}

}   // namespace rayclock::spd
