#pragma once
// What a unit takes of an ECP5: Yosys on one module of a configuration.
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/core/config.hpp"

namespace rayclock::synth {

/// Cells of an ECP5.
struct Count {
    std::uint64_t lut4 = 0;    ///< LUT4: a function of four bits
    std::uint64_t carry = 0;   ///< CCU2C: two bits of a carry chain, in the place of two LUT4
    std::uint64_t ram = 0;     ///< TRELLIS_DPR16X4: 16 words of 4 bits, in the place of six LUT4
    std::uint64_t ff = 0;      ///< TRELLIS_FF
    std::uint64_t dsp = 0;     ///< MULT18X18D
    std::uint64_t bram = 0;    ///< DP16KD or PDPW16KD: 18 Kbit

    Count& operator+=(const Count& o) {
        lut4 += o.lut4, carry += o.carry, ram += o.ram, ff += o.ff, dsp += o.dsp, bram += o.bram;
        return *this;
    }
    friend Count operator*(std::uint64_t n, const Count& c) {
        return {n * c.lut4, n * c.carry, n * c.ram, n * c.ff, n * c.dsp, n * c.bram};
    }
    friend bool operator==(const Count&, const Count&) = default;
    /// Places of LUTs: 2 for a CCU2C and 6 for a DPR16X4, which fill one slice and three (Lattice, ECP5 data
    /// sheet).
    std::uint64_t luts() const { return lut4 + 2 * carry + 6 * ram; }
};

/// A module's own cells and those beneath it.
struct Part {
    std::string name;          ///< without rc_
    std::uint64_t times = 1;   ///< in the part above, whatever its parameters
    Count count;               ///< of all of them together, with what is beneath
    std::vector<Part> parts;   ///< beneath, in alphabetical order
};

nlohmann::ordered_json part_json(const Part& part);
Part part_of(const nlohmann::ordered_json& json);
nlohmann::ordered_json count_json(const Count& count);
/// Throws a JSON exception if it is not as count_json() made it.
Count count_of(const nlohmann::ordered_json& json);

/// Modules that are kept whole within their unit, so that they can be counted apart: all that calculate.
/// Names without rc_.
const std::vector<std::string>& cells();

/// rc_divide from "$paramod/rc_divide/Width=s32'...", "divide" from that; empty for a cell of the ECP5.
std::string module_name(const std::string& type);

/// The command that makes rc_UNIT the top, as the chip has it.
std::string elaborate(const Config& config, const std::string& unit);

/// Parameters that do not come from the package: the arbiter's, which the chip sets, and the chip's own,
/// which goes without counters of what units do.
std::vector<std::pair<std::string, int>> parameters_of(const Config& config, const std::string& unit);

/// What is done with a module once its hierarchy stands.
std::string synth_script();

/// What the module looks like before synthesis, as a hash: the same for configurations that do not differ in
/// it. Nothing if interrupted().
std::optional<std::string> shape_of(const Config& config, const std::string& unit,
                                    const std::filesystem::path& work);

/// Nothing if interrupted().
std::optional<Part> synthesize(const Config& config, const std::string& unit,
                               const std::filesystem::path& work);

/// What `stat -json` says of the unit's module and those beneath it.
Part parts_of_stat(const std::string& stat, const std::string& unit);

}   // namespace rayclock::synth
