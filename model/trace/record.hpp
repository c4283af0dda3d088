#pragma once
// Records one block of pixels: the inner part of record_trace(). The walk is TreeWalk, as everywhere. Boxes
// and primitives are tested in a faster way, because all rays begin at the frame's eye.
#include "model/engine/bvh/box.hpp"
#include "model/layout/memory_image.hpp"
#include "model/trace/decoder.hpp"
#include "model/trace/line_cache.hpp"
#include "model/trace/walk.hpp"
#include "model/unit/tri/facet.hpp"
#include "model/unit/tri/tri_test.hpp"
#include "model/unit/trav/stack.hpp"

namespace rayclock {

/// A node as seen from the eye.
struct SeenNode {
    WideNode node;
    alignas(32) std::array<double, 4> distance{};   ///< org - eye; the fourth is 0
};

/// Data that all rays of a frame share, for any number of threads.
class RecordJob {
public:
    RecordJob(const MemoryImage& image, const Frame& frame, const Config& config)
        : image_(image),
          frame_(frame),
          config_(config),
          test_(tri_test_of(config)),
          read_node_(config),
          nodes_(image.lines()),
          facets_(std::size_t(image.lines()) * 2),
          decoder_(image, config) {}

    const Frame& frame() const { return frame_; }
    const Config& config() const { return config_; }
    const Decoder& decoder() const { return decoder_; }   ///< for structures without tables for the eye
    const SeenNode& node(std::uint32_t line) const {
        return nodes_.get(line, [this, line] { return see(line); });
    }
    const Facet& facet(std::uint32_t half_line) const {
        return facets_.get(half_line,
                           [this, half_line] { return make_facet(triangle(half_line), frame_.eye); });
    }
    /// Performs the configuration's test, for tests without facets.
    void test(std::uint32_t half_line, const Vec3i& d, const Best& best, TriRsp& out) const {
        test_(frame_.eye, d, triangle(half_line), best, config_, out);
    }
    PrimData triangle(std::uint32_t half_line) const {
        return unpack<PrimData>(image_.half_line(half_line), config_);
    }

private:
    SeenNode see(std::uint32_t line) const {
        SeenNode seen{read_node_(image_.line(line)), {}};
        for (std::size_t k = 0; k < 3; ++k) seen.distance[k] = double(seen.node.org[k]) - frame_.eye[k];
        return seen;
    }

    const MemoryImage& image_;
    const Frame& frame_;
    const Config& config_;
    TriTest* test_;
    NodeReader read_node_;
    LineCache<SeenNode> nodes_;
    LineCache<Facet> facets_;
    Decoder decoder_;
};

struct RecordTotals {
    std::uint64_t visits = 0, box_tests = 0, triangle_tests = 0, dropped_groups = 0;
    std::uint64_t instances = 0;   ///< visits of instances, in a chip with two levels
};

/// Memory that a thread reuses from block to block.
struct RecordScratch {
    explicit RecordScratch(const Config& config) : stack(config) {}
    Stack stack;
    std::vector<std::uint32_t> words;   ///< of the block's rays, in any order
    std::vector<std::size_t> starts;    ///< start of each ray's words, row by row
    std::size_t used = 0;               ///< words
};

/// Pixels x0..x1-1 of the rows y0..y1-1.
struct RecordBlock {
    /// Maximum of x1 - x0 and y1 - y0. Rays of a block read the same nodes.
    static constexpr std::uint32_t side = 16;
    std::uint32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// Fills `scratch` and the block's part of `hits` ([y * width + x]), and adds to `totals`.
using RecordFunction = void(const RecordJob& job, const RecordBlock& block, RecordScratch& scratch,
                            Closest* hits, RecordTotals& totals);
RecordFunction record_block_plain;
/// Returns the faster version if this processor supports it, otherwise the plain one.
RecordFunction* record_block();

/// Records one ray of any kind, for a chip that shades. Its words begin at `at` in scratch.words, which grows
/// as necessary. Returns the end of its words.
using RecordRayFunction = std::size_t(const Decoder& decoder, const Config& config, std::uint32_t root,
                                      const Ray& ray, std::size_t at, RecordScratch& scratch,
                                      RecordTotals& totals, Closest& hit);
RecordRayFunction record_any_plain;
/// Returns the faster version if this processor supports it, otherwise the plain one.
RecordRayFunction* record_any();

}   // namespace rayclock
