#include "model/trace/trace.hpp"

#include <atomic>
#include <chrono>
#include <mutex>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include "model/trace/record.hpp"

namespace rayclock {

Trace record_trace(const MemoryImage& image, const Frame& frame, const Config& config, int threads, const Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    constexpr std::uint32_t block = RecordBlock::side;
    Trace trace;
    trace.width = frame.width;
    trace.height = frame.height;
    trace.rays.resize(std::size_t(frame.width) * frame.height);
    trace.hits.resize(trace.rays.size());
    const std::uint32_t columns = (frame.width + block - 1) / block, rows = (frame.height + block - 1) / block;
    trace.chunks.resize(std::size_t(columns) * rows);
    const RecordJob job(image, frame, config);
    RecordFunction* const record = record_block();
    std::mutex mutex;
    std::uint64_t finished = 0;

    const auto record_chunk = [&](std::size_t chunk) {
        thread_local RecordScratch scratch;
        RecordTotals totals;
        RecordBlock pixels;
        pixels.x0 = std::uint32_t(chunk % columns) * block, pixels.y0 = std::uint32_t(chunk / columns) * block;
        pixels.x1 = std::min(pixels.x0 + block, frame.width), pixels.y1 = std::min(pixels.y0 + block, frame.height);
        record(job, pixels, scratch, trace.hits.data(), totals);
        std::vector<std::uint32_t>& words = trace.chunks[chunk];
        words.assign(scratch.words.begin(), scratch.words.begin() + std::ptrdiff_t(scratch.used));
        std::size_t n = 0;
        for (std::uint32_t y = pixels.y0; y < pixels.y1; ++y)
            for (std::uint32_t x = pixels.x0; x < pixels.x1; ++x)
                trace.rays[std::size_t(y) * frame.width + x] = words.data() + scratch.starts[n++];
        const std::lock_guard lock(mutex);
        trace.visits += totals.visits;
        trace.box_tests += totals.box_tests;
        trace.triangle_tests += totals.triangle_tests;
        trace.turns += totals.turns;
        if (progress) progress("rays", ++finished, trace.chunks.size());
    };
    const auto record_all = [&] { tbb::parallel_for(std::size_t(0), trace.chunks.size(), record_chunk); };
    if (threads > 0) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
        record_all();
    } else {
        record_all();
    }
    trace.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return trace;
}

} // namespace rayclock
