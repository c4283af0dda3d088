// What knows OpenImageIO: a library of its own, see codec.hpp. It throws nothing that only the program knows.
#include "sim/image/codec.hpp"

#include <cstring>
#include <stdexcept>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

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

/// The bytes of a file. Into memory, because the library does not see an error of the last bytes, nor of
/// closing the file.
std::string encode(const char* plugin, const Picture& picture, const HitFrame& hits) {
    const Encoded encoded =
        std::string(plugin) == "png" ? encode_png(picture, hits) : encode_exr(picture, hits);
    const auto output = OIIO::ImageOutput::create(plugin);
    if (!output) throw std::runtime_error(OIIO::geterror());
    OIIO::Filesystem::IOVecOutput memory;
    output->set_ioproxy(&memory);
    // TypeUnknown: the data is in the types of the file already, so nothing is rounded twice.
    const bool encoded_all = output->open(std::string("picture.") + plugin, encoded.spec) &&
                             output->write_image(OIIO::TypeUnknown, encoded.data.data()) && output->close();
    if (!encoded_all) throw std::runtime_error(output->geterror());
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
