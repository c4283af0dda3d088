#pragma once
// The recorder for a chip that shades.
#include "model/trace/record.hpp"
#include "model/trace/trace.hpp"
#include "model/unit/shade/shader.hpp"

namespace rayclock {

/// Returns the purpose of the next ray, as the word after a ray holds it.
inline std::uint32_t purpose_word(const Shader& shader) {
    return std::uint32_t(shader.purpose()) << EndWord::purpose_shift;
}

/// Records frames with shading: one block of pixels, all rays of each. record_block() does this for camera
/// rays alone.
class ShadedRecorder {
public:
    ShadedRecorder(const MemoryImage& image, const Frame& frame, const Config& config, const Decoder& decoder)
        : config_(config),
          frame_(frame),
          decoder_(decoder),
          record_(record_any()),
          shader_(frame_, config_, image) {}

    /// Records a pixel. Its words begin at `at` in scratch.words. Returns their end.
    std::size_t pixel(std::uint32_t x, std::uint32_t y, std::size_t at, RecordScratch& scratch,
                      RecordTotals& totals);
    void block(const RecordBlock& block, RecordScratch& scratch, Trace& trace, RecordTotals& totals);
    const RayCounts& counts() const { return shader_.counts(); }

    /// Walks one pixel again, exactly as it was recorded, and reports it to `watch`.
    const Pixel& follow(std::uint32_t x, std::uint32_t y, RecordScratch& scratch, ShadeWatch& watch);
    std::uint64_t signature() const { return shader_.signature(); }   ///< of that pixel

private:
    const Config& config_;
    const Frame& frame_;
    const Decoder& decoder_;
    RecordRayFunction* record_;
    Shader shader_;
};

}   // namespace rayclock
