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

/// A queue of contexts. Up to 255 contexts fit in the queue itself; callers that know that there are no more
/// say so (`few`), and need fewer instructions.
class RayRing {
public:
    static constexpr int most_few = 255;

    explicit RayRing(int capacity) : capacity_(std::uint32_t(capacity)) {
        if (capacity <= most_few) return;
        many_.resize(std::size_t(1) << index_bits(capacity + 1));
        mask_ = std::uint32_t(many_.size() - 1);
    }
    bool empty() const { return head_ == tail_; }
    std::uint32_t size() const { return tail_ - head_; }
    /// Returns the oldest ray; of an empty queue any ray that it has held, or 0.
    template <bool few = false> RayNumber front() const {
        if constexpr (few) return few_[std::uint8_t(head_)];
        return at(0);
    }
    void pop(bool on = true) {
        assert(!on || !empty());
        head_ += on;
    }
    /// Writes the next place, which always exists, and accepts the ray if `on`.
    template <bool few = false> void push(RayNumber ray, bool on = true) {
        assert(!on || size() < capacity_);
        if constexpr (few)
            few_[std::uint8_t(tail_)] = ray;
        else
            (many_.empty() ? few_.data() : many_.data())[tail_ & mask_] = ray;
        tail_ += on;
    }
    bool contains(RayNumber ray) const {
        for (std::uint32_t i = 0; i < size(); ++i)
            if (at(i) == ray) return true;
        return false;
    }

private:
    RayNumber at(std::uint32_t i) const {
        return (many_.empty() ? few_.data() : many_.data())[(head_ + i) & mask_];
    }

    std::uint32_t mask_ = most_few, capacity_;
    std::uint32_t head_ = 0, tail_ = 0;   // both wrap, and so does their difference
    std::array<RayNumber, most_few + 1> few_{};
    std::vector<RayNumber> many_;
};

/// The content of a link in a cycle. If `valid` is false, `ray` is an arbitrary context's number.
struct LinkRay {
    bool valid = false;
    std::uint32_t ray = 0;
};

/// Returns one of two numbers, without a branch: the compiler learns that it could not be predicted.
inline std::uint32_t select(bool first, std::uint32_t a, std::uint32_t b) {
    return __builtin_expect_with_probability(first, 1, 0.5) ? a : b;
}

/// Two queues on one link. The first has priority, but an offer that was not accepted stays. Mirror of
/// rtl/cells/queues/rc_priority_merge.sv, which also remembers an offer of the first; a queue that was not
/// accepted is still valid.
class Merge {
public:
    /// True if the second queue is on offer. `first_valid`: the first queue is valid.
    bool second(bool first_valid) const { return held_second_ | !first_valid; }
    void clock(bool valid, bool taken, bool second) { held_second_ = valid & !taken & second; }

private:
    bool held_second_ = false;
};

/// A stall-free pipeline behind a credit gate. A request admitted in cycle c answers from cycle c + latency
/// + 1 on, in order. `depth` credits bound the answers in flight. Mirror of rc_credit_counter + stages +
/// rc_fifo.
template <class Item> class Pipe {
public:
    Pipe(int latency, int depth) : latency_(std::uint64_t(latency) + 1), depth_(depth), entries_(depth) {}
    bool ready() const { return under_way_ < depth_; }
    bool valid(std::uint64_t now) const { return !entries_.empty() & (entries_.front().due <= now); }
    const Item& front() const { return entries_.front().item; }
    /// One clock edge at the end of cycle `now`. `taken`: the first answer was accepted. `admitted`: a
    /// request with this answer was accepted.
    void clock(std::uint64_t now, bool taken, bool admitted, const Item& answer) {
        take(taken);
        admit(now, taken, admitted, answer);
    }
    // The two halves of clock(). The side of the answers may run ahead of the side of the requests by up to
    // `latency` cycles.
    void take(bool taken) { entries_.pop(taken); }
    void admit(std::uint64_t now, bool taken, bool admitted, const Item& answer) {
        under_way_ += int(admitted) - int(taken);
        entries_.push({now + latency_, answer}, admitted);
    }
    /// Returns the cycle of the first answer; never, if there is none.
    std::uint64_t due() const { return entries_.empty() ? never : entries_.front().due; }
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
    std::uint64_t latency_;
    int depth_, under_way_ = 0;
    Ring<Entry> entries_;
};

/// The same for a unit whose answers are always accepted: a ray admitted in cycle c answers in c + latency
/// + 1. Its depth bounds the rays in flight. answer() still knows the answers of the last `kept` cycles.
class Delay {
public:
    Delay(int latency, int depth, int kept = 0)
        : latency_(std::uint64_t(latency) + 1), kept_(std::uint64_t(kept)), depth_(depth) {
        assert(2 * (latency_ + kept_) < places && "a skip does not reach answers under way");
    }
    bool ready() const { return under_way_ < depth_; }
    /// Returns the output in cycle `now`.
    LinkRay answer(std::uint64_t now) const {
        const std::uint32_t entry = entries_[now % places];
        return {bool(entry / valid), entry % valid};
    }
    void clock(std::uint64_t now, LinkRay ray) {
        under_way_ += int(ray.valid) - int(answer(now).valid);
        admit(now, ray);
    }

    // For a unit that never stalls, whose admissions are known in advance: count() sets the number of rays
    // under way before the next clock().
    bool never_stalls() const { return std::uint64_t(depth_) > latency_; }
    void admit(std::uint64_t now, LinkRay ray) {
        entries_[(now + latency_) % places] = std::uint16_t(ray.ray + valid * ray.valid);
    }
    LinkRay admitted(std::uint64_t now) const { return answer(now + latency_); }
    void count(std::uint64_t now) {
        under_way_ = 0;
        for (std::uint64_t at = now; at < now + latency_; ++at) under_way_ += answer(at).valid;
    }
    /// Skips cycles without an admission, an answer, or an answer that is `kept` cycles old.
    void skip(std::uint64_t now, std::uint64_t cycles) {
        if (under_way_ == 0 && cycles > kept_) return clear();
        for (std::uint64_t i = 0; i < cycles; ++i) entries_[(now + latency_ + i) % places] = 0;
    }
    /// Forgets all answers. Call it when none is under way, before cycles are left out.
    void clear() { entries_.fill(0); }
    /// Returns the first cycle from `now` on with an answer, or with one that is `kept` cycles old; never, if
    /// there is none.
    std::uint64_t due(std::uint64_t now) const {
        for (std::uint64_t at = now; at < now + kept_; ++at)
            if (answer(at).valid || answer(at - kept_).valid) return at;
        for (std::uint64_t at = now; under_way_ > 0; ++at)
            if (answer(at).valid) return at;
        return ~std::uint64_t(0);
    }
    bool contains(RayNumber ray, std::uint64_t now) const { return has(ray, now, now + latency_); }
    /// True if the ray's answer is among those kept.
    bool keeps(RayNumber ray, std::uint64_t now) const { return has(ray, now - kept_, now); }

private:
    static constexpr std::size_t places = 512;
    static constexpr std::uint32_t valid = 1 << 15;   // flag of an entry; the rest is a ray
    bool has(RayNumber ray, std::uint64_t from, std::uint64_t end) const {
        for (std::uint64_t at = from; at != end; ++at)
            if (answer(at).valid && RayNumber(answer(at).ray) == ray) return true;
        return false;
    }
    std::uint64_t latency_, kept_;
    int depth_, under_way_ = 0;
    std::array<std::uint16_t, places> entries_{};   // [cycle]: each cycle writes the entry of its answer
};

}   // namespace rayclock
