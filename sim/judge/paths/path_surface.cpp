// Judges the surface where a ray arrives: the point, the vectors there, and the lights.
#include "model/base/axes.hpp"
#include "model/compile/plane.hpp"
#include "model/scene/placed.hpp"
#include "sim/judge/paths/path.hpp"

namespace rayclock {

namespace {

constexpr std::uint32_t full_share = 1u << unit_bits;
using Wide3 = oracle::Triple<Int128>;

double ratio_of(const Material& m, bool from_inside) {
    const double index = m.index > 0 ? m.index : 1;
    return std::min(from_inside ? index : 1 / index, (std::exp2(ratio_bits) - 1) * std::exp2(-index_frac));
}

/// Returns the value of a field of `bits` bits in two's complement.
std::int64_t signed_value(std::uint32_t field, int bits) {
    const std::int64_t half = std::int64_t(1) << (bits - 1);
    return std::int64_t(field) >= half ? std::int64_t(field) - 2 * half : field;
}

/// True if `unit` equals v / |v|. Each component may differ by the error of unit_vector().
bool is_unit(const Vec3i& unit, const glm::dvec3& v) {
    const glm::dvec3 exact = unit_or_zero(v);
    for (int k = 0; k < 3; ++k)
        if (std::abs(unit[std::size_t(k)] * unit_step - exact[k]) > component_error) return false;
    return true;
}

/// Returns the product of two unit vectors, rounded to nearest and clamped to 0..1.
std::uint32_t promised_cosine(const Vec3i& a, const Vec3i& b) {
    return std::uint32_t(std::clamp<Int128>(nearest_of_power(dot(a, b), unit_bits), 0, full_share));
}

}   // namespace

void PathJudge::arrive(const PassIn& in, const PassOut& out) {
    const ShadeState& s = out.state;
    demand(in.o == bounce_ray_.o && in.d == bounce_ray_.d,
           "a pass was given another ray than the one that arrived");
    place_ = {};
    if (answer_.found && config_.has_textures()) place_.texture = textured(answer_.prim);
    demand(out.leave == (place_.texture && !rules_.placed ? PassOut::Leave::texture : PassOut::Leave::again),
           "a surface sends a ray, or does not request its texture");
    if (branch_.depth == 0 && sample_ == 0 && holes_ == 0)
        demand(s.found == answer_.found && s.prim == answer_.prim && s.t == answer_.t && s.u == answer_.u &&
                   s.v == answer_.v,
               "the pixel's first hit is not kept");
    if (!answer_.found) {
        background(branch_.weight, branch_.exact);
        demand(s.next_event == ShadeEvent::pop, "after the background comes the next ray");
        return;
    }
    if (rules_.placed && visit_.place == oracle::PlacedRay::nowhere)
        return;   // the fault is already recorded
    place_.ratio = ratio_of(rules_.placed ? rules_.placed->material(answer_.prim)
                                          : material_of(rules_.inputs.scene, answer_.prim),
                            answer_.back != 0);
    place_.surface = rules_.placed
                         ? rules_.placed->surface(answer_.prim)
                         : expected_surface(rules_.inputs.scene, rules_.primitives, config_, answer_.prim);
    if (place_.surface.kind == PrimKind::plane)   // its squares are judged with the colours
        place_.surface.colour = in.surface.colour, place_.surface.other = in.surface.other,
        place_.surface.normal = in.surface.normal;
    if (place_.surface.smooth) {
        const bool holds = rules_.placed ? rules_.placed->holds_normals(answer_.prim, in.surface)
                                         : holds_normals(rules_.inputs.scene, answer_.prim, in.surface);
        demand(holds, "memory does not hold the corner normals of the triangle that was hit");
        place_.surface.normal = in.surface.normal;
    }
    if (place_.texture) {   // filtered() judges the record
        demand(in.surface.record != 0, "memory holds no texture for the surface that was hit");
        place_.surface.record = in.surface.record;
    }
    demand(in.surface == place_.surface, "memory does not hold the surface that was hit");
    place_.pane = place_.surface.kind == PrimKind::plane ? pane_bit(rules_.inputs, answer_.prim) : 0;
    demand(s.across == (branch_.cell ^ place_.pane),
           "the other side of a plane is told from this one wrongly");
    judge_place(in, s);
    if (config_.has_textures()) {
        std::optional<Vec3l> far_way;
        if (place_.surface.kind == PrimKind::plane && answer_.t == (1u << config_.t_bits()) - 1)
            far_way = by_axis([&](std::size_t k) { return s.o[k] - in.o[k]; });
        path_ = path_length(path_, in.d, answer_.t, far_way, config_);
        demand(s.record == place_.surface.record && s.ambient == place_.surface.ambient &&
                   (s.is_round != 0) == (place_.surface.kind == PrimKind::sphere),
               "the material that was hit is not kept");
    }
    if (place_.texture && !rules_.placed) return demand_texture(s, out);
    if (!place_.texture) ambient(s);
    if (rules_.placed) {
        demand(rules_.placed->is_map_of(visit_.place, in.placement),
               "memory does not hold the instance that was hit");
        return demand(s.next_event == ShadeEvent::transform,
                      "no transform pass follows an instance's surface");
    }
    demand_lights(s);
}

/// Judges the scale of a request to tex. `place`: number of the instance; nowhere: there are no instances.
void PathJudge::demand_scale(const TexReq& hit, std::uint32_t place) {
    demand(place == oracle::PlacedRay::nowhere ||
               is_scale(hit.scale, rules_.placed->solids().places()[place].a, config_),
           "the request to tex has another scale than the instance's");
}

/// Judges the request to tex. The texture's colour and the ambient light come later.
void PathJudge::demand_texture(const ShadeState& s, const PassOut& out) {
    demand(s.next_event == ShadeEvent::texture, "no texture pass follows a textured surface");
    const TexReq& hit = out.tex;
    demand_scale(hit, visit_.place);
    bool is_there = hit.u == answer_.u && hit.v == answer_.v;
    if (place_.texture && place_.texture->kind == PrimKind::sphere)
        is_there = is_octahedral(
            hit, by_axis([&](std::size_t k) { return answer_.back ? -s.normal[k] : s.normal[k]; }), config_);
    demand(hit.record == s.record && is_there && hit.path == path_ && hit.cosine == s.cosine,
           "the request to tex has another hit than the ray's");
    texel_.reset();
}

void PathJudge::filtered(const TexReq& hit, const TexRecord& record, const TexelPlace& place,
                         const TexRsp& answer) {
    const std::optional<TexturedSurface>& surface = cutout_ ? cutout_ : place_.texture;
    if (!surface)
        fail("a surface without a texture is drawn with one");
    else if (const char* wrong = judge_texture(rules_.inputs, *surface, hit, record, place, answer))
        fail(wrong);
    texel_ = answer;
}

void PathJudge::texture(const PassIn& in, const PassOut& out) {
    const ShadeState& before = in.state;
    const ShadeState& s = out.state;
    demand(texel_ && in.texel == texel_->colour && in.hole == texel_->hole,
           "a pass was given another texture's colour");
    const bool goes_on = in.hole != 0 && holes_ < (1u << hole_bits) - 1;
    if (goes_on) ++holes_;
    ShadeState same = before;
    same.albedo = s.albedo, same.next_event = s.next_event, same.light = s.light, same.pending = s.pending,
    same.colour = s.colour, same.holes = holes_;
    demand(same == s, "the pass of a texture changes fields of the surface");
    for (std::size_t k = 0; k < 3; ++k)
        demand(s.albedo[k] == nearest_of_power(Int128(before.albedo[k]) * in.texel[k], share_bits),
               "the colour is not the surface's times the texture's");
    if (!goes_on) {
        demand(out.leave == PassOut::Leave::again, "a ray continues where its texture has no hole");
        ambient(s);
        return demand_lights(s);
    }
    // The ray starts at the hit point in the triangle, keeps its direction, and leaves on the other side.
    Expected ray{RayKind::bounce, {}, bounce_ray_.d, s.self, s.is_inside};
    ray.o = by_axis([&](std::size_t k) { return std::int32_t(s.o[k]); });
    ray.is_refracted = true;
    if (rules_.placed) ray.home = home_of(s, ray.d);
    demand(dot(s.n, way_of(ray)) < 0, "a ray continues on the side from which it came");
    expect_spawn(out, ray);
    demand(s.next_event == ShadeEvent::arrive, "no pass awaits the hit of a continued ray");
}

std::optional<TexturedSurface> PathJudge::textured(std::uint32_t primitive) const {
    return rules_.placed ? rules_.placed->textured(primitive)
                         : textured_surface(rules_.inputs.scene, rules_.inputs.lattice, primitive);
}

bool PathJudge::has_holes(std::uint32_t primitive) const {
    return rules_.placed ? rules_.placed->may_have_holes(primitive)
                         : may_have_holes(rules_.inputs.scene, primitive);
}

bool PathJudge::is_passed(std::uint32_t primitive) const {
    return std::find(light_holes_.begin(), light_holes_.end(), primitive) != light_holes_.end();
}

/// Judges the pass after a shadow ray has met a cut-out. If the instance has its own material, the cut-out
/// has no texture and hides the light.
void PathJudge::cutout(const PassIn& in, const PassOut& out) {
    cutout_ = textured(answer_.prim);
    ShadeState same = in.state;
    same.pending = out.state.pending, same.colour = out.state.colour;
    demand(same == out.state, "the pass of a cut-out changes fields of the surface");
    if (!cutout_)
        return demand(out.leave == PassOut::Leave::again, "a texture is requested for a cut-out without one");
    const TexReq& hit = out.tex;
    demand(out.leave == PassOut::Leave::texture, "the texture of a cut-out is not requested");
    demand(in.surface.record != 0 && hit.record == in.surface.record && hit.u == answer_.u &&
               hit.v == answer_.v && hit.path == path_ && hit.cosine == full_share,
           "the request to tex has another hit than the ray's");
    demand_scale(hit, rules_.placed ? rules_.placed->place_of(answer_.prim) : oracle::PlacedRay::nowhere);
    texel_.reset();
}

void PathJudge::demand_lights(const ShadeState& s) {
    const bool lights = !rules_.inputs.scene.lights.empty();
    demand(s.light == 0 && s.next_event == (lights ? ShadeEvent::light : after_lights(s)),
           "after a surface come its lights");
}

void PathJudge::judge_place(const PassIn& in, const ShadeState& s) {
    const Surface& surface = place_.surface;
    Vec3l toward{};
    if (surface.kind == PrimKind::sphere) {
        judge_sphere_place(in, s);
        toward = s.n;
    } else {
        judge_flat_place(in, s, toward);
    }
    judge_vectors(in, s, toward);
    demand(s.self == answer_.prim && s.is_inside == answer_.back, "the surface that was hit is not kept");
    demand(s.diffuse == surface.diffuse && s.highlight == surface.highlight && s.mirror == surface.mirror &&
               s.transmit == surface.transmit && s.shine == surface.shine && s.schlick == surface.schlick &&
               s.r0 == surface.r0,
           "the material that was hit is not kept");
    demand(s.ratio == (answer_.back ? surface.leave : surface.enter),
           "the ratio of indices is the wrong way round");
}

/// Judges that the point lies exactly on the surface, and strictly inside a triangle. Its weights are the
/// hit's, rounded, and moved off the border by the rule in docs/proofs/origins.md.
void PathJudge::judge_flat_place(const PassIn& in, const ShadeState& s, Vec3l& toward) {
    const Surface& surface = place_.surface;
    const bool is_plane = surface.kind == PrimKind::plane;
    const int fine = is_plane ? 0 : int(surface.fine), frac = config_.origin_bits + fine;
    const Int128 whole = Int128(1) << frac;
    const int drop = config_.bary_bits - frac;
    const std::int64_t hit_u = is_plane ? signed_value(answer_.u, config_.uv_bits()) : answer_.u;
    const std::int64_t hit_v = is_plane ? signed_value(answer_.v, config_.uv_bits()) : answer_.v;
    const Int128 near_u = nearest_of_power(hit_u, drop), near_v = nearest_of_power(hit_v, drop);
    const auto a = oracle::triple<Int128>(surface.a);
    const Wide3 e1 = oracle::way(a, oracle::triple<Int128>(surface.b)),
                e2 = oracle::way(a, oracle::triple<Int128>(surface.c)), normal = oracle::area(e1, e2);
    const Int128 most = (Int128(1) << (config_.point_width() - 1)) - 1;

    const Int128 end = ((Int128(1) << (config_.coord_bits - 1)) - 1) << config_.origin_bits;
    bool beyond = false, outside = false;
    const auto is_point = [&](Int128 u, Int128 v) {
        beyond = outside = false;
        for (std::size_t k = 0; k < 3; ++k) {
            // The division rounds; see fineness().
            const Int128 at = (Int128(surface.a[k]) * whole + u * e1[k] + v * e2[k]) / (Int128(1) << fine);
            beyond = beyond || at > most || at < -most;
            outside = outside || at > end || at < -end;
            if (std::clamp(at, -most, most) != s.o[k]) return false;
        }
        return true;
    };
    // In a triangle each weight is at least 1. First u and v are raised to 1. If the third is too small, the
    // larger of u and v (v if they are equal) gives the rest.
    Int128 u = near_u, v = near_v;
    if (!is_plane) {
        u = std::max<Int128>(u, 1), v = std::max<Int128>(v, 1);
        const Int128 lacks = std::max<Int128>(u + v + 1 - whole, 0);
        if (u > v)
            u -= lacks;
        else
            v -= lacks;
    }
    const bool good = is_point(u, v);
    demand(good, "a secondary ray's origin is not the point that was hit");

    const std::int64_t last = (std::int64_t(1) << (config_.uv_bits() - 1)) - 1;
    const bool ends =
        is_plane && (hit_u == last || hit_v == last || hit_u == -last - 1 || hit_v == -last - 1);
    place_.is_lost = ends || beyond;
    place_.is_far = place_.is_lost || (config_.planes && outside);
    demand((s.is_far != 0) == place_.is_far && (s.is_lost != 0) == place_.is_lost,
           "a point is far off, or is not");
    for (std::size_t k = 0; k < 3; ++k) {
        demand(s.n[k] == normal[k] * (answer_.back ? -1 : 1),
               "the normal is not the triangle's, turned to the side that is seen");
        const Int128 smooth =
            (whole - u - v) * surface.normal[k] + u * surface.normal[3 + k] + v * surface.normal[6 + k];
        toward[k] = surface.smooth ? std::int64_t(smooth) * (answer_.back ? -1 : 1) : s.n[k];
    }
    demand(dot(s.n, is_turned() ? visit_.ray.direction : in.d) < 0,
           "the normal points away from the side that is seen");

    demand(s.albedo == expected_albedo(surface), "the colour is another square's");
}

/// Returns the surface's colour. A checkered plane has the colour of the hit's square, which follows from the
/// scene and not from the memory image. If u and v cannot distinguish squares (they are saturated, or coarser
/// than the squares), it is the average of both colours. If one square is longer than the range of u and v,
/// it is the square around the plane's point a.
PathJudge::Colour PathJudge::expected_albedo(const Surface& surface) const {
    if (surface.kind != PrimKind::plane || !surface.checkered) return surface.colour;
    const Scene& scene = rules_.inputs.scene;
    const Material& material =
        rules_.placed ? rules_.placed->material(answer_.prim) : material_of(scene, answer_.prim);
    const Plane& plane = rules_.placed
                             ? rules_.placed->plane(answer_.prim)
                             : scene.planes[answer_.prim - scene.triangles.size() - scene.spheres.size()];
    const auto shade = [](double value) {
        return std::uint32_t(std::floor(std::clamp(value, 0.0, 1.0) * std::exp2(share_bits) + 0.5));
    };
    Colour first, second, between;
    for (std::size_t k = 0; k < 3; ++k) {
        first[k] = shade(material.colour[int(k)]), second[k] = shade(material.other[int(k)]);
        between[k] = (first[k] + second[k]) / 2;
    }
    const PlaneOnLattice on = plane_on_lattice(plane, rules_.inputs.lattice);
    const std::int64_t last = (std::int64_t(1) << (config_.uv_bits() - 1)) - 1;
    bool odd = false;
    for (std::size_t i = 0; i < 2; ++i) {
        const std::int64_t sides = signed_value(i == 0 ? answer_.u : answer_.v, config_.uv_bits());
        const int bit = config_.bary_bits + on.level[i];
        if (sides >= last || sides <= -last - 1 || bit < 0) return between;
        if (on.level[i] > corner_bits - 1) {
            odd ^= std::fmod(std::floor(std::ldexp(on.at[i], -on.level[i])), 2) != 0;
            continue;
        }
        // `at` is an integer. Removing a multiple of two squares does not change the colour.
        const double pair = std::exp2(std::max(on.level[i] + 1, 0));
        const auto at = Int128(on.at[i] - pair * std::floor(on.at[i] / pair));
        odd ^= floor_of(sides + (at << config_.bary_bits), Int128(1) << bit) % 2 != 0;
    }
    return odd ? second : first;
}

/// Returns the point of the ray at t, rounded to nearest and clamped to the width of a coordinate.
Vec3i PathJudge::point_at(const PassIn& in) const {
    const int drop = config_.dir_bits - 1 + config_.t_frac_bits - config_.origin_bits;
    const Int128 most = (Int128(1) << (config_.origin_width() - 1)) - 1;
    return by_axis([&](std::size_t k) {
        const Int128 at = in.o[k] + nearest_of_power(Int128(in.d[k]) * answer_.t, drop);
        return std::int32_t(std::clamp(at, -most, most));
    });
}

/// Judges a point of a sphere: it is the ray's point at t, and the normal points to it from the centre.
void PathJudge::judge_sphere_place(const PassIn& in, const ShadeState& s) {
    const Vec3i point = point_at(in);
    for (std::size_t k = 0; k < 3; ++k) {
        demand(s.o[k] == point[k], "a secondary ray's origin is not the point that was hit");
        const Int128 normal = s.o[k] - (Int128(place_.surface.a[k]) << config_.origin_bits);
        demand(s.n[k] == (answer_.back ? -normal : normal),
               "the normal is not the sphere's, turned to the side that is seen");
    }
    demand(s.is_far == 0 && s.is_lost == 0, "a sphere is never far off");
    demand(s.albedo == place_.surface.colour, "the colour is not the surface's");
}

void PathJudge::judge_vectors(const PassIn& in, const ShadeState& s, const Vec3l& toward) {
    place_.normal = unit_or_zero(vector_of(toward));
    place_.view = -unit_or_zero(vector_of(in.d));
    demand(is_unit(s.normal, vector_of(toward)), "the normal is not of unit length or points elsewhere");
    demand(is_unit(s.view, -vector_of(in.d)), "the view vector is not of unit length or points elsewhere");
    demand(s.cosine == promised_cosine(s.normal, s.view),
           "the cosine to the view is not the vectors' product");
}

void PathJudge::ambient(const ShadeState& s) {
    Colour colour{};
    Light range;
    const std::uint32_t ambient = place_.surface.ambient;
    for (std::size_t k = 0; k < 3; ++k) {
        colour[k] =
            std::uint32_t(nearest_of_power(Int128(branch_.weight) * ambient * s.albedo[k], 2 * share_bits));
        range[k] = (std::ldexp(double(ambient) * s.albedo[k], -2 * share_bits) * branch_.exact)
                       .wider(0.5 * unit_step);
    }
    add(colour, range);
}

// ---- A light.

void PathJudge::light(const PassIn& in, const PassOut& out, std::uint32_t number) {
    const ShadeState& s = in.state;
    const auto all = std::uint32_t(rules_.inputs.scene.lights.size());
    demand(number < all, "there is no such light");
    demand(out.state.light == number + 1 &&
               out.state.next_event == (number + 1 < all ? ShadeEvent::light : after_lights(s)),
           "a light is left out or asked twice");
    if (number >= all) return;
    const bool near = frame_.shade.near[number] != 0, to_the_point = near && !place_.is_far;
    const Vec3l way = by_axis([&](std::size_t k) {
        return frame_.shade.place[3 * number + k] * (std::int64_t(1) << config_.origin_bits) - s.o[k];
    });
    judge_light_parts(s, out.light, way);
    judge_share(out.state, out.light, unit_or_zero(vector_of(way)));

    // A shadow ray goes exactly from the light to a point within the lattice. Otherwise the ray leaves the
    // point along a rounded direction.
    Expected ray{to_the_point ? RayKind::shadow : RayKind::away, {}, {}, s.self, s.is_inside};
    for (std::size_t k = 0; k < 3; ++k)
        ray.d[k] =
            to_the_point ? std::int32_t(-way[k]) : (near ? -1 : 1) * direction_component(out.light.unit[k]);
    // Unused if the light lies beyond the lattice.
    const Vec3i from = by_axis([&](std::size_t k) {
        return near ? frame_.shade.place[3 * number + k] * (1 << config_.origin_bits) : 0;
    });
    if (rules_.placed) ray.home = to_the_point ? home_from(s, from) : home_of(s, ray.d);
    const Int128 side = dot(s.n, way_of(ray)) * (near ? -1 : 1);
    const bool clear = frame_.shade.clear[number] != 0 && frame_.shade.cell[number] == branch_.cell;
    if (side <= 0 || out.light.cosine == 0 || (place_.is_far && !clear)) {
        // A cosine that was rounded to 0 may have been slightly above.
        if (side > 0 && out.light.cosine == 0)
            add({}, {Range{0, share_[0].hi}, Range{0, share_[1].hi}, Range{0, share_[2].hi}});
        demand(out.leave == PassOut::Leave::again, "a ray is sent to a light that does not count");
        return;
    }
    std::optional<Vec3i> start;
    if (!near)
        start = start_of(s, ray.d);
    else if (!place_.is_lost)
        start = Vec3i{};
    if (!start) {
        lit_ = true;
        demand(out.leave == PassOut::Leave::again, "a ray is sent that passes by the lattice");
        return;
    }
    ray.o = near ? from : *start;
    ray.is_partial = config_.planes && !to_the_point && clear;
    ray.holes = std::uint32_t(light_holes_.size());
    lit_if_free_ = true;
    expect_spawn(out, ray);
}

/// Returns the origin of a ray from the surface along d. From a point beyond the lattice the ray takes the
/// fewest whole steps of 2^s d that bring it past the near side of every slab (docs/proofs/origins.md).
/// Returns nothing if it then lies outside the lattice.
std::optional<Vec3i> PathJudge::start_of(const ShadeState& s, const Vec3i& d) const {
    if (place_.is_lost) return std::nullopt;
    const Int128 end = ((Int128(1) << (config_.coord_bits - 1)) - 1) << config_.origin_bits;
    Int128 steps = place_.is_far ? 1 : 0;
    std::array<Int128, 3> step{};
    for (std::size_t k = 0; k < 3; ++k) {
        step[k] = Int128(d[k]) << config_.approach_shift();
        // The remaining distance on this axis.
        const Int128 before = step[k] < 0 ? s.o[k] - end : -end - s.o[k];
        if (!place_.is_far || before <= 0) continue;
        if (step[k] == 0) return std::nullopt;
        steps = std::max(steps, ceil_of(before, step[k] < 0 ? -step[k] : step[k]));
    }
    if (steps > (Int128(1) << approach_steps)) return std::nullopt;
    Vec3i start{};
    for (std::size_t k = 0; k < 3; ++k) {
        const Int128 at = s.o[k] + steps * step[k];
        if (at > end || at < -end) {
            if (place_.is_far) return std::nullopt;
        }
        start[k] = std::int32_t(at);
    }
    return start;
}

/// The same for a bounce. If it passes by the lattice, its origin is rounded to a lattice 2^far_drop times as
/// coarse: to the neighbouring point on the side to which the bounce leaves.
std::optional<PathJudge::Start> PathJudge::bounce_start_of(const ShadeState& s, const Vec3i& d,
                                                           bool through) const {
    if (const std::optional<Vec3i> start = start_of(s, d)) return Start{*start, false};
    if (!config_.horizon || place_.is_lost) return std::nullopt;
    const Int128 coarse = Int128(1) << (light_reach + 1);
    return Start{by_axis([&](std::size_t k) {
                     const Int128 below = floor_of(s.o[k], coarse);
                     const bool up = through ? s.n[k] < 0 : s.n[k] >= 0;
                     return std::int32_t(up ? below + 1 : below);
                 }),
                 true};
}

/// Converts a unit vector's component to a direction of M bits.
std::int32_t PathJudge::direction_component(Int128 unit) const {
    const int up = config_.dir_bits - 2 - unit_bits;
    return std::int32_t(up >= 0 ? unit * (1 << up) : nearest_of_power(unit, -up));
}

void PathJudge::judge_light_parts(const ShadeState& s, const LightParts& parts, const Vec3l& way) {
    demand(is_unit(parts.unit, vector_of(way)),
           "the vector to the light is not of unit length or points elsewhere");
    demand(parts.cosine == promised_cosine(s.normal, parts.unit),
           "the cosine to the light is not the vectors' product");
    const Int128 mirrored = nearest_of_power(2 * Int128(parts.cosine) * s.cosine, unit_bits) -
                            nearest_of_power(dot(parts.unit, s.view), unit_bits);
    const double base = double(std::clamp<Int128>(mirrored, 0, full_share)) * unit_step;
    demand(power_range({base, base}, s.shine).holds(parts.phong * unit_step),
           "the highlight's power is out of its bounds");
}

/// Returns the possible results of power() for a base in the range: model/fixed/power.hpp has its
/// bounds.
Range PathJudge::power_range(const Range& base, std::uint32_t shine) {
    const double exponent = shine / std::exp2(shine_frac), share = shine / std::exp2(shine_bits);
    const auto raised = [&](double x) { return x > 0 ? std::pow(x, exponent) : 0.0; };
    return {(1 - 1.1e-2 * share) * raised(base.lo) - unit_step,
            (1 + 1.4e-3 * share) * raised(base.hi) + 2 * unit_step};
}

/// Judges the light's contribution: its documented rounding, and its distance from Phong's formula.
void PathJudge::judge_share(const ShadeState& s, const LightParts& parts, const glm::dvec3& way) {
    const std::uint32_t number = s.light - 1;
    const double full = std::exp2(-share_bits);
    const double error = place_.cosine_error();
    const Range to_light = Range::around(glm::dot(place_.normal, way), error).clamped(0, 1);
    const Range to_view = Range::around(glm::dot(place_.normal, place_.view), error).clamped(0, 1);
    const Range along = Range::around(glm::dot(way, place_.view), cosine_error);
    const Range phong =
        power_range((2 * (to_light * to_view) - along).wider(unit_step).clamped(0, 1), s.shine).clamped(0, 1);
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t colour = frame_.shade.colour[3 * number + k];
        const Int128 matte = nearest_of_power(Int128(s.diffuse) * parts.cosine * s.albedo[k], 2 * share_bits);
        const Int128 gloss = nearest_of_power(Int128(s.highlight) * parts.phong, share_bits);
        const Int128 share = std::min<Int128>(
            nearest_of_power((matte + gloss) * colour * branch_.weight, share_bits + unit_bits), full_share);
        demand(s.share[k] == share, "a light's contribution is not the product of what makes it");
        const Range exact = (s.diffuse * full * s.albedo[k] * full) * to_light + s.highlight * full * phong;
        share_[k] =
            (colour * full * (exact.wider(unit_step) * branch_.exact)).wider(0.5 * unit_step).clamped(0, 1);
    }
}

}   // namespace rayclock
