#pragma once
// An instance as it lies in memory, and how a line says what it is (docs/motion.md).
#include "model/core/payloads.hpp"

namespace rayclock {

/// K: fraction bits of an instance's map.
constexpr int map_frac(const Config& c) { return c.coord_bits + 3; }

/// An instance as it lies in a memory line of 64 bytes (right-aligned): x' = A x + b takes a point of the
/// scene's lattice to the mesh's. Rows of A sum to 1 at most, in size, so that no operand grows.
struct Placement {
    std::uint32_t first = 0;           ///< number of its first primitive
    std::uint32_t root = 0;            ///< line of the root of its lower structure
    std::array<std::int32_t, 9> a{};   ///< [3 * row + column], K fraction bits; 1 is possible
    Vec3l b{};                         ///< K fraction bits
    template <class V> void fields(V& v, const Config& c) {
        v("first", first, c.prim_bits);
        v("root", root, c.addr_bits);
        v("a", a, map_frac(c) + 2, 9);
        v("b", b, c.coord_bits + map_frac(c), 3);
    }
    friend bool operator==(const Placement&, const Placement&) = default;
};

/// What a line of a structure of two levels holds, by its two highest bits, which nodes leave alone.
enum class LineKind : std::uint32_t { scene_node, mesh_node, placement };
constexpr int line_kind_shift = 30;   // in the last word
inline LineKind line_kind(const std::uint32_t* line) { return LineKind(line[15] >> line_kind_shift); }
inline void set_line_kind(std::uint32_t* line, LineKind kind) {
    line[15] |= std::uint32_t(kind) << line_kind_shift;
}

}   // namespace rayclock
