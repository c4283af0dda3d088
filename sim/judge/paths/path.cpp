// Judges the rays, the passes and the colour of a pixel.
#include "sim/judge/paths/path.hpp"

#include "model/core/payloads.hpp"
#include "sim/judge/paths/camera.hpp"

namespace rayclock {

namespace {

constexpr std::uint32_t full_weight = 1u << unit_bits;

}   // namespace

void PathJudge::fail(const char* what) {
    if (!is_wrong()) fault_ = {what, ray_number_};
}

void PathJudge::start(std::uint32_t x, std::uint32_t y) {
    fault_ = {};
    x_ = x, y_ = y;
    ray_number_ = 0;
    fresh_ = true;
    expected_ = {};
    branch_ = {{}, full_weight, 0, 0, 0, {1, 1}};
    path_ = holes_ = 0;
    texel_.reset();
    cutout_.reset();
    light_holes_.clear();
    waiting_.clear();
    lit_if_free_ = lit_ = false;
    colour_ = sum_ = most_ = {};
    least_ = {full_weight, full_weight, full_weight};
    exact_ = exact_sum_ = {};
    sample_ = 0;
}

// ---- Rays.

void PathJudge::judge_camera(const Ray& ray) {
    demand(ray.d == exact_direction(frame_, config_, rules_.settings, int(x_), int(y_), int(sample_)),
           "the camera ray's direction is not the pixel's, rounded");
    for (std::size_t k = 0; k < 3; ++k)
        demand(ray.o[k] == frame_.eye[k] * (1 << config_.origin_frac()),
               "the camera ray does not begin at the eye");
}

void PathJudge::sent(const Ray& ray) {
    const auto kind = ray.kind;
    demand(kind == expected_.kind, "the ray is of another kind than was asked for");
    if (kind == RayKind::camera) {
        judge_camera(ray);
        ++rays_.primary;
    } else {
        demand(ray.o == expected_.o && ray.d == expected_.d, "the ray is not the one that was asked for");
        demand((ray.is_partial != 0) == expected_.is_partial,
               "the ray asks planes where it must not, or the other way round");
        demand(!config_.spheres || (ray.self == expected_.self && ray.is_inside == expected_.is_inside),
               "the ray leaves another surface than was asked for");
        demand(ray.holes == expected_.holes,
               "the ray ignores another number of cut-outs than the number of holes");
        demand(ray.home == expected_.home, "the ray leaves its instance elsewhere than was asked for");
        if (ends_at_any(ray.kind))
            ++rays_.shadow;
        else
            ++(expected_.is_refracted ? rays_.refraction : rays_.reflection);
    }
    ray_ = ray;
    if (!ends_at_any(ray.kind)) bounce_ray_ = ray;
}

void PathJudge::answered(const Closest& hit) {
    const Cutouts* const cutouts = config_.has_textures() ? this : nullptr;
    const char* wrong = rules_.placed ? judge_answer(*rules_.placed, config_, ray_, hit, cutouts)
                                      : judge_answer(rules_.solids, config_, ray_, hit, cutouts);
    if (wrong) fail(wrong);
    answer_ = hit;
    if (rules_.placed && !ends_at_any(ray_.kind)) {
        visit_ = {hit.found ? rules_.placed->place_of(hit.prim) : oracle::PlacedRay::nowhere, {}};
        if (visit_.place != oracle::PlacedRay::nowhere)
            visit_.ray = rules_.placed->solids().seen_by(visit_.place, rules_.placed->ray(ray_));
    }
    ++ray_number_;
}

// ---- Passes.

void PathJudge::add(const Colour& colour, const Light& exact) {
    for (std::size_t k = 0; k < 3; ++k) {
        colour_[k] = std::min(colour_[k] + colour[k], full_weight);
        exact_[k] = exact_[k] + exact[k];
    }
}

void PathJudge::passed(const PassIn& in, const PassOut& out) {
    const ShadeState& s = in.state;
    demand(fresh_ ? s.x == x_ && s.y == y_ && s.next_event == ShadeEvent::arrive && s.weight == full_weight &&
                        s.depth == 0
                  : s == last_,
           "the context's state is not what the last pass left");
    demand(same_answer(in.hit, answer_) && in.hit.cutout == answer_.cutout,
           "a pass was given another answer");
    const bool asks_cutout = lit_if_free_ && answer_.found && answer_.cutout;
    if (lit_ || (lit_if_free_ && !answer_.found)) add(s.share, share_);
    lit_ = lit_if_free_ = false;
    if (asks_cutout)
        cutout(in, out);
    else
        event(in, out);
    demand(out.state.light_holes == light_holes_.size(), "the holes that light passes are miscounted");
    demand(out.leave == PassOut::Leave::pixel || out.state.colour == colour_,
           "what was added is not what the surface, light or background gives");
    demand(
        out.state.sample == sample_ && out.state.depth == branch_.depth && out.state.weight == branch_.weight,
        "a ray's weight or depth was lost");
    demand(!config_.has_textures() || out.state.path == path_, "the length of a path is wrong");
    demand(out.state.in_cell == branch_.cell, "a path is on the other side of a plane");
    demand(out.state.waiting == waiting_.size(), "the number of waiting rays is wrong");
    last_ = out.state;
    fresh_ = false;
}

void PathJudge::event(const PassIn& in, const PassOut& out) {
    const ShadeState& s = in.state;
    if (cutout_) {   // its texture has been read
        demand(texel_ && in.hole == texel_->hole, "a pass was given another texture's colour");
        const bool lets_pass = texel_ && texel_->hole && light_holes_.size() < (1u << hole_bits) - 1;
        cutout_.reset();
        if (lets_pass) {
            // Structures that cut space may test a triangle several times.
            demand(!is_passed(answer_.prim) || config_.cuts_space() || config_.is_walked(Structure::octree),
                   "light passes the same hole twice");
            light_holes_.push_back(answer_.prim);
            return light(in, out, s.light - 1);
        }
    }
    light_holes_.clear();
    switch (s.next_event) {
        case ShadeEvent::arrive: arrive(in, out); break;
        case ShadeEvent::light: light(in, out, s.light); break;
        case ShadeEvent::refract: refract(in, out); break;
        case ShadeEvent::reflect: reflect(in, out); break;
        case ShadeEvent::pop: pop(in, out); break;
        case ShadeEvent::transform: transform(in, out); break;
        case ShadeEvent::texture: texture(in, out); break;
    }
}

void PathJudge::expect_spawn(const PassOut& out, const Expected& ray) {
    demand(out.leave == PassOut::Leave::spawn, "no ray was sent where one is due");
    expected_ = ray;
}

ShadeEvent PathJudge::after_lights(const ShadeState& s) const {
    if (branch_.depth >= std::uint32_t(rules_.settings.depth)) return ShadeEvent::pop;
    if (s.transmit > 0) return ShadeEvent::refract;
    return s.mirror > 0 ? ShadeEvent::reflect : ShadeEvent::pop;
}

void PathJudge::background(std::uint32_t weight, const Range& exact) {
    Colour colour{};
    Light range;
    for (std::size_t k = 0; k < 3; ++k) {
        const double light = rules_.inputs.scene.background[int(k)];
        colour[k] = std::uint32_t(nearest_of_power(Int128(weight) * frame_.shade.background[k], unit_bits));
        range[k] =
            (exact * Range::around(std::clamp(light, 0.0, 1.0), 0.5 * unit_step)).wider(0.5 * unit_step);
    }
    add(colour, range);
}

// ---- The end of a ray's tree, of a sample, of the pixel.

void PathJudge::pop(const PassIn& in, const PassOut& out) {
    if (waiting_.empty()) return end_sample(out);
    branch_ = waiting_.back();
    waiting_.pop_back();
    path_ = branch_.path;
    holes_ = 0;
    const Expected& ray = branch_.ray;
    demand(in.top.o == ray.o && in.top.d == ray.d && in.top.weight == branch_.weight &&
               in.top.depth == branch_.depth && in.top.home == ray.home && in.top.path == branch_.path,
           "another ray waited");
    demand(!config_.spheres || (in.top.self == ray.self && in.top.is_inside == ray.is_inside),
           "another ray waited");
    demand(in.top.in_cell == branch_.cell && (in.top.is_partial != 0) == ray.is_partial,
           "another ray waited");
    expect_spawn(out, ray);
    demand(out.state.next_event == ShadeEvent::arrive, "a bounce that was sent is not waited for");
}

void PathJudge::end_sample(const PassOut& out) {
    bool same = rules_.settings.contrast > 0, alike = same;
    const double contrast = std::clamp(rules_.settings.contrast, 0.0, 1.0) / unit_step;
    for (std::size_t k = 0; k < 3; ++k) {
        sum_[k] += colour_[k];
        exact_sum_[k] = exact_sum_[k] + exact_[k].clamped(0, 1);
        least_[k] = std::min(least_[k], colour_[k]);
        most_[k] = std::max(most_[k], colour_[k]);
        same = same && most_[k] - least_[k] <= contrast;
        alike = alike && most_[k] - least_[k] < contrast + 1;   // the register is rounded up
    }
    const auto all = std::uint32_t(rules_.settings.aa * rules_.settings.aa), done = sample_ + 1;
    const bool may_stop = done == std::min(first_samples, all);
    const bool goes_on = out.leave == PassOut::Leave::spawn;
    if (done >= all || !config_.supersampling)
        demand(!goes_on, "there are more samples than asked for");
    else if (!may_stop || !alike)
        demand(goes_on, "a pixel ends before its last sample");
    else if (same)
        demand(!goes_on, "samples that do not differ do not end the pixel");
    if (goes_on) {
        sample_ = done;
        colour_ = {};
        exact_ = {};
        branch_ = {{}, full_weight, 0, 0, 0, {1, 1}};
        path_ = holes_ = 0;
        demand(out.state.colour == colour_ && out.state.sum == sum_ && out.state.least == least_ &&
                   out.state.most == most_,
               "the samples' sum is wrong");
        demand(out.state.next_event == ShadeEvent::arrive, "a sample's ray is not waited for");
        return expect_spawn(out, {});
    }
    demand(out.leave == PassOut::Leave::pixel, "the pixel is not given out");
    for (std::size_t k = 0; k < 3; ++k) {
        const Int128 share = nearest_of(full_weight, done);
        pixel_[k] =
            config_.supersampling
                ? std::uint32_t(std::min<Int128>(nearest_of_power(sum_[k] * share, unit_bits), full_weight))
                : colour_[k];
        // The share has an error of half a unit, times a sum of `done` samples, and the product is rounded.
        exact_pixel_[k] =
            (1.0 / done * exact_sum_[k]).wider(config_.supersampling ? 0.5 * (done + 1) * unit_step : 0);
    }
    demand(out.pixel.colour == pixel_, "the pixel is not the mean of its samples");
}

void PathJudge::finish(const Colour& colour) {
    demand(colour == pixel_, "the machine's pixel is not the one that its rays give");
    for (std::size_t k = 0; k < 3; ++k) {
        const Range range = exact_pixel_[k].clamped(0, 1);
        demand(range.wider(0.5 * unit_step).holds(colour[k] * unit_step), "the colour is out of its bounds");
        widest_ = std::max(widest_, 0.5 * (range.hi - range.lo) / unit_step);
    }
}

}   // namespace rayclock
