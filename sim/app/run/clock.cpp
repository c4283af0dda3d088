// Parses clocks and looks up routed ones.
#include "sim/app/run/clock.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/split.hpp"
#include "model/board/board_memory.hpp"
#include "sim/app/run/typed_values.hpp"
#include "sim/silicon/chip/clock.hpp"

namespace rayclock {

namespace {

bool is_routed(const std::optional<chip::RoutedClock>& routed, int khz) {
    return routed && khz <= routed->khz();
}

}   // namespace

void check_clocks(const std::string& typed) {
    if (typed.find("fmax") == std::string::npos) parse_clocks(typed);
}

std::vector<int> clocks_of(const std::string& typed, const Config& config) {
    std::vector<std::string> items = split(typed, ',');
    for (std::string& item : items) {
        if (item != "fmax") continue;
        const std::optional<chip::RoutedClock> routed = chip::routed_clock(config);
        if (!routed)
            throw UserError(
                fmt::format("--clock fmax: '{0}' was not routed with these parameters; "
                            "rayclock chip --config {0} with the same --set routes it",
                            printable(config.name)));
        item = fmt::format("{:.3f}", routed->khz() / 1e3);
    }
    const std::vector<int> clocks = parse_clocks(fmt::format("{}", fmt::join(items, ",")));
    for (const int khz : clocks) {
        try {
            check_board_clock(config, khz);
        } catch (const UserError& error) {
            throw UserError(fmt::format("--clock {:g}: {}", khz / 1e3, error.what()));
        }
    }
    return clocks;
}

int one_clock_of(const std::string& typed, const Config& config) {
    const std::vector<int> clocks = clocks_of(typed, config);
    if (clocks.size() != 1) throw UserError("--clock: this command takes one clock, not " + shown(typed));
    return clocks[0];
}

std::string clock_is(const Config& config, int khz) {
    return is_routed(chip::routed_clock(config), khz) ? "routed" : "assumed";
}

void mark_clock(nlohmann::ordered_json& clock, const Config& config, int khz) {
    const std::optional<chip::RoutedClock> routed = chip::routed_clock(config);
    clock["clock_is"] = is_routed(routed, khz) ? "routed" : "assumed";
    clock["clock_mhz_routed"] =
        routed ? nlohmann::ordered_json(routed->mhz) : nlohmann::ordered_json(nullptr);
}

std::string clock_line(const Config& config, const std::vector<int>& khz) {
    const std::optional<chip::RoutedClock> routed = chip::routed_clock(config);
    if (!routed)
        return fmt::format("  '{}' was not routed, so these clocks are assumed\n", printable(config.name));
    std::vector<std::string> assumed;
    for (const int clock : khz)
        if (!is_routed(routed, clock)) assumed.push_back(fmt::format("{:g} MHz", clock / 1e3));
    return fmt::format("  routed on {}: {:.1f} MHz{}\n", routed->device, routed->mhz,
                       assumed.empty() ? "" : fmt::format("; {} assumed", fmt::join(assumed, ", ")));
}

}   // namespace rayclock
