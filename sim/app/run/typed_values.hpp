#pragma once
// Parses the values of options: sizes, clocks, percentages, parts of pictures and of memory.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/run/request/request.hpp"

namespace rayclock {

/// Parses "512x384". Throws UserError.
FrameSize parse_size(const std::string& text);
/// Parses "255,190", column and row of a pixel, to its index, row by row from the top. Throws UserError.
/// The sentence begins with `option` if it is given.
std::size_t parse_pixel(const std::string& text, FrameSize size, const std::string& option = "");
/// Parses --pixels of a picture, in one of the forms of `pixels_forms`. Throws UserError.
PixelRect parse_pixels(const std::string& text, FrameSize whole);
/// Parses --size, and --pixels, which chooses a part of that picture. Returns the size of the picture to
/// draw, and sets the view's window if it is a part.
FrameSize parse_part(const std::string& size, const std::optional<std::string>& pixels, ViewChoice& view);
/// Cycles of a frame, without `last`.
struct CycleRange {
    std::uint64_t first = 0, last = 0;
};
/// Parses --cycles, FIRST:LAST. Throws UserError unless it holds a cycle.
CycleRange parse_cycles(const std::string& text);
/// Parses "66,90,200" MHz to kHz. Each value is from 1 to 100,000 with at most three decimals. Throws
/// UserError.
std::vector<int> parse_clocks(const std::string& text);
/// Parses whole numbers: "1,2,4" or "12:20:2" (from, to, step). Throws UserError whose sentence begins with
/// `option`.
std::vector<int> parse_values(const std::string& option, const std::string& text);
/// Parses a number of rays such as "1e6", from 1 to 1e12. Throws UserError.
std::uint64_t parse_rays(const std::string& text);
/// Parses "0.1%" or "0.1 %". Throws UserError unless the percentage is above 0 and below 100; `zero` also
/// allows 0.
double parse_percent(const std::string& option, const std::string& typed, bool zero);
/// Parses "320%". Throws UserError unless it is a percentage of at least 0.
double parse_any_percent(const std::string& option, const std::string& typed);
/// Parses "0:16", the number of the first line of memory and the number of lines, for --lines. Throws
/// UserError unless there is at least one.
std::pair<std::uint64_t, std::uint64_t> parse_lines(const std::string& text);
/// Throws UserError unless --min-psnr is above 0 and at most 200.
void check_psnr(const std::optional<double>& psnr);

}   // namespace rayclock
