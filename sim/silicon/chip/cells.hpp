#pragma once
// The cells of a netlist as Yosys and nextpnr write it, and to which unit of the machine each belongs.
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/silicon/chip/device.hpp"

namespace rayclock::chip {

struct Cell {
    std::string name, type;
    std::string source;      ///< attribute src: places in sources, from the outermost instance inwards
    std::string bel;         ///< "X107/Y74/SLICEC.RAMW", once it is placed
    std::vector<int> nets;   ///< numbers of what its ports are wired to
};

/// Calls `take` for each cell of the netlist, which is read piece by piece: as a whole it would fill a
/// gigabyte. False if the text is not complete JSON.
bool read_cells(const std::string& file, const std::function<void(const Cell&)>& take);

/// Instances have the names of their modules: u_box is the unit box, whatever lies around it. The outermost
/// unit counts. What is in none is "wiring" inside the machine and "harness" around it. nextpnr adds a cell
/// where a carry chain begins or ends, and does not say for whom: in a chip these are "carry ends", a unit of
/// their own. The harness has no carry chain.
class Units {
public:
    /// `top` is what the harness holds: "chip", or the name of a unit.
    explicit Units(std::string top);

    std::string of(std::string_view cell) const;

private:
    std::vector<std::string> names_;
    std::string top_;
};
constexpr const char* harness_unit = "harness";
constexpr const char* wiring_unit = "wiring";
constexpr const char* carry_unit = "carry_ends";

/// What a cell takes, before or after it is placed.
Use use_of(const std::string& type);

/// "rtl/engine/bvh/rc_box.sv:120" of a src attribute: of its places in the folder `sources` that are
/// instances, or that are none but what is in one, the first; empty if there is no such place.
std::string source_line(const std::string& src, const std::string& sources, bool instances = false);
/// The innermost line that a name tells of, for cells that Yosys made without a place:
/// "u_mshr.u_next.mem.0.7" of prim_cache is where rc_mshr has u_next, if there is a rc_mshr.sv; else where
/// rc_prim_cache has u_mshr.
std::string source_of_name(const std::string& unit, const std::string& name, const std::string& sources);

/// The register, memory or multiplier that a cell is, or is named after, as a path within the unit and
/// without numbers of bits: "u_rank.s4_q" of "u_top.u_box.u_rank.s4_q_TRELLIS_FF_Q_5" in box.
std::string register_of(std::string_view cell, const std::string& unit);

}   // namespace rayclock::chip
