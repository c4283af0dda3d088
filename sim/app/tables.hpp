#pragma once
// Reports as text for people: the same figures as in JSON.
#include <optional>
#include <string>
#include <vector>

#include "sim/report/json.hpp"

namespace rayclock {

std::string heading(const Scene& scene, FrameSize size, const Job& job);
std::string work_table(const FrameRun& run);
std::string clock_table(const FrameRun& run, const std::vector<double>& clocks);
std::string unit_table(const FrameRun& run);
std::string error_line(const char* who, const FrameError& error);

} // namespace rayclock
