#pragma once
// Records the pixels that a machine starts, for samples of a frame.
#include <deque>
#include <memory>
#include <optional>
#include <unordered_map>

#include "model/trace/record.hpp"
#include "model/trace/record_shaded.hpp"
#include "model/trace/trace.hpp"

namespace rayclock {

/// The work of a pixel's rays.
struct PixelWork {
    RayCounts rays;
    RecordTotals steps;
};

/// The decoded lines of the memory image, which all recorders of a frame share, in any number of threads.
/// `image`, `frame` and `config` must stay in place.
struct OnDemandJob {
    OnDemandJob(const MemoryImage& image, const Frame& frame, const Config& config);
    OnDemandJob(const OnDemandJob&) = delete;
    const MemoryImage& image;
    const Frame& frame;
    const Config& config;
    /// The frame with a width of 0, so that a recorder needs room for the hits of one row only.
    Frame narrow;
    std::optional<RecordJob> job;       ///< for camera rays
    std::unique_ptr<Decoder> decoder;   ///< for a chip that shades
};

/// Records one pixel at a time, with the same words as record_trace(). Only one thread may use it.
class OnDemandRecorder : public PixelRecorder {
public:
    explicit OnDemandRecorder(const OnDemandJob& shared);
    OnDemandRecorder(const OnDemandRecorder&) = delete;
    /// Returns the trace for a machine. It has no rays; the machine calls record().
    const Trace& trace() const { return trace_; }
    const std::uint32_t* record(std::uint32_t x, std::uint32_t y) override { return kept(x, y).words; }
    /// Returns the work of a pixel that record() keeps, and records it if necessary.
    const PixelWork& work(std::uint32_t x, std::uint32_t y) { return kept(x, y).work; }
    /// Walks a pixel and keeps nothing.
    PixelWork walk(std::uint32_t x, std::uint32_t y);
    /// Walks a pixel and keeps nothing. Returns its words, which the next call overwrites.
    const std::uint32_t* passing(std::uint32_t x, std::uint32_t y) {
        walk(x, y);
        return scratch_.words.data();
    }
    /// Forgets all pixels.

private:
    struct Kept {
        const std::uint32_t* words = nullptr;
        PixelWork work;
    };
    const Kept& kept(std::uint32_t x, std::uint32_t y);

    const OnDemandJob& shared_;
    Trace trace_;
    RecordScratch scratch_;
    std::size_t end_ = 0;   ///< words of the pixel that was walked last
    std::vector<Closest> hits_;
    std::optional<ShadedRecorder> shaded_;
    RecordFunction* record_;
    std::unordered_map<std::uint32_t, Kept> kept_;   ///< by y * width + x
    std::deque<std::vector<std::uint32_t>> chunks_;
    std::size_t room_ = 0;   ///< free words at the end of the last chunk
};

}   // namespace rayclock
