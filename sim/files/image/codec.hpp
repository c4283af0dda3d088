#pragma once
// The interface between the program and its library of picture formats, which uses OpenImageIO. OpenImageIO
// loads 250 libraries, which takes 0.2 s. So the code is in a separate library, which the program loads when
// it first reads or writes a picture.
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <glm/vec4.hpp>

#include "model/scene/hit_shading.hpp"
#include "model/scene/texture.hpp"

namespace rayclock {

/// A picture with 8-bit sRGB colours and alpha, row by row from the top. The colours are not multiplied by
/// alpha.
struct Texels {
    FrameSize size;
    std::vector<std::array<std::uint8_t, 4>> rgba;
};

/// The functions of the library.
struct PictureCodec {
    /// Returns the bytes of a file. `plugin` is OpenImageIO's name of the format: png or openexr. Throws
    /// std::runtime_error with the reason. Calls `stop` every few rows. Once it returns true, the bytes are
    /// not a whole file.
    std::string (*encode)(const char* plugin, const Picture& picture, const HitFrame& hits,
                          const std::function<bool()>& stop);
    /// Decodes the bytes of a whole file and throws std::runtime_error if they do not hold exactly the
    /// picture and the hits. OpenImageIO can encode wrongly and report success. It may return early once
    /// `stop` returns true.
    void (*check)(const char* plugin, const std::string& bytes, const Picture& picture, const HitFrame& hits,
                  const std::function<bool()>& stop);
    /// Reads a picture file as linear RGB. Throws std::runtime_error with the reason.
    Picture (*decode)(const std::string& path);
    /// Decodes a PNG in memory with three or four channels. Throws std::runtime_error with the reason.
    Texels (*texels)(const std::string& png);
    /// See average_colour(). Throws std::runtime_error with the reason.
    glm::vec4 (*average)(const std::string& bytes);
    /// See decoded_picture(). Throws std::runtime_error with the reason.
    TexelLevel (*picture)(const std::string& bytes);
};

/// Returns the functions of the library and loads it at the first call. Throws UserError if it is missing.
const PictureCodec& picture_codec();

/// Replaces the library during this object's life. Only tests use it.
class StandInCodec {
public:
    explicit StandInCodec(const PictureCodec& codec);
    ~StandInCodec();
    StandInCodec(const StandInCodec&) = delete;
};

}   // namespace rayclock
