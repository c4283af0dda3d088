// Records the pixels that a machine starts.
#include "model/trace/on_demand.hpp"

#include <algorithm>

namespace rayclock {

OnDemandJob::OnDemandJob(const MemoryImage& image_, const Frame& frame_, const Config& config_)
    : image(image_), frame(frame_), config(config_), narrow(frame_) {
    narrow.width = 0;
    if (config.has_shade())
        decoder = std::make_unique<Decoder>(image, config);
    else
        job.emplace(image, narrow, config);
}

OnDemandRecorder::OnDemandRecorder(const OnDemandJob& shared)
    : shared_(shared), scratch_(shared.config), record_(record_block()) {
    trace_.width = shared.frame.width;
    trace_.height = shared.frame.height;
    trace_.first_mesh_line = shared.config.has_two_engines() ? shared.image.first_mesh_line : ~0u;
    trace_.source = this;
    if (shared.decoder)
        shaded_.emplace(shared.image, shared.frame, shared.config, *shared.decoder);
    else
        hits_.resize(shared.frame.width);
}

PixelWork OnDemandRecorder::walk(std::uint32_t x, std::uint32_t y) {
    PixelWork work;
    if (shaded_) {
        const RayCounts before = shaded_->counts();
        end_ = shaded_->pixel(x, y, 0, scratch_, work.steps);
        work.rays = shaded_->counts() - before;
    } else {
        record_(*shared_.job, {x, y, x + 1, y + 1}, scratch_, hits_.data(), work.steps);
        end_ = scratch_.used;
        work.rays.primary = 1;
    }
    return work;
}

const OnDemandRecorder::Kept& OnDemandRecorder::kept(std::uint32_t x, std::uint32_t y) {
    constexpr std::size_t chunk_words = 1 << 16;
    Kept& pixel = kept_[y * trace_.width + x];
    if (pixel.words != nullptr) return pixel;
    pixel.work = walk(x, y);
    if (room_ < end_) {
        room_ = std::max(end_, chunk_words);
        chunks_.emplace_back(room_);
    }
    std::uint32_t* const words = chunks_.back().data() + (chunks_.back().size() - room_);
    std::copy_n(scratch_.words.begin(), end_, words);
    room_ -= end_;
    pixel.words = words;
    return pixel;
}

}   // namespace rayclock
