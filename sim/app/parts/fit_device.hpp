#pragma once
// The search of `fit --device` for the fastest machine that fits a device. Routing confirms the result. The
// number formats are fitted before.
#include <optional>

#include "sim/app/parts/methods.hpp"
#include "sim/explore/balance/search.hpp"
#include "sim/run/film/choice.hpp"
#include "sim/silicon/chip/place_and_route.hpp"

namespace rayclock {

/// The options as typed.
struct DeviceOptions {
    std::string device;
    std::optional<std::string> fill, clock;
    MethodOptions methods;
    bool no_route = false, fresh = false;
};
void device_options(Parser& parser, DeviceOptions& options);

/// The device and the limits of the search.
struct DeviceGoal {
    chip::Device device;
    chip::Use room;   ///< the part that the search may fill; the rest is for wiring and for the placer
    int khz = default_khz;
    bool route = true, fresh = false;
    chip::Methods methods{};   ///< methods for routing
};
/// Returns the goal, or nothing if no device was requested. Throws UserError.
std::optional<DeviceGoal> device_goal(const DeviceOptions& options);

/// The result for a device.
struct DeviceFit {
    DeviceGoal goal;
    balance::SearchResult found;
    Config config;                        ///< the fastest machine
    std::optional<chip::Result> routed;   ///< the routed chip, if routing was requested
    std::optional<double> routed_fps;     ///< frames per second at the routed clock, if the chip fits
};
/// Searches machines with the number formats of `formats`. Throws std::runtime_error if none fits, or if
/// interrupted().
DeviceFit fit_device(const DeviceGoal& goal, const Scene& scene, FrameSize size, const Config& formats,
                     int threads, const Progress& progress, const PictureChoice& picture);

std::string text(const DeviceFit& fit);
nlohmann::ordered_json json(const DeviceFit& fit);

}   // namespace rayclock
