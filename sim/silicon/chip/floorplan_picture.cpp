// Draws the placement of a chip.
#include "sim/silicon/chip/floorplan_picture.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "sim/files/table.hpp"
#include "sim/silicon/chip/cells.hpp"

namespace rayclock::chip {

namespace {

using plot::Boxes;
using plot::Colour;

constexpr double scale = 8, left = 20, top = 50, legend_width = 230, line = 18;

/// Returns one of twelve hues that stay distinct in print and then repeat. The harness and the wiring are
/// grey.
Colour colour_of(const std::string& unit, std::size_t index) {
    constexpr Colour hues[] = {{31, 119, 180},  {214, 39, 40},  {44, 160, 44}, {255, 127, 14},
                               {148, 103, 189}, {23, 190, 207}, {140, 86, 75}, {227, 119, 194},
                               {188, 189, 34},  {11, 61, 98},   {120, 20, 20}, {20, 90, 20}};
    if (unit == harness_unit) return {190, 190, 190};
    if (unit == wiring_unit || unit == carry_unit) return {110, 110, 110};
    return hues[index % std::size(hues)];
}

std::vector<std::string> largest_first(const std::map<std::string, Use>& units) {
    std::vector<std::string> names;
    for (const auto& [unit, use] : units) names.push_back(unit);
    std::stable_sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
        const Use &x = units.at(a), &y = units.at(b);
        return std::tuple(a == harness_unit, y.lut + y.ff) < std::tuple(b == harness_unit, x.lut + x.ff);
    });
    return names;
}

/// Returns the part of a tile that a unit fills. A tile has eight LUTs and eight flip-flops.
double share_of(const Use& use) {
    if (use.dsp || use.bram) return 1;
    return std::min(1.0, double(std::max(use.lut, use.ff)) / 8);
}

}   // namespace

plot::Drawing placement(const Route& route, const Device& device, const std::string& title) {
    plot::Drawing drawing;
    const double width = device.columns * scale, height = device.rows * scale;
    drawing.width = left + width + legend_width, drawing.height = top + height + 20;
    drawing.shapes.emplace_back(plot::Text{{left, 30}, title, 16, {}, plot::Anchor::start, false});
    drawing.shapes.emplace_back(Boxes{{{left, top, width, height}}, {242, 242, 242}});
    const std::vector<std::string> units = largest_first(route.units);
    std::map<std::pair<int, int>, double> filled;
    std::map<std::string, Boxes> boxes;
    for (const Tile& tile : route.tiles) {
        double& from = filled[{tile.x, tile.y}];
        const double part = std::min(share_of(tile.use), 1 - from);
        boxes[tile.unit].boxes.push_back(
            {left + tile.x * scale, top + (tile.y + 1 - from - part) * scale, scale - 0.5, part * scale});
        from += part;
    }
    for (std::size_t i = 0; i < units.size(); ++i) {
        const Colour colour = colour_of(units[i], i);
        Boxes& of = boxes[units[i]];
        of.colour = colour;
        drawing.shapes.emplace_back(of);
        const double y = top + line * double(i + 1), x = left + width + 15;
        drawing.shapes.emplace_back(Boxes{{{x, y - 11, 12, 12}}, colour});
        drawing.shapes.emplace_back(
            plot::Text{{x + 18, y},
                       fmt::format("{}, {} LUTs", units[i], grouped(route.units.at(units[i]).lut)),
                       12,
                       {},
                       plot::Anchor::start,
                       false});
    }
    return drawing;
}

}   // namespace rayclock::chip
