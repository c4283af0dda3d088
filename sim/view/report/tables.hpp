#pragma once
// Reports as text, with the same values as the JSON.
#include <optional>
#include <string>
#include <vector>

#include "model/scene/builtin.hpp"
#include "sim/view/report/json.hpp"

namespace rayclock {

/// Returns counts in words: "12 triangles, 3 spheres, 1 plane".
std::string primitives_text(const PrimitiveCounts& counts);
std::string primitives_text(const Scene& scene);
std::string heading(const Scene& scene, FrameSize size, const Job& job);
std::string work_table(const Config& config, const FramesAtClock& run);
std::string clock_table(const Config& config, const std::vector<FramesAtClock>& runs);
/// Returns how every unit spent its cycles, with one column for each clock.
std::string unit_table(const Config& config, const std::vector<FramesAtClock>& runs);
std::string error_line(const char* who, const FrameError& error);
/// Returns why pixels differ, and the oracle's verdicts.
std::string cause_lines(const Judgement& judgement);

}   // namespace rayclock
