#pragma once
// JSON data of the page's charts.
#include <nlohmann/json.hpp>

#include "sim/view/page/run_page.hpp"

namespace rayclock {

/// A heat map: one value for each pixel.
struct PixelMap {
    const char* key;
    const char* name;
    std::uint32_t (*value)(const PixelCost&);
};
const std::vector<PixelMap>& pixel_maps();

/// Returns all data that the scripts draw, including the values of all pixels.
nlohmann::ordered_json page_data(const PageInput& input);

/// Returns the sentence that names a pixel's cause. Empty if the pixel does not differ or no judgement
/// exists.
std::string cause_of(const PageInput& input, std::size_t pixel);

}   // namespace rayclock
