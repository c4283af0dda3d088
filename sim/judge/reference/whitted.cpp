// Whitted's picture in double precision, written from the rules and not from the machine. It has Phong's
// local light (1975), shadow rays to point lights, reflection, and refraction by Snell's law. Materials may
// request Schlick's approximation (1994).
#include "sim/judge/reference/whitted.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "sim/judge/reference/holes.hpp"
#include "sim/judge/reference/tiles.hpp"

namespace rayclock {
namespace {

// The offset of a secondary ray's start. Two measures keep the ray from hitting the surface that it leaves,
// and neither depends on the rounding of the hit. First, the search excludes the primitive itself: a straight
// ray cannot hit a triangle or plane again. Of a sphere it can hit only the far root, from inside.
//
// This suffices on a single primitive, but not next to an edge, where the rounded point may lie behind the
// neighbour's plane. So the start also moves off the surface, to the side that the ray goes to. A hit is off
// its surface by about 2^-50 of its distance from the middle of the scene. The offset of 2^-36 is far above
// that. It is far below anything visible: a picture of 512 x 512 has pixels of 2^-9.
constexpr double off_surface = 0x1p-36;

glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& otherwise) {
    const double length = glm::length(v);
    return length > 0 && std::isfinite(length) ? v / length : otherwise;
}

/// Traces the rays of pixels and counts them.
class WhittedTracer {
public:
    WhittedTracer(const RefGeometry& geometry, const Scene& scene, const Whitted& settings,
                  const RayWatch& watch, double spread, RefSteer* steer = nullptr)
        : geometry_(geometry),
          scene_(scene),
          settings_(settings),
          watch_(watch),
          spread_(spread),
          steer_(steer) {}

    glm::dvec3 pixel(const PixelRays& rays, std::uint32_t x, std::uint32_t y, Hit& first);
    const RayCounts& counts() const { return counts_; }
    std::uint64_t signature() const { return signature_.value(); }

private:
    RefClosest closest(const RefPath& path);
    void report_ray(const RefPath& path, double reach, bool hits,
                    std::vector<std::uint32_t> blockers = {}) const;
    glm::dvec3 sample(const RefPath& path, RefClosest& hit);
    void follow(const RefPath& path, double weight, int depth);
    void shade(const RefPath& path, const RefClosest& hit, double weight, int depth);
    void reflect_and_refract(const RefPath& path, const RefSurface& surface, double weight, int depth);
    glm::dvec3 light(const RefPath& path, const RefSurface& surface, std::size_t number);
    bool sends(RefBounce& bounce) const;
    void follow_bounce(const RefBounce& bounce, int depth);

    RefSurface surface_of(const RefPath& path, const RefClosest& hit) const;
    void on_triangle(const RefPath& path, const RefClosest& hit, RefSurface& surface) const;
    void on_sphere(const RefPath& path, const RefClosest& hit, RefSurface& surface) const;
    void on_plane(const RefClosest& hit, RefSurface& surface) const;
    void find_place(const Texture& texture, const RefClosest& hit, const RefSurface& surface,
                    RefTexel& texel) const;
    glm::dvec3 picture(const RefPath& path, const RefClosest& hit, RefSurface& surface) const;

    static RefPath leave(const RefSurface& surface, const glm::dvec3& direction, bool goes_through);

    const RefGeometry& geometry_;
    const Scene& scene_;
    const Whitted& settings_;
    const RayWatch& watch_;
    const double spread_;     ///< see sample_spread()
    RefSteer* const steer_;   ///< null: the tracer follows its own rays
    RayCounts counts_;
    glm::dvec3 sum_{0};         ///< of the current sample
    PathSignature signature_;   ///< of the pixel
};

void WhittedTracer::on_triangle(const RefPath& path, const RefClosest& hit, RefSurface& surface) const {
    const Triangle& triangle = scene_.triangles[hit.primitive];
    const auto& vertex = triangle.vertex;
    const RefUnitSpace& space = geometry_.space();
    const glm::dvec3 a = space(scene_.vertices[vertex[0]]), b = space(scene_.vertices[vertex[1]]),
                     c = space(scene_.vertices[vertex[2]]);
    surface.material = &scene_.materials[triangle.material];
    surface.position = (1 - hit.u - hit.v) * a + hit.u * b + hit.v * c;
    const glm::dvec3 outside = glm::cross(b - a, c - a);
    surface.flat = surface.normal = unit_or(outside, -path.direction);
    if (scene_.normals.empty()) return;
    std::array<glm::dvec3, 3> n{scene_.normals[vertex[0]], scene_.normals[vertex[1]],
                                scene_.normals[vertex[2]]};
    // The order of the vertices decides which side is outside. If the sum of the corner normals points
    // inwards, all three are turned.
    const double along = glm::dot(n[0] + n[1] + n[2], outside);
    if (along < 0)
        for (glm::dvec3& corner : n) corner = -corner;
    RefClosest at = hit;
    if (steer_) {
        // The limit covers rounding: each corner has the errors of its coordinates, and an edge at most four
        // times as much.
        const double normals = glm::length(n[0]) + glm::length(n[1]) + glm::length(n[2]),
                     corners = glm::length(a) + glm::length(b) + glm::length(c),
                     edges = glm::length(b - a) + glm::length(c - a);
        steer_->round_corners(at, n, std::abs(along) <= 0x1p-48 * normals * corners * edges);
    }
    surface.normal = unit_or((1 - at.u - at.v) * n[0] + at.u * n[1] + at.v * n[2], surface.flat);
}

void WhittedTracer::on_sphere(const RefPath& path, const RefClosest& hit, RefSurface& surface) const {
    const Sphere& sphere = scene_.spheres[hit.primitive - scene_.triangles.size()];
    const glm::dvec3 centre = geometry_.space()(sphere.centre);
    surface.material = &scene_.materials[sphere.material];
    surface.flat = surface.normal = unit_or(path.from + hit.depth * path.direction - centre, -path.direction);
    surface.position = centre + sphere.radius * geometry_.space().scale * surface.flat;
}

void WhittedTracer::on_plane(const RefClosest& hit, RefSurface& surface) const {
    const Plane& plane = scene_.planes[hit.primitive - scene_.triangles.size() - scene_.spheres.size()];
    const RefUnitSpace& space = geometry_.space();
    surface.material = &scene_.materials[plane.material];
    surface.position = space(plane.point) + hit.u * space.scale * plane.u + hit.v * space.scale * plane.v;
    surface.flat = surface.normal =
        glm::normalize(glm::cross(glm::normalize(plane.u), glm::normalize(plane.v)));
    const bool is_other =
        surface.material->checkered && std::fmod(std::floor(hit.u) + std::floor(hit.v), 2) != 0;
    surface.colour = is_other ? surface.material->other : surface.material->colour;
    if (steer_) surface.colour = steer_->plane_colour(hit, *surface.material, surface.colour);
}

/// Finds the place in the texture of the surface that was hit, and the density of its texels
/// (RefTexel::detail).
void WhittedTracer::find_place(const Texture& texture, const RefClosest& hit, const RefSurface& surface,
                               RefTexel& texel) const {
    const std::size_t triangles = scene_.triangles.size(), planes = triangles + scene_.spheres.size();
    const auto between = [&](const CornerCoordinates& c) {
        return (1 - hit.u - hit.v) * c[0] + hit.u * c[1] + hit.v * c[2];
    };
    if (hit.primitive < triangles) {
        texel.st = between(scene_.coordinates[hit.primitive]);
        texel.detail = texture_detail(scene_, hit.primitive);
    } else if (hit.primitive < planes) {
        texel.st = octahedral_place(surface.normal);
        texel.detail = texture_detail(texture, scene_.spheres[hit.primitive - triangles]);
    } else {
        const Plane& plane = scene_.planes[hit.primitive - planes];
        texel.st = between(plane.coordinates);
        texel.detail = texture_detail(texture, plane);
    }
}

/// Returns the factor of a surface's colour: the colour of its texture, or 1. Determines whether a triangle
/// has a hole there.
glm::dvec3 WhittedTracer::picture(const RefPath& path, const RefClosest& hit, RefSurface& surface) const {
    const std::optional<std::uint32_t> number = texture_of(scene_, hit.primitive);
    if (!number) return glm::dvec3(1);
    const Texture& texture = scene_.textures[*number];
    RefTexel own{glm::dvec2(0),
                 0,
                 surface.travelled / geometry_.space().scale,
                 spread_,
                 std::abs(glm::dot(surface.normal, path.direction)),
                 glm::dvec3(0)};
    find_place(texture, hit, surface, own);
    const double lod = level_of_detail(own.detail, own.distance, own.spread, own.cosine);
    const glm::dvec4 found = filtered_with_alpha(texture, own.st, level_of(texture, lod));
    own.colour = glm::dvec3(found);
    own.is_hole = hit.primitive < scene_.triangles.size() && found.a < surface.material->cutoff;
    if (steer_) steer_->texel(hit, surface, own);
    surface.is_hole = own.is_hole;
    return own.colour;
}

RefSurface WhittedTracer::surface_of(const RefPath& path, const RefClosest& hit) const {
    RefSurface surface;
    surface.primitive = hit.primitive;
    if (hit.primitive < scene_.triangles.size())
        on_triangle(path, hit, surface);
    else if (hit.primitive < scene_.triangles.size() + scene_.spheres.size())
        on_sphere(path, hit, surface);
    else
        on_plane(hit, surface);
    if (hit.primitive < scene_.triangles.size() + scene_.spheres.size())
        surface.colour = surface.material->colour;
    surface.travelled = path.travelled + hit.depth;
    surface.colour *= picture(path, hit, surface);
    // Until here both normals point outwards.
    surface.is_inside = glm::dot(surface.flat, path.direction) > 0;
    if (surface.is_inside) {
        surface.flat = -surface.flat;
        surface.normal = -surface.normal;
    }
    if (steer_) steer_->move_ray_origin(surface);
    return surface;
}

RefPath WhittedTracer::leave(const RefSurface& surface, const glm::dvec3& direction, bool goes_through) {
    const glm::dvec3 size = glm::abs(surface.position);
    const double reach = 1 + std::max(size.x, std::max(size.y, size.z));
    const glm::dvec3 side = goes_through ? -surface.flat : surface.flat;
    return {surface.position + off_surface * reach * side, direction, surface.primitive,
            goes_through != surface.is_inside, surface.travelled};
}

/// Returns the light that one source adds, or 0 if it is blocked.
glm::dvec3 WhittedTracer::light(const RefPath& path, const RefSurface& surface, std::size_t number) {
    const Light& light = scene_.lights[number];
    const Material& m = *surface.material;
    const bool is_turned = watch_.lights_outside_of_glass && m.transmit > 0 && surface.is_inside;
    const double side = is_turned ? -1 : 1;
    const glm::dvec3 position = geometry_.space()(light.position), to_light = position - surface.position;
    const double faces = glm::dot(side * surface.flat, to_light);
    if (!(faces > 0) && !steer_) return glm::dvec3(0);
    const glm::dvec3 l = glm::normalize(to_light);
    const double lambert = side * glm::dot(surface.normal, l);
    const bool counts = steer_ ? steer_->light_counts(number, faces / glm::length(to_light), lambert)
                               : faces > 0 && lambert > 0;
    if (!counts) return glm::dvec3(0);

    ++counts_.shadow;
    RefPath shadow = leave(surface, l, is_turned);
    const double distance = glm::length(position - shadow.from);
    if (!(distance > 0)) {   // a light on the surface
        signature_.asked(true);
        return glm::dvec3(0);
    }
    shadow.direction = (position - shadow.from) / distance;
    bool is_blocked = hidden_at(geometry_, scene_, shadow, distance, spread_).surely;
    if (steer_) is_blocked = steer_->is_blocked(number, shadow, distance, is_blocked);
    if (watch_.see) report_ray(shadow, distance, is_blocked, geometry_.blockers(shadow, distance));
    signature_.asked(is_blocked);
    if (is_blocked) return glm::dvec3(0);

    const glm::dvec3 mirrored = 2 * std::max(lambert, 0.0) * side * surface.normal - l;
    double along = -glm::dot(mirrored, path.direction);
    if (steer_ && glm::dot(surface.normal, path.direction) > 0)   // as docs/machine/shading.md has it
        along = glm::dot(l, path.direction);
    const double phong = std::pow(std::max(0.0, along), m.shine);
    return light.colour * (m.diffuse * std::max(lambert, 0.0) * surface.colour + m.highlight * phong);
}

/// Snell's law with an index of 1 for the surrounding medium. `cosine` is that between the normal and the
/// reversed ray.
struct Refraction {
    double ratio, rest;   ///< rest: the squared cosine of the refracted ray; negative: total reflection
    Refraction(double index, bool is_inside, double cosine)
        : ratio(is_inside ? index : 1 / index), rest(1 - ratio * ratio * (1 - cosine * cosine)) {}
    bool is_total() const { return rest < 0; }
    glm::dvec3 direction(const glm::dvec3& d, const glm::dvec3& normal, double cosine) const {
        return glm::normalize(ratio * d + (ratio * cosine - std::sqrt(std::max(rest, 0.0))) * normal);
    }
};

double schlick(double index, double cosine) {
    const double root = (1 - index) / (1 + index), r0 = root * root;
    return r0 + (1 - r0) * std::pow(1 - cosine, 5);
}

/// A total reflection counts as a refracted ray where a refracted ray would have been sent, as Haines
/// counts it.
void WhittedTracer::reflect_and_refract(const RefPath& path, const RefSurface& surface, double weight,
                                        int depth) {
    const Material& m = *surface.material;
    // Near its outline a smooth surface may show its back. Then it counts as seen edge-on.
    const double cosine = std::clamp(-glm::dot(surface.normal, path.direction), 0.0, 1.0);
    const double fresnel = m.schlick ? schlick(m.index, cosine) : 0;
    // A surface never sends on more light than it receives.
    double reflected = weight * std::min(m.mirror + m.transmit * fresnel, 1.0),
           refracted = weight * m.transmit * (1 - fresnel);
    const bool transmits = m.transmit > 0;
    const Refraction refraction(transmits ? m.index : 1, surface.is_inside, cosine);
    bool is_total = transmits && refraction.is_total();
    if (steer_ && transmits) is_total = steer_->is_total(surface, refraction.ratio, cosine, is_total);
    if (is_total) {
        refracted = weight * m.transmit;
        reflected = weight * std::min(m.mirror + m.transmit, 1.0);
    }
    RefBounce mirrored{RefBounce::Interaction::reflected,
                       surface,
                       glm::normalize(path.direction + 2 * cosine * surface.normal),
                       reflected,
                       weighs_enough(reflected, settings_.threshold),
                       cosine};
    if (sends(mirrored)) {
        ++counts_.reflection;
        follow_bounce(mirrored, depth);
    }
    if (!transmits) return;
    const bool is_called = weighs_enough(refracted, settings_.threshold);
    if (is_total) {
        counts_.refraction += is_called;
        return;
    }
    RefBounce bent{RefBounce::Interaction::refracted,
                   surface,
                   refraction.direction(path.direction, surface.normal, cosine),
                   refracted,
                   is_called,
                   cosine,
                   refraction.ratio};
    if (!sends(bent)) return;
    ++counts_.refraction;
    follow_bounce(bent, depth);
}

bool WhittedTracer::sends(RefBounce& bounce) const {
    if (steer_) return steer_->accept_bounce(bounce);
    const double side = glm::dot(bounce.direction, bounce.surface.flat);
    return bounce.weighs_enough &&
           (bounce.interaction == RefBounce::Interaction::reflected ? side > 0 : side < 0);
}

void WhittedTracer::follow_bounce(const RefBounce& bounce, int depth) {
    if (steer_) steer_->enter(bounce.interaction);
    follow(leave(bounce.surface, bounce.direction, bounce.interaction == RefBounce::Interaction::refracted),
           bounce.weight, depth + 1);
    if (steer_) steer_->leave();
}

void WhittedTracer::shade(const RefPath& path, const RefClosest& hit, double weight, int depth) {
    const RefSurface surface = surface_of(path, hit);
    const Material& m = *surface.material;
    if (surface.is_hole && path.holes < max_holes) {
        ++counts_.refraction;
        if (steer_) steer_->enter(RefBounce::Interaction::passed);
        RefPath onward = leave(surface, path.direction, true);
        onward.holes = path.holes + 1;
        follow(onward, weight, depth);
        if (steer_) steer_->leave();
        return;
    }
    glm::dvec3 local = m.ambient * surface.colour;
    for (std::size_t i = 0; i < scene_.lights.size(); ++i) local += light(path, surface, i);
    sum_ += weight * local;
    if (depth < settings_.depth && (m.mirror > 0 || m.transmit > 0))
        reflect_and_refract(path, surface, weight, depth);
}

void WhittedTracer::report_ray(const RefPath& path, double reach, bool hits,
                               std::vector<std::uint32_t> blockers) const {
    const RefUnitSpace& space = geometry_.space();
    watch_.see({space.centre + path.from / space.scale, path.direction, reach / space.scale, hits,
                std::move(blockers)});
}

RefClosest WhittedTracer::closest(const RefPath& path) {
    RefClosest hit = geometry_.closest(path);
    if (steer_) hit = steer_->choose_hit(path, hit);
    const bool hits = hit.primitive != no_primitive;
    if (watch_.see) report_ray(path, hits ? hit.depth : HUGE_VAL, hits);
    return hit;
}

void WhittedTracer::follow(const RefPath& path, double weight, int depth) {
    const RefClosest hit = closest(path);
    signature_.met(hit.primitive);
    if (hit.primitive == no_primitive)
        sum_ += weight * scene_.background;
    else
        shade(path, hit, weight, depth);
}

glm::dvec3 WhittedTracer::sample(const RefPath& path, RefClosest& hit) {
    ++counts_.primary;
    hit = closest(path);
    signature_.met(hit.primitive);
    if (hit.primitive == no_primitive) return scene_.background;
    ++counts_.primary_hits;
    sum_ = glm::dvec3(0);
    shade(path, hit, 1, 0);
    return glm::min(sum_, glm::dvec3(1));
}

/// Returns the mean of all samples, or of the first few if they differ little.
glm::dvec3 WhittedTracer::pixel(const PixelRays& rays, std::uint32_t x, std::uint32_t y, Hit& first) {
    const auto samples = static_cast<std::uint32_t>(settings_.aa * settings_.aa);
    glm::dvec3 total(0), darkest(1), brightest(0);
    signature_.start();
    for (std::uint32_t s = 0; s < samples; ++s) {
        const SampleOffset offset = sample_offset(x, y, s, settings_.aa, settings_.jitter, settings_.seed);
        RefClosest hit;
        RefPath path;
        const bool is_ray =
            geometry_.find_path(rays.eye, rays.direction(x + offset.x / 256.0, y + offset.y / 256.0), path);
        if (steer_) steer_->begin_sample(s, path);
        const glm::dvec3 colour = is_ray ? sample(path, hit) : scene_.background;
        if (s == 0) first = ref_hit(hit, geometry_.space());
        total += colour;
        darkest = glm::min(darkest, colour);
        brightest = glm::max(brightest, colour);
        const glm::dvec3 range = brightest - darkest;
        const double difference = std::max(range.r, std::max(range.g, range.b));
        const bool may_end = s + 1 == first_samples && settings_.contrast > 0;
        bool ends = may_end && difference <= settings_.contrast;
        if (steer_ && may_end) ends = steer_->ends_sampling(s + 1, difference, ends);
        if (ends) return total / static_cast<double>(first_samples);
    }
    return total / static_cast<double>(samples);
}

}   // namespace

WhittedFrame ref_whitted(const RefGeometry& geometry, const Scene& scene, const Camera& camera,
                         FrameSize size, const Whitted& settings, int threads, const Progress& progress,
                         const RayWatch& watch) {
    check_frame_size(size);
    const PixelRays rays = pixel_rays(camera, size);
    const std::size_t pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    WhittedFrame frame{std::vector<glm::dvec3>(pixels),
                       {},
                       {size, std::vector<Hit>(pixels)},
                       std::vector<std::uint64_t>(pixels)};
    std::mutex adding;
    for_each_tile(size, threads, "reference", progress, [&](const PixelTile& tile) {
        WhittedTracer tracer(geometry, scene, settings, watch, sample_spread(camera, size, settings.aa));
        for (int y = tile.rows().begin(); y < tile.rows().end(); ++y)
            for (int x = tile.cols().begin(); x < tile.cols().end(); ++x) {
                const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                                       static_cast<std::size_t>(x);
                frame.pixels[at] = tracer.pixel(rays, static_cast<std::uint32_t>(x),
                                                static_cast<std::uint32_t>(y), frame.hits.hits[at]);
                frame.signatures[at] = tracer.signature();
            }
        const std::lock_guard lock(adding);
        frame.rays += tracer.counts();
    });
    return frame;
}

WhittedPixel ref_pixel(const RefGeometry& geometry, const Scene& scene, const Camera& camera, FrameSize size,
                       const Whitted& settings, std::uint32_t x, std::uint32_t y, RefSteer* steer) {
    static const RayWatch nobody;
    WhittedTracer tracer(geometry, scene, settings, nobody, sample_spread(camera, size, settings.aa), steer);
    WhittedPixel pixel;
    pixel.colour = tracer.pixel(pixel_rays(camera, size), x, y, pixel.first);
    pixel.signature = tracer.signature();
    return pixel;
}

}   // namespace rayclock
