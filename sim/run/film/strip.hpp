#pragma once
// Frames as numbered pictures, and as a film.
#include <string>

#include "sim/files/folder.hpp"
#include "sim/files/image/image.hpp"

namespace rayclock {

/// The program that makes the film: Debian's package of the same name. An animated PNG loses nothing, and
/// every browser plays it.
constexpr const char* film_program = "apngasm";

/// "frame_0007.png"
std::string frame_name(std::size_t f);

/// Makes a film of the frames 0 to count - 1 that lie in the stage, and publishes both; older frames behind
/// them go. Returns a sentence about what was made, or why there is no film. Throws UserError if the film is
/// not whole, and Interrupted after Ctrl-C: then nothing is published.
std::string make_film(StagedFiles& staged, const std::string& folder, std::size_t count, double fps);

}   // namespace rayclock
