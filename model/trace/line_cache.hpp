#pragma once
// A table of objects that threads decode on their first request.
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace rayclock {

/// Objects decoded from the places of a memory, each on its first request, by any thread. Objects lie in the
/// order of their creation. Neither they nor the table's empty parts are touched before, so the system
/// allocates pages only for the part of the image that is read. Most of a big scene's image is never read.
template <class T> class LineCache {
    static_assert(std::is_trivially_destructible_v<T>);

public:
    explicit LineCache(std::size_t places)
        : table_(static_cast<std::uint32_t*>(std::calloc(places, sizeof(std::uint32_t)))),
          things_(static_cast<T*>(::operator new(places * sizeof(T), align))) {
        if (!table_) throw std::bad_alloc();
    }

    /// Returns the object at a place. `make()` creates it, and is called once.
    template <class Make> const T& get(std::uint32_t place, Make&& make) const {
        const std::uint32_t state = std::atomic_ref(table_[place]).load(std::memory_order_acquire);
        return things_[(state >= first ? state : fill(place, make)) - first];
    }

private:
    static constexpr std::uint32_t claimed = 1,
                                   first = 2;   // states: 0 empty, from `first` on the position of the object
    static constexpr std::align_val_t align{alignof(T)};
    struct Free {
        void operator()(std::uint32_t* table) const { std::free(table); }
    };
    struct Delete {
        void operator()(T* things) const { ::operator delete(things, align); }
    };

    /// One thread creates the object; the others wait.
    template <class Make>
    [[gnu::noinline, gnu::cold]] std::uint32_t fill(std::uint32_t place, Make& make) const {
        const std::atomic_ref state(table_[place]);
        std::uint32_t value = 0;
        if (state.compare_exchange_strong(value, claimed)) {
            const std::uint32_t at = made_.fetch_add(1, std::memory_order_relaxed);
            ::new (&things_[at]) T(make());
            state.store(first + at, std::memory_order_release);
            return first + at;
        }
        while (value == claimed) value = state.load(std::memory_order_acquire);
        return value;
    }

    std::unique_ptr<std::uint32_t[], Free> table_;
    std::unique_ptr<T[], Delete> things_;
    mutable std::atomic<std::uint32_t> made_{0};
};

}   // namespace rayclock
