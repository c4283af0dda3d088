#pragma once
// Writes payloads as memory words.
#include "model/core/config.hpp"
#include "model/core/layout.hpp"

namespace rayclock {

constexpr std::size_t words_per_line = std::size_t(line_bits / 32),
                      words_per_half = std::size_t(half_line_bits / 32);

/// Writes a payload right-aligned into memory that is zero. `scratch` only saves an allocation.
template <class P>
void write_payload(const P& payload, const Config& config, std::uint32_t* at, Words& scratch) {
    pack(payload, config, scratch);
    std::copy(scratch.begin(), scratch.end(), at);
}

}   // namespace rayclock
