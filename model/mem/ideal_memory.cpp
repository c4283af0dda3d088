// The ideal memory's clock edge.
#include "model/mem/ideal_memory.hpp"

namespace rayclock {

IdealMemory::IdealMemory(const Config& config, int ids)
    : latency_(std::uint64_t(config.mem_latency)),
      interval_(std::uint64_t(config.mem_interval)),
      pending_(ids) {}

void IdealMemory::clock(const Answer* request) {
    if (valid()) pending_.pop();
    if (request) {
        pending_.push({*request, now_ + latency_});
        next_free_ = now_ + interval_;
    }
    ++now_;
}

}   // namespace rayclock
