// Reads the output of Yosys's `stat`.
#include "sim/silicon/synth/stat.hpp"

#include "sim/files/json_form.hpp"
#include "sim/files/text.hpp"

namespace rayclock::synth {

namespace {

// A limit for cells and for the bits of one register. It exceeds every device.
constexpr std::uint64_t max_cells = 1 << 30;

/// Returns the bits of a register type: 18 for $sdffe_18, 0 for other cells.
std::uint64_t bits_of(const std::string& type, const JsonValue& count) {
    const std::size_t width = type.rfind('_');
    if (type.find("dff") == std::string::npos || type[0] != '$' || width == std::string::npos) return 0;
    const std::int64_t bits = whole_number(std::string_view(type).substr(width + 1), {"stat.json of yosys"});
    if (bits < 0 || std::uint64_t(bits) >= max_cells) count.refuse("counts registers of an odd width");
    return std::uint64_t(bits);
}

}   // namespace

Netlist counts_of(const std::string& stat) {
    const std::string name = "stat.json of yosys";
    const Json document = parse_json(name, stat);
    Netlist counts;
    const JsonValue types = JsonValue(document, name).at("design").at("num_cells_by_type");
    for_each(types, [&](const std::string& type, const JsonValue& count) {
        const std::uint64_t n = count.whole(max_cells);
        if (type == "MULT18X18D") counts.multipliers += n;
        counts.flip_flops += bits_of(type, count) * n;
    });
    return counts;
}

}   // namespace rayclock::synth
