#pragma once
// FPGAs that a configuration can be placed on: the ECP5 family, package CABGA381, speed grade 6.
#include <cstdint>
#include <string>
#include <vector>

namespace rayclock::chip {

/// What cells take of a device, or what a device has.
struct Use {
    std::uint64_t lut = 0;    ///< places of a LUT4
    std::uint64_t ff = 0;     ///< flip-flops
    std::uint64_t dsp = 0;    ///< MULT18X18D
    std::uint64_t bram = 0;   ///< DP16KD, 18 Kbit each

    Use& operator+=(const Use& o) {
        lut += o.lut, ff += o.ff, dsp += o.dsp, bram += o.bram;
        return *this;
    }
    friend bool operator==(const Use&, const Use&) = default;
};

/// The four figures of Use, for tables and sentences.
struct Resource {
    const char* key;    ///< in JSON
    const char* name;   ///< "LUTs"
    std::uint64_t Use::*member;
};
const std::vector<Resource>& resources();

struct Device {
    std::string name;     ///< "lfe5u-85"
    const char* option;   ///< of nextpnr-ecp5
    Use has;
    int columns, rows;   ///< of tiles, as nextpnr numbers them
};
const std::vector<Device>& devices();

/// Throws UserError with the nearest name.
const Device& device_of(const std::string& name);

constexpr const char* package_name = "CABGA381";
constexpr int speed_grade = 6;

}   // namespace rayclock::chip
