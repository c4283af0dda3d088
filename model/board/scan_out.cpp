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
    const bool opens = opens_;
    const bool issues =
        to_request_ != 0 && pending_ != shape_.in_flight && (!req_valid_ || in.req_ready) && !taking;
    const bool line_done = in.beat && beat_ == beats_of_line - 1;

    // Stages of a pixel.
    underruns_ = std::min(underruns_ + s3_late_, max_underruns);
    const bool there = s2_.row < arrived_row_ || (s2_.row == arrived_row_ && s2_.block < arrived_);
    s3_late_ = s2_.valid && !there;
    s2_ = s1_;
    s1_ = under_beam();

    // Requests. A row is opened a cycle after the beam has left it.
    urgent_ = req_valid_ && !in.req_ready && to_request_ >= to_fall_;
    opens_ = row_ends() && opened_ < shown_.blocks_down();
    const std::uint32_t pace_limit = ScreenTiming::total_width * (4U << shown_.doubled),
                        pace_sum = pace_ + shown_.blocks_across();
    const bool falls = tick && to_fall_ != 0 && pace_sum >= pace_limit;
    if (taking)
        pace_ = 0;
    else if (tick && to_fall_ != 0)
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

std::uint32_t ScanOut::ticks_to_event() const {
    constexpr std::uint32_t width = ScreenTiming::total_width, height = ScreenTiming::total_height,
                            blank = height - ScreenTiming::shown_height;
    // The beam's place, in ticks and lines since the start of the vertical blank.
    const std::uint32_t line = (v_ + blank) % height, place = line * width + h_;
    const auto to = [&](std::uint32_t other) { return (width * height + other - place) % (width * height); };
    const std::uint32_t to_beam = std::min(to(0), to(width * height - near));
    if (!shown_.is_shown() || opened_ >= shown_.blocks_down()) return to_beam;
    const std::uint32_t lines = 4U << shown_.doubled, shown_height = shown_.height << shown_.doubled,
                        top = blank + (ScreenTiming::shown_height - shown_height) / 2;
    // The line at whose end a row of blocks ends: this line, or a later one.
    const std::uint32_t from = line + (h_ > ScreenTiming::shown_width);
    const std::uint32_t rows = from < top ? 0 : (from - top) / lines;
    const std::uint32_t end = (top + rows * lines + lines - 1) * width + ScreenTiming::shown_width;
    return std::min(to_beam, end - place);
}

std::uint64_t ScanOut::quiet() const {
    if (req_valid_ || pending_ != 0 || to_request_ != 0 || taken_ || start_ || opens_ || s3_late_) return 0;
    // The event comes with the tick after so many others.
    const std::int64_t phase = std::int64_t(ticks_to_event() + 1) * shape_.chip_khz - phase_;
    return (std::uint64_t(phase) + shape_.pixel_khz - 1) / shape_.pixel_khz - 1;
}

void ScanOut::skip(std::uint64_t cycles) {
    phase_ += std::int64_t(cycles * shape_.pixel_khz);
    const std::uint64_t ticks = phase_ < 0 ? 0 : std::uint64_t(phase_) / shape_.chip_khz;
    phase_ -= std::int64_t(ticks * shape_.chip_khz);
    const std::uint64_t pace_limit = ScreenTiming::total_width * (4U << shown_.doubled),
                        pace = pace_ + ticks * shown_.blocks_across();
    if (to_fall_ != 0) {
        const std::uint64_t falls = std::min<std::uint64_t>(pace / pace_limit, to_fall_);
        // After the last block has fallen due the pace stands still.
        pace_ = std::uint32_t(falls == to_fall_ ? 0 : pace - falls * pace_limit);
        to_fall_ -= std::uint32_t(falls);
    }
    // All opened blocks have arrived, so no pixel on its way is late.
    if (cycles > 0) s1_ = s2_ = {};
    const std::uint64_t place = (v_ * ScreenTiming::total_width + h_ + ticks) %
                                (ScreenTiming::total_width * ScreenTiming::total_height);
    v_ = std::uint32_t(place / ScreenTiming::total_width);
    h_ = std::uint32_t(place % ScreenTiming::total_width);
}

}   // namespace rayclock
