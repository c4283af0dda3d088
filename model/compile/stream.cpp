// Converts rays from any program to records in the chip's memory.
#include "model/compile/stream.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/base/error.hpp"
#include "model/core/payloads.hpp"
#include "model/layout/words.hpp"

namespace rayclock {

namespace {

/// A largest component within this relative distance below a power of two counts as that power.
constexpr double close_to_power = 0x1p-40;

/// The range of t in which a ray lies within the lattice.
struct Within {
    double from, to;
    int axis = -1;   ///< axis across the border through which the ray enters; -1 if it begins within
    bool is_high = false;
};
/// The lattice of origins ends a step beyond the scene's vertices on the lower sides, and a step less 2^-frac
/// on the upper ones. So a ray that begins at its border meets a surface there at t > 0.
std::optional<Within> within_lattice(const StreamRay& ray, const Lattice& lattice, int frac) {
    const double reach = std::ldexp(1.0, lattice.coord_bits - 1);
    Within in{ray.t_min, ray.t_max};
    for (int k = 0; k < 3; ++k) {
        const double low = lattice.centre[k] - reach * lattice.pitch[k],
                     high = lattice.centre[k] + (reach - std::ldexp(1.0, -frac)) * lattice.pitch[k],
                     o = ray.origin[k], d = ray.direction[k];
        if (d == 0) {
            if (o < low || o > high) return std::nullopt;
            continue;
        }
        const double a = (low - o) / d, b = (high - o) / d;
        if (std::min(a, b) > in.from) in = {std::min(a, b), in.to, k, d < 0};
        in.to = std::min(in.to, std::max(a, b));
    }
    if (!(in.from <= in.to) || !std::isfinite(in.from)) return std::nullopt;
    return in;
}

/// Returns a coordinate in lattice steps, with `frac` fraction bits, rounded to nearest.
double on_axis(const glm::dvec3& point, int axis, const Lattice& lattice, int frac) {
    return std::round(std::ldexp((point[axis] - lattice.centre[axis]) / lattice.pitch[axis], frac));
}

/// Returns a point within the lattice in lattice steps, with `frac` fraction bits.
Vec3i origin_of(const glm::dvec3& point, const Lattice& lattice, int frac) {
    const double reach = std::ldexp(1.0, lattice.coord_bits - 1 + frac);
    Vec3i p{};
    for (int k = 0; k < 3; ++k)
        p[std::size_t(k)] = std::int32_t(std::clamp(on_axis(point, k, lattice, frac), -reach, reach - 1));
    return p;
}

/// The lattice point nearest to the end of a segment, if vertices reach as far.
struct SegmentEnd {
    Vec3i point{};
    bool is_beyond = false;    ///< beyond all vertices, so the segment needs no end
    bool is_outside = false;   ///< the whole segment lies beyond all vertices
};
SegmentEnd end_of(const StreamRay& ray, const Lattice& lattice) {
    const double most = std::ldexp(1.0, lattice.coord_bits - 1) - 1;
    SegmentEnd end;
    for (int k = 0; k < 3; ++k) {
        const double x = on_axis(ray.origin + ray.t_max * ray.direction, k, lattice, 0);
        const bool beyond = std::abs(x) > most;
        end.is_beyond = end.is_beyond || beyond;
        end.is_outside = end.is_outside || (beyond && !(x * ray.direction[k] > 0));
        end.point[std::size_t(k)] = beyond ? 0 : std::int32_t(x);
    }
    return end;
}

}   // namespace

std::optional<LatticeRay> on_lattice(const StreamRay& ray, const Lattice& lattice, const Config& config) {
    const int frac = config.origin_frac();
    const std::optional<Within> in = within_lattice(ray, lattice, frac);
    if (!in) return std::nullopt;
    LatticeRay made;
    made.begin = in->from;
    made.is_clipped = in->from > ray.t_min;
    RayRecord& record = made.record;
    Vec3i begin = origin_of(ray.origin + in->from * ray.direction, lattice, frac);
    if (in->axis >= 0) {   // exactly on the border, even if doubles are coarse at the given origin
        const std::int32_t reach = 1 << (config.origin_width() - 1);
        begin[std::size_t(in->axis)] = in->is_high ? reach - 1 : -reach;
    }
    // A segment that leaves the lattice needs no end.
    const bool is_segment = ray.any_hit && std::isfinite(ray.t_max);
    if (is_segment && in->to == ray.t_max) {
        const SegmentEnd end = end_of(ray, lattice);
        if (end.is_outside && !config.planes) {
            record = ray_to_nowhere(config);
            return made;
        }
        if (!end.is_beyond) {
            record.kind = RayKind::shadow;
            for (std::size_t k = 0; k < 3; ++k) {
                record.o[k] = end.point[k] * (1 << frac);
                record.d[k] = begin[k] - record.o[k];
            }
            if (record.d == Vec3i{}) record = ray_to_nowhere(config);   // a point meets nothing
            return made;
        }
    }
    const bool is_compared = is_segment && config.planes;   // a plane may lie behind the end
    record.kind = ray.any_hit && !is_compared ? RayKind::away : RayKind::bounce;
    record.o = begin;
    const glm::dvec3 steps = lattice.direction(ray.direction);
    const double largest = std::max({std::abs(steps.x), std::abs(steps.y), std::abs(steps.z)});
    const auto most = double((1 << (config.dir_bits - 1)) - 1);
    const int shift = config.dir_bits - 2 - std::ilogb(largest * (1 + close_to_power));
    made.scale = std::ldexp(lattice.coarsest(), shift);
    for (int k = 0; k < 3; ++k)
        record.d[std::size_t(k)] =
            std::int32_t(std::clamp(std::round(std::ldexp(steps[k], shift)), -most, most));
    return made;
}

bool meets_plane_outside(const Scene& scene, const StreamRay& ray, std::optional<double> begin) {
    return std::any_of(scene.planes.begin(), scene.planes.end(), [&](const Plane& plane) {
        const glm::dvec3 normal = glm::cross(plane.u, plane.v);
        const double t = glm::dot(normal, plane.point - ray.origin) / glm::dot(normal, ray.direction);
        return t > ray.t_min && t <= ray.t_max && (!begin || t < *begin);   // false for a NaN
    });
}

RayRecord ray_to_nowhere(const Config& config) {
    RayRecord record{RayKind::away, {}, {}};
    for (std::size_t k = 0; k < 3; ++k) {
        record.o[k] = (1 << (config.origin_width() - 1)) - 1;
        record.d[k] = (1 << (config.dir_bits - 1)) - 1;
    }
    return record;
}

void place_rays(MemoryImage& image, std::span<const RayRecord> rays, const Config& config) {
    const auto at_multiple = [](std::uint64_t line, int burst_bytes) {
        const auto burst = std::uint64_t(burst_bytes / line_bytes);
        return (line + burst - 1) / burst * burst;
    };
    const std::uint64_t first = at_multiple(image.lines(), config.stream_line),
                        lines = (std::uint64_t(rays.size()) + 1) / 2,
                        most = std::uint64_t(1) << config.addr_bits;
    if (rays.size() >> 2 * config.pixel_bits != 0)
        throw UserError(std::to_string(rays.size()) + " rays are too many: with pixel_bits=" +
                        std::to_string(config.pixel_bits) + " the chip numbers at most " +
                        std::to_string((std::uint64_t(1) << 2 * config.pixel_bits) - 1));
    if (first + lines > most)
        throw UserError(std::to_string(rays.size()) + " rays and the scene need " +
                        std::to_string(first + lines) + " lines of memory, and addr_bits=" +
                        std::to_string(config.addr_bits) + " allows " + std::to_string(most));
    image.first_ray_line = std::uint32_t(first);
    // Hits begin a line of every cache, so no cache reads what is written.
    image.first_hit_line = std::uint32_t(at_multiple(first + lines, config.longest_line()));
    const auto in_line = std::uint64_t(hits_of_line(config));
    image.hit_lines = std::uint32_t((std::uint64_t(rays.size()) + in_line - 1) / in_line);
    image.records.assign(std::size_t(lines) * words_per_line, 0);
    image.report.bytes = (std::uint64_t(first) + lines) * line_bytes;
    Words scratch;
    for (std::size_t i = 0; i < rays.size(); ++i)
        write_payload(rays[i], config, &image.records[i * words_per_half], scratch);
}

Frame make_stream_frame(const MemoryImage& image, std::size_t rays, const Config& config) {
    Frame frame;
    frame.width = 1u << config.pixel_bits;
    frame.height = std::uint32_t((rays + frame.width - 1) / frame.width);
    frame.ray_count = std::uint32_t(rays);
    frame.first_ray_line = image.first_ray_line;
    frame.first_hit_line = image.first_hit_line;
    frame.listed_primitives = image.listed_primitives;
    return frame;
}

}   // namespace rayclock
