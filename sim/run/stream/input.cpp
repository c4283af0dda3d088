// The input of a stream, and its answers without timing.
#include "sim/run/stream/input.hpp"

#include <bit>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "model/base/error.hpp"
#include "model/base/interrupted.hpp"
#include "model/base/quote.hpp"
#include "model/scene/camera.hpp"
#include "model/trace/hits.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/judge/reference/tiles.hpp"
#include "sim/run/request/request.hpp"
#include "sim/run/stream/surface.hpp"

namespace rayclock {

Outside parse_outside(const std::string& text) {
    if (text == "clip") return Outside::clip;
    if (text == "refuse") return Outside::refuse;
    throw UserError("--outside: " + shown(text) + " is not clip or refuse");
}

StreamInput::StreamInput(Scene scene, std::unique_ptr<const Rays> rays, Outside outside)
    : scene_(std::move(scene)), rays_(std::move(rays)), outside_(outside) {
    refuse_folded(scene_);
    if (!scene_.camera) scene_.camera = fit_camera(scene_, 1);
}

std::string StreamInput::digest() const {
    Digest digest;
    const auto add = [&](double x) { digest.add(std::bit_cast<std::uint64_t>(x)); };
    digest.add(std::uint64_t(outside_));
    digest.add(rays_->size());
    for (std::size_t i = 0; i < rays_->size(); ++i) {
        const StreamRay ray = (*rays_)[i];
        for (int k = 0; k < 3; ++k) add(ray.origin[k]), add(ray.direction[k]);
        add(ray.t_min), add(ray.t_max);
        digest.add(ray.any_hit);
    }
    return fmt::format("{:016x}", digest.value());
}

std::vector<std::string> stream_notes(const StreamJob& stream) {
    if (stream.clipped == 0) return {};
    return {fmt::format("{}: {} of {} rays begin outside the lattice, and their part outside it is clipped",
                        printable(stream.rays.name()), stream.clipped, stream.rays.size())};
}

namespace {

/// Returns the reference's answer to a ray. It traces from the point at t_min, and a hit must lie before
/// t_max.
StreamHit reference_hit(const Reference& reference, const Scene& scene, const StreamRay& ray) {
    const double length = glm::length(ray.direction);
    const Hit found = reference.trace(ray.origin + ray.t_min * ray.direction, ray.direction);
    StreamHit hit;
    const double t = ray.t_min + double(found.depth) / length;
    if (found.primitive == no_primitive || t > ray.t_max) return hit;
    hit.hit = true;
    if (ray.any_hit) return hit;
    hit.back =
        glm::dot(front_normal(scene, found.primitive, ray.origin + t * ray.direction), ray.direction) > 0;
    hit.primitive = found.primitive, hit.t = t, hit.u = double(found.u), hit.v = double(found.v);
    return hit;
}

std::vector<StreamHit> trace_on_reference(const StreamInput& input, int threads, const Progress& progress) {
    const Reference reference(input.scene());
    std::vector<StreamHit> hits(input.rays().size());
    constexpr int block = 1024;
    for_each_tile({int(hits.size()), 1}, threads, "rays", progress,
                  [&](const PixelTile& tile) {
                      for (int i = tile.cols().begin(); i < tile.cols().end(); ++i)
                          hits[std::size_t(i)] =
                              reference_hit(reference, input.scene(), input.rays()[std::size_t(i)]);
                  },
                  {block, 1});
    name_instances(input.scene(), hits);
    return hits;
}

}   // namespace

StreamAnswers trace_stream(const StreamInput& input, Tracer tracer, const Config& config, int threads,
                           const Progress& progress) {
    if (tracer == Tracer::reference) return {trace_on_reference(input, threads, progress), {}};
    const StreamJob stream = input.job(config, progress);
    const std::vector<Closest> answers =
        tracer == Tracer::rtl ? run_rtl(stream.job, {}, progress).answers
                              : record_frame(stream.job, stream.job.frame, threads, progress).trace.hits;
    if (interrupted()) throw Interrupted("interrupted: nothing is written");
    return {hits_of(stream, answers), stream_notes(stream)};
}

}   // namespace rayclock
