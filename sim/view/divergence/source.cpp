// Finds the line of Verilog that drives a differing link.
#include "sim/view/divergence/source.hpp"

#include <regex>
#include <sstream>

#include <fmt/format.h>

#include "sim/run/lockstep/driver.hpp"
#include "sim/run/rtl/sources.hpp"

namespace rayclock {

namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::string trimmed(const std::string& line) {
    const std::size_t first = line.find_first_not_of(' ');
    return first == std::string::npos ? "" : line.substr(first);
}

/// A line that gives `name` a value: by assignment, or as the output of an instance.
std::size_t driver(const std::vector<std::string>& lines, const std::string& name) {
    const std::regex assigns("(^|[^A-Za-z0-9_])" + name + "(\\[[^\\]]*\\])? *<?=[^=]"),
        connects("(_o\\( *\\{?|[(,] *\\.|^ *\\.)" + name + " *[,})]");
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (std::regex_search(lines[i], assigns) || std::regex_search(lines[i], connects)) return i + 1;
    return 0;
}

}   // namespace

/// The link's whole name, or its last word if the unit has one link of that kind. What all share is wired in
/// rc_top, without ports.
std::vector<std::string> output_names(const Divergence& d, const Config& config) {
    const bool offer = d.got == "no offer" || d.expected == "no offer";
    const bool acceptance =
        !offer && (d.got == "an offer that is not accepted" || d.expected == "an offer that is not accepted");
    const std::string what = offer ? "_valid" : acceptance ? "_ready" : "";
    std::string link = d.link;
    if (d.on && !acceptance) link = port_of(*d.on, d.unit.substr(0, d.unit.find('[')), config);
    const std::size_t bar = link.rfind('_');
    std::vector<std::string> names{link + what + "_o"};
    if (offer) names.push_back(link + "_fires_o");
    if (bar != std::string::npos) names.push_back(link.substr(bar + 1) + what + "_o");
    names.push_back("rsp" + what + "_o");   // a cache's answer, whatever link it comes on
    names.push_back(link + what);
    return names;
}

SourceLine source_of(const Divergence& divergence, const Config& config) {
    const std::string unit = divergence.unit.substr(0, divergence.unit.find('['));
    const std::string wanted = unit == "memport" ? "rc_top.sv" : "rc_" + unit + ".sv";
    for (const RtlText& source : rtl_texts()) {
        if (source.name.substr(source.name.rfind('/') + 1) != wanted) continue;
        const std::vector<std::string> lines = lines_of(source.text);
        for (const std::string& name : output_names(divergence, config))
            if (const std::size_t line = driver(lines, name); line > 0)
                return {source.name, line, trimmed(lines[line - 1])};
        for (std::size_t i = 0; i < lines.size(); ++i)
            if (lines[i].starts_with("module ")) return {source.name, i + 1, lines[i]};
    }
    return {};
}

}   // namespace rayclock
