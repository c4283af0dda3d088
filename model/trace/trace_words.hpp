#pragma once
// The words in which a Trace records a pixel's rays. The recorder writes them, and a pipeline reads them in
// the same order, mostly one word per event. All accessors are free of branches.
//
//     pixel = ray [end ray]... end     with shading; without shading: ray
//     ray   = (visit [test]...)...
//     end   = [place [material]] [record texels] surface passes
//
//               31        30         29         28       27..26   25          24         23..0
//     visit     dropped groups, 6 bits; all ones: an instance     ends_ray    has_tests  line of the node
//     test      is_last   -          -          -        -        -           half line of the primitive
//     place     is_place  -          -          -        -        -           -          line of the instance
//     material  is_place  -          -          -        -        -           -          line of a surface
//     record    -         is_record  -          -        -        -           -          line of a TexRecord
//     texels    -         -          -          -        -        -           -          line of the texels
//     surface   -         -          is_cutout  texture  purpose  ends_pixel  has_line   line of the surface
//     passes    number of passes of shade after the ray
//
// - visit: `dropped groups` is the number that trav drops from its stack after the node. The value of an
//   instance occurs in a chip with two levels only, and no number of groups takes it there.
// - test: a primitive that was tested. is_last marks the last one of the visit.
// - place: the instance that was hit, in a chip with two levels.
// - material: follows if the surface of this line replaces those of the instance's primitives.
// - record, texels: the lines that tex reads, if the surface or cut-out that was hit has a texture.
// - surface: has_line is set if shade reads the surface. is_cutout: it belongs to a cut-out in the way to a
//   light. purpose (RayPurpose): of the next ray, or 0 with ends_pixel.
#include <cstdint>

#include "model/core/config.hpp"
#include "model/scene/whitted.hpp"

namespace rayclock {

/// A line's address in a word.
constexpr std::uint32_t trace_line_mask = (1u << max_addr_bits) - 1;

struct VisitWord {
    static constexpr std::uint32_t tests_flag = 1u << 24, end_flag = 1u << 25;
    static constexpr int dropped_shift = 26;
    static constexpr std::uint32_t entry_flags = ~0u << dropped_shift;   ///< of an instance
    std::uint32_t bits = 0;
    constexpr std::uint32_t line() const { return bits & trace_line_mask; }
    constexpr bool has_tests() const { return bits & tests_flag; }
    constexpr bool ends_ray() const { return bits & end_flag; }
    constexpr bool is_entry() const { return bits >= entry_flags; }
    constexpr std::uint32_t dropped() const { return bits >> dropped_shift; }   ///< unless is_entry()
};

struct TestWord {
    static constexpr std::uint32_t last_flag = 1u << 31;
    std::uint32_t bits = 0;
    constexpr std::uint32_t half_line() const { return bits & ((2u << max_addr_bits) - 1); }
    constexpr bool is_last() const { return bits & last_flag; }
};

/// A word after a ray, except the number of passes.
struct EndWord {
    static constexpr std::uint32_t line_flag = 1u << 24, pixel_flag = 1u << 25, texture_flag = 1u << 28,
                                   cutout_flag = 1u << 29, record_flag = 1u << 30, place_flag = 1u << 31;
    static constexpr int purpose_shift = 26;
    std::uint32_t bits = 0;
    constexpr std::uint32_t line() const { return bits & trace_line_mask; }
    constexpr bool is_place() const { return bits & place_flag; }     ///< place or material
    constexpr bool is_record() const { return bits & record_flag; }   ///< `texels` follows
    // The accessors below are for the word `surface`.
    constexpr bool has_line() const { return bits & line_flag; }
    constexpr bool ends_pixel() const { return bits & pixel_flag; }
    constexpr bool has_texture() const { return bits & texture_flag; }
    constexpr bool is_cutout() const { return bits & cutout_flag; }
    constexpr RayPurpose purpose() const { return RayPurpose(bits >> purpose_shift & 3); }
};

}   // namespace rayclock
