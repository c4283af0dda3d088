#pragma once
// Parallel work on TBB threads. The results do not depend on the number of threads.
#include <algorithm>
#include <cstddef>
#include <utility>

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

namespace rayclock::parallel {

/// Returns the number of threads to use: `asked`, but at most the number of cores. 0 means one per core.
inline int threads_of(int asked) {
    const int cores = tbb::this_task_arena::max_concurrency();
    return asked > 0 ? std::min(asked, cores) : cores;
}

/// Calls make(0), make(1), ... while goes_on(i) is true. The calls start in this order on several threads.
/// Calls take(result of make) for one result after the other, in the same order. After the first exception no
/// new call starts, and in_order() rethrows it. While a make() waits for threads of its own, its thread
/// starts no other make().
template <class GoesOn, class Make, class Take>
void in_order(int threads, GoesOn goes_on, Make make, Take take) {
    using Made = decltype(make(std::size_t()));
    using tbb::filter_mode;
    const int cores = threads_of(threads);
    // The number of results that may wait for their turn.
    const std::size_t ahead = cores > 1 ? 4 * std::size_t(cores) : 1;
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

/// Calls piece(i) for every i below `count`. Order and exceptions are those of in_order().
template <class Piece> void for_each(std::size_t count, int threads, Piece piece) {
    const auto make = [&](std::size_t i) {
        piece(i);
        return i;
    };
    in_order(
        threads, [&](std::size_t i) { return i < count; }, make, [](std::size_t) {});
}

}   // namespace rayclock::parallel
