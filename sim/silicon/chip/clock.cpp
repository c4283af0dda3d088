// Stores and finds routed clocks in the cache of chips.
#include "sim/silicon/chip/clock.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "sim/files/cache/libraries.hpp"
#include "sim/run/gen/rc_pkg.hpp"
#include "sim/silicon/synth/yosys.hpp"

namespace rayclock::chip {

namespace {

constexpr const char* kind = "chip-clock";

std::string key_of(const Config& config) {
    return fmt::format("package {} rtl {} pipelines {}", results::hash_text(rc_package(config)),
                       synth::rtl_digest(), config.pipelines);
}

std::optional<RoutedClock> find(const Config& config, const results::Cache& cache) {
    return cache.find(kind, key_of(config), [](const nlohmann::ordered_json& json) {
        return RoutedClock{json.at("mhz").get<double>(), json.at("device").get<std::string>(),
                           json.at("seed").get<int>()};
    });
}

}   // namespace

std::optional<RoutedClock> routed_clock(const Config& config) {
    try {
        const std::filesystem::path folder = cache_place().folder / "chip";
        std::error_code error;
        if (!std::filesystem::is_directory(folder, error)) return std::nullopt;   // do not create the folder
        return find(config, results::Cache(folder, false));
    } catch (const UserError&) {
        return std::nullopt;   // without a cache or sources there is no routed clock
    }
}

void keep_clock(const Config& config, const RoutedClock& clock, results::Cache& cache) {
    const std::optional<RoutedClock> before = find(config, cache);
    if (before && before->mhz >= clock.mhz) return;
    cache.keep(kind, key_of(config), {{"mhz", clock.mhz}, {"device", clock.device}, {"seed", clock.seed}});
}

}   // namespace rayclock::chip
