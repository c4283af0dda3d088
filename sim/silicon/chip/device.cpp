// Tables of devices and of their resources.
#include "sim/silicon/chip/device.hpp"

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/nearest.hpp"

namespace rayclock::chip {

const std::vector<Resource>& resources() {
    static const std::vector<Resource> all{{"lut", "LUTs", &Use::lut},
                                           {"ff", "flip-flops", &Use::ff},
                                           {"dsp", "multipliers", &Use::dsp},
                                           {"bram", "block RAMs", &Use::bram}};
    return all;
}

const std::vector<Device>& devices() {
    // Counts from nextpnr's own report. The data sheet rounds LUTs up to thousands.
    static const std::vector<Device> all{{"lfe5u-25", "--25k", {24288, 24288, 28, 56}, 73, 50},
                                         {"lfe5u-45", "--45k", {43848, 43848, 72, 108}, 91, 71},
                                         {"lfe5u-85", "--85k", {83640, 83640, 156, 208}, 127, 96}};
    return all;
}

const Device& device_of(const std::string& name) {
    return by_name(devices(), name, "--device: no device", "; there are lfe5u-25, lfe5u-45, lfe5u-85");
}

}   // namespace rayclock::chip
