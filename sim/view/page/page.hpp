#pragma once
// A run as one HTML file that needs no network: pictures, heat maps, charts, tables, and every figure as
// data.
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "sim/judge/cause/cause.hpp"
#include "sim/view/observe/costs.hpp"
#include "sim/view/report/json.hpp"

namespace rayclock {

struct PageInput {
    const nlohmann::ordered_json& report;   ///< as simulate --json writes it
    const Config& config;
    int khz = 0;
    const FrameRun& run;
    const FrameCosts& costs;   ///< of the same frame
    const Picture& picture;
    const Picture* reference = nullptr;     ///< null: there is none
    const Judgement* judgement = nullptr;   ///< likewise
    std::string explain;                    ///< the command that explains a pixel, up to the pixel
    std::vector<std::pair<std::uint32_t, std::string>> explanations;   ///< of the slowest pixels, as explain
                                                                       ///< tells them
    std::vector<std::pair<std::string, std::string>> origin;           ///< command line, versions, digest
};

/// The page. Throws UserError if the library that draws its charts is not installed.
std::string report_page(const PageInput& input);

/// The pixels that took the most cycles, the slowest first.
std::vector<std::uint32_t> slowest_pixels(const FrameCosts& costs, std::size_t most);

/// Costs as JSON, for `work_by_kind` of the report.
nlohmann::ordered_json work_by_kind_json(const FrameCosts& costs);

}   // namespace rayclock
