#pragma once
// Pieces of work on several threads, by TBB. What comes of them does not depend on how many threads there
// are.
#include <algorithm>
#include <cstddef>
#include <utility>

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

namespace rayclock::jobs {

/// As many threads as asked for, but not more than there are cores; 0: one for each.
inline int threads_of(int asked) {
    const int cores = tbb::this_task_arena::max_concurrency();
    return asked > 0 ? std::min(asked, cores) : cores;
}

/// Calls make(0), make(1), ... for as long as goes_on(i), begun in this order on several threads, and
/// take(what make gave) one after the other, in the same order. The first exception lets nothing more begin,
/// and is thrown here. While a piece waits for threads of its own, its thread begins no other piece.
template <class GoesOn, class Make, class Take>
void in_order(int threads, GoesOn goes_on, Make make, Take take) {
    using Made = decltype(make(std::size_t()));
    using tbb::filter_mode;
    const int cores = threads_of(threads);
    const std::size_t ahead = cores > 1 ? 4 * std::size_t(cores) : 1;   // pieces that may be done before
                                                                        // their turn to be taken
    std::size_t next = 0;
    const auto begin = [&](tbb::flow_control& flow) {
        if (goes_on(next)) return next++;
        flow.stop();
        return std::size_t(0);
    };
    const auto apart = [&](std::size_t i) { return tbb::this_task_arena::isolate([&] { return make(i); }); };
    tbb::task_arena(cores).execute([&] {
        tbb::parallel_pipeline(ahead,
                               tbb::make_filter<void, std::size_t>(filter_mode::serial_in_order, begin) &
                                   tbb::make_filter<std::size_t, Made>(filter_mode::parallel, apart) &
                                   tbb::make_filter<Made, void>(filter_mode::serial_in_order, take));
    });
}

/// Calls piece(i) for every i below `count`, begun in this order. The rest is as above.
template <class Piece> void for_each(std::size_t count, int threads, Piece piece) {
    const auto make = [&](std::size_t i) {
        piece(i);
        return i;
    };
    in_order(
        threads, [&](std::size_t i) { return i < count; }, make, [](std::size_t) {});
}

}   // namespace rayclock::jobs
