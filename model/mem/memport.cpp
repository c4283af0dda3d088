#include "model/mem/memport.hpp"

#include <algorithm>

namespace rayclock {

Memport::Memport(const Config& config, Traffic traffic)
    : latency_(std::uint64_t(config.mem_latency)), interval_(std::uint64_t(config.mem_interval)), traffic_(traffic), rng_(traffic.seed) {
    pending_.reserve(std::size_t(config.contexts));
}

void Memport::clock(const Answer* request, bool taken) {
    if (request) {
        const std::uint64_t extra = traffic_.jitter > 0 ? std::uint64_t(rng_.below(traffic_.jitter + 1)) : 0;
        pending_.push_back({*request, now_ + latency_ + extra});
        next_free_ = now_ + interval_;
    }
    ++now_;
    if (taken) valid_ = false;
    if (!valid_) {  // an answer once offered stays until it is taken
        const auto due = std::find_if(pending_.begin(), pending_.end(), [&](const Pending& p) { return p.due <= now_; });
        if (due != pending_.end()) {
            valid_ = true;
            answer_ = due->what;
            pending_.erase(due);
        }
    }
    ready_ = now_ >= next_free_ && (traffic_.stall_percent == 0 || rng_.below(100) >= traffic_.stall_percent);
}

} // namespace rayclock
