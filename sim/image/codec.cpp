// What knows OpenImageIO: a library of its own, see codec.hpp. It throws nothing that only the program knows.
#include "sim/image/codec.hpp"

#include <algorithm>
#include <cstring>
#include <functional>
#include <stdexcept>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "sim/image/srgb.hpp"

namespace rayclock {
namespace {

/// A format: the file's header, and how one pixel lies in its own types, packed channel by channel.
struct Encoding {
    OIIO::ImageSpec spec;
    std::function<void(std::size_t pixel, std::byte* to)> put;
};

Encoding png(const Picture& picture) {
    OIIO::ImageSpec spec(picture.size.width, picture.size.height, 3, OIIO::TypeUInt8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    return {spec,
            [&](std::size_t i, std::byte* to) { std::memcpy(to, srgb_bytes(picture.pixels[i]).data(), 3); }};
}

Encoding exr(const Picture& picture, const HitFrame& hits) {
    OIIO::ImageSpec spec(picture.size.width, picture.size.height, 5, OIIO::TypeHalf);
    spec.channelnames = {"R", "G", "B", "Z", "id"};
    spec.channelformats = {OIIO::TypeHalf, OIIO::TypeHalf, OIIO::TypeHalf, OIIO::TypeFloat, OIIO::TypeUInt32};
    spec.z_channel = 3;
    spec.attribute("oiio:ColorSpace", "Linear");
    spec.attribute("compression", "zip");
    constexpr std::size_t z_at = 6, id_at = 10;
    return {spec, [&](std::size_t i, std::byte* to) {
                OIIO::convert_pixel_values(OIIO::TypeFloat, &picture.pixels[i], OIIO::TypeHalf, to, 3);
                std::memcpy(to + z_at, &hits.hits[i].depth, sizeof(float));
                std::memcpy(to + id_at, &hits.hits[i].primitive, sizeof(std::uint32_t));
            }};
}

/// The bytes of a file. Into memory, because the library does not see an error of the last bytes, nor of
/// closing the file.
std::string encode(const char* plugin, const Picture& picture, const HitFrame& hits,
                   const std::function<bool()>& stop) {
    const Encoding encoding = std::string(plugin) == "png" ? png(picture) : exr(picture, hits);
    const auto output = OIIO::ImageOutput::create(plugin);
    if (!output) throw std::runtime_error(OIIO::geterror());
    OIIO::Filesystem::IOVecOutput memory;
    output->set_ioproxy(&memory);
    bool good = output->open(std::string("picture.") + plugin, encoding.spec);
    constexpr int rows = 64;
    const std::size_t pixel_bytes = encoding.spec.pixel_bytes(true), width = std::size_t(picture.size.width);
    std::vector<std::byte> data(pixel_bytes * width * rows);
    for (int y = 0; good && y < picture.size.height && (y == 0 || !stop()); y += rows) {
        const int end = std::min(y + rows, picture.size.height);
        for (std::size_t i = 0; i < std::size_t(end - y) * width; ++i)
            encoding.put(std::size_t(y) * width + i, &data[i * pixel_bytes]);
        // TypeUnknown: the data is in the types of the file already, so nothing is rounded twice.
        good = output->write_scanlines(y, end, 0, OIIO::TypeUnknown, data.data());
    }
    if (!good || (!stop() && !output->close())) throw std::runtime_error(output->geterror());
    const auto& bytes = memory.buffer();
    return {bytes.begin(), bytes.end()};
}

bool is_floating(OIIO::TypeDesc type) {
    return type.basetype == OIIO::TypeDesc::HALF || type.basetype == OIIO::TypeDesc::FLOAT ||
           type.basetype == OIIO::TypeDesc::DOUBLE;
}

/// Integer formats hold sRGB, floating ones linear light: true of what write_picture() writes and of common
/// use. One or two channels are grey (and alpha); channels beyond the third are not read.
Picture decode(const std::string& path) {
    const auto input = OIIO::ImageInput::open(path);
    if (!input) throw std::runtime_error(OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.width > max_frame_side ||
        spec.height > max_frame_side)
        throw std::runtime_error(std::to_string(spec.width) + "x" + std::to_string(spec.height) +
                                 " pixels; at most " + std::to_string(max_frame_side) +
                                 " a side can be read");
    const int channels = spec.nchannels >= 3 ? 3 : 1;
    const bool linear = is_floating(spec.format);
    Picture picture{{spec.width, spec.height}, {}};
    picture.pixels.resize(static_cast<std::size_t>(spec.width) * spec.height);
    std::vector<float> values(picture.pixels.size() * channels);
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeFloat, values.data()))
        throw std::runtime_error(input->geterror());
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const float value = values[i * channels + (channels == 3 ? c : 0)];
            picture.pixels[i][c] = linear ? value : static_cast<float>(linear_from_srgb(value));
        }
    return picture;
}

/// Row by row, so that a large picture takes little memory; sums in the order of the rows.
glm::vec4 average(const std::string& bytes) {
    const bool is_png = bytes.starts_with("\x89PNG"), is_jpeg = bytes.starts_with("\xff\xd8");
    if (!is_png && !is_jpeg) throw std::runtime_error("it is neither PNG nor JPEG");
    OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes.data()), bytes.size());
    const auto input = OIIO::ImageInput::create(is_png ? "png" : "jpeg");
    if (!input || !input->set_ioproxy(&memory)) throw std::runtime_error(OIIO::geterror());
    OIIO::ImageSpec spec, wish;
    wish.attribute("oiio:UnassociatedAlpha", 1);
    if (!input->open(is_png ? "texture.png" : "texture.jpg", spec, wish))
        throw std::runtime_error(input->geterror());
    constexpr std::int64_t most_texels = std::int64_t{1} << 26;
    if (std::int64_t{spec.width} * spec.height > most_texels)
        throw std::runtime_error(std::to_string(spec.width) + "x" + std::to_string(spec.height) +
                                 " texels are too many");
    const int channels = spec.nchannels;
    std::vector<float> row(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(channels));
    double sum[4] = {};
    for (int y = 0; y < spec.height; ++y) {
        if (!input->read_scanline(y, 0, OIIO::TypeFloat, row.data()))
            throw std::runtime_error(input->geterror());
        for (int x = 0; x < spec.width; ++x) {
            const float* texel = &row[static_cast<std::size_t>(x * channels)];
            for (int c = 0; c < 3; ++c) sum[c] += linear_from_srgb(texel[channels >= 3 ? c : 0]);
            sum[3] += channels == 4 ? texel[3] : channels == 2 ? texel[1] : 1;
        }
    }
    const double texels = double(spec.width) * spec.height;
    return {float(sum[0] / texels), float(sum[1] / texels), float(sum[2] / texels), float(sum[3] / texels)};
}

}   // namespace
}   // namespace rayclock

extern "C" const rayclock::PictureCodec rayclock_picture_codec{rayclock::encode, rayclock::decode,
                                                               rayclock::average};
