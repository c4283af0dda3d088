#pragma once
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/core/config.hpp"

namespace rayclock {

/// First-in first-out queue of fixed capacity; storage is a power of two and never moves.
/// What goes in during a cycle is seen in the next: callers take before they put. Mirror of rtl/prim/rc_fifo.sv.
template <class Item> class Ring {
public:
    explicit Ring(int capacity) : items_(std::size_t(1) << index_bits(capacity)), mask_(items_.size() - 1), capacity_(std::size_t(capacity)) {}
    bool empty() const { return head_ == tail_; }
    bool full() const { return size() == capacity_; }
    std::size_t size() const { return tail_ - head_; }
    const Item& front() const { return items_[head_ & mask_]; }
    void pop() { assert(!empty()); ++head_; }
    Item& push() { assert(!full()); return items_[tail_++ & mask_]; }
    void push(const Item& item) { push() = item; }
    const Item& at(std::size_t i) const { return items_[(head_ + i) & mask_]; }

private:
    std::vector<Item> items_;
    std::size_t mask_, capacity_;
    std::size_t head_ = 0, tail_ = 0;
};

/// Two queues on one link: the first goes before the second, but an offer that was not accepted stays.
/// Mirror of rtl/prim/rc_merge.sv.
class Merge {
public:
    /// Whether the second queue is on offer, given which of them have something.
    bool second(bool first_valid) const { return held_ ? held_second_ : !first_valid; }
    void clock(bool valid, bool taken, bool second) {
        held_ = valid && !taken;
        held_second_ = second;
    }

private:
    bool held_ = false, held_second_ = false;
};

/// A stall-free pipeline behind a door: a request admitted in cycle c answers from cycle c + latency + 1 on, in order;
/// `depth` credits bound the answers in flight. Mirror of rc_door + stages + rc_fifo.
template <class Item> class Pipe {
public:
    Pipe(int latency, int depth) : latency_(std::uint64_t(latency)), items_(depth), stamps_(depth) {}
    bool ready() const { return !items_.full(); }
    bool valid(std::uint64_t now) const { return due_ <= now; }
    const Item& front() const { return items_.front(); }
    /// Admits a request in cycle `now`; the caller fills in the answer.
    Item& admit(std::uint64_t now) {
        stamps_.push(now + latency_ + 1);
        if (due_ == never) due_ = now + latency_ + 1;
        return items_.push();
    }
    void leave() {
        items_.pop();
        stamps_.pop();
        due_ = stamps_.empty() ? never : stamps_.front();
    }
    const Ring<Item>& items() const { return items_; }

private:
    static constexpr std::uint64_t never = ~std::uint64_t(0);
    std::uint64_t latency_, due_ = never;   // due_: when the first answer can be taken
    Ring<Item> items_;
    Ring<std::uint64_t> stamps_;
};

} // namespace rayclock
