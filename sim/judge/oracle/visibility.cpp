// The signs of the unmoved path, and those of the moves where they are 0.
#include "sim/judge/oracle/visibility.hpp"

namespace rayclock::oracle {

namespace {

Int128 exact_volume(const Triple<Int128>& a, const Triple<Int128>& b, const Triple<Int128>& c) {
    return oracle::volume<Int128>(a, area(b, c));
}
int sign(Int128 value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }
Triple<Int128> between(const Vec3i& from, const Vec3i& to) {
    return way(triple<Int128>(from), triple<Int128>(to));
}
/// Returns the vector from a lattice point to a place, times its den.
Triple<Int128> between(const Vec3i& from, const RationalPoint& to) {
    return {to.num[0] - to.den * from[0], to.num[1] - to.den * from[1], to.num[2] - to.den * from[2]};
}

/// Eight sets of three independent directions.
constexpr int moves[8][9] = {{1, 2, 3, -2, 1, 1, 3, -1, 2},   {-3, 1, 2, 1, 1, -2, 2, 3, 1},
                             {2, -3, 1, 1, 2, 1, -1, 1, 3},   {3, 2, -1, 2, -1, 1, 1, 3, 2},
                             {-1, -2, 3, 3, 1, 1, 1, -3, 2},  {2, -1, -3, 1, 3, 2, -2, 1, -1},
                             {-2, 3, -1, -1, -1, 3, 3, 2, 1}, {-1, -3, -2, 2, 1, -3, 1, 2, -1}};

}   // namespace

bool in_plane(const RationalPoint& place, const Corners& t) {
    return exact_volume(between(t.a, place), between(t.a, t.b), between(t.a, t.c)) == 0;
}

Visibility::Visibility(const Path& path, const Corners& surface, int facing) : path_(path) {
    for (std::size_t k = 0; k < 3; ++k)
        way_[k] =
            path.to ? Int128((*path.to)[k]) * path.from.den - path.from.num[k] : Int128(path.direction[k]);
    for (std::size_t i = 0; i < sets; ++i) {
        Set& set = sets_[i];
        if (i == 8)
            set.moves = {way_, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        else
            for (std::size_t j = 0; j < 9; ++j) set.moves[j / 3][j % 3] = moves[i][j];
        if (moved_plane(surface, set) != facing)
            for (auto& x : set.moves[0]) x = -x;
        // If the first move lies in the surface's plane, one of the others must lead off the plane.
        for (std::size_t j = 1; j < 4 && moved_plane(surface, set) != facing; ++j)
            for (auto& x : set.moves[j]) x = -x;
    }
    if (signs(surface).end == -facing) blocked_ = all;
}

Visibility::Signs Visibility::signs(const Corners& t) const {
    const Triple<Int128> ab = between(t.a, t.b), ac = between(t.a, t.c), begin = between(t.a, path_.from);
    Signs s{sign(exact_volume(begin, ab, ac)), 0, 0, 0, 0};
    s.end = sign(exact_volume(path_.to ? between(t.a, *path_.to) : triple<Int128>(path_.direction), ab, ac));
    if (s.end == 0 || s.begin == s.end) return s;
    const auto edge = [&](const Vec3i& p, const Vec3i& q) {
        return sign(exact_volume(between(p, path_.from),
                                 path_.to ? between(p, *path_.to) : triple<Int128>(path_.direction),
                                 between(p, q)));
    };
    s.ab = edge(t.a, t.b);
    s.bc = edge(t.b, t.c);
    s.ca = edge(t.c, t.a);
    return s;
}

int Visibility::moved_plane(const Corners& t, const Set& set) const {
    for (const auto& move : set.moves)
        if (const int s = sign(exact_volume(move, between(t.a, t.b), between(t.a, t.c)))) return s;
    return 0;
}
int Visibility::moved_edge(const Vec3i& p, const Vec3i& q, const Set& set) const {
    for (const auto& move : set.moves)
        if (const int s = sign(exact_volume(move, way_, between(p, q)))) return s;
    return 0;
}

bool Visibility::add(const Corners& t) {
    const Signs s = signs(t);
    // The path crosses only if no decided sign contradicts a crossing.
    if (s.end == 0 || s.begin == s.end) return true;
    const bool some = s.ab > 0 || s.bc > 0 || s.ca > 0, other = s.ab < 0 || s.bc < 0 || s.ca < 0;
    if (some && other) return true;
    if (s.begin != 0 && s.ab != 0 && s.bc != 0 && s.ca != 0) {
        blocked_ = all;
        return false;
    }
    for (int i = 0; i < sets; ++i) {
        const Set& set = sets_[std::size_t(i)];
        const auto edge = [&](int decided, const Vec3i& p, const Vec3i& q) {
            return decided != 0 ? decided : moved_edge(p, q, set);
        };
        const int ab = edge(s.ab, t.a, t.b);
        const int begin = s.begin != 0 ? s.begin : moved_plane(t, set);
        const bool crosses =
            begin != s.end && ab != 0 && edge(s.bc, t.b, t.c) == ab && edge(s.ca, t.c, t.a) == ab;
        if (crosses) blocked_ |= 1u << i;
    }
    return blocked_ != all;
}

Visibility::Answer Visibility::answer() const {
    return blocked_ == 0 ? Answer::free : blocked_ == all ? Answer::blocked : Answer::either;
}

}   // namespace rayclock::oracle
