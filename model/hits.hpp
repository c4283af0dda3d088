#pragma once
#include <cstdint>

#include "model/accel/memory_image.hpp"
#include "model/core/payloads.hpp"
#include "model/scene/hit.hpp"

namespace rayclock {

/// What the chip's answer means in scene units: depth = t / 2^(M-1+F) * |d| * pitch, weights u, v / 2^bary_bits.
Hit to_hit(const HitOut& out, const Frame& frame, const Lattice& lattice, const Config& config);

/// FNV-1a over numbers, 64 bits: the same on every machine.
class Digest {
public:
    void add(std::uint64_t value) {
        for (int i = 0; i < 8; ++i, value >>= 8) state_ = (state_ ^ (value & 255)) * 0x100000001b3u;
    }
    std::uint64_t value() const { return state_; }

private:
    std::uint64_t state_ = 0xcbf29ce484222325u;
};

} // namespace rayclock
