// The library of picture formats, the only code that includes OpenImageIO (see codec.hpp). It throws only
// standard exceptions, never the program's own types.
#include "sim/files/image/codec.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string_view>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "sim/files/image/average.hpp"
#include "sim/files/image/srgb.hpp"

namespace rayclock {
namespace {

/// A file format: the file's header, and a function that packs one pixel into the format's types, channel by
/// channel.
struct Encoding {
    OIIO::ImageSpec spec;
    std::function<void(std::size_t pixel, std::byte* to)> put;

    std::size_t pixel_bytes() const { return spec.pixel_bytes(true); }
    std::size_t row_bytes() const { return pixel_bytes() * std::size_t(spec.width); }
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

Encoding encoding_of(const char* plugin, const Picture& picture, const HitFrame& hits) {
    return std::string_view(plugin) == "png" ? png(picture) : exr(picture, hits);
}

/// Calls band(first row, row after the last, their pixels in the file's types) for a few rows at a time.
/// Stops early if `band` returns false or `stop` returns true. Returns false if `band` did.
template <class Band>
bool for_each_band(const Encoding& encoding, const std::function<bool()>& stop, Band&& band) {
    constexpr int rows = 64;
    const auto width = std::size_t(encoding.spec.width);
    std::vector<std::byte> data(encoding.row_bytes() * rows);
    for (int y = 0; y < encoding.spec.height && (y == 0 || !stop()); y += rows) {
        const int end = std::min(y + rows, encoding.spec.height);
        for (std::size_t i = 0; i < std::size_t(end - y) * width; ++i)
            encoding.put(std::size_t(y) * width + i, &data[i * encoding.pixel_bytes()]);
        if (!band(y, end, data)) return false;
    }
    return true;
}

// OIIO::TypeUnknown: the data has the file's own types, so nothing is converted. Always pass the strides:
// with TypeUnknown and default strides, OpenImageIO 2.5.18 writes wrong pixels and reports success.

/// Returns the bytes of a file. It writes to memory, because the library misses errors in the last bytes and
/// in closing the file.
std::string encode(const char* plugin, const Picture& picture, const HitFrame& hits,
                   const std::function<bool()>& stop) {
    const Encoding encoding = encoding_of(plugin, picture, hits);
    const auto output = OIIO::ImageOutput::create(plugin);
    if (!output) throw std::runtime_error(OIIO::geterror());
    OIIO::Filesystem::IOVecOutput memory;
    output->set_ioproxy(&memory);
    const bool good = output->open(std::string("picture.") + plugin, encoding.spec) &&
                      for_each_band(encoding, stop, [&](int y, int end, const std::vector<std::byte>& data) {
                          return output->write_scanlines(y, end, 0, OIIO::TypeUnknown, data.data(),
                                                         OIIO::stride_t(encoding.pixel_bytes()),
                                                         OIIO::stride_t(encoding.row_bytes()));
                      });
    if (!good || (!stop() && !output->close())) throw std::runtime_error(output->geterror());
    const auto& bytes = memory.buffer();
    return {bytes.begin(), bytes.end()};
}

[[noreturn]] void encoded_wrongly(const std::string& where) {
    throw std::runtime_error("OpenImageIO " OIIO_VERSION_STRING " encoded it wrongly: read back, " + where);
}

/// Returns true if both have the same size, channels and types.
bool have_the_same_pixels(const OIIO::ImageSpec& a, const OIIO::ImageSpec& b) {
    if (a.width != b.width || a.height != b.height || a.channelnames != b.channelnames) return false;
    for (int c = 0; c < a.nchannels; ++c)
        if (a.channelformat(c) != b.channelformat(c)) return false;
    return true;
}

void check(const char* plugin, const std::string& bytes, const Picture& picture, const HitFrame& hits,
           const std::function<bool()>& stop) {
    const Encoding encoding = encoding_of(plugin, picture, hits);
    OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes.data()), bytes.size());
    const auto input = OIIO::ImageInput::create(plugin);
    if (!input || !input->set_ioproxy(&memory)) throw std::runtime_error(OIIO::geterror());
    OIIO::ImageSpec spec;
    if (!input->open(std::string("picture.") + plugin, spec)) encoded_wrongly(input->geterror());
    if (!have_the_same_pixels(spec, encoding.spec)) encoded_wrongly("its header differs");
    std::vector<std::byte> read;
    const std::size_t pixel = encoding.pixel_bytes(), row = encoding.row_bytes();
    for_each_band(encoding, stop, [&](int y, int end, const std::vector<std::byte>& data) {
        read.resize(data.size());
        if (!input->read_scanlines(0, 0, y, end, 0, 0, spec.nchannels, OIIO::TypeUnknown, read.data(),
                                   OIIO::stride_t(pixel), OIIO::stride_t(row)))
            encoded_wrongly(input->geterror());
        const auto differ = std::size_t(
            std::mismatch(read.begin(), read.begin() + std::ptrdiff_t(row) * (end - y), data.begin()).first -
            read.begin());
        if (differ < row * std::size_t(end - y))
            encoded_wrongly("pixel " + std::to_string(differ % row / pixel) + "," +
                            std::to_string(std::size_t(y) + differ / row) + " differs");
        return true;
    });
}

bool is_floating(OIIO::TypeDesc type) {
    return type.basetype == OIIO::TypeDesc::HALF || type.basetype == OIIO::TypeDesc::FLOAT ||
           type.basetype == OIIO::TypeDesc::DOUBLE;
}

/// Reads a picture file as linear RGB. Assumes that integer formats hold sRGB and floating-point formats
/// linear light. This holds for the output of write_picture() and is common use. One or two channels are grey
/// (and alpha). Channels beyond the third are not read.
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
    const auto pixel_bytes = OIIO::stride_t(sizeof(float)) * channels;
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeFloat, values.data(), pixel_bytes,
                           pixel_bytes * spec.width))
        throw std::runtime_error(input->geterror());
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const float value = values[i * channels + (channels == 3 ? c : 0)];
            picture.pixels[i][c] = linear ? value : static_cast<float>(linear_from_srgb(value));
        }
    return picture;
}

Texels texels(const std::string& png) {
    OIIO::Filesystem::IOMemReader memory(const_cast<char*>(png.data()), png.size());
    const auto input = OIIO::ImageInput::create("png");
    if (!input || !input->set_ioproxy(&memory)) throw std::runtime_error(OIIO::geterror());
    OIIO::ImageSpec spec, wish;
    wish.attribute("oiio:UnassociatedAlpha", 1);
    if (!input->open("picture.png", spec, wish)) throw std::runtime_error(input->geterror());
    if (spec.width > max_frame_side || spec.height > max_frame_side || spec.nchannels < 3)
        throw std::runtime_error("its size or its channels are no frame's");
    Texels all{{spec.width, spec.height}, {}};
    all.rgba.assign(std::size_t(spec.width) * std::size_t(spec.height), {0, 0, 0, 255});
    if (!input->read_image(0, 0, 0, std::min(spec.nchannels, 4), OIIO::TypeUInt8, all.rgba.data(), 4,
                           OIIO::stride_t(4) * spec.width))
        throw std::runtime_error(input->geterror());
    return all;
}

/// Detects a file's format from its first or last bytes. Returns OpenImageIO's name for the format.
const char* plugin_of(const std::string& bytes) {
    struct Mark {
        std::string_view bytes;
        const char* plugin;
    };
    using namespace std::string_view_literals;
    constexpr std::array<Mark, 8> marks{{{"\x89PNG"sv, "png"},
                                         {"\xff\xd8"sv, "jpeg"},
                                         {"BM"sv, "bmp"},
                                         {"II\x2a\0"sv, "tiff"},
                                         {"MM\0\x2a"sv, "tiff"},
                                         {"\x76\x2f\x31\x01"sv, "openexr"},
                                         {"#?RADIANCE"sv, "hdr"},
                                         {"#?RGBE"sv, "hdr"}}};
    for (const Mark& mark : marks)
        if (bytes.starts_with(mark.bytes)) return mark.plugin;
    if (bytes.ends_with("TRUEVISION-XFILE.\0"sv)) return "targa";
    throw std::runtime_error("it is not PNG, JPEG, BMP, TIFF, TGA (version 2), OpenEXR or HDR");
}

/// Returns true if a JPEG file ends before its picture does. The library would invent the missing texels.
bool is_cut_jpeg(std::string_view bytes) {
    const std::size_t scan = bytes.rfind("\xff\xda"), end = bytes.rfind("\xff\xd9");
    return scan != bytes.npos && (end == bytes.npos || end < scan);
}

/// Reads a picture file in memory row by row. So averaging needs little memory, and a truncated file fails
/// before the memory for its texels is filled.
class TextureReader {
public:
    /// `bytes` must outlive the reader.
    explicit TextureReader(const std::string& bytes)
        : memory_(const_cast<char*>(bytes.data()), bytes.size()) {
        const std::string plugin = plugin_of(bytes);
        if (plugin == "jpeg" && is_cut_jpeg(bytes)) throw std::runtime_error("the file is cut off");
        input_ = OIIO::ImageInput::create(plugin);
        if (!input_ || !input_->set_ioproxy(&memory_)) throw std::runtime_error(OIIO::geterror());
        OIIO::ImageSpec wish;
        wish.attribute("oiio:UnassociatedAlpha", 1);
        if (!input_->open("texture." + plugin, spec_, wish)) throw std::runtime_error(input_->geterror());
        if (spec_.width < 1 || spec_.height < 1 || spec_.depth > 1 || spec_.tile_width > 0 ||
            spec_.nchannels < 1)
            throw std::runtime_error("its pixels are not rows of one picture");
        if (width() > max_picture_side || height() > max_picture_side ||
            std::int64_t{width()} * height() > max_picture_pixels)
            throw std::runtime_error(std::to_string(width()) + "x" + std::to_string(height()) +
                                     " texels are too many");
        const std::int64_t texel_bytes = std::max<std::int64_t>(sizeof(std::array<std::uint8_t, 4>),
                                                                std::int64_t(spec_.pixel_bytes(true)));
        if (std::int64_t{width()} * height() * texel_bytes >
            std::max(least_picture_bytes, picture_bytes_for_a_byte * std::int64_t(bytes.size())))
            throw std::runtime_error(std::to_string(width()) + "x" + std::to_string(height()) +
                                     " texels in a file of " + std::to_string(bytes.size()) +
                                     " bytes are too many");
        // The library divides by alpha only for some formats.
        is_divided_ = (plugin != "openexr" && plugin != "tiff") ||
                      spec_.get_int_attribute("oiio:UnassociatedAlpha") != 0;
    }

    int width() const { return spec_.width; }
    int height() const { return spec_.height; }
    /// True if the channels hold linear light, false if they hold sRGB.
    bool is_linear() const { return is_floating(spec_.format); }

    /// Calls take(texel) for each texel, row by row from the top. A texel has red, green, blue and alpha,
    /// clamped to 0..1; NaN counts as 0.
    template <class Take> void for_each(const Take& take) {
        const auto channels = std::size_t(spec_.nchannels);
        std::vector<float> row(std::size_t(width()) * channels);
        for (int y = 0; y < height(); ++y) {
            if (!input_->read_scanline(spec_.y + y, 0, OIIO::TypeFloat, row.data()))
                throw std::runtime_error(input_->geterror());
            for (std::size_t x = 0; x < std::size_t(width()); ++x) take(texel(&row[x * channels]));
        }
    }

private:
    glm::vec4 texel(const float* channel) const {
        const float alpha = spec_.alpha_channel < 0 ? 1 : within_one(channel[spec_.alpha_channel]);
        const float divisor = is_divided_ || alpha <= 0 ? 1 : alpha;
        glm::vec4 out(0, 0, 0, alpha);
        for (int c = 0; c < 3; ++c) out[c] = within_one(channel[spec_.nchannels >= 3 ? c : 0] / divisor);
        return out;
    }
    static float within_one(float value) { return value > 0 ? std::min(value, 1.0f) : 0; }

    OIIO::Filesystem::IOMemReader memory_;
    std::unique_ptr<OIIO::ImageInput> input_;
    OIIO::ImageSpec spec_;
    bool is_divided_ = true;   ///< the library returns colours that are not multiplied by alpha
};

/// Adds in the order of the texels.
glm::vec4 average(const std::string& bytes) {
    TextureReader reader(bytes);
    const bool is_linear = reader.is_linear();
    glm::dvec4 sum(0);
    reader.for_each([&](const glm::vec4& texel) {
        for (int c = 0; c < 3; ++c) sum[c] += is_linear ? double(texel[c]) : linear_from_srgb(texel[c]);
        sum[3] += double(texel[3]);
    });
    return glm::vec4(sum / (double(reader.width()) * reader.height()));
}

std::uint8_t code_of(float value, bool is_linear) {
    return is_linear ? srgb_byte(value) : static_cast<std::uint8_t>(std::lround(255 * value));
}

TexelLevel picture(const std::string& bytes) {
    TextureReader reader(bytes);
    const bool is_linear = reader.is_linear();
    TexelLevel made{reader.width(), reader.height(), {}};
    made.texels.reserve(std::size_t(reader.width()) * std::size_t(reader.height()));
    reader.for_each([&](const glm::vec4& texel) {
        made.texels.push_back({code_of(texel.r, is_linear), code_of(texel.g, is_linear),
                               code_of(texel.b, is_linear), code_of(texel.a, false)});
    });
    return made;
}

}   // namespace
}   // namespace rayclock

extern "C" const rayclock::PictureCodec rayclock_picture_codec{rayclock::encode,  rayclock::check,
                                                               rayclock::decode,  rayclock::texels,
                                                               rayclock::average, rayclock::picture};
