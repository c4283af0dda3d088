// Synthesises units with Yosys, and reads the hierarchy of their cells.
#include "sim/silicon/synth/parts.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "sim/files/cache/results.hpp"
#include "sim/files/json_form.hpp"
#include "sim/run/gen/ecp5.hpp"
#include "sim/silicon/synth/yosys.hpp"

namespace rayclock::synth {

using nlohmann::ordered_json;

namespace {

void add_cells(Count& count, const std::string& type, std::uint64_t n) {
    if (type == "LUT4") count.lut4 += n;
    if (type == "CCU2C") count.carry += n;
    if (type == "TRELLIS_DPR16X4") count.ram += n;
    if (type == "TRELLIS_FF") count.ff += n;
    if (type == "MULT18X18D") count.dsp += n;
    if (type == "DP16KD" || type == "PDPW16KD") count.bram += n;
}

/// Adds `more`, a part of the same kind, to `part`. The parts below `part` are sorted by name.
void merge(Part& part, const Part& more) {
    part.times += more.times;
    part.count += more.count;
    for (const Part& p : more.parts) {
        const auto at = std::lower_bound(part.parts.begin(), part.parts.end(), p,
                                         [](const Part& a, const Part& b) { return a.name < b.name; });
        if (at != part.parts.end() && at->name == p.name)
            merge(*at, p);
        else
            part.parts.insert(at, p);
    }
}

Part scaled(const Part& part, std::uint64_t n) {
    Part result{part.name, n * part.times, n * part.count, {}};
    for (const Part& p : part.parts) result.parts.push_back(scaled(p, n));
    return result;
}

constexpr std::uint64_t max_part_cells = 1 << 30;   // exceeds every device

/// Reads modules within modules. It limits depth and visits, because a hostile file may nest modules
/// endlessly or multiply their instances.
class Modules {
public:
    explicit Modules(const JsonValue& modules) : modules_(modules) {}

    Part part(const std::string& type) {
        if (visits_++ > max_visits || depth_ > max_depth) modules_.refuse("are nested too deeply");
        ++depth_;
        Part made{module_name(type), 1, {}, {}}, beneath;
        for_each(modules_.at(type).at("num_cells_by_type"),
                 [&](const std::string& cell, const JsonValue& in) {
                     const std::uint64_t n = in.whole(max_part_cells);
                     add_cells(made.count, cell, n);
                     // The name of a module as Yosys writes it, in its definition and in the cells that use
                     // it.
                     const std::string inner_type = cell.starts_with("$") ? cell : "\\" + cell;
                     if (!modules_.raw().contains(inner_type)) return;
                     const Part inner = scaled(part(inner_type), n);
                     made.count += inner.count;
                     merge(beneath, Part{"", 0, {}, {inner}});
                 });
        made.parts = std::move(beneath.parts);
        --depth_;
        return made;
    }

private:
    static constexpr int max_visits = 100'000, max_depth = 100;
    const JsonValue& modules_;
    int visits_ = 0, depth_ = 0;
};

constexpr const char* read_flags = "-defer ";   // elaborates only what the top module needs

}   // namespace

std::string module_name(const std::string& type) {
    const std::size_t at = type.find("rc_");
    if (at == std::string::npos) return {};
    const std::size_t end = type.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_", at);
    return type.substr(at + 3, end == std::string::npos ? end : end - at - 3);
}

const std::vector<std::string>& cell_names() {
    static const std::vector<std::string> names{
        "divide", "sqrt",   "unit",  "power",  "sample", "recip",   "slope",    "stack",   "slab", "rank",
        "plane",  "span",   "edges", "shear",  "hitdiv", "sphere",  "contexts", "pass",    "surf", "corners",
        "ball",   "angles", "light", "bounce", "snell",  "schlick", "finish",   "pass_end"};
    return names;
}

std::vector<std::pair<std::string, int>> parameters_of(const Config& c, const std::string& unit) {
    if (unit == "chip") return {{"Counters", 0}};
    if (unit != "arbiter") return {};
    return {{"Sources", c.clients() * c.pipelines},
            {"Width", c.client_id_bits() - c.client_bits() + c.addr_bits}};
}

std::string elaborate(const Config& c, const std::string& unit) {
    std::string command = "hierarchy -check -top rc_" + unit;
    for (const auto& [name, value] : parameters_of(c, unit))
        command += fmt::format(" -chparam {} {}", name, value);
    return command + "\n";
}

std::string synth_script() {
    // Omits the last steps of synth_ecp5. `autoname` would take half of the time, and the tests in
    // tests/synth run `check`.
    std::string modules;   // whole names, alone or with parameters behind them: rc_pass is not rc_pass_end
    for (const std::string& cell : cell_names()) modules += fmt::format(" *rc_{0} *rc_{0}[!a-z0-9_]*", cell);
    return fmt::format("setattr -mod -set keep_hierarchy 1{}\n{}tee -q -o stat.json stat -json\n", modules,
                       ecp5_steps("check"));
}

std::optional<std::string> shape_of(const Config& config, const std::string& unit,
                                    const std::filesystem::path& work) {
    const YosysFolder folder(work);
    const std::string tidy =
        "proc\nopt_expr\nopt_clean\nsetattr -unset src\nsetattr -mod -unset src\nwrite_rtlil shape.il\n";
    if (!folder.run(config, read_flags, elaborate(config, unit) + tidy)) return std::nullopt;
    return results::hash_text(folder.text("shape.il"));
}

std::optional<Part> synthesize(const Config& config, const std::string& unit,
                               const std::filesystem::path& work) {
    const YosysFolder folder(work);
    if (!folder.run(config, read_flags, elaborate(config, unit) + synth_script())) return std::nullopt;
    return parts_of_stat(folder.text("stat.json"), unit);
}

Part parts_of_stat(const std::string& stat, const std::string& top) {
    // After the modules Yosys 0.23 prints their hierarchy, which is not JSON.
    const std::size_t end = stat.find("\n   },");
    const std::string name = "stat.json of yosys",
                      text = end == std::string::npos ? stat : stat.substr(0, end) + "}}";
    const Json document = parse_json(name, text);
    const JsonValue modules = JsonValue(document, name).at("modules");
    for (const auto& [type, module] : modules.object().raw().items())
        if (module_name(type) == top) return Modules(modules).part(type);
    throw UserError("yosys counted no module rc_" + top);
}

ordered_json count_json(const Count& c) {
    return {{"luts", c.luts()}, {"lut4", c.lut4},      {"ccu2c", c.carry}, {"dpr16x4", c.ram},
            {"ff", c.ff},       {"mult18x18d", c.dsp}, {"dp16kd", c.bram}};
}

ordered_json part_json(const Part& part) {
    ordered_json json{{"name", part.name},
                      {"times", part.times},
                      {"count", count_json(part.count)},
                      {"parts", ordered_json::array()}};
    for (const Part& p : part.parts) json["parts"].push_back(part_json(p));
    return json;
}

Count count_of(const ordered_json& json) {
    const auto number = [&](const char* key) { return json.at(key).get<std::uint64_t>(); };
    return {number("lut4"), number("ccu2c"),      number("dpr16x4"),
            number("ff"),   number("mult18x18d"), number("dp16kd")};
}

Part part_of(const ordered_json& json) {
    Part part{json.at("name").get<std::string>(),
              json.at("times").get<std::uint64_t>(),
              count_of(json.at("count")),
              {}};
    for (const ordered_json& p : json.at("parts")) part.parts.push_back(part_of(p));
    return part;
}

}   // namespace rayclock::synth
