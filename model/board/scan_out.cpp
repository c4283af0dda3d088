// A cycle of scan-out.
#include "model/board/scan_out.hpp"

#include <algorithm>

namespace rayclock {

ScanOut::Fetch ScanOut::under_beam() const {
    if (!ticks() || !shown_.is_shown() || h_ >= ScreenTiming::shown_width || v_ >= ScreenTiming::shown_height)
        return {};
    const std::uint32_t width = shown_.width << shown_.doubled, height = shown_.height << shown_.doubled;
    // A position left of the picture or above it wraps to a large number.
    const std::uint32_t x = h_ - (ScreenTiming::shown_width - width) / 2,
                        y = v_ - (ScreenTiming::shown_height - height) / 2;
    if (x >= width || y >= height) return {};
    return {true, y >> shown_.doubled >> 2, x >> shown_.doubled >> 2};
}

bool ScanOut::row_ends() const {
    if (!ticks() || h_ != ScreenTiming::shown_width || !shown_.is_shown()) return false;
    const std::uint32_t height = shown_.height << shown_.doubled,
                        y = v_ - (ScreenTiming::shown_height - height) / 2, lines = 4U << shown_.doubled;
    return y < height && y % lines == lines - 1;
}

void ScanOut::clock(const Inputs& in) {
    const bool tick = ticks(), taking = takes(), starts = start_ && shown_.is_shown();
    const bool opens = row_ends() && opened_ < shown_.blocks_down();
    const bool issues =
        to_request_ != 0 && pending_ != shape_.in_flight && (!req_valid_ || in.req_ready) && !taking;
    const bool line_done = in.beat && beat_ == beats_of_line - 1;

    // Stages of a pixel.
    underruns_ = std::min(underruns_ + s3_late_, most_underruns);
    const bool there = s2_.row < arrived_row_ || (s2_.row == arrived_row_ && s2_.block < arrived_);
    s3_late_ = s2_.valid && !there;
    s2_ = s1_;
    s1_ = under_beam();

    // Requests.
    const std::uint32_t pace_limit = ScreenTiming::total_width * (4U << shown_.doubled),
                        pace_sum = pace_ + shown_.blocks_across();
    const bool falls = tick && to_fall_ != 0 && pace_sum >= pace_limit;
    if (to_fall_ == 0)
        pace_ = 0;
    else if (tick)
        pace_ = falls ? pace_sum - pace_limit : pace_sum;
    std::uint32_t added = 0;
    if (starts)
        added = shown_.blocks_across() * std::min(shown_.blocks_down(), 2U);
    else if (opens)
        added = shown_.blocks_across();
    to_request_ = taking ? 0 : to_request_ + added - issues;
    to_fall_ = taking ? 0 : to_fall_ + added - falls;
    if (taking)
        opened_ = opens_nothing;
    else if (starts)
        opened_ = 2;
    else if (opens)
        ++opened_;
    if (issues) address_ = next_address_++;
    if (start_) next_address_ = shown_.base;
    req_valid_ = issues || (req_valid_ && !in.req_ready);

    // Arrival. Lines of the picture before are discarded.
    const bool keeps = drop_ == 0;
    pending_ = pending_ + issues - line_done;
    if (taking)
        drop_ = pending_;
    else if (line_done && !keeps)
        --drop_;
    if (in.beat) beat_ = (beat_ + 1) % beats_of_line;
    if (taking) {
        arrived_ = arrived_row_ = 0;
    } else if (line_done && keeps && ++arrived_ == shown_.blocks_across()) {
        arrived_ = 0;
        ++arrived_row_;
    }

    // Beam.
    start_ = taken_;
    taken_ = taking;
    if (taking) shown_ = in.picture;
    phase_ += shape_.pixel_khz;
    if (!tick) return;
    phase_ -= shape_.chip_khz;
    if (++h_ < ScreenTiming::total_width) return;
    h_ = 0;
    if (++v_ == ScreenTiming::total_height) v_ = 0;
}

}   // namespace rayclock
