// Records a frame's rays on all cores.
#include "model/trace/trace.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>
#include <optional>
#include <system_error>

#include "model/trace/record.hpp"
#include "model/trace/record_shaded.hpp"
#include "model/unit/raygen/raygen.hpp"

namespace rayclock {

/// The state that the threads share. They take blocks in order, so that a machine that replays at the same
/// time finds its next rays.
struct Recording::Work {
    static constexpr std::uint32_t block = RecordBlock::side, stream_chunk = 1024;

    Work(const MemoryImage& image_, const Frame& frame_, const Config& config, Trace& trace_,
         const Progress& progress_)
        : frame(frame_),
          trace(trace_),
          progress(progress_),
          columns(config.is_stream() ? std::uint32_t((frame.pixels() + stream_chunk - 1) / stream_chunk)
                                     : (frame.width + block - 1) / block),
          rows(config.is_stream() ? 1 : (frame.height + block - 1) / block),
          image(image_),
          job(image, frame, config),
          record(record_block()),
          record_given(record_any()) {
        if (config.shading) decoder = std::make_unique<Decoder>(image, config);
        trace.width = frame.width;
        trace.first_mesh_line = config.has_two_engines() ? image.first_mesh_line : ~0u;
        trace.height = frame.height;
        trace.rays.assign(std::size_t(frame.pixels()), nullptr);
        trace.hits.resize(trace.rays.size());
        if (config.has_shade())
            trace.colours.resize(trace.rays.size()), trace.signatures.resize(trace.rays.size());
        trace.chunks.resize(std::size_t(columns) * rows);
    }

    void run() {
        RecordScratch scratch(job.config());
        RecordTotals totals;
        std::optional<ShadedRecorder> shaded;
        RayCounts streamed;
        if (job.config().has_shade()) shaded.emplace(image, frame, job.config(), *decoder);
        try {
            for (std::size_t chunk = next++; chunk < trace.chunks.size() && !trace.failed; chunk = next++)
                job.config().is_stream() ? record_stream(chunk, scratch, totals, streamed)
                                         : record_chunk(chunk, scratch, totals, shaded);
        } catch (...) {
            const std::lock_guard lock(mutex);
            error = std::current_exception();
            trace.failed.store(true);
        }
        const std::lock_guard lock(mutex);
        trace.visits += totals.visits;
        trace.box_tests += totals.box_tests;
        trace.triangle_tests += totals.triangle_tests;
        trace.dropped_groups += totals.dropped_groups;
        if (shaded)
            trace.counts += shaded->counts();
        else if (job.config().is_stream())
            trace.counts += streamed;
        else
            trace.counts.primary = trace.rays.size();
    }

    void record_chunk(std::size_t chunk, RecordScratch& scratch, RecordTotals& totals,
                      std::optional<ShadedRecorder>& shaded) {
        RecordBlock pixels;
        pixels.x0 = std::uint32_t(chunk % columns) * block,
        pixels.y0 = std::uint32_t(chunk / columns) * block;
        pixels.x1 = std::min(pixels.x0 + block, frame.width),
        pixels.y1 = std::min(pixels.y0 + block, frame.height);
        if (shaded)
            shaded->block(pixels, scratch, trace, totals);
        else
            record(job, pixels, scratch, trace.hits.data(), totals);
        std::vector<std::uint32_t>& words = trace.chunks[chunk];
        words.assign(scratch.words.begin(), scratch.words.begin() + std::ptrdiff_t(scratch.used));
        std::size_t n = 0;
        for (std::uint32_t y = pixels.y0; y < pixels.y1; ++y)
            for (std::uint32_t x = pixels.x0; x < pixels.x1; ++x)
                std::atomic_ref(trace.rays[std::size_t(y) * frame.width + x])
                    .store(words.data() + scratch.starts[n++], std::memory_order_release);
        report();
    }

    /// Records the next rays of a stream. Rays that need any hit count as shadow rays.
    void record_stream(std::size_t chunk, RecordScratch& scratch, RecordTotals& totals, RayCounts& counts) {
        const std::size_t first = chunk * stream_chunk,
                          last = std::min<std::size_t>(first + stream_chunk, frame.ray_count);
        scratch.starts.clear();
        std::size_t end = 0;
        for (std::size_t i = first; i < last; ++i) {
            const auto given = unpack<RayRecord>(image.record(std::uint32_t(i)), job.config());
            scratch.starts.push_back(end);
            end = record_given(*decoder, job.config(), frame.root, recorded_ray(given, 0, job.config()), end,
                               scratch, totals, trace.hits[i]);
            ++(ends_at_any(given.kind) ? counts.shadow : counts.primary);
        }
        std::vector<std::uint32_t>& words = trace.chunks[chunk];
        words.assign(scratch.words.begin(), scratch.words.begin() + std::ptrdiff_t(end));
        for (std::size_t i = first; i < last; ++i)
            std::atomic_ref(trace.rays[i])
                .store(words.data() + scratch.starts[i - first], std::memory_order_release);
        report();
    }

    void report() {
        if (!progress) return;
        const std::lock_guard lock(mutex);
        progress("rays", ++finished, trace.chunks.size());
    }

    const Frame frame;
    Trace& trace;
    const Progress progress;
    std::uint32_t columns, rows;
    const MemoryImage& image;
    RecordJob job;
    RecordFunction* record;
    RecordRayFunction* record_given;
    std::unique_ptr<Decoder> decoder;   // for a chip that shades
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::uint64_t finished = 0;
    std::exception_ptr error;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    std::vector<std::thread> threads;
};

Recording::Recording(const MemoryImage& image, const Frame& frame, const Config& config, int threads,
                     Trace& trace, const Progress& progress)
    : work_(std::make_unique<Work>(image, frame, config, trace, progress)) {
    const std::size_t cores =
        threads > 0 ? std::size_t(threads) : std::max(1u, std::thread::hardware_concurrency());
    try {
        for (std::size_t i = 0; i < std::min(cores, trace.chunks.size()); ++i)
            work_->threads.emplace_back([work = work_.get()] { work->run(); });
    } catch (const std::system_error&) {
        // The system provides no more threads. Existing threads do all the work. Without any, the caller's
        // thread does it now.
        if (work_->threads.empty()) work_->run();
    }
}

Recording::~Recording() {
    if (!work_->threads.empty()) work_->trace.failed.store(true);   // abandoned: the threads stop soon
    for (std::thread& thread : work_->threads) thread.join();
}

void Recording::finish() {
    for (std::thread& thread : work_->threads) thread.join();
    work_->threads.clear();
    if (work_->error) std::rethrow_exception(work_->error);
    work_->trace.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - work_->start).count();
}

Trace record_trace(const MemoryImage& image, const Frame& frame, const Config& config, int threads,
                   const Progress& progress) {
    Trace trace;
    Recording(image, frame, config, threads, trace, progress).finish();
    return trace;
}

}   // namespace rayclock
