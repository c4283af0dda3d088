#pragma once
// The resources of one unit on an ECP5, from Yosys on one module of a configuration.
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
    std::uint64_t carry = 0;   ///< CCU2C: two bits of a carry chain; occupies two LUT4 sites
    std::uint64_t ram = 0;     ///< TRELLIS_DPR16X4: 16 words of 4 bits; occupies six LUT4 sites
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
    /// Returns LUT sites: 2 for a CCU2C (one slice) and 6 for a DPR16X4 (three slices; Lattice, ECP5 data
    /// sheet).
    std::uint64_t luts() const { return lut4 + 2 * carry + 6 * ram; }
};

/// The cells of a module and of the modules below it.
struct Part {
    std::string name;          ///< without rc_
    std::uint64_t times = 1;   ///< instances in the part above, with any parameters
    Count count;               ///< all instances together, including the modules below
    std::vector<Part> parts;   ///< the modules below, in alphabetical order
};

nlohmann::ordered_json part_json(const Part& part);
Part part_of(const nlohmann::ordered_json& json);
nlohmann::ordered_json count_json(const Count& count);
/// Reads the output of count_json(). Throws a JSON exception if the format is wrong.
Count count_of(const nlohmann::ordered_json& json);

/// Returns the modules that stay separate within their unit, so that each is counted: all arithmetic modules.
/// Names are without rc_.
const std::vector<std::string>& cell_names();

/// Returns "divide" for "$paramod/rc_divide/Width=s32'..."; empty for a cell of the ECP5.
std::string module_name(const std::string& type);

/// Returns the command that makes rc_UNIT the top module, with the chip's parameters.
std::string elaborate(const Config& config, const std::string& unit);

/// Returns the parameters that do not come from the package: those of the arbiter, which the chip sets, and
/// the chip's own. The chip is counted without the counters of unit activity.
std::vector<std::pair<std::string, int>> parameters_of(const Config& config, const std::string& unit);

/// Returns the synthesis script for an elaborated hierarchy.
std::string synth_script();

/// Returns a hash of the module before synthesis. Configurations in which the module is equal share it.
/// Nothing if interrupted().
std::optional<std::string> shape_of(const Config& config, const std::string& unit,
                                    const std::filesystem::path& work);

/// Synthesises a unit. Returns nothing if interrupted().
std::optional<Part> synthesize(const Config& config, const std::string& unit,
                               const std::filesystem::path& work);

/// Reads the output of `stat -json` for the unit's module and those below it.
Part parts_of_stat(const std::string& stat, const std::string& unit);

}   // namespace rayclock::synth
