// Finding equal primitives by sorting hashes of their points.
#include "sim/judge/reference/distinct.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

namespace rayclock {
namespace {

using Corner = std::array<double, 3>;

/// Turns -0 into 0, which is the same place.
Corner corner(const glm::dvec3& p) { return {p.x + 0.0, p.y + 0.0, p.z + 0.0}; }

std::uint64_t mixed(std::uint64_t h) {   // the mixing function of SplitMix64
    h = (h ^ h >> 30) * 0xbf58476d1ce4e5b9u;
    h = (h ^ h >> 27) * 0x94d049bb133111ebu;
    return h ^ h >> 31;
}

std::uint64_t hash_of(const Corner& c) {
    std::uint64_t h = 1;
    for (const double x : c) h = mixed(h + std::bit_cast<std::uint64_t>(x));
    return h;
}

/// A primitive as the points that define it. Equal primitives have equal keys.
using Key = std::array<Corner, 3>;
std::uint64_t hash_of(const Key& key) {
    std::uint64_t h = 0;
    for (const Corner& c : key) h = mixed(h + hash_of(c));
    return h;
}

/// Returns the numbers of the primitives without an equal one before them. key(i) returns the key of
/// primitive i.
template <class KeyOf> std::vector<std::uint32_t> first_of_each(std::size_t count, const KeyOf& key) {
    struct Entry {
        std::uint64_t hash;
        std::uint32_t number;
        bool operator<(const Entry& other) const {
            return hash != other.hash ? hash < other.hash : number < other.number;
        }
    };
    std::vector<Entry> entries(count);
    tbb::parallel_for(std::size_t(0), count, [&](std::size_t i) {
        entries[i] = {hash_of(key(i)), std::uint32_t(i)};
    });
    tbb::parallel_sort(entries.begin(), entries.end());
    std::vector<std::uint32_t> kept;
    kept.reserve(count);
    for (std::size_t begin = 0, end; begin < count; begin = end) {
        for (end = begin + 1; end < count && entries[end].hash == entries[begin].hash;) ++end;
        const std::size_t first = kept.size();
        for (std::size_t i = begin; i < end; ++i) {
            const auto same = [&](std::uint32_t number) { return key(number) == key(entries[i].number); };
            if (end - begin == 1 || std::none_of(kept.begin() + std::ptrdiff_t(first), kept.end(), same))
                kept.push_back(entries[i].number);
        }
    }
    std::sort(kept.begin(), kept.end());
    return kept;
}

}   // namespace

std::vector<std::uint32_t> distinct_triangles(const Scene& scene) {
    return first_of_each(scene.triangles.size(), [&](std::size_t i) {
        const auto& v = scene.triangles[i].vertex;
        Key key{corner(scene.vertices[v[0]]), corner(scene.vertices[v[1]]), corner(scene.vertices[v[2]])};
        std::sort(key.begin(), key.end());
        return key;
    });
}

std::vector<std::uint32_t> distinct_spheres(const Scene& scene) {
    return first_of_each(scene.spheres.size(), [&](std::size_t i) {
        const Sphere& s = scene.spheres[i];
        return Key{corner(s.centre), Corner{s.radius, 0, 0}, Corner{}};
    });
}

std::vector<std::uint32_t> distinct_planes(const Scene& scene) {
    return first_of_each(scene.planes.size(), [&](std::size_t i) {
        const Plane& p = scene.planes[i];
        return Key{corner(p.point), corner(p.u), corner(p.v)};
    });
}

}   // namespace rayclock
