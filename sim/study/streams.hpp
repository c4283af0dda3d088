#pragma once
// The page docs/measured/stream-figures.md: streams of rays of many kinds, on every acceleration structure
// and in three orders.
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/base/progress.hpp"
#include "model/core/config.hpp"
#include "model/scene/camera.hpp"

namespace rayclock::streams {

struct Study {
    Config base;
    std::vector<std::string> scenes;
    FrameSize size;   ///< size of the pictures whose camera rays are followed
    int khz = 0;
    int threads = 0;
};

/// A stream that was traced. Figures are per ray.
struct Row {
    std::string scene, kind, structure, order;
    std::uint64_t rays = 0, cycles = 0, wrong = 0;
    double visits = 0, tests = 0, bytes = 0, node_hits = 0, primitive_hits = 0, reached = 0, mrays_per_s = 0;
    std::string bound;
    double cycles_per_ray() const { return double(cycles) / double(rays); }
};

/// Traces every stream with every structure as recorded, and with the base's structure in the other orders
/// too. Judges all answers exactly.
std::vector<Row> measure(const Study& study, const Progress& progress);

/// Returns the page as Markdown. `command` is the command that makes it.
std::string page(const std::vector<Row>& rows, const Study& study, const std::string& command);
nlohmann::ordered_json rows_json(const std::vector<Row>& rows);

}   // namespace rayclock::streams
