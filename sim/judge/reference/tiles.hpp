#pragma once
// Rendering an image in tiles on several threads.
#include <algorithm>
#include <mutex>
#include <string_view>

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "model/base/progress.hpp"
#include "model/scene/camera.hpp"

namespace rayclock {

using PixelTile = tbb::blocked_range2d<int>;

/// Returns an arena with the requested number of threads, but at most the number of cores. 0 means all cores.
inline tbb::task_arena arena_of(int threads) {
    const int cores = tbb::this_task_arena::max_concurrency();
    return tbb::task_arena(threads > 0 ? std::min(threads, cores) : cores);
}

/// Calls body(tile) for every tile of 32 x 32 pixels, or `side`, on `threads` cores (0: all). Reports `what`
/// and the number of finished pixels to `progress`.
template <class Body> void for_each_tile(FrameSize size, int threads, std::string_view what,
                                         const Progress& progress, const Body& body,
                                         FrameSize side = {32, 32}) {
    std::mutex reporting;
    std::uint64_t done = 0;
    const std::uint64_t total =
        static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height);
    arena_of(threads).execute([&] {
        const PixelTile pixels(0, size.height, std::size_t(side.height), 0, size.width,
                               std::size_t(side.width));
        tbb::parallel_for(
            pixels,
            [&](const PixelTile& tile) {
                body(tile);
                if (!progress) return;
                const std::lock_guard lock(reporting);
                done += tile.rows().size() * tile.cols().size();
                progress(what, done, total);
            },
            tbb::simple_partitioner{});
    });
}

}   // namespace rayclock
