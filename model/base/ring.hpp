#pragma once
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "model/core/config.hpp"

namespace rayclock {

/// First-in first-out queue of fixed capacity; storage is a power of two and never moves. `most`, if given,
/// is the largest capacity: the storage then lies in the queue itself, which is faster. What goes in during a
/// cycle is seen in the next: callers take before they put. Mirror of rtl/prim/rc_fifo.sv.
template <class Item, std::size_t most = 0> class Ring {
public:
    explicit Ring(int capacity)
        : mask_((std::uint32_t(1) << index_bits(capacity)) - 1), capacity_(std::uint32_t(capacity)) {
        if constexpr (most == 0) items_.resize(std::size_t(mask_) + 1);
        assert(mask_ < items_.size());
    }
    bool empty() const { return head_ == tail_; }
    bool full() const { return size() == capacity_; }
    std::uint32_t size() const { return tail_ - head_; }
    const Item& front() const { return items_[head_ & mask_]; }
    void pop() {
        assert(!empty());
        ++head_;
    }
    Item& push() {
        assert(!full());
        return items_[tail_++ & mask_];
    }
    void push(const Item& item) { push() = item; }
    bool contains(const Item& item) const {
        for (std::uint32_t i = head_; i != tail_; ++i)
            if (items_[i & mask_] == item) return true;
        return false;
    }
    const Item& at(std::size_t i) const { return items_[(head_ + std::uint32_t(i)) & mask_]; }

private:
    std::uint32_t mask_, capacity_;
    std::uint32_t head_ = 0, tail_ = 0;   // they wrap, and so does their difference
    std::conditional_t<most == 0, std::vector<Item>, std::array<Item, most>> items_{};
};

/// A number that fits all contexts of a pipeline, and a queue of them.
using RayNumber = std::uint16_t;
constexpr std::size_t most_contexts = 1024, most_answers = 256;
using RayRing = Ring<RayNumber, most_contexts>;

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

/// A stall-free pipeline behind a door: a request admitted in cycle c answers from cycle c + latency + 1 on,
/// in order; `depth` credits bound the answers in flight. Mirror of rc_door + stages + rc_fifo.
template <class Item, std::size_t most = most_answers> class Pipe {
public:
    Pipe(int latency, int depth) : latency_(std::uint64_t(latency) + 1), entries_(depth) {}
    bool ready() const { return !entries_.full(); }
    bool valid(std::uint64_t now) const { return due_ <= now; }
    const Item& front() const { return entries_.front().item; }
    /// Admits a request in cycle `now`; the caller fills in the answer.
    Item& admit(std::uint64_t now) {
        const std::uint64_t due = now + latency_;
        if (due_ == never) due_ = due;
        Entry& entry = entries_.push();
        entry.due = due;
        return entry.item;
    }
    void leave() {
        entries_.pop();
        due_ = entries_.empty() ? never : entries_.front().due;
    }
    std::uint64_t due() const { return due_; }   ///< cycle of the first answer; never, if there is none
    bool contains(const Item& item) const {
        for (std::size_t i = 0; i < entries_.size(); ++i)
            if (entries_.at(i).item == item) return true;
        return false;
    }

private:
    static constexpr std::uint64_t never = ~std::uint64_t(0);
    struct Entry {
        std::uint64_t due = 0;
        Item item{};
    };
    std::uint64_t latency_, due_ = never;   // due_: when the first answer can be taken
    Ring<Entry, most> entries_;
};

}   // namespace rayclock
