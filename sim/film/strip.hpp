#pragma once
// Frames as numbered pictures, and as a film.
#include <string>

#include "sim/image/image.hpp"

namespace rayclock {

/// The program that makes the film: Debian's package of the same name. An animated PNG loses nothing, and
/// every browser plays it.
constexpr const char* film_program = "apngasm";

/// "frame_0007.png"
std::string frame_name(std::size_t f);

/// Makes `folder`/film.png of the frames 0 to count - 1 that lie in it. Returns a sentence about what was
/// made, or why nothing was. Throws UserError if an old one cannot be removed.
std::string make_film(const std::string& folder, std::size_t count, double fps);

}   // namespace rayclock
