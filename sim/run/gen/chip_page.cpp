// One function for each kind of table.
#include "sim/run/gen/chip_page.hpp"

#include <map>
#include <stdexcept>
#include <type_traits>

#include <fmt/format.h>

#include "model/core/parameters.hpp"
#include "model/core/payloads.hpp"
#include "model/engine/engines.hpp"
#include "sim/run/gen/description.hpp"
#include "sim/run/gen/registers.hpp"

namespace rayclock {

namespace {

/// One row for each field of a payload.
struct FieldRow {
    std::string name;
    int elements, width, at;   ///< bit position of the lowest element
    bool is_signed;
};
class RowVisitor {
public:
    explicit RowVisitor(int bits) : at_(bits) {}
    std::vector<FieldRow> rows;
    template <class T> void operator()(const char* name, const T&, int width) {
        at_ -= width;
        rows.push_back({name, 1, width, at_, std::is_signed_v<T>});
    }
    template <class T, std::size_t n>
    void operator()(const char* name, const std::array<T, n>&, int width, int count) {
        at_ -= width * count;
        rows.push_back({name, count, width, at_, std::is_signed_v<T>});
    }

private:
    int at_;
};
template <class P> std::vector<FieldRow> rows_of(const Config& config) {
    RowVisitor visitor(bits_of<P>(config));
    P{}.fields(visitor, config);
    return std::move(visitor.rows);
}

/// Returns the width for a table: "3 x 18, signed".
std::string width_text(const FieldRow& row) {
    return fmt::format("{}{}{}", row.elements > 1 ? fmt::format("{} x ", row.elements) : "", row.width,
                       row.is_signed ? ", signed" : "");
}

template <class P> std::string layout(const Config& config) {
    std::string text =
        fmt::format("{} bits.\n\n| bits | field | width |\n|---|---|---|\n", bits_of<P>(config));
    for (const FieldRow& row : rows_of<P>(config)) {
        const int top = row.at + row.elements * row.width - 1;
        text += fmt::format("| {} | {} | {} |\n",
                            top == row.at ? std::to_string(top) : fmt::format("{}..{}", top, row.at),
                            row.name, width_text(row));
    }
    return text;
}

std::string control_table() {
    std::string text = "| address | name | access | meaning |\n|---|---|---|---|\n";
    for (const HostRegister& r : host_registers())
        text += fmt::format("| 0x{:04x} | `{}` | {} | {} |\n", r.address, r.name,
                            r.access == Access::read    ? "read"
                            : r.access == Access::write ? "write"
                                                        : "read, write",
                            r.what);
    return text;
}

std::string parameter_table(const Config& config) {
    std::string text = fmt::format("| address | parameter | in `{}` |\n|---|---|---|\n", config.name);
    std::uint32_t address = parameter_base;
    for (const HostParameter& p : host_parameters(config))
        text += fmt::format("| 0x{:04x} | `{}` | {} |\n", address++, p.name, p.value);
    return text;
}

/// The codes of the registers `structure` and `mesh_structure`. Structures that one engine walks share a
/// code.
std::string structure_table() {
    std::map<int, std::string> rows;
    for (const std::string& name : names_of<Structure>()) {
        std::string& row = rows[int(Config::engine_of(choice_named<Structure>(name)))];
        row += fmt::format("{}`{}`", row.empty() ? "" : ", ", name);
    }
    std::string text = "| code | structure |\n|---|---|\n";
    for (const auto& [code, structures] : rows) text += fmt::format("| {} | {} |\n", code, structures);
    return text;
}

std::string frame_table(const Config& config) {
    std::string text = "| address | field | width | words |\n|---|---|---|---|\n";
    std::uint32_t address = frame_base;
    for (const FieldRow& row : rows_of<Frame>(config)) {
        const int words = row.elements * ((row.width + 31) / 32);
        text += fmt::format("| 0x{:04x} | `{}` | {} | {} |\n", address, row.name, width_text(row), words);
        address += std::uint32_t(words);
    }
    return text;
}

std::string counter_table() {
    std::string text = "| unit | group | number | causes, from code 0 |\n|---|---|---|---|\n";
    for (std::size_t u = 0; u < pipeline_units + shared_units; ++u) {
        const bool shared = u >= pipeline_units;
        std::string causes;
        for (const Cause& cause : unit_infos[u].causes) {
            if (cause.kind == CauseKind::none) continue;
            const char* kind = cause.kind == CauseKind::busy      ? "busy: "
                               : cause.kind == CauseKind::starved ? "starved by "
                                                                  : "stalled by ";
            causes += fmt::format("{}{}{}", causes.empty() ? "" : "; ", kind, cause.name);
        }
        text += fmt::format("| {} | {} | {} | {} |\n", unit_infos[u].name, shared ? "0" : "p + 1",
                            shared ? u - pipeline_units : u, causes);
    }
    return text;
}

/// Every parameter: legal values, its value in each named configuration ("=": as in `default`), when it
/// matters.
std::string configuration_tables() {
    std::vector<Config> configs;
    std::string head = "\n| parameter | values |", line = "|---|---|", text;
    for (const std::string& name : config_names()) {
        configs.push_back(named_config(name));
        head += " " + name + " |", line += "---|";
    }
    head += " only with | meaning |\n" + line + "---|---|\n";
    const char* group = "";
    for (const Parameter& p : parameters()) {
        if (p.group != group)
            text += fmt::format("{}**{}**\n{}", text.empty() ? "" : "\n", group = p.group, head);
        const std::string usual = value_text(configs[0], p);
        text += fmt::format("| `{}` | {} | {} |", p.key, range_text(p), usual);
        for (std::size_t i = 1; i < configs.size(); ++i) {
            const std::string value = value_text(configs[i], p);
            text += " " + (value == usual ? "=" : value) + " |";
        }
        text += fmt::format(" {} | {} |\n", p.effect->words, p.meaning);
    }
    return text;
}

/// `default`, with every unit that a finished picture may need.
Config shaded() {
    Config c = named_config("default");
    c.shading = c.spheres = c.planes = c.smooth = c.refraction = c.supersampling = 1;
    return c;
}

/// `default`, for a stream of rays whose hits it writes.
Config streaming() {
    Config c = named_config("default");
    c.shading = c.pixel_writes = true;
    c.source = RaySource::stream;
    return c;
}

std::map<std::string, std::string> tables() {
    const Config plain = named_config("default"), all = shaded(), streams = streaming();
    std::map<std::string, std::string> tables{{"configurations", configuration_tables()},
                                              {"registers", control_table()},
                                              {"parameters", parameter_table(plain)},
                                              {"structures", structure_table()},
                                              {"frame", frame_table(plain)},
                                              {"frame that is shaded", frame_table(all)},
                                              {"counters", counter_table()},
                                              {"mem_req_t", layout<MemReq>(plain)},
                                              {"mem_req_t that writes", layout<MemReq>(streams)},
                                              {"hit_record_t", layout<HitRecord>(streams)},
                                              {"mem_rsp_t", layout<MemRsp>(plain)},
                                              {"hit_t", layout<HitOut>(plain)},
                                              {"hit_t that is shaded", layout<HitOut>(all)},
                                              {"instance", layout<Placement>(plain)},
                                              {"primitive", layout<PrimData>(plain)},
                                              {"primitive of several kinds", layout<PrimData>(all)},
                                              {"surface", layout<Surface>(all)},
                                              {"units", units_table()},
                                              {"links", links_table()},
                                              {"diagram of links", links_diagram()}};
    for_each_engine([&]<class E>(E) { tables[E::node_name] = layout<typename E::Node>(plain); });
    return tables;
}

}   // namespace

std::string with_tables(const std::string& page) {
    const std::string open = "<!-- made: ", close = " -->\n", end = "<!-- end -->";
    const std::map<std::string, std::string> all = tables();
    std::string text;
    std::size_t at = 0;
    for (std::size_t mark; (mark = page.find(open, at)) != std::string::npos;) {
        const std::size_t name_at = mark + open.size(), name_end = page.find(close, name_at),
                          last = page.find(end, name_at);
        if (name_end == std::string::npos || last == std::string::npos)
            throw std::logic_error("a table of the page has no end");
        const auto table = all.find(page.substr(name_at, name_end - name_at));
        if (table == all.end())
            throw std::logic_error("no table is called " + page.substr(name_at, name_end - name_at));
        text += page.substr(at, name_end + close.size() - at) + "\n" + table->second + "\n";
        at = last;
    }
    return text + page.substr(at);
}

}   // namespace rayclock
