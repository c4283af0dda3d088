// Parses typed values.
#include "sim/app/run/typed_values.hpp"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/split.hpp"

namespace rayclock {

namespace {

template <class Number> bool parse_whole(std::string_view text, Number& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && end == text.data() + text.size() && !text.empty();
}

/// WIDTHxHEIGHT
bool parse_sides(std::string_view text, FrameSize& size) {
    const std::size_t cross = text.find('x');
    return cross != text.npos && parse_whole(text.substr(0, cross), size.width) &&
           parse_whole(text.substr(cross + 1), size.height);
}

}   // namespace

FrameSize parse_size(const std::string& text) {
    FrameSize size;
    if (!parse_sides(text, size))
        throw UserError("--size: " + shown(text) + " is not WIDTHxHEIGHT, for example 512x384");
    check_frame_size(size);
    constexpr int most = 1 << 26;   // fits in a few gigabytes of host memory
    if (size.width > most / size.height)
        throw UserError(fmt::format("--size: {} has more than {} pixels", text, most));
    return size;
}

std::size_t parse_pixel(const std::string& text, FrameSize size, const std::string& option) {
    const std::string head = option.empty() ? "" : option + ": ";
    const std::size_t comma = text.find(',');
    int x = 0, y = 0;
    if (comma == std::string::npos || !parse_whole(std::string_view(text).substr(0, comma), x) ||
        !parse_whole(std::string_view(text).substr(comma + 1), y))
        throw UserError(head + shown(text) + " is not a pixel, COLUMN,ROW, for example 255,190");
    if (x < 0 || x >= size.width || y < 0 || y >= size.height)
        throw UserError(fmt::format("{}pixel {},{} lies outside the picture, whose pixels are 0,0 to {},{}",
                                    head, x, y, size.width - 1, size.height - 1));
    return std::size_t(y) * std::size_t(size.width) + std::size_t(x);
}

namespace {

constexpr const char* not_pixels =
    " is not a part of a picture: give column, row and size, for example 400,300,64x48, or two corners, "
    "400,300..463,347, or one pixel, 400,300";

/// Parses two corners, both inside, or one pixel.
PixelRect parse_corners(const std::string& text, FrameSize whole) {
    const std::size_t dots = text.find("..");
    const std::size_t first = parse_pixel(text.substr(0, dots), whole, "--pixels"),
                      last =
                          dots == text.npos ? first : parse_pixel(text.substr(dots + 2), whole, "--pixels");
    const auto width = std::size_t(whole.width);
    const int x = int(first % width), y = int(first / width);
    const PixelRect rect{x, y, {int(last % width) - x + 1, int(last / width) - y + 1}};
    if (rect.size.width < 1 || rect.size.height < 1)
        throw UserError("--pixels: " + shown(text) +
                        " holds no pixel; the first corner must be the upper left one");
    return rect;
}

}   // namespace

PixelRect parse_pixels(const std::string& text, FrameSize whole) {
    const std::vector<std::string> parts = split(text, ',');
    if (parts.size() == 2 || text.find("..") != text.npos) return parse_corners(text, whole);
    PixelRect rect;
    if (parts.size() != 3 || !parse_whole(parts[0], rect.x) || !parse_whole(parts[1], rect.y) ||
        !parse_sides(parts[2], rect.size))
        throw UserError("--pixels: " + shown(text) + not_pixels);
    const FrameSize part = rect.size;
    const bool is_inside = rect.x >= 0 && rect.y >= 0 && part.width >= 1 && part.height >= 1 &&
                           part.width <= whole.width - rect.x && part.height <= whole.height - rect.y;
    if (!is_inside)
        throw UserError(fmt::format("--pixels: {} does not lie in the picture of {}x{} pixels (--size)",
                                    shown(text), whole.width, whole.height));
    return rect;
}

FrameSize parse_part(const std::string& size, const std::optional<std::string>& pixels, ViewChoice& view) {
    const FrameSize whole = parse_size(size);
    if (!pixels) return whole;
    const PixelRect rect = parse_pixels(*pixels, whole);
    view.window = PictureWindow{rect.x, rect.y, whole.width, whole.height};
    return rect.size;
}

CycleRange parse_cycles(const std::string& text) {
    const std::vector<std::string> ends = split(text, ':');
    CycleRange range;
    if (ends.size() != 2 || !parse_whole(ends[0], range.first) || !parse_whole(ends[1], range.last))
        throw UserError("--cycles: " + shown(text) + " is not FIRST:LAST, for example 2000:3000");
    if (range.first >= range.last) throw UserError("--cycles: " + shown(text) + " holds no cycle");
    return range;
}

std::vector<int> parse_clocks(const std::string& text) {
    std::vector<int> clocks;
    for (const std::string& item : split(text, ',')) {
        double mhz = 0;
        if (!parse_whole(item, mhz) || !(mhz >= 1) || mhz > 100000)
            throw UserError(fmt::format("--clock: {} is not a clock in MHz from 1 to 100000, in {}",
                                        shown(item), shown(text)));
        clocks.push_back(int(std::lround(mhz * 1000)));
    }
    if (clocks.size() > 64)
        throw UserError(fmt::format("--clock: {} clocks are more than 64", clocks.size()));
    return clocks;
}

std::vector<int> parse_values(const std::string& option, const std::string& text) {
    constexpr int most = 10000;
    std::vector<int> parts;
    const char separator = text.find(':') != std::string::npos ? ':' : ',';
    for (const std::string& part : split(text, separator)) {
        parts.emplace_back();
        if (!parse_whole(part, parts.back()))
            throw UserError(
                fmt::format("{}: {} in {} is not a whole number", option, shown(part), shown(text)));
    }
    if (separator == ',') return parts;
    const int step = parts.size() > 2 ? parts[2] : 1;
    if (parts.size() > 3 || step < 1 || parts[1] < parts[0])
        throw UserError(fmt::format("{}: {} is not from:to:step with a step above 0", option, shown(text)));
    std::vector<int> values;
    for (std::int64_t value = parts[0]; value <= parts[1]; value += step) {
        if (values.size() == most)
            throw UserError(fmt::format("{}: {} are more than {} values", option, shown(text), most));
        values.push_back(int(value));
    }
    return values;
}

std::uint64_t parse_rays(const std::string& text) {
    try {
        std::size_t used = 0;
        const double rays = std::stod(text, &used);
        if (used == text.size() && rays >= 1 && rays <= 1e12) return std::uint64_t(rays);
    } catch (const std::exception&) {}
    throw UserError("--rays: " + shown(text) +
                    " is not a number of rays from 1 to 1e12, for example 1000000 or 1e9");
}

namespace {

double percentage(const std::string& option, const std::string& typed) {
    std::string number = typed;
    if (!number.empty() && number.back() == '%')
        number.pop_back();
    else
        number.clear();
    if (!number.empty() && number.back() == ' ') number.pop_back();
    double value = 0;
    std::size_t used = 0;
    try {
        value = std::stod(number, &used);
    } catch (const std::exception&) {
        used = 0;
    }
    const bool is_number =
        used > 0 && used == number.size() && number.find_first_not_of("0123456789.e-") == std::string::npos;
    if (!is_number)
        throw UserError(fmt::format("{}: {} is not a percentage, for example 0.1%", option, shown(typed)));
    return value;
}

}   // namespace

double parse_percent(const std::string& option, const std::string& typed, bool zero) {
    const double value = percentage(option, typed);
    if (!(value > 0 || (zero && value == 0)) || !(value < 100))
        throw UserError(fmt::format("{}: {} must lie {} 100 %", option, shown(typed),
                                    zero ? "from 0 to below" : "above 0 and below"));
    return value;
}

double parse_any_percent(const std::string& option, const std::string& typed) {
    const double value = percentage(option, typed);
    if (!(value >= 0)) throw UserError(fmt::format("{}: {} must not be negative", option, shown(typed)));
    return value;
}

std::pair<std::uint64_t, std::uint64_t> parse_lines(const std::string& text) {
    const std::size_t colon = text.find(':');
    std::uint64_t first = 0, count = 0;
    if (colon == text.npos || !parse_whole(std::string_view(text).substr(0, colon), first) ||
        !parse_whole(std::string_view(text).substr(colon + 1), count))
        throw UserError("--lines: " + shown(text) + " is not FIRST:COUNT, such as 0:16");
    if (count == 0) throw UserError("--lines: " + shown(text) + " has no lines");
    return {first, count};
}

void check_psnr(const std::optional<double>& psnr) {
    if (psnr && !(*psnr > 0 && *psnr <= 200))
        throw UserError(fmt::format("--min-psnr must lie above 0 and not above 200 dB, not {}", *psnr));
}

}   // namespace rayclock
