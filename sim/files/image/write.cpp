// write_picture(): the picture formats. A format is one row of the table `formats`.
#include "sim/files/image/image.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/interrupted.hpp"
#include "sim/files/image/codec.hpp"

namespace rayclock {
namespace {

struct Format {
    const char* ending;
    const char* plugin;
};
constexpr Format formats[] = {{".png", "png"}, {".exr", "openexr"}};

const Format& format_of(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    std::string known;
    for (const Format& format : formats) {
        if (ending == format.ending) return format;
        known += (known.empty() ? "" : ", ") + std::string(format.ending);
    }
    throw UserError(fmt::format("{}: unknown picture ending '{}'; known ones are {}", path, ending, known));
}

/// Returns the library's message in a form that ends a sentence: one line, without a final full stop.
std::string reason(std::string message) {
    std::replace(message.begin(), message.end(), '\n', ' ');
    while (!message.empty() && (message.back() == ' ' || message.back() == '.')) message.pop_back();
    return message.empty() ? "unknown reason" : message;
}

/// Returns the bytes of a file after reading them back and comparing. `path` is for messages. Throws
/// UserError if the library fails.
std::string file_bytes(const std::string& path, const Format& format, const Picture& picture,
                       const HitFrame& hits, const std::function<bool()>& stop) {
    const PictureCodec& codec = picture_codec();
    try {
        std::string bytes = codec.encode(format.plugin, picture, hits, stop);
        if (!stop()) codec.check(format.plugin, bytes, picture, hits, stop);
        return bytes;
    } catch (const std::runtime_error& error) {
        throw UserError(fmt::format("{}: cannot be written: {}", path, reason(error.what())));
    }
}

}   // namespace

std::string png_bytes(const Picture& picture) {
    return file_bytes("picture.png", formats[0], picture, {}, [] { return false; });
}

void check_picture_path(const std::string& path) {
    format_of(path);
    check_replaceable(path);
}

void write_picture(const std::string& path, const Picture& picture, const HitFrame& hits,
                   const std::function<bool()>& stop) {
    const Format& format = format_of(path);
    check_frame_size(picture.size);
    const auto pixels = static_cast<std::size_t>(picture.size.width) * picture.size.height;
    if (picture.pixels.size() != pixels || hits.size != picture.size || hits.hits.size() != pixels)
        throw UserError(fmt::format("{}: picture and hits differ in size", path));
    check_replaceable(path);
    const std::string bytes = file_bytes(path, format, picture, hits, stop);
    if (stop()) throw Interrupted("interrupted: nothing is written");
    write_bytes(path, bytes);
}

}   // namespace rayclock
