#pragma once
// The hash of keys and files.
#include <cstdint>
#include <string_view>

namespace rayclock {

/// Returns the 64-bit FNV-1a hash.
inline std::uint64_t hash_of(std::string_view bytes) {
    std::uint64_t h = 0xcbf29ce484222325u;
    for (const unsigned char c : bytes) h = (h ^ c) * 0x100000001b3u;
    return h;
}

}   // namespace rayclock
