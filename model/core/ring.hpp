#pragma once
// Queues and pipelines of the model, which mirror the cells of the RTL.
#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "model/core/config.hpp"

namespace rayclock {

// A machine's queues behave irregularly, and a wrong guess of the host's branch predictor costs more than the
// work. So queues push and pop items `if` a flag says so, without a branch.

/// First-in first-out queue of fixed capacity. Its storage is a power of two and never moves. With a small
/// capacity given as `most`, the storage lies in the queue itself. An item pushed in a cycle is visible in
/// the next, because callers pop before they push. Mirror of rtl/cells/queues/rc_fifo.sv.
template <class Item, std::uint32_t most = 0> class Ring {
public:
    explicit Ring(int capacity) : capacity_(std::uint32_t(capacity)) {
        if constexpr (most == 0) {
            items_.resize(std::size_t(1) << index_bits(capacity + 1));
            mask_ = std::uint32_t(items_.size() - 1);
        }
        assert(capacity_ <= mask());
    }
    bool empty() const { return head_ == tail_; }
    bool full() const { return size() == capacity_; }
    std::uint32_t size() const { return tail_ - head_; }
    /// Returns the oldest item; of an empty queue any item that it has held, or Item{}.
    const Item& front() const { return items_[head_ & mask()]; }
    void pop(bool on = true) {
        assert(!on || !empty());
        head_ += on;
    }
    /// Writes the next place, which always exists, and accepts the item if `on`.
    void push(const Item& item, bool on = true) {
        assert(!on || !full());
        items_[tail_ & mask()] = item;
        tail_ += on;
    }
    bool contains(const Item& item) const {
        for (std::uint32_t i = head_; i != tail_; ++i)
            if (items_[i & mask()] == item) return true;
        return false;
    }
    const Item& at(std::size_t i) const { return items_[(head_ + std::uint32_t(i)) & mask()]; }

private:
    std::uint32_t mask() const { return most == 0 ? mask_ : std::bit_ceil(most + 1) - 1; }

    std::uint32_t mask_ = 0, capacity_;
    std::uint32_t head_ = 0, tail_ = 0;   // both wrap, and so does their difference
    std::conditional_t<most == 0, std::vector<Item>, std::array<Item, std::bit_ceil(most + 1)>> items_{};
};

/// A number that fits all contexts of a pipeline, and a queue of such numbers.
using RayNumber = std::uint16_t;
using RayRing = Ring<RayNumber>;

/// The content of a link in a cycle. If `valid` is false, `ray` is an arbitrary context's number.
struct LinkRay {
    bool valid = false;
    std::uint32_t ray = 0;
};

/// Returns one of two numbers, without a branch.
inline std::uint32_t select(bool first, std::uint32_t a, std::uint32_t b) {
    return b ^ ((a ^ b) & (0u - std::uint32_t(first)));
}

/// Two queues on one link. The first has priority, but an offer that was not accepted stays. Mirror of
/// rtl/cells/queues/rc_priority_merge.sv.
class Merge {
public:
    /// True if the second queue is on offer. `first_valid`: the first queue is valid.
    bool second(bool first_valid) const { return held_second_ | (!first_valid & !held_first_); }
    void clock(bool valid, bool taken, bool second) {
        held_first_ = valid & !taken & !second;
        held_second_ = valid & !taken & second;
    }

private:
    bool held_first_ = false, held_second_ = false;
};

/// A stall-free pipeline behind a credit gate. A request admitted in cycle c answers from cycle c + latency
/// + 1 on, in order. `depth` credits bound the answers in flight. Mirror of rc_credit_counter + stages +
/// rc_fifo.
template <class Item> class Pipe {
public:
    Pipe(int latency, int depth) : latency_(std::uint64_t(latency) + 1), entries_(depth) {}
    bool ready() const { return !entries_.full(); }
    bool valid(std::uint64_t now) const { return due_ <= now; }
    const Item& front() const { return entries_.front().item; }
    /// One clock edge at the end of cycle `now`. `taken`: the first answer was accepted. `admitted`: a
    /// request with this answer was accepted.
    void clock(std::uint64_t now, bool taken, bool admitted, const Item& answer) {
        entries_.pop(taken);
        entries_.push({now + latency_, answer}, admitted);
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
    std::uint64_t latency_, due_ = never;   // due_: the first cycle in which an answer can be accepted
    Ring<Entry> entries_;
};

/// The same for a unit whose answers are always accepted: a ray admitted in cycle c answers in c + latency
/// + 1. Its depth bounds the rays in flight.
class Delay {
public:
    Delay(int latency, int depth)
        : latency_(std::uint64_t(latency) + 1),
          mask_((std::uint64_t(1) << index_bits(latency + 2)) - 1),
          depth_(depth),
          entries_(std::size_t(mask_) + 1, never << number_bits) {}
    bool ready() const { return under_way_ < depth_; }
    /// Returns the output in cycle `now`.
    LinkRay answer(std::uint64_t now) const {
        const std::uint64_t entry = entries_[now & mask_];
        return {entry >> number_bits == now, RayNumber(entry)};
    }
    void clock(std::uint64_t now, LinkRay admitted) {
        const std::uint64_t due = now + latency_;
        under_way_ += int(admitted.valid) - int(answer(now).valid);
        const std::uint64_t when = due | (std::uint64_t(admitted.valid) - 1);   // or never
        entries_[due & mask_] = when << number_bits | admitted.ray;
    }
    /// Returns the cycle of the first answer from `now` on; never, if there is none.
    std::uint64_t due(std::uint64_t now) const {
        for (std::uint64_t at = now; under_way_ > 0; ++at)
            if (answer(at).valid) return at;
        return never;
    }
    bool contains(RayNumber ray, std::uint64_t now) const {
        for (std::uint64_t at = now; at < now + latency_; ++at)
            if (answer(at).valid && RayNumber(answer(at).ray) == ray) return true;
        return false;
    }

private:
    static constexpr std::uint64_t never = ~std::uint64_t(0);
    static constexpr int number_bits = 16;
    std::uint64_t latency_, mask_;
    int depth_, under_way_ = 0;
    std::vector<std::uint64_t> entries_;   // [cycle]: that cycle, and a ray
};

}   // namespace rayclock
