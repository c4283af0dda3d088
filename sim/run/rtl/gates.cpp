// Synthesis by Yosys, and the simulation models of the cells.
#include "sim/run/rtl/gates.hpp"

#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "model/base/error.hpp"
#include "model/machine/units.hpp"
#include "sim/files/cache/libraries.hpp"
#include "sim/files/input.hpp"
#include "sim/files/process/process.hpp"
#include "sim/files/process/tools.hpp"
#include "sim/run/gen/ecp5.hpp"
#include "sim/run/gen/rc_pkg.hpp"
#include "sim/run/rtl/adapter.hpp"
#include "sim/run/rtl/sources.hpp"

namespace rayclock {

namespace fs = std::filesystem;

namespace {

/// The modules that only wire others. Links are tapped in them (sim/run/rtl/adapter.cpp).
const std::vector<std::string>& wiring() {
    static const std::vector<std::string> names{"chip", "top", "pipeline", "tree"};
    return names;
}

std::vector<std::string> units() {
    std::vector<std::string> names{"host", "counters", "none", "arbiter"};
    for (const UnitInfo& unit : unit_infos)
        if (unit.place != UnitPlace::outside) names.emplace_back(unit.name);
    return names;
}

/// The cells in Yosys' own library that netlists use. For all other cells (sim/silicon/synth/yosys.cpp reads
/// them without bodies), the models are in the RTL's folder.
const std::vector<std::string> modelled_by_yosys{"LUT2", "LUT4", "CCU2C", "TRELLIS_FF", "TRELLIS_DPR16X4"};

/// Returns the synthesis script of `rayclock chip` (sim/silicon/chip/place_and_route.cpp) without the last
/// steps of synth_ecp5: `autoname` makes long names, and the tests run `check`. Then unused nets are removed,
/// and vectors in units are split into bits. Otherwise a carry chain within one vector would look like a loop
/// to Verilator.
std::string script(const std::string& module) {
    std::string text = "hierarchy -check -top " + module_name(module);
    for (const auto& [name, value] : parameter_values(module))
        text += fmt::format(" -chparam {} {}", name, value);
    text += "\n";
    const std::vector<std::string> all = units();
    if (module == "rc_chip")
        text += fmt::format("setattr -mod -set keep_hierarchy 1 *rc_{}* *rc_{}*\n",
                            fmt::join(wiring(), "* *rc_"), fmt::join(all, "* *rc_"));
    text += ecp5_steps("check") + "select -set inner *rc_*";
    for (const std::string& name : wiring()) text += " rc_" + name + " %d";
    return text +
           "\nopt_clean -purge @inner\nsplitnets @inner\nopt_clean -purge @inner\n"
           "select -clear\nwrite_verilog -noattr -norename gates.v\n";
}

/// Returns rayclock's own models of cells. Throws UserError if they are missing.
std::string own_cells() {
    const fs::path file = rtl_sources() / "ecp5/cells.v";
    std::string text = read_if_there(file);
    if (text.empty()) throw UserError(file.string() + " cannot be read, and netlists are simulated with it");
    return text;
}

/// Extracts the models from Yosys' library, as `read_verilog -ppdump` prints it.
std::string models_in(const std::string& dump) {
    std::string text;
    for (const std::string& name : modelled_by_yosys) {
        const std::size_t begin = dump.find(fmt::format("\nmodule {}(", name));
        const std::size_t spaced = dump.find(fmt::format("\nmodule {} (", name));
        const std::size_t at = std::min(begin, spaced), end = dump.find("\nendmodule", at);
        if (at == std::string::npos || end == std::string::npos)
            throw std::runtime_error("yosys has no model of the cell " + name);
        text += dump.substr(at, end - at) + "\nendmodule\n";
    }
    return text;
}

void run_yosys(const fs::path& folder, const std::string& commands, const Working& working) {
    write_text(folder / "run.ys", commands);
    run_tools(folder, {{{"yosys", "-q", "run.ys"}, "yosys.log"}}, "yosys", [&] { working("Yosys", {}); });
}

}   // namespace

const std::string& gates_tool() {
    static const std::string version = version_line({"yosys", "-V"});
    return version;
}

std::string gates_inputs(const Config& config, const std::string& module) {
    std::string all = rc_package(config) + source_inputs(module) + script(module) + own_cells();
    for (const std::string& name : modelled_by_yosys) all += " " + name;
    return all;
}

void make_gates(const fs::path& folder, const Config& config, const std::string& module,
                const Working& working) {
    std::string commands =
        "tee -q -o cells.log read_verilog -lib -ppdump +/ecp5/cells_sim.v\n"
        "read_verilog -lib +/ecp5/cells_bb.v\n";
    for (const std::string& file : stage_sources(folder, config, module))
        if (fs::path(file).extension() == ".sv")
            commands += fmt::format("read_verilog -sv -D RC_ECP5 {}{}\n",
                                    file == "rtl/rc_pkg.sv" ? "" : "-defer ", file);
    run_yosys(folder, commands + script(module), working);
    write_text(folder / "netlist.v", models_in(read_if_there(folder / "cells.log")) + own_cells() +
                                         read_if_there(folder / "gates.v"));
    tidy(folder, folder / "netlist.v");
}

std::string gates_vlt() {
    std::string text = "`verilator_config\nlint_off -rule INITIALDLY -file \"netlist.v\"\n";
    for (const std::string& name : units()) text += fmt::format("no_inline -module \"rc_{}\"\n", name);
    return text;
}

}   // namespace rayclock
