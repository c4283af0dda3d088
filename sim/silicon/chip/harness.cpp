// Reads the ports of a module, and writes its harness.
#include "sim/silicon/chip/harness.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/files/json_form.hpp"
#include "sim/silicon/synth/parts.hpp"

namespace rayclock::chip {

namespace {

constexpr const char* harness_template =
    R"(// Made by rayclock chip: {top} with registers around it, and four pins.
module rc_harness (
  input  wire clk_i,
  input  wire rst_ni,
  input  wire serial_i,
  output wire serial_o
);
  reg               rst_q;
  reg  [{in}-1:0]   in_q;
  wire [{out}-1:0]  out;
  reg  [{out}-1:0]  out_q, sum_q;
  always @(posedge clk_i) begin
    rst_q <= rst_ni;
    in_q  <= {{in_q, serial_i}};
    out_q <= out;
    sum_q <= {{sum_q, sum_q[{out}-1]}} ^ out_q;
  end
  assign serial_o = sum_q[{out}-1];
  rc_{top} {parameters}u_{top} (
    {ports});
endmodule
)";

bool is_clock(const Port& port) { return port.name == "clk_i" || port.name == "rst_ni"; }

std::uint64_t width_of(const ModuleInterface& interface, bool inputs) {
    std::uint64_t sum = 0;
    for (const Port& port : interface.ports)
        if (port.is_input == inputs && !is_clock(port)) sum += port.width;
    return std::max<std::uint64_t>(sum, 1);
}

}   // namespace

ModuleInterface interface_of(const std::string& netlist, const std::string& top) {
    const std::string file = "interface.json of yosys";
    parse_json(file, netlist);   // refuses text that is not JSON, and names the line
    ModuleInterface interface;
    std::set<std::string> modules;
    understood(file, [&] {   // keeps the order of ports for the harness
        const nlohmann::ordered_json document = nlohmann::ordered_json::parse(netlist);
        for (const auto& [type, module] : document.at("modules").items()) {
            const std::string name = synth::module_name(type);
            if (name.empty() || type.starts_with("$abstract")) continue;
            modules.insert(name);
            if (name != top || !interface.ports.empty()) continue;
            for (const auto& [port, what] : module.at("ports").items())
                interface.ports.push_back({port, what.at("direction") == "input", what.at("bits").size()});
        }
    });
    interface.modules.assign(modules.begin(), modules.end());
    return interface;
}

std::string harness_text(const Config& config, const std::string& top, const ModuleInterface& interface) {
    std::vector<std::string> ports, parameters;
    std::uint64_t in = 0, out = 0;
    for (const Port& port : interface.ports) {
        std::uint64_t& at = port.is_input ? in : out;
        if (is_clock(port))
            ports.push_back(fmt::format(".{}({})", port.name, port.name == "clk_i" ? "clk_i" : "rst_q"));
        else
            ports.push_back(
                fmt::format(".{}({}[{} +: {}])", port.name, port.is_input ? "in_q" : "out", at, port.width));
        if (!is_clock(port)) at += port.width;
    }
    for (const auto& [name, value] : synth::parameters_of(config, top))
        parameters.push_back(fmt::format(".{}({})", name, value));
    return fmt::format(
        harness_template, fmt::arg("top", top), fmt::arg("in", width_of(interface, true)),
        fmt::arg("out", width_of(interface, false)),
        fmt::arg("parameters", parameters.empty() ? "" : fmt::format("#({}) ", fmt::join(parameters, ", "))),
        fmt::arg("ports", fmt::join(ports, ",\n    ")));
}

}   // namespace rayclock::chip
