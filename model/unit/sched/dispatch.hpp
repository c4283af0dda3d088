#pragma once
// The unit dispatch: gives tiles to pipelines.
#include <utility>
#include <vector>

#include "model/core/payloads.hpp"

namespace rayclock {

/// Tiles of a frame that follow each other in the order of dispatch. A whole frame is one stretch. A sample
/// of a frame consists of several.
struct Stretch {
    Tile first{};
    std::uint32_t tiles = ~0u;   ///< a stretch ends at the frame's last tile at the latest
};

/// Distributes the picture in tiles of 2^tile_bits x 2^tile_bits pixels, row by row. It gives one tile per
/// cycle, round-robin, to the pipelines that have room. With a stream it distributes groups of 4^tile_bits
/// rays. Mirror of rtl/unit/sched/rc_dispatch.sv.
class Dispatch {
public:
    explicit Dispatch(const Config& config)
        : pipelines_(std::uint32_t(config.pipelines)),
          tile_bits_(config.tile_bits),
          columns_of_rays_(config.is_stream() ? 1u << config.tile_coord_bits() : 0) {}

    void start(const Frame& frame, std::vector<Stretch> stretches = {{}}) {
        if (columns_of_rays_ > 0) {
            const std::uint32_t last = (frame.ray_count - 1) >> 2 * tile_bits_;   // the last group
            columns_ = columns_of_rays_;
            rows_ = last / columns_ + 1;
            last_columns_ = last % columns_ + 1;
        } else {
            columns_ = last_columns_ = (frame.width + (1u << tile_bits_) - 1) >> tile_bits_;
            rows_ = (frame.height + (1u << tile_bits_) - 1) >> tile_bits_;
        }
        stretches_ = std::move(stretches);
        next_stretch_ = 0;
        more_ = begin_stretch();
    }
    bool more() const { return more_; }
    const Tile& tile() const { return tile_; }

    /// Returns the pipeline that gets the tile, among those set in `want`, or -1.
    int grant(std::uint32_t want) const {
        if (!more_ || want == 0) return -1;
        std::uint32_t p = next_;
        while (!(want >> p & 1)) p = (p + 1) & (pipelines_ - 1);
        return int(p);
    }
    void clock(int granted) {
        if (granted < 0) return;
        next_ = (std::uint32_t(granted) + 1) & (pipelines_ - 1);
        ++tile_.x;
        if (--left_ == 0 || (tile_.y + 1 == rows_ && tile_.x == last_columns_)) [[unlikely]] {
            more_ = begin_stretch();
            return;
        }
        if (tile_.x == columns_) tile_.x = 0, ++tile_.y;
    }

private:
    /// Moves to the first tile of the next stretch. Returns false if there is none.
    bool begin_stretch() {
        if (next_stretch_ == stretches_.size()) return false;
        const Stretch& stretch = stretches_[next_stretch_++];
        tile_ = stretch.first;
        left_ = stretch.tiles;
        return true;
    }

    std::uint32_t pipelines_;
    int tile_bits_;
    std::uint32_t columns_of_rays_;   // of a chip for streams, else 0
    std::uint32_t columns_ = 0, rows_ = 0, next_ = 0;
    std::uint32_t last_columns_ = 0;   // columns of the last row
    std::vector<Stretch> stretches_;
    std::size_t next_stretch_ = 0;
    std::uint32_t left_ = 0;   // tiles of the stretch
    Tile tile_;
    bool more_ = false;
};

}   // namespace rayclock
