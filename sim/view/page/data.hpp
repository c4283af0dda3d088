#pragma once
// The figures of the page's charts.
#include <nlohmann/json.hpp>

#include "sim/view/page/page.hpp"

namespace rayclock {

/// A heat map: a figure of every pixel.
struct PixelMap {
    const char* key;
    const char* name;
    std::uint32_t (*value)(const PixelCost&);
};
const std::vector<PixelMap>& pixel_maps();

/// All that the scripts draw, the values of all pixels included.
nlohmann::ordered_json page_data(const PageInput& input);

/// A pixel's cause as a sentence says it; empty if it does not differ or nobody has judged.
std::string cause_of(const PageInput& input, std::size_t pixel);

}   // namespace rayclock
