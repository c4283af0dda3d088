#pragma once
#include <optional>

namespace rayclock {

/// Settings of a finished picture, as far as they were typed.
struct Finish {
    std::optional<int> depth, aa;
    std::optional<double> threshold, contrast;
    bool jittered = false, fresnel = false;

    bool is_asked() const { return depth || aa || threshold || contrast || jittered || fresnel; }
};

}   // namespace rayclock
