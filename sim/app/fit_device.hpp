#pragma once
// What `fit --device` does after the formats: the fastest machine that fits a device, confirmed by routing
// it.
#include <optional>

#include "sim/app/methods.hpp"
#include "sim/explore/balance/search.hpp"
#include "sim/silicon/chip/run.hpp"
#include "sim/run/film/choice.hpp"

namespace rayclock {

/// As typed.
struct DeviceOptions {
    std::string device;
    std::optional<std::string> fill, clock;
    MethodOptions methods;
    bool no_route = false, fresh = false;
};
void device_options(Parser& parser, DeviceOptions& options);

struct DeviceGoal {
    chip::Device device;
    chip::Use room;   ///< what the search may fill: the rest is for wiring, and for the placer
    int khz = default_khz;
    bool route = true, fresh = false;
    chip::Methods methods{};   ///< by which it is routed
};
/// Nothing if no device was asked for. Throws UserError.
std::optional<DeviceGoal> device_goal(const DeviceOptions& options);

struct DeviceFit {
    DeviceGoal goal;
    balance::Found found;
    Config config;                        ///< the winner
    std::optional<chip::Result> routed;   ///< if it was to be
    std::optional<double> routed_fps;     ///< at the routed clock, if it fits
};
/// Looks among machines with the formats of `formats`. Throws std::runtime_error if none fits, or if
/// interrupted().
DeviceFit fit_device(const DeviceGoal& goal, const Scene& scene, FrameSize size, const Config& formats,
                     int threads, const Progress& progress, const PictureChoice& picture);

std::string text(const DeviceFit& fit);
nlohmann::ordered_json json(const DeviceFit& fit);

}   // namespace rayclock
