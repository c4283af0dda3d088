#pragma once
// The cells of a netlist of Yosys or nextpnr, and the unit of the machine that each belongs to.
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/silicon/chip/device.hpp"

namespace rayclock::chip {

struct Cell {
    std::string name, type;
    std::string source;      ///< attribute src: places in sources, the outermost instance first
    std::string bel;         ///< "X107/Y74/SLICEC.RAMW", once it is placed
    std::vector<int> nets;   ///< numbers of the nets at its ports
};

/// Calls `take` for each cell of the netlist. Reads the file piece by piece, since the whole would fill a
/// gigabyte. Returns false if the text is not complete JSON.
bool read_cells(const std::string& file, const std::function<void(const Cell&)>& take);

/// Finds the unit of a cell by its name. Instances have the names of their modules: u_box is the unit box at
/// any depth, and the outermost unit counts. A cell outside all units is "wiring" inside the machine and
/// "harness" around it. nextpnr adds cells at the ends of carry chains without a name of the unit: in a chip
/// these form a unit "carry_ends". The harness has no carry chain.
class Units {
public:
    /// `top` is the content of the harness: "chip", the name of a unit, or board_top. The harness of a board
    /// is its PLL, resets and pins.
    explicit Units(std::string top);

    std::string of(std::string_view cell) const;

private:
    std::vector<std::string> names_;
    std::string top_;
};
constexpr const char* harness_unit = "harness";
constexpr const char* wiring_unit = "wiring";
constexpr const char* carry_unit = "carry_ends";

/// Returns the resources of a cell.
Use use_of(const std::string& type);

/// Returns the first place of a `src` attribute in the folder `sources`: "rtl/engine/bvh/rc_box.sv:120".
/// `instances` selects instances, otherwise other lines. Empty if there is none.
std::string source_line(const std::string& src, const std::string& sources, bool instances = false);
/// Returns the innermost source line that a cell's name identifies, for cells without a `src` attribute. For
/// "u_mshr.u_next.mem.0.7" of prim_cache it is the line of u_next in rc_mshr, if rc_mshr.sv exists; else the
/// line of u_mshr in rc_prim_cache.
std::string source_of_name(const std::string& unit, const std::string& name, const std::string& sources);

/// Returns the register, memory or multiplier of a cell, by its name, as a path within the unit and without
/// numbers of bits: "u_rank.s4_q" for "u_top.u_box.u_rank.s4_q_TRELLIS_FF_Q_5" in box.
std::string register_of(std::string_view cell, const std::string& unit);

}   // namespace rayclock::chip
