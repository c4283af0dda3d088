// Reading a picture file, with the library's errors as UserError.
#include <filesystem>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "sim/files/image/codec.hpp"
#include "sim/files/image/image.hpp"

namespace rayclock {

Picture read_picture(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::exists(path, error)) throw UserError(fmt::format("{}: no such file", path));
    if (std::filesystem::is_directory(path, error))
        throw UserError(fmt::format("{}: is a directory, not a picture", path));
    const PictureCodec& codec = picture_codec();
    try {
        return codec.decode(path);
    } catch (const std::runtime_error& reason) {
        std::string why = reason.what();
        if (const auto end = why.find('\n'); end != std::string::npos) why.resize(end);
        throw UserError(
            fmt::format("{}: is not a picture that can be read{}", path, why.empty() ? "" : ": " + why));
    }
}

}   // namespace rayclock
