#pragma once
// The cells of a netlist written by Yosys or nextpnr, and the unit of the machine that each belongs to.
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/silicon/chip/device.hpp"

namespace rayclock::chip {

/// A cell of a netlist.
struct Cell {
    std::string name, type;
    std::string source;      ///< attribute src: positions in sources, from the outermost instance inwards
    std::string bel;         ///< site after placement: "X107/Y74/SLICEC.RAMW"
    std::vector<int> nets;   ///< numbers of the nets at its ports
};

/// Calls `take` for each cell of the netlist. Reads the file piecewise, because the whole document would need
/// a gigabyte. Returns false if the text is incomplete JSON.
bool read_cells(const std::string& file, const std::function<void(const Cell&)>& take);

/// Assigns cells to units by name. Instances have the names of their modules: u_box is the unit box at any
/// depth. The outermost unit counts. Cells outside all units are "wiring" inside the machine and "harness"
/// around it. nextpnr adds a cell at each end of a carry chain, without a unit in its name. In a chip these
/// cells form the unit "carry_ends"; the harness has no carry chain.
class Units {
public:
    /// `top` is the content of the harness: "chip", or the name of a unit.
    explicit Units(std::string top);

    std::string of(std::string_view cell) const;

private:
    std::vector<std::string> names_;
    std::string top_;
};
constexpr const char* harness_unit = "harness";
constexpr const char* wiring_unit = "wiring";
constexpr const char* carry_unit = "carry_ends";

/// Returns the resources of a cell type, before or after placement.
Use use_of(const std::string& type);

/// Returns a line such as "rtl/engine/bvh/rc_box.sv:120" for a src attribute. Considers its positions in the
/// folder `sources`: those of instances, or those of anything else. Returns the first, or an empty string.
std::string source_line(const std::string& src, const std::string& sources, bool instances = false);
/// Returns the innermost source line that a name identifies, for cells without a position. For
/// "u_mshr.u_next.mem.0.7" of prim_cache this is the line of u_next in rc_mshr, if rc_mshr.sv exists.
/// Otherwise it is the line of u_mshr in rc_prim_cache.
std::string source_of_name(const std::string& unit, const std::string& name, const std::string& sources);

/// Returns the register, memory or multiplier that a cell implements, as a path within the unit without bit
/// numbers. In box, "u_top.u_box.u_rank.s4_q_TRELLIS_FF_Q_5" gives "u_rank.s4_q".
std::string register_of(std::string_view cell, const std::string& unit);

}   // namespace rayclock::chip
