#pragma once
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

/// body(tile) for every square of 32 x 32 pixels, on `threads` cores (0: all); `what` and the pixels done go
/// to `progress`.
template <class Body> void for_each_tile(FrameSize size, int threads, std::string_view what,
                                         const Progress& progress, const Body& body) {
    constexpr int tile_side = 32;
    std::mutex reporting;
    std::uint64_t done = 0;
    const std::uint64_t total =
        static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height);
    const int cores = tbb::this_task_arena::max_concurrency();
    tbb::task_arena arena(threads > 0 ? std::min(threads, cores) : cores);
    arena.execute([&] {
        const PixelTile pixels(0, size.height, tile_side, 0, size.width, tile_side);
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
