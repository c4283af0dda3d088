#pragma once
// Frames as numbered pictures, and as a film.
#include <string>

#include "sim/files/folder.hpp"
#include "sim/files/image/image.hpp"

namespace rayclock {

/// The program that makes the film; Debian's package has the same name. An animated PNG is lossless, and
/// every browser plays it.
constexpr const char* film_program = "apngasm";

/// Returns the file name of a frame: "frame_0007.png".
std::string frame_name(std::size_t f);

/// Makes a film of the staged frames 0 to count - 1 and publishes both. Removes older frames with higher
/// numbers. Returns a sentence about the film, or the reason why there is none. Throws UserError if the film
/// is damaged, and Interrupted after Ctrl-C. Then it publishes nothing.
std::string make_film(StagedFiles& staged, const std::string& folder, std::size_t count, double fps);

}   // namespace rayclock
