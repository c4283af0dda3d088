// The hash of a configuration: FNV-1a of its package, 64 bits.
#include "sim/board/identity.hpp"

#include "sim/run/gen/rc_pkg.hpp"

namespace rayclock {

std::uint64_t config_hash(const Config& config) {
    std::uint64_t hash = 0xcbf2'9ce4'8422'2325;
    for (const char c : rc_package(config)) hash = (hash ^ std::uint8_t(c)) * 0x100'0000'01b3;
    return hash;
}

}   // namespace rayclock
