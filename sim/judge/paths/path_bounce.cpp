// Judges reflected and refracted rays: whether they are sent, their direction and their weight.
#include "model/base/axes.hpp"
#include "sim/judge/paths/path.hpp"

namespace rayclock {

namespace {

constexpr Int128 wide_unit = Int128(1) << unit_bits;

/// Returns floor(sqrt(x)), starting from the root of a double.
Int128 root_of(Int128 x) {
    auto root = Int128(std::sqrt(double(x)));
    while (root * root > x) --root;
    while ((root + 1) * (root + 1) <= x) ++root;
    return root;
}

/// The refracted ray by Snell's law.
struct Bend {
    Int128 cosine_squared;   ///< 2 unit_bits of fraction; negative: total reflection
    Int128 along;            ///< share of the normal in the direction; unit_bits of fraction
};
/// Rounds as docs/machine/shading.md states: the square of the refracted sine down, the root down, the
/// product to nearest.
Bend promised_bend(const ShadeState& s) {
    const Int128 sine_squared = wide_unit * wide_unit - Int128(s.cosine) * s.cosine;
    const Int128 refracted = floor_of(Int128(s.ratio) * s.ratio * sine_squared, Int128(1) << 2 * index_frac);
    const Int128 cosine_squared = wide_unit * wide_unit - refracted;
    return {cosine_squared, nearest_of_power(Int128(s.ratio) * s.cosine, index_frac) -
                                (cosine_squared < 0 ? 0 : root_of(cosine_squared))};
}

}   // namespace

PathJudge::Branch PathJudge::bounce(const ShadeState& s, const Weight& weight, const Start& start,
                                    const Vec3i& d, bool through) const {
    return {{RayKind::bounce, start.o, d, s.self, s.is_inside ^ std::uint32_t(through), start.is_beyond,
             through, rules_.placed ? home_of(s, d) : Home{}},
            weight.promised,
            branch_.depth + 1,
            through ? branch_.cell ^ place_.pane : branch_.cell,
            path_,
            weight.exact};
}

/// Schlick 1994: R0 + (1 - R0) (1 - cosine)^5; rounded as documented, and as a range.
PathJudge::Share PathJudge::schlick(const ShadeState& s) const {
    const Int128 q = wide_unit - s.cosine, q2 = nearest_of_power(q * q, unit_bits),
                 q4 = nearest_of_power(q2 * q2, unit_bits), q5 = nearest_of_power(q4 * q, unit_bits);
    const double r0 = s.r0 * unit_step;
    const Range cosine =
        Range::around(glm::dot(place_.normal, place_.view), place_.cosine_error()).clamped(0, 1);
    const auto fifth = [](double x) { return x * x * x * x * x; };
    const Range powered = Range{fifth(1 - cosine.hi), fifth(1 - cosine.lo)}.wider(3 * unit_step);
    return {s.r0 + nearest_of_power((wide_unit - s.r0) * q5, unit_bits),
            (Range{r0, r0} + (1 - r0) * powered).wider(0.5 * unit_step).clamped(0, 1)};
}

/// Returns the weight of a bounce from its share of the ray's weight.
PathJudge::Weight PathJudge::weight_of(const Share& share) const {
    return {std::uint32_t(
                nearest_of_power(Int128(branch_.weight) * std::min(share.promised, wide_unit), unit_bits)),
            (branch_.exact * share.exact.clamped(0, 1)).wider(0.5 * unit_step).clamped(0, 1)};
}

void PathJudge::refract(const PassIn& in, const PassOut& out) {
    const ShadeState& s = in.state;
    demand(config_.refraction, "there is no refraction in this chip");
    demand(out.leave == PassOut::Leave::again && out.state.next_event == ShadeEvent::reflect,
           "after the refracted ray comes the reflected one");
    const Bend bend = promised_bend(s);
    const bool total = bend.cosine_squared < 0;
    demand(total == (out.state.total != 0), "total reflection was decided wrongly");
    judge_total(total);

    const double transmit = s.transmit * unit_step;
    Share share{Int128(s.transmit), {transmit, transmit}};
    if (s.schlick) {
        const Share fresnel = schlick(s);
        share = {nearest_of_power(s.transmit * (wide_unit - fresnel.promised), unit_bits),
                 (transmit * (Range{1, 1} - fresnel.exact)).wider(0.5 * unit_step)};
    }
    const Weight weight = weight_of(share);
    const bool due = follows(weight);
    demand(out.refracted == due, "a refracted ray is followed against the threshold");
    if (!due || total) return demand(!out.push, "a refracted ray is sent where none is due");
    const Vec3i d = by_axis([&](std::size_t k) {
        return direction_component(std::clamp<Int128>(
            nearest_of_power(
                bend.along * s.normal[k] - (Int128(s.ratio) * s.view[k] << (unit_bits - index_frac)),
                unit_bits),
            -wide_unit, wide_unit));
    });
    judge_refracted(d);
    if (dot(s.n, is_turned() ? home_of(s, d).d : d) >= 0)
        return demand(!out.push, "a refracted ray leaves on the side from which it came");
    // The boxes of instances are proven only for longer directions: docs/machine/motion.md, Secondary rays.
    const std::int32_t quarter = std::int32_t(std::exp2(config_.dir_bits - 2)) / 4;
    if (rules_.placed && std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])}) < quarter)
        return demand(!out.push, "a refracted ray is sent that is too short");
    const std::optional<Start> start = bounce_start_of(s, d, true);
    if (!start) {
        background(weight.promised, weight.exact);
        return demand(!out.push, "a ray is sent that passes by the lattice");
    }
    demand(out.push, "a refracted ray is missing");
    waiting_.push_back(bounce(s, weight, *start, d, true));
    const Expected& ray = waiting_.back().ray;
    const Waiting expected{ray.o,    ray.d,         weight.promised,      branch_.depth + 1,
                           ray.self, ray.is_inside, waiting_.back().cell, ray.is_partial,
                           path_,    ray.home};
    demand(out.pushed.weight == expected.weight, "a bounce's weight is not the product of what makes it");
    demand(out.pushed == expected, "a refracted ray does not go where Snell's law sends it");
}

void PathJudge::reflect(const PassIn& in, const PassOut& out) {
    const ShadeState& s = in.state;
    const double mirror = s.mirror * unit_step, transmit = s.transmit * unit_step;
    Share share{Int128(s.mirror), {mirror, mirror}};
    if (s.total) {
        share = {share.promised + s.transmit, {mirror + transmit, mirror + transmit}};
    } else if (s.schlick) {
        const Share fresnel = schlick(s);
        share.promised += nearest_of_power(s.transmit * fresnel.promised, unit_bits);
        share.exact = (share.exact + transmit * fresnel.exact).wider(0.5 * unit_step);
    }
    const Weight weight = weight_of(share);
    const Vec3i d = by_axis([&](std::size_t k) {
        return direction_component(
            std::clamp<Int128>(nearest_of_power(2 * Int128(s.cosine) * s.normal[k], unit_bits) - s.view[k],
                               -wide_unit, wide_unit));
    });
    judge_reflected(d);
    const bool due = follows(weight) && dot(s.n, is_turned() ? home_of(s, d).d : d) > 0;
    const std::optional<Start> start = bounce_start_of(s, d, false);
    if (!due || !start) {
        if (due) background(weight.promised, weight.exact);
        demand(out.leave == PassOut::Leave::again && out.state.next_event == ShadeEvent::pop,
               "a reflected ray is sent where none is due");
        return;
    }
    branch_ = bounce(s, weight, *start, d, false);
    holes_ = 0;
    expect_spawn(out, branch_.ray);
    demand(out.state.next_event == ShadeEvent::arrive, "a bounce that was sent is not waited for");
}

/// Returns true if a bounce must be sent: its weight is not below the threshold (docs/machine/shading.md,
/// Weights and threshold). Judges the rounded rule against the bound that is proven there.
bool PathJudge::follows(const Weight& weight) {
    const auto bounce = std::int64_t(branch_.depth) + 1;
    const double threshold = std::clamp(rules_.settings.threshold, 0.0, 1.0);
    const bool due = 2 * std::int64_t(weight.promised) + 3 * bounce >=
                     std::int64_t(std::floor(threshold * std::exp2(unit_bits + 1)));
    if (due)
        demand(weight.exact.hi > threshold - (3.5 * double(bounce) + 1) * unit_step,
               "a ray of less weight than the threshold is followed");
    else
        demand(weight.exact.lo < threshold, "a ray whose weight is not below the threshold is not followed");
    return due;
}

// The bound of a reflected direction R = 2 (N . V) N - V. V has an error of vector_error, and N of n, which
// is larger only with two levels. R is linear in V and keeps lengths, so V's error counts once. N's error
// counts at most four times. The cosine's rounding counts twice, and the product's once.
void PathJudge::judge_reflected(const Vec3i& d) {
    const double n = place_.normal_error, turned = 4 * n + 2 * n * n,
                 error = turned + vector_error * (1 + turned) + 1.5 * unit_step;
    const double full = std::exp2(config_.dir_bits - 2);
    const double cosine = std::max(0.0, glm::dot(place_.normal, place_.view));
    const glm::dvec3 mirrored = 2 * cosine * place_.normal - place_.view;
    for (int k = 0; k < 3; ++k)
        demand(std::abs(d[std::size_t(k)] / full - mirrored[k]) <= error + 0.5 / full,
               "a reflected ray goes elsewhere");
}

/// If the range allows both answers, either passes.
void PathJudge::judge_total(bool total) {
    const Range cosine_squared = exact_bend().cosine_squared;
    if (total)
        demand(cosine_squared.lo < 0, "total reflection below the critical angle");
    else
        demand(cosine_squared.hi >= -Range::slack, "no total reflection beyond the critical angle");
}

PathJudge::ExactBend PathJudge::exact_bend() const {
    const Range ratio = Range::around(place_.ratio, 0.5 * std::exp2(-index_frac));
    const Range cosine =
        Range::around(glm::dot(place_.normal, place_.view), place_.cosine_error()).clamped(0, 1);
    const Range cosine_squared = Range{1, 1} - ratio * ratio * (Range{1, 1} - cosine * cosine);
    const Range root{std::sqrt(std::max(0.0, cosine_squared.lo - unit_step * unit_step)),
                     std::sqrt(std::max(0.0, cosine_squared.hi + unit_step * unit_step))};
    return {cosine_squared, ratio, (ratio * cosine - root.wider(unit_step)).wider(0.5 * unit_step)};
}

void PathJudge::judge_refracted(const Vec3i& d) {
    const ExactBend bend = exact_bend();
    const double full = std::exp2(config_.dir_bits - 2);
    for (int k = 0; k < 3; ++k) {
        const Range normal =
                        Range::around(place_.normal[k], is_turned() ? place_.normal_error : component_error),
                    view = Range::around(place_.view[k], component_error);
        const Range bent = (bend.along * normal - bend.ratio * view).wider(0.5 * unit_step).clamped(-1, 1);
        demand(bent.wider(0.5 / full).holds(d[std::size_t(k)] / full), "a refracted ray goes elsewhere");
    }
}

}   // namespace rayclock
