#pragma once
// The options of finished pictures.
#include <optional>

namespace rayclock {

/// The settings of a finished picture that the user gave.
struct Finish {
    std::optional<int> depth, aa;
    std::optional<double> threshold, contrast;
    bool jittered = false, fresnel = false;

    bool is_given() const { return depth || aa || threshold || contrast || jittered || fresnel; }
};

}   // namespace rayclock
