#include "model/mem/memport.hpp"

#include <algorithm>

namespace rayclock {

Memport::Memport(const Config& config, Traffic traffic)
    : latency_(std::uint64_t(config.mem_latency)), interval_(std::uint64_t(config.mem_interval)), traffic_(traffic), rng_(traffic.seed),
      in_order_(config.contexts) {}

void Memport::clock(const Answer* request, bool taken) {
    if (request) {
        const std::uint64_t extra = traffic_.jitter > 0 ? std::uint64_t(rng_.below(traffic_.jitter + 1)) : 0;
        if (traffic_.jitter > 0) overtaking_.push_back({*request, now_ + latency_ + extra});
        else in_order_.push({*request, now_ + latency_});
        next_free_ = now_ + interval_;
    }
    ++now_;
    if (taken) valid_ = false;
    if (!valid_) offer();   // an answer once offered stays until it is taken
    ready_ = now_ >= next_free_ && !in_order_.full() && (traffic_.stall_percent == 0 || rng_.below(100) >= traffic_.stall_percent);
}

void Memport::offer() {
    if (traffic_.jitter == 0) {  // the oldest request is due first
        if (in_order_.empty() || in_order_.front().due > now_) return;
        answer_ = in_order_.front().what;
        in_order_.pop();
    } else {
        const auto due = std::find_if(overtaking_.begin(), overtaking_.end(), [&](const Pending& p) { return p.due <= now_; });
        if (due == overtaking_.end()) return;
        answer_ = due->what;
        overtaking_.erase(due);
    }
    valid_ = true;
}

} // namespace rayclock
