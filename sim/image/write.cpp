// write_picture(): the picture formats. A format is one row of the table `formats`.
#include "sim/image/image.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "model/base/error.hpp"
#include "sim/image/srgb.hpp"

namespace rayclock {
namespace {

/// Pixels in the file's own types, packed channel by channel, and the header that says so.
struct Encoded {
    OIIO::ImageSpec spec;
    std::vector<std::byte> data;
};

Encoded encode_png(const Picture& picture, const HitFrame&) {
    Encoded out{OIIO::ImageSpec(picture.size.width, picture.size.height, 3, OIIO::TypeUInt8), {}};
    out.spec.attribute("oiio:ColorSpace", "sRGB");
    out.data.resize(picture.pixels.size() * 3);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        std::memcpy(&out.data[3 * i], srgb_bytes(picture.pixels[i]).data(), 3);
    return out;
}

Encoded encode_exr(const Picture& picture, const HitFrame& hits) {
    Encoded out{OIIO::ImageSpec(picture.size.width, picture.size.height, 5, OIIO::TypeHalf), {}};
    out.spec.channelnames = {"R", "G", "B", "Z", "id"};
    out.spec.channelformats = {OIIO::TypeHalf, OIIO::TypeHalf, OIIO::TypeHalf, OIIO::TypeFloat,
                               OIIO::TypeUInt32};
    out.spec.z_channel = 3;
    out.spec.attribute("oiio:ColorSpace", "Linear");
    out.spec.attribute("compression", "zip");
    const std::size_t stride = out.spec.pixel_bytes(true);
    constexpr std::size_t z_at = 6, id_at = 10;
    out.data.resize(picture.pixels.size() * stride);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        std::byte* pixel = &out.data[i * stride];
        OIIO::convert_pixel_values(OIIO::TypeFloat, &picture.pixels[i], OIIO::TypeHalf, pixel, 3);
        std::memcpy(pixel + z_at, &hits.hits[i].depth, sizeof(float));
        std::memcpy(pixel + id_at, &hits.hits[i].primitive, sizeof(std::uint32_t));
    }
    return out;
}

struct Format {
    const char* ending;
    const char* plugin;
    Encoded (*encode)(const Picture&, const HitFrame&);
};
constexpr Format formats[] = {{".png", "png", encode_png}, {".exr", "openexr", encode_exr}};

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

/// The library's message as the end of a sentence.
std::string reason(std::string message) {
    std::replace(message.begin(), message.end(), '\n', ' ');
    while (!message.empty() && (message.back() == ' ' || message.back() == '.')) message.pop_back();
    return message.empty() ? "unknown reason" : message;
}

/// The bytes of a file; `path` is for messages. Into memory, because the library does not see an error of the
/// last bytes, nor of closing the file.
std::vector<unsigned char> file_bytes(const std::string& path, const Format& format, const Picture& picture,
                                      const HitFrame& hits) {
    const Encoded encoded = format.encode(picture, hits);
    const auto output = OIIO::ImageOutput::create(format.plugin);
    if (!output) throw UserError(fmt::format("{}: cannot be written: {}", path, reason(OIIO::geterror())));
    OIIO::Filesystem::IOVecOutput memory;
    output->set_ioproxy(&memory);
    // TypeUnknown: the data is in the types of the file already, so nothing is rounded twice.
    const bool encoded_all = output->open(path, encoded.spec) &&
                             output->write_image(OIIO::TypeUnknown, encoded.data.data()) && output->close();
    if (!encoded_all)
        throw UserError(fmt::format("{}: cannot be written: {}", path, reason(output->geterror())));
    return memory.buffer();
}

}   // namespace

std::string png_bytes(const Picture& picture) {
    const auto bytes = file_bytes("picture.png", formats[0], picture, {});
    return {bytes.begin(), bytes.end()};
}

void check_picture_path(const std::string& path) {
    format_of(path);
    check_replaceable(path);
}

void write_picture(const std::string& path, const Picture& picture, const HitFrame& hits) {
    const Format& format = format_of(path);
    check_frame_size(picture.size);
    const auto pixels = static_cast<std::size_t>(picture.size.width) * picture.size.height;
    if (picture.pixels.size() != pixels || hits.size != picture.size || hits.hits.size() != pixels)
        throw UserError(fmt::format("{}: picture and hits differ in size", path));
    check_replaceable(path);
    const auto bytes = file_bytes(path, format, picture, hits);
    write_bytes(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}   // namespace rayclock
