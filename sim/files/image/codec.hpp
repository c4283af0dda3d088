#pragma once
// Between the program and the library that encodes pictures, OpenImageIO. That brings 250 libraries, which
// take a fifth of a second to load: what knows it is a library of its own, which is loaded when the first
// picture is read or written.
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <glm/vec4.hpp>

#include "model/scene/hit_shading.hpp"

namespace rayclock {

/// A picture of 8-bit colours that are not multiplied by alpha, row by row from the top.
struct Texels {
    FrameSize size;
    std::vector<std::array<std::uint8_t, 4>> rgba;
};

struct PictureCodec {
    /// The bytes of a file. `plugin` is OpenImageIO's name of the format: png or openexr. Throws
    /// std::runtime_error with the reason. `stop` is asked every few rows; once it is true, the bytes are not
    /// a whole file.
    std::string (*encode)(const char* plugin, const Picture& picture, const HitFrame& hits,
                          const std::function<bool()>& stop);
    /// Reads the bytes of a whole file and throws std::runtime_error if they do not hold exactly the picture
    /// and the hits: a library that encodes wrongly reports success. Once `stop` is true, it may return
    /// early.
    void (*check)(const char* plugin, const std::string& bytes, const Picture& picture, const HitFrame& hits,
                  const std::function<bool()>& stop);
    /// Throws std::runtime_error with the reason.
    Picture (*decode)(const std::string& path);
    /// Of the bytes of a PNG with three or four channels. Throws std::runtime_error with the reason.
    Texels (*texels)(const std::string& png);
    /// See average_colour(). Throws std::runtime_error with the reason.
    glm::vec4 (*average)(const std::string& bytes);
};

/// Throws UserError if the library is missing.
const PictureCodec& picture_codec();

/// For tests: while it lives, it takes the place of the library.
class StandInCodec {
public:
    explicit StandInCodec(const PictureCodec& codec);
    ~StandInCodec();
    StandInCodec(const StandInCodec&) = delete;
};

}   // namespace rayclock
