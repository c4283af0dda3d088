#include "tests/system/exact.hpp"

namespace rayclock::test {

namespace {

using Vec = std::array<Int, 3>;

Vec vec(const Vec3i& v) { return {Int(v[0]), Int(v[1]), Int(v[2])}; }
Vec operator-(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// Signed volume of the parallelepiped over three vectors, by Sarrus' rule.
Int volume(const Vec& a, const Vec& b, const Vec& c) {
    return a[0] * b[1] * c[2] + a[1] * b[2] * c[0] + a[2] * b[0] * c[1] - a[2] * b[1] * c[0] - a[1] * b[0] * c[2] - a[0] * b[2] * c[1];
}

/// On which side of the directed edge p -> q the line from o along d passes, if o is moved by (e, e^2, e^3), e -> 0:
/// the sign of volume(d, p - o', q - o'). Its coefficient of o'[k] is -volume(d, axis k, q - o) - volume(d, p - o, axis k),
/// and terms of two moves vanish, since both would stand in equal rows. 0 only if d is parallel to the edge.
int side(const Vec& o, const Vec& d, const Vec& p, const Vec& q) {
    const Vec po = p - o, qo = q - o;
    const Int value = volume(d, po, qo);
    if (value != 0) return value > 0 ? 1 : -1;
    for (std::size_t k = 0; k < 3; ++k) {
        Vec axis{Int(0), Int(0), Int(0)};
        axis[k] = 1;
        const Int slope = -volume(d, axis, qo) - volume(d, po, axis);
        if (slope != 0) return slope > 0 ? 1 : -1;
    }
    return 0;
}

} // namespace

ExactScene::ExactScene(const Scene& scene, const Lattice& lattice) {
    const auto corner = [&](const Triangle& t, std::size_t k) { return lattice.snap(scene.vertices[t.vertex[k]]); };
    for (const Triangle& t : scene.triangles) triangles_.push_back({corner(t, 0), corner(t, 1), corner(t, 2)});
}

ExactHit ExactScene::closest(const Vec3i& origin, const Vec3i& direction) const {
    ExactHit best;
    const Vec o = vec(origin), d = vec(direction);
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        const Vec a = vec(triangles_[i].a), b = vec(triangles_[i].b), c = vec(triangles_[i].c);
        const int ab = side(o, d, a, b);
        if (ab == 0 || side(o, d, b, c) != ab || side(o, d, c, a) != ab) continue;
        // n . (o + t d - a) = 0 with n = ab x ac: t = volume(a - o, ab, ac) / volume(d, ab, ac).
        Int num = volume(a - o, b - a, c - a), den = volume(d, b - a, c - a);
        if (den < 0) {
            num = -num;
            den = -den;
        }
        if (den == 0 || num <= 0) continue;
        if (best.primitive == no_primitive || num * best.den < best.num * den) best = {std::uint32_t(i), num, den};
    }
    return best;
}

Vec3i exact_direction(const Frame& frame, int x, int y) {
    Vec3i d{};
    for (std::size_t k = 0; k < 3; ++k) {
        const Int twice = 2 * (Int(frame.corner[k]) + x * Int(frame.right[k]) + y * Int(frame.down[k])), unit = Int(2) << guard_bits;
        Int whole = (twice + unit / 2) / unit;   // towards zero
        if (whole * unit > twice + unit / 2) --whole;
        d[k] = whole.convert_to<std::int32_t>();
    }
    return d;
}

} // namespace rayclock::test
