#pragma once
// How far a picture may be from the reference's although model and RTL agree.
#include <string>

#include "sim/report/json.hpp"

namespace rayclock {

/// What was typed, or the defaults: then what goes beyond is said, and does not fail.
struct Limits {
    double max_other = 1;   ///< pixels with another primitive, per cent
    double min_psnr = 30;   ///< dB
    bool fails = false;     ///< one of them was typed
};

/// One sentence about each limit that the picture is beyond; empty if there is none.
std::string beyond_limits(const Limits& limits, const FrameError& error);
nlohmann::ordered_json limits_json(const Limits& limits, const FrameError& error);

}   // namespace rayclock
