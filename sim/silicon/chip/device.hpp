#pragma once
// The supported FPGAs: the ECP5 family, package CABGA381, speed grade 6.
#include <cstdint>
#include <string>
#include <vector>

namespace rayclock::chip {

/// Resources that cells use, or that a device has.
struct Use {
    std::uint64_t lut = 0;    ///< LUT4 sites
    std::uint64_t ff = 0;     ///< flip-flops
    std::uint64_t dsp = 0;    ///< MULT18X18D
    std::uint64_t bram = 0;   ///< DP16KD, 18 Kbit each

    Use& operator+=(const Use& o) {
        lut += o.lut, ff += o.ff, dsp += o.dsp, bram += o.bram;
        return *this;
    }
    friend bool operator==(const Use&, const Use&) = default;
};

/// One of the four counts in Use, for tables and sentences.
struct Resource {
    const char* key;    ///< key in JSON
    const char* name;   ///< "LUTs"
    std::uint64_t Use::*member;
};
const std::vector<Resource>& resources();

/// An FPGA.
struct Device {
    std::string name;     ///< "lfe5u-85"
    const char* option;   ///< its option of nextpnr-ecp5
    Use has;
    int columns, rows;   ///< of tiles, in nextpnr's numbering
};
const std::vector<Device>& devices();

/// Returns the device of this name. Throws UserError that names the nearest device.
const Device& device_of(const std::string& name);

constexpr const char* package_name = "CABGA381";
constexpr int speed_grade = 6;

}   // namespace rayclock::chip
