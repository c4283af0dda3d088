// A stream of rays in place of a camera.
#include "sim/run/stream/stream.hpp"

#include <cmath>
#include <cstring>
#include <functional>
#include <memory>
#include <mutex>
#include <stdexcept>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/stopwatch.hpp"
#include "model/compile/compile.hpp"
#include "model/compile/lattice.hpp"
#include "model/compile/plane.hpp"
#include "model/compile/surfaces.hpp"
#include "model/machine/machine.hpp"
#include "model/unit/tri/vectors.hpp"
#include "model/unit/raygen/raygen.hpp"
#include "sim/files/npy.hpp"
#include "sim/files/process/interrupt.hpp"
#include "sim/judge/paths/answer.hpp"
#include "sim/judge/paths/placed.hpp"
#include "sim/judge/paths/world.hpp"
#include "sim/judge/reference/tiles.hpp"

namespace rayclock {

Config streaming(Config config, const Scene& scene) {
    config.shading = true;
    config.source = RaySource::stream;
    config.spheres = !scene.spheres.empty();
    config.planes = !scene.planes.empty();
    config.smooth = config.refraction = config.supersampling = config.horizon = config.scan_out = false;
    config.panes = 0;
    return config;
}

namespace {

/// Largest distance of a common origin from the middle of the scene, in diagonals of its bounds.
constexpr double max_diagonals = 4;

/// The point that must be a lattice point, and the lattice's size in units of its least size.
struct Anchor {
    glm::dvec3 point;
    double room = 1;
};
/// Returns the common origin of all rays, if they have one and it is near enough to keep the lattice fine.
/// The lattice is then the one of a picture from there. Otherwise returns the middle of the scene, with a
/// margin around spheres.
Anchor anchor_of(const Scene& scene, const Rays& rays, const Config& config) {
    const Bounds box = bounds(scene);
    const double largest = largest_coordinate(config.coord_bits);
    const Anchor middle{0.5 * box.lo + 0.5 * box.hi,
                        scene.spheres.empty() ? 1 : largest / (largest - sphere_margin)};
    const glm::dvec3 first = rays[0].origin;
    if (!(glm::length(first - middle.point) <= max_diagonals * glm::length(box.hi - box.lo))) return middle;
    for (std::size_t i = 1; i < rays.size(); ++i)
        if (rays[i].origin != first) return middle;
    return {first};
}

}   // namespace

StreamJob make_stream_job(const Scene& scene, const Rays& rays, const Config& config, Outside outside,
                          const Progress& progress) {
    const Anchor anchor = anchor_of(scene, rays, config);
    return make_stream_job(scene, rays, config,
                           compile_scene(scene, anchor.point, config, progress, anchor.room), outside);
}

StreamJob make_stream_job(const Scene& scene, const Rays& rays, const Config& config, MemoryImage image,
                          Outside outside) {
    StreamJob stream{scene, rays, {config, {}, std::move(image), {}}};
    std::vector<RayRecord> records;
    records.reserve(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const StreamRay ray = rays[i];
        const auto made = on_lattice(ray, stream.job.image.lattice, config);
        if (outside == Outside::refuse && (!made || made->is_clipped))
            throw UserError(
                fmt::format("{}: ray {} begins outside the lattice that holds the scene; --outside clip "
                            "leaves out the part before it",
                            printable(rays.name()), i));
        if ((!made || made->is_clipped) &&
            meets_plane_outside(scene, ray, made ? std::optional(made->begin) : std::nullopt))
            throw UserError(
                fmt::format("{}: ray {} meets a plane before it enters the lattice that holds the other "
                            "primitives, and a record holds no point outside the lattice",
                            printable(rays.name()), i));
        ++(ray.any_hit ? stream.any : stream.closest);
        stream.clipped += made && made->is_clipped;
        stream.missing += !made;
        records.push_back(made ? made->record : ray_to_nowhere(config));
    }
    place_rays(stream.job.image, records, config);
    check_capacity(stream.job.image, config);
    stream.job.frame = make_stream_frame(stream.job.image, rays.size(), config);
    return stream;
}

namespace {

/// Returns the distance of a plane along a record, in directions.
double distance_of(const PrimData& plane, const RayRecord& record, const Config& config) {
    const Vec3l n = cross(minus(plane.b, plane.a), minus(plane.c, plane.a));
    double height = 0, slope = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        height += double(n[k]) * (plane.a[k] - std::ldexp(record.o[k], -config.origin_frac()));
        slope += double(n[k]) * record.d[k];
    }
    return height / slope;
}

/// Returns u or v of a plane as a multiple of the given plane's side, counted from its point.
double along_plane(std::uint32_t part, const PlaneOnLattice& plane, std::size_t side, const Config& config) {
    const int spare = 32 - config.uv_bits();
    const std::int32_t whole = std::int32_t(part << spare) >> spare;   // two's complement
    return std::ldexp(plane.at[side] + std::ldexp(whole, -config.bary_bits), -plane.level[side]);
}

}   // namespace

StreamHit hit_of(const StreamJob& stream, std::size_t ray, const Closest& answer) {
    StreamHit hit;
    hit.hit = answer.found != 0, hit.back = answer.back != 0;
    const StreamRay given = stream.rays[ray];
    const Config& config = stream.job.config;
    if (!hit.hit || (given.any_hit && !config.planes)) return hit;
    const Lattice& lattice = stream.job.image.lattice;
    const auto made = on_lattice(given, lattice, config);
    if (!made || ends_at_any(made->record.kind)) return hit;

    const std::size_t first_plane = stream.scene.triangles.size() + stream.scene.spheres.size();
    double way = std::ldexp(double(answer.t), -(config.dir_bits - 1 + config.t_frac_bits));
    if (answer.prim >= first_plane && answer.t == (1u << config.t_bits()) - 1)   // beyond the range of t
        way = distance_of(snap_primitive(stream.scene, lattice, answer.prim), made->record, config);
    const double t = made->begin + made->scale * way;
    if (t > given.t_max) return {};
    if (given.any_hit) {
        hit.back = false;
        return hit;
    }
    hit.primitive = answer.prim;
    hit.t = t;
    if (answer.prim >= first_plane) {
        const PlaneOnLattice plane =
            plane_on_lattice(stream.scene.planes[answer.prim - first_plane], lattice);
        hit.u = along_plane(answer.u, plane, 0, config);
        hit.v = along_plane(answer.v, plane, 1, config);
        return hit;
    }
    hit.u = std::ldexp(double(answer.u), -config.bary_bits);
    hit.v = std::ldexp(double(answer.v), -config.bary_bits);
    return hit;
}

void name_instances(const Scene& scene, std::vector<StreamHit>& hits) {
    if (!scene.placed) return;
    const InstanceNumbers instances(*scene.placed);
    for (StreamHit& hit : hits) hit.instance = instances.of(hit.primitive);
}

std::vector<StreamHit> hits_of(const StreamJob& stream, const std::vector<Closest>& answers) {
    std::vector<StreamHit> hits;
    hits.reserve(answers.size());
    for (std::size_t i = 0; i < answers.size(); ++i) hits.push_back(hit_of(stream, i, answers[i]));
    name_instances(stream.scene, hits);
    return hits;
}

std::string hits_npy(const std::vector<StreamHit>& hits, const std::vector<std::uint64_t>& cycles) {
    std::string bytes = npy_head(
        "[('hit', 'u1'), ('back', 'u1'), ('primitive', '<u4'), ('instance', '<u4'), ('t', '<f8'), ('u', "
        "'<f8'), "
        "('v', '<f8'), ('cycle', '<u8')]",
        {hits.size()});
    constexpr std::size_t bytes_of_hit = 42;
    bytes.reserve(bytes.size() + hits.size() * bytes_of_hit);
    const auto add = [&](const auto& value) {
        char raw[sizeof value];
        std::memcpy(raw, &value, sizeof value);
        bytes.append(raw, sizeof value);
    };
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const StreamHit& hit = hits[i];
        add(std::uint8_t(hit.hit)), add(std::uint8_t(hit.back)), add(hit.primitive);
        add(hit.instance), add(hit.t), add(hit.u), add(hit.v);
        add(cycles.empty() ? std::uint64_t(0) : cycles[i]);
    }
    return bytes;
}

std::vector<std::uint64_t> retirements(const Config& config, int khz, const RecordedFrame& frame,
                                       Disturbance disturbance, std::uint64_t cycles,
                                       const Progress& progress) {
    constexpr std::uint64_t between_reports = 1 << 16;
    std::vector<std::uint64_t> retired(frame.trace.rays.size());
    std::vector<std::size_t> left;   // rays whose answers are on their way out of the chip
    Machine machine(config, khz, disturbance);
    machine.start(frame.frame, frame.trace);
    const std::uint64_t first = machine.cycle();
    for (std::uint64_t now = 0; !machine.done() && !interrupted(); now = machine.cycle() - first) {
        if (now > cycles) throw std::logic_error("a second replay takes more cycles than the first one");
        if (progress && now % between_reports == 0) progress("hits", std::size_t(now), std::size_t(cycles));
        machine.step([&](const Move& move) {
            if (move.link == Link::hit) left.push_back(std::size_t(move.y) * frame.trace.width + move.x);
            if (config.writes_hits() && !move.is_write) return;
            for (const std::size_t ray : left) retired[ray] = now;
            left.clear();
        });
    }
    if (progress) progress("hits", std::size_t(cycles), std::size_t(cycles));
    return retired;
}

namespace {

/// Returns the judge of a ray's answer. With two levels a fault of an instance's map is the fault of every
/// ray.
std::function<const char*(const Ray&, const Closest&)> judge_of(const StreamJob& stream) {
    const MemoryImage& image = stream.job.image;
    const Config& config = stream.job.config;
    if (config.has_instances()) {
        const auto asked = std::make_shared<const FrameInputs>(
            FrameInputs{stream.scene, *stream.scene.camera, stream.job.frame, image.lattice, config});
        const auto world = std::make_shared<const PlacedWorld>(*asked, image);
        if (!world->faults().empty())
            return [](const Ray&, const Closest&) {
                return "an instance's map in memory does not match its place";
            };
        return [asked, world, &config](const Ray& ray, const Closest& answer) {
            return judge_answer(*world, config, ray, answer);
        };
    }
    const std::optional<Scene> moved = align_large_triangles(stream.scene, image.lattice);
    const auto primitives = std::make_shared<const std::vector<oracle::Solid>>(
        solids_of(moved ? *moved : stream.scene, image.lattice, config.coord_bits));
    const auto solids = std::make_shared<const oracle::Solids>(*primitives);
    return [primitives, solids, &config](const Ray& ray, const Closest& answer) {
        return judge_answer(*solids, config, ray, answer);
    };
}

}   // namespace

StreamJudgement judge_stream(const StreamJob& stream, const std::vector<Closest>& answers, int threads,
                             const Progress& progress) {
    const Stopwatch watch;
    const MemoryImage& image = stream.job.image;
    const Config& config = stream.job.config;
    const std::function<const char*(const Ray&, const Closest&)> fault_of = judge_of(stream);
    StreamJudgement judged{answers.size(), 0, {}, 0};
    std::size_t first_wrong = answers.size();
    std::mutex mutex;
    constexpr int block = 1024;
    for_each_tile({int(answers.size()), 1}, threads, "judging", progress,
                  [&](const PixelTile& tile) {
                      for (int i = tile.cols().begin(); i < tile.cols().end(); ++i) {
                          const auto record = unpack<RayRecord>(image.record(std::uint32_t(i)), config);
                          const char* fault =
                              fault_of(recorded_ray(record, 0, config), answers[std::size_t(i)]);
                          if (!fault) continue;
                          const std::lock_guard lock(mutex);
                          ++judged.wrong;
                          if (std::size_t(i) >= first_wrong) continue;
                          first_wrong = std::size_t(i);
                          judged.first = fmt::format("ray {}: {}", i, fault);
                      }
                  },
                  {block, 1});
    judged.seconds = watch.seconds();
    return judged;
}

}   // namespace rayclock
