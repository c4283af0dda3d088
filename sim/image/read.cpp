#include "sim/image/image.hpp"

#include <filesystem>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "model/base/error.hpp"
#include "sim/image/srgb.hpp"

namespace rayclock {
namespace {

UserError not_readable(const std::string& path, std::string why) {
    if (const auto end = why.find('\n'); end != std::string::npos) why.resize(end);
    return UserError(
        fmt::format("{}: is not a picture that can be read{}", path, why.empty() ? "" : ": " + why));
}

bool is_floating(OIIO::TypeDesc type) {
    return type.basetype == OIIO::TypeDesc::HALF || type.basetype == OIIO::TypeDesc::FLOAT ||
           type.basetype == OIIO::TypeDesc::DOUBLE;
}

}   // namespace

// Integer formats hold sRGB, floating ones linear light: true of what write_picture() writes and of common
// use. One or two channels are grey (and alpha); channels beyond the third are not read.
Picture read_picture(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::exists(path, error)) throw UserError(fmt::format("{}: no such file", path));
    if (std::filesystem::is_directory(path, error))
        throw UserError(fmt::format("{}: is a directory, not a picture", path));
    const auto input = OIIO::ImageInput::open(path);
    if (!input) throw not_readable(path, OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.width > max_frame_side ||
        spec.height > max_frame_side)
        throw UserError(fmt::format("{}: {}x{} pixels; at most {} a side can be read", path, spec.width,
                                    spec.height, max_frame_side));
    const int channels = spec.nchannels >= 3 ? 3 : 1;
    const bool linear = is_floating(spec.format);
    Picture picture{{spec.width, spec.height}, {}};
    picture.pixels.resize(static_cast<std::size_t>(spec.width) * spec.height);
    std::vector<float> values(picture.pixels.size() * channels);
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeFloat, values.data()))
        throw not_readable(path, input->geterror());
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const float value = values[i * channels + (channels == 3 ? c : 0)];
            picture.pixels[i][c] = linear ? value : static_cast<float>(linear_from_srgb(value));
        }
    return picture;
}

}   // namespace rayclock
