// Writes wrappers with faults.
#include "tests/system/elastic/faulty.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <unistd.h>

#include <fmt/format.h>

#include "sim/run/rtl/sources.hpp"

namespace rayclock::test {

namespace {

namespace fs = std::filesystem;

/// The ports of a unit's module, and the type of one output.
struct Head {
    std::string ports, type;
    std::vector<std::string> names;
};
Head head_of_unit(const FaultyUnit& f) {
    const std::string source = module_text(f.unit), start = "module rc_" + f.unit + " (";
    const std::size_t begin = source.find(start);
    REQUIRE(begin != std::string::npos);
    Head head{source.substr(begin + start.size(), source.find(");", begin) - begin - start.size()), {}, {}};
    const std::regex port("^ *(input|output) +(.*?) +(\\w+)\\s*,?\\s*(//.*)?$");
    std::istringstream lines(head.ports);
    for (std::string line; std::getline(lines, line);) {
        std::smatch found;
        if (!std::regex_match(line, found, port)) continue;
        head.names.push_back(found[3]);
        if (found[3] == f.port + "_o") head.type = found[2];
    }
    REQUIRE(!head.type.empty());
    return head;
}

/// Returns the module's body: what happens between the project's unit and the output. With `fires`, the
/// receiver accepts in every cycle.
std::string body(const FaultyUnit& f, bool fires) {
    const std::string p = f.port, valid = p + (fires ? "_fires_o" : "_valid_o"),
                      ready = fires ? "1'b1" : p + "_ready_i";
    const std::string now = f.fault == Fault::value ? ">=" : "==";
    std::string text = fmt::format(R"(
  logic own_valid, own_ready, again_q, is_it;
  logic [15:0] count_q;
  assign is_it = count_q {} 16'd{};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) count_q <= '0;
    else if (own_valid && own_ready) count_q <= count_q + 16'd1;
  end
)",
                                   now, f.number);
    switch (f.fault) {
        case Fault::value:
            return text + fmt::format(
                              "  assign {0} = own_valid;\n  assign own_ready = {1};\n"
                              "  assign {2}_o = is_it ? own ^ ($bits(own)'(1) << {3}) : own;\n"
                              "  assign again_q = 0;\n",
                              valid, ready, p, f.bit);
        case Fault::lost:
            return text + fmt::format(
                              "  assign {0} = own_valid && !is_it;\n  assign own_ready = {1} || is_it;\n"
                              "  assign {2}_o = own;\n  assign again_q = 0;\n",
                              valid, ready, p);
        case Fault::twice: break;
    }
    if (fires)
        return text + fmt::format(
                          "  logic [$bits(own)-1:0] last_q;\n"
                          "  assign {0} = own_valid || again_q;\n  assign own_ready = 1;\n"
                          "  assign {1}_o = own_valid ? own : last_q;\n"
                          "  always_ff @(posedge clk_i) begin\n    again_q <= rst_ni && own_valid && is_it;\n"
                          "    last_q <= own;\n  end\n",
                          valid, p);
    return text + fmt::format(
                      "  assign {0} = own_valid;\n  assign own_ready = {1} && !(is_it && !again_q);\n"
                      "  assign {2}_o = own;\n"
                      "  always_ff @(posedge clk_i) begin\n    if (!rst_ni) again_q <= 0;\n"
                      "    else if (own_valid && {1} && is_it) again_q <= 1;\n  end\n",
                      valid, ready, p);
}

std::string faulty_module(const FaultyUnit& f) {
    const Head head = head_of_unit(f);
    const bool fires = head.ports.find(f.port + "_fires_o") != std::string::npos;
    std::string connections;
    for (const std::string& name : head.names) {
        connections += connections.empty() ? "" : ", ";
        if (name == f.port + (fires ? "_fires_o" : "_valid_o"))
            connections += "." + name + "(own_valid)";
        else if (name == f.port + "_ready_i")
            connections += "." + name + "(own_ready)";
        else if (name == f.port + "_o")
            connections += "." + name + "(own)";
        else
            connections += "." + name;
    }
    return fmt::format(
        "`default_nettype none\nmodule rc_{0} ({1});\n  {2} own;\n{3}"
        "  rc_{0}_own u_own ({4});\nendmodule\n`default_nettype wire\n",
        f.unit, head.ports, head.type, body(f, fires), connections);
}

}   // namespace

std::string name_of(const FaultyUnit& f) {
    const char* const kind = f.fault == Fault::value ? "value" : f.fault == Fault::lost ? "lost" : "twice";
    return fmt::format("{} {} {}", f.unit, f.port, kind);
}

OtherUnit::OtherUnit(const std::string& unit, const std::string& file) { replace_module(unit, file); }

OtherUnit::OtherUnit(const FaultyUnit& faulty) { use(faulty.unit, faulty_module(faulty)); }

OtherUnit::OtherUnit(const std::string& unit,
                     const std::vector<std::pair<std::string, std::string>>& changes) {
    std::string text = module_text(unit);
    for (const auto& [old, fresh] : changes) {
        const std::size_t at = text.find(old);
        REQUIRE(at != std::string::npos);
        REQUIRE(text.find(old, at + 1) == std::string::npos);
        text.replace(at, old.size(), fresh);
    }
    use(unit, text);
}

void OtherUnit::use(const std::string& unit, const std::string& text) {
    file_ = (fs::temp_directory_path() / fmt::format("rayclock-faulty-{}.sv", getpid())).string();
    std::ofstream(file_) << text;
    replace_module(unit, file_);
}

OtherUnit::~OtherUnit() {
    restore_modules();
    if (!file_.empty()) fs::remove(file_);
}

}   // namespace rayclock::test
