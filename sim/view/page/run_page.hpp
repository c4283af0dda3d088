#pragma once
// Shows a run as one HTML file that needs no network: pictures, heat maps, charts, tables and all data.
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "sim/judge/cause/cause.hpp"
#include "sim/view/observe/costs.hpp"
#include "sim/view/report/json.hpp"

namespace rayclock {

struct PageInput {
    const nlohmann::ordered_json& report;   ///< the output of simulate --json
    const Config& config;
    int khz = 0;
    const FrameResult& run;
    const FrameCosts& costs;   ///< costs of the frame in `run`
    const Picture& picture;
    const Picture* reference = nullptr;     ///< null without a reference
    const Judgement* judgement = nullptr;   ///< null without a judgement
    /// The command that explains a pixel, without the pixel's coordinates.
    std::string explain;
    /// Output of `explain` for each of the slowest pixels.
    std::vector<std::pair<std::uint32_t, std::string>> explanations;
    std::vector<std::pair<std::string, std::string>> origin;   ///< command line, versions, digest
};

/// Returns the page. Throws UserError if the chart library is not installed.
std::string report_page(const PageInput& input);

/// Returns the `most` pixels that took the most cycles, the slowest first.
std::vector<std::uint32_t> slowest_pixels(const FrameCosts& costs, std::size_t most);

/// Returns the costs of each kind of ray, for `work_by_kind` of the report.
nlohmann::ordered_json work_by_kind_json(const FrameCosts& costs);

}   // namespace rayclock
