// The hash of a configuration: FNV-1a of its package, 64 bits.
#include "sim/board/identity.hpp"

#include "sim/files/cache/hash.hpp"
#include "sim/run/gen/rc_pkg.hpp"

namespace rayclock {

std::uint64_t config_hash(const Config& config) { return hash_of(rc_package(config)); }

}   // namespace rayclock
