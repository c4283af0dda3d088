// Writes the template of a unit from the tables of links, payloads and don't-care outputs.
#include "sim/run/elastic/template.hpp"

#include <array>
#include <optional>
#include <regex>
#include <sstream>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/run/elastic/dont_care.hpp"
#include "sim/run/elastic/elastic.hpp"
#include "sim/run/elastic/findings.hpp"
#include "sim/run/elastic/unit_alone.hpp"
#include "sim/run/rtl/sources.hpp"

namespace rayclock {

namespace {

/// Lists a payload's fields with their widths: "o[3] (18)".
class WidthVisitor {
public:
    std::string text;
    template <class T> void operator()(const char* name, const T&, int width) {
        add(fmt::format("{} ({})", name, width));
    }
    template <class T, std::size_t n>
    void operator()(const char* name, const std::array<T, n>&, int width, int count) {
        add(fmt::format("{}[{}] ({})", name, count, width));
    }

private:
    void add(const std::string& field) { text += (text.empty() ? "" : ", ") + field; }
};

std::string payload_text(Link c, const Config& config) {
    return with_payload(c, [&]<class P>() {
        P payload{};
        WidthVisitor fields;
        payload.fields(fields, config);
        return fields.text;
    });
}

/// A module's ports, as its source declares them.
struct Ports {
    std::string text;   ///< between the brackets
    std::vector<std::string> names;
};
Ports ports_of_module(const std::string& source, const std::string& module) {
    std::smatch head;
    const std::regex start("\\bmodule\\s+" + module + "\\s*\\(\\n?");
    if (!std::regex_search(source, head, start))
        throw UserError(module + ": the head of its module cannot be read");
    const std::size_t begin = std::size_t(head.position(0) + head.length(0));
    Ports ports{source.substr(begin, source.find(");", begin) - begin), {}};
    static const std::regex name("(\\w+)\\s*,?\\s*(//.*)?$");
    std::istringstream lines(ports.text);
    for (std::string line; std::getline(lines, line);) {
        std::smatch found;
        if (line.find("put ") != line.npos && std::regex_search(line, found, name))
            ports.names.push_back(found[1]);
    }
    return ports;
}

/// A module with the unit's ports that contains the project's own.
std::string wrapper_text(const std::string& unit, const Ports& ports) {
    std::string connections;
    for (const std::string& port : ports.names) connections += (connections.empty() ? "." : ", .") + port;
    return fmt::format(
        "// Your unit {0}. It contains the project's unit, unchanged. Add logic between "
        "the ports\n// and the instance.\n`default_nettype none\nmodule rc_{0} (\n{1});\n"
        "  rc_{0}_own u_own ({2});\nendmodule\n`default_nettype wire\n",
        unit, ports.text, connections);
}

std::string links_text(const std::string& unit, const Config& config) {
    std::string text = "| link | direction | flow | fields (bits) |\n|---|---|---|---|\n";
    for (std::size_t i = 0; i < link_count; ++i) {
        const LinkInfo& link = link_infos[i];
        if (!is_there(Link(i), config) || (link.from != unit && link.to != unit)) continue;
        const bool out = link.from == unit;
        text += fmt::format("| `{}` | {} {} | {} | {} |\n", link.name, out ? "to" : "from",
                            out ? link.to : link.from, link.flow == Flow::fires ? "fires" : "handshake",
                            payload_text(Link(i), config));
    }
    return text;
}

std::string dont_care_text(const std::string& unit) {
    std::string text;
    for (const DontCare& rule : dont_cares)
        if (unit == unit_name(rule.unit))
            text += fmt::format("- `{}`: {} {}\n", link_infos[index(rule.link)].name, rule.fields, rule.when);
    return text.empty() ? "None: every bit of every transfer is compared.\n" : text;
}

/// Returns the run line of the unit alone, if it can run alone. It does not run alone on a stream of rays.
std::string alone_text(const std::string& unit, const Config& config, const std::string& options) {
    if (!runs_alone(unit) || config.is_stream()) return {};
    return fmt::format(
        "\nThe unit alone, on the requests of a frame, with random valid and ready:\n\n    rayclock "
        "verify gears:2 --size 48x36 --config {1} --unit-only {0} --unit {0}=rc_{0}.sv\n",
        unit, options);
}

std::string readme(const std::string& unit, const Ports& ports, const Config& config,
                   const std::string& options) {
    return fmt::format(R"(# The unit {0}

These files are the start of your unit `{0}`, for the chip `{6}`.

- `rc_{0}.sv` is a copy of the project's module. Rewrite it.
- `wrapped_{0}.sv` is a module with the same ports that contains the project's module under the name
  `rc_{0}_own`. Use it to add registers, queues or faults around the unit.

These commands compare values and accept any timing:

{7}    rayclock verify gears:2 {8} --config {1} --elastic {0} --unit {0}=rc_{0}.sv
    rayclock verify gears:2 {8} --config {1} --elastic {0} --unit {0}=wrapped_{0}.sv

Without `--elastic` the command also compares every cycle.
{5}
## Ports

```systemverilog
module rc_{0} (
{2});
```

## Links

{3}
Types and widths are in `rc_pkg.sv`. `rayclock export SCENE --config {1} -o FOLDER` writes this file for
the chip. A payload's first field is the most significant.

## Rules

- *handshake*: a transfer happens in each cycle in which valid and ready are 1. Once valid is 1, valid and
  payload stay unchanged until the transfer. *fires*: the receiver accepts in every cycle.
- An answer carries the `ray` or `id` of its request. A request has at most one answer. Answers may come
  after any number of cycles, and in any order across rays. A ray has one transfer in flight.
- Reset lasts at least four cycles. After it, valid is 0.
- `cause`, `outcome`, `occupied` and `waits` outputs feed the counters only. They are not compared.

## Don't-care outputs

No unit reads these outputs. Drive them with any value.

{4})",
                       unit, options, ports.text, links_text(unit, config), dont_care_text(unit),
                       alone_text(unit, config, options), printable(config.name),
                       config.is_stream() ? "    rayclock rays gears:2 --size 48x36 -o rays.npy\n" : "",
                       config.is_stream() ? "--rays rays.npy" : "--size 48x36");
}

}   // namespace

std::vector<TemplateFile> unit_template(const std::string& unit, const Config& config,
                                        const std::string& options) {
    const std::optional<Unit> found = unit_called(unit);
    if (!found)
        throw UserError(
            fmt::format("no unit is called {}; this chip has {}", shown(unit), unit_names(config)));
    if (*found == Unit::memory || *found == Unit::memport)
        throw UserError(fmt::format("the unit {} is not a separate module, so it has no template", unit));
    if (!is_there(*found, config))
        throw UserError(fmt::format("the chip '{}' has no unit {}", printable(config.name), unit));
    const std::string source = module_text(unit);
    const Ports ports = ports_of_module(source, "rc_" + unit);
    return {{"rc_" + unit + ".sv", source},
            {"wrapped_" + unit + ".sv", wrapper_text(unit, ports)},
            {"README.md", readme(unit, ports, config, options)}};
}

}   // namespace rayclock
