// Computes the exact hits of camera rays, and rounds t, u and v by its own formulas.
#include "sim/judge/cause/exact_answers.hpp"

#include <algorithm>

namespace rayclock {

namespace {

using oracle::Int128;

Int128 power_of_two(int exponent) { return Int128(1) << exponent; }

/// floor(a / b), b > 0. Division of C++ goes towards zero.
Int128 floor_divide(Int128 a, Int128 b) { return a / b - (a % b < 0 ? 1 : 0); }

Int128 size(Int128 a) { return a < 0 ? -a : a; }

}   // namespace

// The weight of a corner is the volume over the ray's direction and the other two, seen from the origin; all
// three sum to den. Widths: num < 2^(3N+1) <= 2^61, u, v and den < 2^(2N+M+1) <= 2^63, see oracle/cross.hpp.
ExactPixel ExactAnswers::pixel(const Frame& frame, int x, int y) const {
    const Vec3i direction = exact_direction(frame, config_, {}, x, y, 0);
    if (placed_) return placed_pixel(camera_ray(frame.eye, direction));
    const oracle::ExactHit hit = surface_.closest(frame.eye, direction);
    if (hit.primitive == no_primitive) return {};
    const oracle::Corners& t = surface_.triangles()[hit.primitive];
    using Short = std::int64_t;
    const auto o = oracle::triple<Short>(frame.eye), d = oracle::triple<Short>(direction);
    const auto a = oracle::way(o, oracle::triple<Short>(t.a)), b = oracle::way(o, oracle::triple<Short>(t.b)),
               c = oracle::way(o, oracle::triple<Short>(t.c));
    return {hit.primitive, hit.num, hit.den, size(oracle::volume<Int128>(d, oracle::area(c, a))),
            size(oracle::volume<Int128>(d, oracle::area(a, b)))};
}

Ray camera_ray(const Vec3i& eye, const Vec3i& direction) {
    Ray ray;
    ray.o = eye, ray.d = direction;
    return ray;
}

ExactPixel ExactAnswers::placed_pixel(const Ray& ray) const {
    const oracle::PlacedHit found = placed_->solids().nearest(placed_->ray(ray));
    if (found.place == oracle::PlacedRay::nowhere) return {};
    const oracle::FlatHit& hit = found.hit;   // of a ray without fraction bits total is den
    return {hit.primitive + placed_->solids().places()[found.place].first, hit.num, hit.den, hit.u, hit.v};
}

// t has at most 2^31 units a step of num / den, and a weight 2^24: nothing here reaches 2^93.
Closest ExactAnswers::answer(const ExactPixel& pixel) const {
    if (pixel.primitive == no_primitive) return {};
    const Int128 units = pixel.num * power_of_two(config_.dir_bits - 1 + config_.t_frac_bits),
                 most = power_of_two(config_.t_bits()) - 1;
    const auto weight = [&](Int128 part) {
        return std::uint32_t(floor_divide(part * power_of_two(config_.bary_bits), pixel.den));
    };
    Closest answer;
    answer.found = 1;
    answer.prim = pixel.primitive;
    answer.t = std::uint32_t(std::min(-floor_divide(-units, pixel.den), most));
    answer.u = weight(pixel.u);
    answer.v = weight(pixel.v);
    return answer;
}

}   // namespace rayclock
