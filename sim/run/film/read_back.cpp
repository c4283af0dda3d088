// Reading the chunks of an animated PNG, and composing its frames.
#include "sim/run/film/read_back.hpp"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <zlib.h>

#include "sim/files/image/codec.hpp"

namespace rayclock {
namespace {

constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";

std::uint32_t number(std::string_view bytes, std::size_t at, std::size_t width = 4) {
    if (bytes.size() < at + width) throw std::runtime_error("it ends too early");
    std::uint32_t n = 0;
    for (std::size_t i = 0; i < width; ++i) n = n << 8 | std::uint8_t(bytes[at + i]);
    return n;
}

std::string four_bytes(std::size_t n) {
    return {char(n >> 24 & 255), char(n >> 16 & 255), char(n >> 8 & 255), char(n & 255)};
}

std::string chunk(const std::string& kind, std::string_view data) {
    const std::string sum_of = kind + std::string(data);
    const auto crc = crc32(0, reinterpret_cast<const Bytef*>(sum_of.data()), uInt(sum_of.size()));
    return four_bytes(data.size()) + sum_of + four_bytes(crc);
}

/// A part of the picture that is redrawn, and its disposal before the next step.
struct Step {
    std::size_t width, height, x, y;
    std::uint32_t delay, parts_of_second;
    enum : std::uint32_t { keep, clear, restore } after;
    bool is_blended;
    std::string data;   ///< in the format of a PNG's IDAT
};

struct Steps {
    /// IHDR's data, and the chunks that hold for all steps: palette and transparent colour.
    std::string header, shared;
    std::vector<Step> steps;
};

Step step_of(std::string_view d) {
    return {number(d, 4),
            number(d, 8),
            number(d, 12),
            number(d, 16),
            number(d, 20, 2),
            number(d, 22, 2),
            decltype(Step::after)(number(d, 24, 1)),
            number(d, 25, 1) == 1,
            {}};
}

/// Reads the steps. A picture without steps has one step of `whole` thousandths.
Steps steps_of(std::string_view film, long whole) {
    if (!film.starts_with(signature)) throw std::runtime_error("it is not a PNG");
    Steps all;
    for (std::size_t at = signature.size(); at < film.size();) {
        const std::size_t length = number(film, at);
        const std::string kind(film.substr(at + 4, 4));
        number(film, at + 8 + length);   // throws unless the whole chunk exists
        const std::string_view data = film.substr(at + 8, length);
        if (kind == "IHDR") all.header = data;
        if (kind == "tRNS" || kind == "PLTE") all.shared += chunk(kind, data);
        if (kind == "fcTL") all.steps.push_back(step_of(data));
        if (kind == "IDAT" && all.steps.empty())
            all.steps.push_back({number(all.header, 0),
                                 number(all.header, 4),
                                 0,
                                 0,
                                 std::uint32_t(whole),
                                 1000,
                                 Step::keep,
                                 false,
                                 {}});
        if (kind == "IDAT") all.steps.back().data += data;
        if (kind == "fdAT" && length > 4 && !all.steps.empty()) all.steps.back().data += data.substr(4);
        at += length + 12;
    }
    return all;
}

/// Decodes a part. Replaces the library's messages, which are not meant for users.
Texels texels_of(const std::string& png) {
    try {
        return picture_codec().texels(png);
    } catch (const std::runtime_error&) {
        throw std::runtime_error("a part of it cannot be decoded");
    }
}

Texels texels_of(const Steps& all, const Step& step) {
    const std::string rest = all.header.substr(std::min<std::size_t>(8, all.header.size()));
    return texels_of(std::string(signature) +
                     chunk("IHDR", four_bytes(step.width) + four_bytes(step.height) + rest) + all.shared +
                     chunk("IDAT", step.data) + chunk("IEND", {}));
}

/// Draws a step into the picture.
void draw(const Texels& part, const Step& step, Texels& picture) {
    for (std::size_t y = 0; y < step.height; ++y)
        for (std::size_t x = 0; x < step.width; ++x) {
            const auto& texel = part.rgba[y * step.width + x];
            auto& to = picture.rgba[(step.y + y) * std::size_t(picture.size.width) + step.x + x];
            if (!step.is_blended || texel[3] == 255) to = texel;
        }
}

void after(const Step& step, const Texels& before, Texels& picture) {
    if (step.after == Step::restore) picture = before;
    if (step.after == Step::clear) {
        Texels nothing{{int(step.width), int(step.height)}, {}};
        nothing.rgba.resize(step.width * step.height);
        Step whole = step;
        whole.is_blended = false;
        draw(nothing, whole, picture);
    }
}

void compare(const std::string& film, std::size_t count, long delay,
             const std::function<std::string(std::size_t)>& frame) {
    const Steps all = steps_of(film, long(count) * delay);
    Texels picture{{int(number(all.header, 0)), int(number(all.header, 4))}, {}};
    picture.rgba.resize(std::size_t(picture.size.width) * std::size_t(picture.size.height));
    std::size_t f = 0;
    for (const Step& step : all.steps) {
        if (step.x + step.width > std::size_t(picture.size.width) ||
            step.y + step.height > std::size_t(picture.size.height))
            throw std::runtime_error("a part of it lies outside");
        const Texels before = picture, part = texels_of(all, step);
        if (part.size != FrameSize{int(step.width), int(step.height)})
            throw std::runtime_error("a part of it has another size");
        draw(part, step, picture);
        // Consecutive equal frames are stored as one frame with a longer delay.
        if (step.parts_of_second != 1000 || step.delay == 0 || step.delay % delay != 0)
            throw std::runtime_error(
                fmt::format("frame {} is shown for {}/{} s", f, step.delay, step.parts_of_second));
        for (const std::size_t end = f + step.delay / std::size_t(delay); f < end; ++f) {
            if (f >= count) throw std::runtime_error("it has too many frames");
            const Texels own = texels_of(frame(f));
            if (own.size != picture.size || own.rgba != picture.rgba)
                throw std::runtime_error(fmt::format("frame {} differs", f));
        }
        after(step, before, picture);
    }
    if (f != count) throw std::runtime_error(fmt::format("it has {} frames instead of {}", f, count));
}

}   // namespace

std::string film_fault(const std::string& film, std::size_t count, long delay,
                       const std::function<std::string(std::size_t)>& frame) {
    try {
        compare(film, count, delay, frame);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

}   // namespace rayclock
