// Textures from the library of picture formats.
#include "sim/files/image/average.hpp"

#include "sim/files/image/codec.hpp"

namespace rayclock {

glm::vec4 average_colour(const std::string& bytes) { return picture_codec().average(bytes); }

TexelLevel decoded_picture(const std::string& bytes) { return picture_codec().picture(bytes); }

}   // namespace rayclock
