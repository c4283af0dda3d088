#pragma once
// Writes payloads as memory words, and reads primitives back.
#include "model/core/config.hpp"
#include "model/core/layout.hpp"
#include "model/core/lines.hpp"
#include "model/layout/memory_image.hpp"

namespace rayclock {

constexpr std::size_t words_per_line = std::size_t(line_bits / 32),
                      words_per_half = std::size_t(half_line_bits / 32);

/// Writes a payload right-aligned into memory that is zero. `scratch` only saves an allocation.
template <class P>
void write_payload(const P& payload, const Config& config, std::uint32_t* at, Words& scratch) {
    pack(payload, config, scratch);
    std::copy(scratch.begin(), scratch.end(), at);
}

/// Returns the primitive in a half line of a memory image.
inline PrimData read_primitive(const MemoryImage& image, std::uint32_t half_line, const Config& config) {
    return unpack<PrimData>(image.half_line(half_line), config);
}

}   // namespace rayclock
