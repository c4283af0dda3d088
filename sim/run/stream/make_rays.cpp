// Streams of rays from the reference tracer.
#include "sim/run/stream/make_rays.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/geometric.hpp>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/rng.hpp"
#include "model/compile/frame.hpp"
#include "model/compile/lattice.hpp"
#include "model/compile/plane.hpp"
#include "model/layout/memory_image.hpp"
#include "model/unit/raygen/raygen.hpp"
#include "sim/files/npy.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/judge/reference/tiles.hpp"
#include "sim/run/stream/stream.hpp"
#include "sim/run/stream/surface.hpp"

namespace rayclock {

namespace {

/// A number in [0, 1).
double unit_number(Rng& dice) { return double(dice.next() >> 11) * 0x1p-53; }

glm::dvec3 cosine_weighted(const glm::dvec3& normal, Rng& dice) {
    const double z = 2 * unit_number(dice) - 1, angle = 2 * M_PI * unit_number(dice),
                 r = std::sqrt(1 - z * z);
    const glm::dvec3 d = normal + glm::dvec3(r * std::cos(angle), r * std::sin(angle), z);
    return glm::dot(d, d) > 0 ? glm::normalize(d) : normal;
}

/// A point just off a surface, and the surface's normal on that side.
struct Spot {
    bool there = false;
    glm::dvec3 point{0}, normal{0};
};

/// Makes the rays that follow camera rays, from the reference's hits.
class RayGenerator {
public:
    RayGenerator(const Scene& scene, const RayStreamPlan& plan, const Config& config)
        : scene_(scene), plan_(plan), reference_(scene) {
        const Bounds b = bounds(scene);
        const double diagonal = glm::length(b.hi - b.lo);
        off_ = diagonal * 0x1p-16;
        radius_ = plan.radius > 0 ? plan.radius : diagonal / 10;
        const Lattice lattice = fit_lattice(scene, scene.camera->eye, config.coord_bits, true,
                                            room_around_planes(scene, streaming(config, scene)));
        const Frame frame = make_frame(*scene.camera, plan.size, lattice, config);
        const auto size = plan.size;
        directions_.resize(std::size_t(size.width) * std::size_t(size.height));
        for (std::size_t i = 0; i < directions_.size(); ++i) {
            const auto x = std::uint32_t(i % std::size_t(size.width)),
                       y = std::uint32_t(i / std::size_t(size.width));
            const Vec3i d = pixel_direction(x, y, frame, config);
            directions_[i] = {double(d[0]), double(d[1]), double(d[2])};
        }
        for (int k = 0; k < 3; ++k)
            eye_[k] = lattice.centre[k] + lattice.pitch[k] * frame.eye[std::size_t(k)];
    }

    /// Returns the rays of a pixel.
    std::vector<StreamRay> rays(std::size_t pixel) const {
        Rng dice(Rng(Rng(plan_.seed).next() ^ pixel).next());
        std::vector<StreamRay> all;
        if (plan_.kind == RayStreamKind::camera) {
            all.push_back({eye_, directions_[pixel]});
            return all;
        }
        glm::dvec3 from = eye_, direction = directions_[pixel];
        Spot spot = spot_of(from, direction);
        const bool bounces = plan_.kind == RayStreamKind::mirror || plan_.kind == RayStreamKind::diffuse;
        for (int k = 1; bounces && k < plan_.bounce && spot.there; ++k) {
            direction = bounced(direction, spot, dice);
            spot = spot_of(spot.point, direction);
        }
        if (!spot.there) return all;
        const double endless = std::numeric_limits<double>::infinity();
        switch (plan_.kind) {
            case RayStreamKind::shadow:
                for (const Light& light : scene_.lights)
                    all.push_back({spot.point, light.position - spot.point, 0, 1, true});
                break;
            case RayStreamKind::ao:
                for (int i = 0; i < plan_.samples; ++i)
                    all.push_back({spot.point, cosine_weighted(spot.normal, dice), 0, radius_, true});
                break;
            case RayStreamKind::mirror:
                all.push_back({spot.point, bounced(direction, spot, dice), 0, endless, false});
                break;
            default:
                for (int i = 0; i < plan_.samples; ++i)
                    all.push_back({spot.point, cosine_weighted(spot.normal, dice), 0, endless, false});
        }
        return all;
    }

private:
    glm::dvec3 bounced(const glm::dvec3& d, const Spot& spot, Rng& dice) const {
        if (plan_.kind == RayStreamKind::mirror) return d - 2 * glm::dot(d, spot.normal) * spot.normal;
        return cosine_weighted(spot.normal, dice);
    }
    /// Returns the spot that a ray hits. Its point lies on the surface in double precision, because the
    /// reference's depth is a float.
    Spot spot_of(const glm::dvec3& from, const glm::dvec3& direction) const {
        const Hit hit = reference_.trace(from, direction);
        if (hit.primitive == no_primitive) return {};
        const glm::dvec3 near = from + glm::normalize(direction) * double(hit.depth);
        glm::dvec3 n = front_normal(scene_, hit.primitive, near);
        const double along = glm::dot(n, direction);
        if (along == 0 || !(glm::length(n) > 0)) return {};
        const glm::dvec3 point = point_on(scene_, hit.primitive, near, direction);
        n = glm::normalize(n);
        if (along > 0) n = -n;
        return {true, point + n * off_, n};
    }

    const Scene& scene_;
    const RayStreamPlan& plan_;
    Reference reference_;
    double off_ = 0, radius_ = 0;
    glm::dvec3 eye_{0};
    std::vector<glm::dvec3> directions_;
};

/// Sorts rays by the Morton code of origin and direction, ten bits of each coordinate.
void sort_by_place(std::vector<StreamRay>& rays) {
    glm::dvec3 low{1e300}, high{-1e300};
    for (const StreamRay& r : rays) low = glm::min(low, r.origin), high = glm::max(high, r.origin);
    const auto code = [&](const StreamRay& r) {
        std::array<std::uint64_t, 6> parts;
        const glm::dvec3 d = glm::normalize(r.direction);
        for (int k = 0; k < 3; ++k) {
            const double size = high[k] - low[k];
            parts[std::size_t(k)] = size > 0 ? std::uint64_t((r.origin[k] - low[k]) / size * 1023) : 0;
            parts[std::size_t(3 + k)] = std::uint64_t((d[k] + 1) / 2 * 1023);
        }
        std::uint64_t bits = 0;
        for (int bit = 9; bit >= 0; --bit)
            for (const std::uint64_t part : parts) bits = bits << 1 | (part >> bit & 1);
        return bits;
    };
    std::vector<std::pair<std::uint64_t, std::size_t>> order;
    for (std::size_t i = 0; i < rays.size(); ++i) order.emplace_back(code(rays[i]), i);
    std::sort(order.begin(), order.end());
    std::vector<StreamRay> sorted;
    sorted.reserve(rays.size());
    for (const auto& [key, i] : order) sorted.push_back(rays[i]);
    rays = std::move(sorted);
}

/// Shuffles rays (Fisher, Yates 1938).
void shuffle(std::vector<StreamRay>& rays, std::uint64_t seed) {
    Rng dice(seed);
    for (std::size_t i = rays.size(); i > 1; --i) std::swap(rays[i - 1], rays[dice.next() % i]);
}

}   // namespace

std::vector<StreamRay> make_rays(const Scene& scene, const RayStreamPlan& plan, const Config& config,
                                 int threads, const Progress& progress) {
    if (plan.kind == RayStreamKind::shadow && scene.lights.empty())
        throw UserError(scene.name + ": there is no light, so there are no shadow rays");
    const std::size_t of_a_hit = plan.kind == RayStreamKind::shadow ? scene.lights.size()
                                 : plan.kind == RayStreamKind::ao || plan.kind == RayStreamKind::diffuse
                                     ? std::size_t(plan.samples)
                                     : 1;
    const std::size_t all = std::size_t(plan.size.width) * std::size_t(plan.size.height) * of_a_hit;
    if (all > max_rays)
        throw UserError("up to " + std::to_string(all) + " rays would be made, and a stream has at most " +
                        std::to_string(max_rays));
    const RayGenerator maker(scene, plan, config);
    const auto width = std::size_t(plan.size.width);
    std::vector<std::vector<StreamRay>> of_pixel(width * std::size_t(plan.size.height));
    for_each_tile(plan.size, threads, "rays", progress, [&](const PixelTile& tile) {
        for (int y = tile.rows().begin(); y < tile.rows().end(); ++y)
            for (int x = tile.cols().begin(); x < tile.cols().end(); ++x) {
                const std::size_t pixel = std::size_t(y) * width + std::size_t(x);
                of_pixel[pixel] = maker.rays(pixel);
            }
    });
    std::vector<StreamRay> rays;
    for (auto& some : of_pixel) {
        rays.insert(rays.end(), some.begin(), some.end());
        some = {};
    }
    order_rays(rays, plan.order, plan.seed);
    return rays;
}

void order_rays(std::vector<StreamRay>& rays, RayOrder order, std::uint64_t seed) {
    if (order == RayOrder::morton) sort_by_place(rays);
    if (order == RayOrder::random) shuffle(rays, seed);
}

namespace {

/// Returns the position of a word among others. Throws UserError.
int chosen(const std::string& option, const std::string& typed, const std::vector<std::string>& words) {
    const auto at = std::find(words.begin(), words.end(), typed);
    if (at == words.end())
        throw UserError(fmt::format("{}: {} is not one of {}", option, shown(typed), fmt::join(words, ", ")));
    return int(at - words.begin());
}

}   // namespace

RayStreamPlan ray_stream_plan(const RayStreamChoice& c, const std::string& prefix) {
    const auto check = [&](const char* name, int value, int most) {
        if (value < 1 || value > most)
            throw UserError(fmt::format("{}{} must lie in 1..{}, not {}", prefix, name, most, value));
    };
    RayStreamPlan plan;
    plan.kind =
        RayStreamKind(chosen(prefix + "kind", c.kind, {"camera", "shadow", "mirror", "ao", "diffuse"}));
    plan.order = RayOrder(chosen(prefix + "order", c.order, {"recorded", "morton", "random"}));
    check_frame_size(c.size);
    check("bounce", c.bounce, 16);
    check("samples", c.samples, 1024);
    if (c.radius && !(*c.radius > 0 && std::isfinite(*c.radius)))
        throw UserError(fmt::format("{}radius must be above 0, not {}", prefix, *c.radius));
    plan.size = c.size, plan.bounce = c.bounce, plan.samples = c.samples, plan.seed = c.seed;
    plan.radius = c.radius.value_or(0);
    return plan;
}

std::string rays_npy(const std::vector<StreamRay>& rays, const std::string& scene) {
    if (rays.empty())
        throw UserError(scene + ": the stream would be empty, because no earlier ray hits a surface");
    const bool plain = std::none_of(rays.begin(), rays.end(), [](const StreamRay& r) {
        return r.any_hit || r.t_min != 0 || std::isfinite(r.t_max);
    });
    const std::size_t columns = plain ? 6 : 9;
    std::string bytes = npy_head("'<f8'", {rays.size(), columns});
    bytes.reserve(bytes.size() + rays.size() * columns * sizeof(double));
    for (const StreamRay& r : rays) {
        const std::array<double, 9> row{r.origin.x,    r.origin.y,    r.origin.z,
                                        r.direction.x, r.direction.y, r.direction.z,
                                        r.t_min,       r.t_max,       double(r.any_hit)};
        char raw[sizeof row];
        std::memcpy(raw, row.data(), sizeof row);
        bytes.append(raw, columns * sizeof(double));
    }
    return bytes;
}

}   // namespace rayclock
