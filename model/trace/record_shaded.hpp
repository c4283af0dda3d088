#pragma once
#include "model/unit/shade/shader.hpp"
#include "model/trace/record.hpp"
#include "model/trace/trace.hpp"

namespace rayclock {

/// What the word after a ray says of the next one.
inline std::uint32_t purpose_word(const Shader& shader) {
    return std::uint32_t(shader.purpose()) << Trace::purpose_shift;
}

/// Shading frames: one block of pixels, all rays of each; as record_block() does for camera rays alone.
class ShadedRecorder {
public:
    ShadedRecorder(const MemoryImage& image, const Frame& frame, const Config& config, const Decoder& decoder)
        : config_(config),
          frame_(frame),
          decoder_(decoder),
          record_(record_any()),
          shader_(frame_, config_, image) {}

    void block(const RecordBlock& block, RecordScratch& scratch, Trace& trace, RecordTotals& totals);
    const RayCounts& counts() const { return shader_.counts(); }

    /// One pixel again, seen by `watch`; as it was recorded.
    const Pixel& follow(std::uint32_t x, std::uint32_t y, RecordScratch& scratch, ShadeWatch& watch);
    std::uint64_t signature() const { return shader_.signature(); }   ///< of that pixel

private:
    /// Their words begin at `at` in scratch.words; return where they end.
    std::size_t pixel(std::uint32_t x, std::uint32_t y, std::size_t at, RecordScratch& scratch,
                      RecordTotals& totals);

    const Config& config_;
    const Frame& frame_;
    const Decoder& decoder_;
    RecordRayFunction* record_;
    Shader shader_;
};

}   // namespace rayclock
