#pragma once
// Decoding an animated PNG: https://wiki.mozilla.org/APNG_Specification.
#include <functional>
#include <string>

namespace rayclock {

/// Returns an empty string if `film` shows exactly the frames 0 to count - 1, each for `delay` thousandths of
/// a second. Returns the difference otherwise. `frame` returns the bytes of a frame's PNG, and is called once
/// for each. Takes the time to decode all frames twice.
std::string film_fault(const std::string& film, std::size_t count, long delay,
                       const std::function<std::string(std::size_t)>& frame);

}   // namespace rayclock
