#pragma once
// The parts of the board's video under Verilator, their memory, and model and RTL side by side.
#include <array>
#include <cstring>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "model/board/pixel_writer.hpp"
#include "model/board/scan_out.hpp"
#include "sim/board/screen.hpp"
#include "sim/run/rtl/rtl_module.hpp"
#include "sim/run/rtl/signal.hpp"
#include "tests/support/cases/draw.hpp"
#include <catch2/catch.hpp>

namespace rayclock::test {

/// The configuration of rc_pkg, on which parts of the board do not depend.
inline Config video_config() { return Config{}; }

/// Lines of 64 bytes, as 32 beats of 16 bits.
using PixelLine = std::array<std::uint16_t, 32>;
using LineMemory = std::vector<PixelLine>;

inline std::uint32_t line_of(const ShownPicture& picture, std::uint32_t x, std::uint32_t y) {
    return picture.base + y / 4 * picture.blocks_across() + x / 4;
}
inline ScreenPicture::Pixel pixel_in(const LineMemory& memory, const ShownPicture& picture, std::uint32_t x,
                                     std::uint32_t y) {
    const PixelLine& line = memory.at(line_of(picture, x, y));
    const std::size_t beat = 2 * (4 * (y % 4) + x % 4);
    return {std::uint8_t(line[beat]), std::uint8_t(line[beat] >> 8), std::uint8_t(line[beat + 1])};
}

/// The screen that should be seen: the picture in the middle, black around it.
inline ScreenPicture expected_screen(const LineMemory& memory, const ShownPicture& picture) {
    ScreenPicture screen{640, 480, std::vector<ScreenPicture::Pixel>(640 * 480)};
    if (!picture.is_shown()) return screen;
    const std::uint32_t scale = picture.doubled ? 2 : 1, left = (640 - scale * picture.width) / 2,
                        top = (480 - scale * picture.height) / 2;
    for (std::uint32_t y = 0; y < scale * picture.height; ++y)
        for (std::uint32_t x = 0; x < scale * picture.width; ++x)
            screen.pixels[(top + y) * 640 + left + x] = pixel_in(memory, picture, x / scale, y / scale);
    return screen;
}

/// The memory as scan-out sees it. It answers in order, with the beats of a line in a row.
class ReadPort {
public:
    struct Speed {
        std::uint32_t line_cycles = 40;   ///< least time between two requests, at least 32
        std::uint32_t latency = 20;       ///< from the request to the first beat
        bool only_if_urgent = false;
        /// Percentage of cycles in which a request is refused; then the latency is random as well.
        int refuses = 0;
    };
    ReadPort(const LineMemory& memory, const Speed& speed, unsigned seed = 1)
        : memory_(memory), speed_(speed), draw_(seed) {}

    /// Begins a cycle: decides `ready` and the beat.
    void begin(bool urgent) {
        ready = now_ >= next_request_ && (urgent || !speed_.only_if_urgent) &&
                (speed_.refuses == 0 || !draw_.percent(speed_.refuses));
        beat.reset();
        if (lines_.empty() || now_ < lines_.front().second) return;
        beat = memory_.at(lines_.front().first)[beats_];
    }
    /// Ends a cycle in which `address` was requested, if so.
    void end(std::optional<std::uint32_t> address) {
        if (beat && ++beats_ == 32) {
            beats_ = 0;
            lines_.pop_front();
        }
        if (address && ready) {
            const std::uint32_t more = speed_.refuses ? std::uint32_t(draw_.below(100)) : 0;
            lines_.emplace_back(*address, now_ + speed_.latency + more);
            next_request_ = now_ + speed_.line_cycles;
            ++requests;
        }
        ++now_;
    }
    void change(const Speed& speed) { speed_ = speed; }

    bool ready = false;
    std::optional<std::uint16_t> beat;
    std::uint64_t requests = 0;

private:
    const LineMemory& memory_;
    Speed speed_;
    Draw draw_;
    std::uint64_t now_ = 0, next_request_ = 0;
    std::deque<std::pair<std::uint32_t, std::uint64_t>> lines_;   ///< and the cycle of the first beat
    std::size_t beats_ = 0;
};

/// A pixel as scan-out sends it.
struct SentPixel {
    bool valid = false, de = false, hsync = false, vsync = false;
    std::uint32_t colour = 0;   ///< red in the lowest byte
};

/// rc_scan_out with its model. check() compares all that both decide.
class ScanOutPair {
public:
    explicit ScanOutPair(std::uint32_t chip_khz = 75000, unsigned seed = 1)
        : model(ScanOut::Shape{.chip_khz = chip_khz}),
          rtl_(video_config(), "rc_scan_out ChipKhz=" + std::to_string(chip_khz), int(seed)) {
        req_ready_ = 0, rd_valid_ = 0, rd_data_ = 0, base_ = 0, width_ = 0, height_ = 0, double_ = 0;
        rtl_.reset();
    }
    /// Simulates one cycle with the memory, and returns what the screen gets.
    SentPixel clock(const ShownPicture& picture, ReadPort& memory) {
        memory.begin(model.is_urgent());
        base_ = picture.base, width_ = picture.width, height_ = picture.height, double_ = picture.doubled;
        req_ready_ = memory.ready;
        rd_valid_ = memory.beat.has_value();
        rd_data_ = memory.beat.value_or(std::uint16_t(0xdead));
        rtl_.settle();
        check();
        const SentPixel sent{bool(pixel_valid_), bool(pixel_de_), bool(pixel_hsync_), bool(pixel_vsync_),
                             std::uint32_t(pixel_colour_)};
        model_clock(model, picture, memory);
        rtl_.clock();
        ++cycle_;
        return sent;
    }
    /// Simulates one cycle of a model alone; memory.begin() has been called.
    static void model_clock(ScanOut& model, const ShownPicture& picture, ReadPort& memory) {
        const bool requests = model.requests();
        const std::uint32_t address = model.address();
        model.clock({picture, memory.ready, memory.beat.has_value()});
        memory.end(requests ? std::optional(address) : std::nullopt);
    }

    ScanOut model;

private:
    void check() const {
        const bool same = bool(req_valid_) == model.requests() && bool(urgent_) == model.is_urgent() &&
                          bool(takes_) == model.takes() && bool(nears_) == model.nears() &&
                          underruns_ == model.underruns() &&
                          (!model.requests() || req_addr_ == model.address());
        if (same) return;
        FAIL("cycle " << cycle_ << ": the RTL has request " << req_valid_ << " of line " << req_addr_
                      << ", urgent " << urgent_ << ", takes " << takes_ << ", underruns " << underruns_
                      << "; the model " << model.requests() << ", " << model.address() << ", "
                      << model.is_urgent() << ", " << model.takes() << ", " << model.underruns());
    }

    RtlModule rtl_;
    std::uint64_t cycle_ = 0;
    Signal req_ready_{rtl_, "req_ready"}, rd_valid_{rtl_, "rd_valid"}, rd_data_{rtl_, "rd_data"},
        base_{rtl_, "base"}, width_{rtl_, "width"}, height_{rtl_, "height"}, double_{rtl_, "double"};
    Signal takes_{rtl_, "takes"}, nears_{rtl_, "nears"}, underruns_{rtl_, "underruns"},
        req_valid_{rtl_, "req_valid"}, req_addr_{rtl_, "req_addr"}, urgent_{rtl_, "urgent"},
        pixel_valid_{rtl_, "pixel_valid"}, pixel_colour_{rtl_, "pixel_colour"}, pixel_de_{rtl_, "pixel_de"},
        pixel_hsync_{rtl_, "pixel_hsync"}, pixel_vsync_{rtl_, "pixel_vsync"};
};

/// rc_video with its three clocks. Pixels come at the chip's clock; the receiver gets the pairs of the shift
/// clock, 125 MHz.
class Video {
public:
    Video(std::uint32_t chip_khz, TmdsReceiver& receiver)
        : chip_khz_(chip_khz), receiver_(receiver), rtl_(video_config(), "rc_video") {
        pixel_valid_ = 0, pixel_rst_ = 0, shift_rst_ = 0, shift_clk_ = 0, pixel_clk_ = 0;
        for (int i = 0; i < 10; ++i) edges(true, true);
        rtl_.reset();
        pixel_rst_ = 1, shift_rst_ = 1;
        rtl_.settle();
    }
    /// Simulates until and with the next edge of the chip's clock.
    void clock(const SentPixel& pixel) {
        pixel_valid_ = pixel.valid, pixel_colour_ = pixel.colour, pixel_de_ = pixel.de;
        pixel_hsync_ = pixel.hsync, pixel_vsync_ = pixel.vsync;
        // Times are in units in which the chip's period is 125000 and the shift clock's is chip_khz_.
        const std::uint64_t chip_edge = chip_time_ += 125000;
        while (shift_time_ + chip_khz_ < chip_edge) shift_edge(false);
        if (shift_time_ + chip_khz_ == chip_edge)
            shift_edge(true);
        else
            edges(false, false);
    }
    bool overflow() { return overflow_; }
    bool underflow() { return underflow_; }

private:
    void shift_edge(bool with_chip) {
        shift_time_ += chip_khz_;
        rtl_.settle();
        receiver_.pairs(std::uint32_t(tmds_));
        shift_clk_ = 1;
        pixel_clk_ = ++shift_edges_ % 5 == 0;
        if (with_chip)
            rtl_.clock();
        else
            rtl_.settle();
        shift_clk_ = 0, pixel_clk_ = 0;
        rtl_.settle();
    }
    void edges(bool shift, bool pixel) {
        rtl_.settle();
        shift_clk_ = shift, pixel_clk_ = pixel;
        rtl_.clock();
        shift_clk_ = 0, pixel_clk_ = 0;
        rtl_.settle();
    }

    std::uint32_t chip_khz_;
    std::uint64_t chip_time_ = 0, shift_time_ = 0, shift_edges_ = 0;
    TmdsReceiver& receiver_;
    RtlModule rtl_;
    Signal pixel_valid_{rtl_, "pixel_valid"}, pixel_colour_{rtl_, "pixel_colour"},
        pixel_de_{rtl_, "pixel_de"}, pixel_hsync_{rtl_, "pixel_hsync"}, pixel_vsync_{rtl_, "pixel_vsync"},
        pixel_rst_{rtl_, "pixel_rst"}, shift_rst_{rtl_, "shift_rst"}, pixel_clk_{rtl_, "pixel_clk"},
        shift_clk_{rtl_, "shift_clk"};
    Signal overflow_{rtl_, "overflow"}, underflow_{rtl_, "underflow"}, tmds_{rtl_, "tmds"};
};

/// rc_pixel_writer with its model, on a memory that accepts writes at random times.
class PixelWriterPair {
public:
    struct Pixel {
        std::uint32_t x = 0, y = 0, colour = 0;   ///< red in the lowest byte
    };

    PixelWriterPair(LineMemory& memory, unsigned seed)
        : memory_(memory), draw_(seed), rtl_(video_config(), "rc_pixel_writer", int(seed)) {
        pixel_valid_ = 0, req_ready_ = 0, next_ = 0, flush_ = 0;
        rtl_.reset();
    }
    /// Simulates one cycle with an offered pixel. Returns true if it was accepted. `accepts` is the
    /// percentage of cycles in which the memory takes a request or a beat.
    bool clock(const std::optional<Pixel>& pixel, const ShownPicture& picture, bool flush, int accepts) {
        const bool ready = !beats_left_ && draw_.percent(accepts),
                   next = beats_left_ && draw_.percent(accepts);
        pixel_valid_ = pixel.has_value();
        if (pixel) pixel_x_ = pixel->x, pixel_y_ = pixel->y, pixel_colour_ = pixel->colour;
        base_ = picture.base, width_ = picture.width, flush_ = flush, req_ready_ = ready, next_ = next;
        rtl_.settle();
        check();
        const bool accepted = pixel && pixel_ready_;
        if (next) take_beat();
        if (ready && req_valid_) {
            beats_left_ = 32;
            line_ = std::uint32_t(req_addr_);
            written.push_back(line_);
        }
        const bool sleeps = !pixel && !next && !(ready && model.requests()) && model.sleeps(flush);
        const auto outputs = [&] {
            return std::tuple(model.ready(), model.empty(), model.requests(), model.address(), model.words(),
                              model.sleeps(flush));
        };
        const auto before = outputs();
        model.clock({picture.base, picture.width, flush,
                     pixel ? std::optional(PixelWriter::PixelPlace{pixel->x, pixel->y}) : std::nullopt, ready,
                     next});
        if (sleeps && outputs() != before) FAIL("cycle " << cycle_ << ": the writer changed in its sleep");
        rtl_.clock();
        ++cycle_;
        return accepted;
    }

    PixelWriter model;
    std::vector<std::uint32_t> written;   ///< lines, in the order of their requests

private:
    void check() const {
        const bool same = bool(pixel_ready_) == model.ready() && bool(empty_) == model.empty() &&
                          bool(req_valid_) == model.requests() &&
                          (!model.requests() || req_addr_ == model.address());
        if (same) return;
        FAIL("cycle " << cycle_ << ": the RTL has ready " << pixel_ready_ << ", empty " << empty_
                      << ", request " << req_valid_ << " of line " << req_addr_ << "; the model "
                      << model.ready() << ", " << model.empty() << ", " << model.requests() << ", "
                      << model.address());
    }
    void take_beat() {
        const std::uint32_t beat = 32 - beats_left_--;
        const bool there = model.words() >> (beat / 2) & 1;
        if (mask_ != (there ? 0U : 3U))
            FAIL("cycle " << cycle_ << ": beat " << beat << " has mask " << mask_);
        if (there) memory_.at(line_)[beat] = std::uint16_t(data_);
    }

    LineMemory& memory_;
    Draw draw_;
    RtlModule rtl_;
    std::uint64_t cycle_ = 0;
    std::uint32_t beats_left_ = 0, line_ = 0;
    Signal base_{rtl_, "base"}, width_{rtl_, "width"}, flush_{rtl_, "flush"},
        pixel_valid_{rtl_, "pixel_valid"}, pixel_x_{rtl_, "pixel_x"}, pixel_y_{rtl_, "pixel_y"},
        pixel_colour_{rtl_, "pixel_colour"}, req_ready_{rtl_, "req_ready"}, next_{rtl_, "next"};
    Signal empty_{rtl_, "empty"}, pixel_ready_{rtl_, "pixel_ready"}, req_valid_{rtl_, "req_valid"},
        req_addr_{rtl_, "req_addr"}, data_{rtl_, "data"}, mask_{rtl_, "mask"};
};

}   // namespace rayclock::test
