// The ports of each module, and the text of the adapter.
#include "sim/run/rtl/adapter.hpp"

#include <set>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "model/machine/links.hpp"
#include "sim/run/rtl/board_ports.hpp"

namespace rayclock {

namespace {

std::string port_line(const std::string& module, const PortSpec& p) {
    const std::string& n = p.name;
    const auto line = [&](const std::string& valid, const std::string& ready, const std::string& data) {
        return fmt::format("        add(\"{}\", {}, {}, &{}, sizeof {});\n", n, valid, ready, data, data);
    };
    switch (p.kind) {
        case PortKind::in: return line("&top." + n + "_valid_i", "&top." + n + "_ready_o", "top." + n + "_i");
        case PortKind::out:
            return line("&top." + n + "_valid_o", "&top." + n + "_ready_i", "top." + n + "_o");
        case PortKind::fixed:
            return line("nullptr", "nullptr", "top." + (p.data.empty() ? n : p.data) + "_i");
        case PortKind::listen: return line("&top." + n + "_fires_i", "nullptr", "top." + n + "_i");
        case PortKind::granted:
            return line("&top." + n + "_fires_i", "&top." + n + "_ready_o", "top." + n + "_i");
        case PortKind::fires: return line("&top." + n + "_fires_o", "nullptr", "top." + n + "_o");
        case PortKind::plain:
            return line("nullptr", "nullptr", "top." + (p.data.empty() ? n : p.data) + "_o");
        case PortKind::low: return line("nullptr", "nullptr", "top." + n + "_no");
        case PortKind::low_in: return line("nullptr", "nullptr", "top." + n + "_ni");
        case PortKind::tap: break;
    }
    return fmt::format("        tap(\"{}\", \"TOP.{}{}\", \"{}\", \"{}\", \"{}\");\n", n, module, p.path,
                       p.valid, p.ready, p.data);
}

/// Returns the tap of a pipeline's link. A link of the engine is found there, under a name that is the same
/// for all node units of a level. Other links are found in rc_pipeline: at a port if one end
/// lies outside, else as a net.
PortSpec pipeline_tap(const LinkInfo& link, const Config& config, const std::string& path,
                      const std::string& index) {
    const bool inside = link.of_engine();
    const Link number = Link(&link - link_infos.data());
    const NodeUnit upper = node_unit(config.engine()), lower = node_unit(config.lower_engine());
    const std::string name = number == upper.req   ? "node_unit_req"
                             : number == upper.rsp ? "node_unit_rsp"
                             : number == lower.req ? "mesh_req"
                             : number == lower.rsp ? "mesh_rsp"
                                                   : link.name;
    const bool comes_in = !is_of_pipeline(link.from), goes_out = !is_of_pipeline(link.to);
    const std::string in = comes_in ? "_i" : goes_out ? "_o" : "", back = goes_out ? "_i" : "";
    const bool fires = link.flow == Flow::fires;
    return {link.name + index,
            PortKind::tap,
            path + (inside ? ".gen_tree.u_tree" : ""),
            inside ? "rc_tree" : "rc_pipeline",
            name + (fires ? "_fires" : "_valid") + in,
            fires ? "" : name + "_ready" + back,
            name + in};
}

/// Returns the links inside rc_chip. The memory's links are ports and not among them.
std::vector<PortSpec> taps_of_chip(const Config& config) {
    using enum PortKind;
    std::vector<PortSpec> taps;
    for (int p = 0; p < config.pipelines; ++p) {
        const std::string index = fmt::format("[{}]", p),
                          path = fmt::format(".u_top.gen_pipeline[{}].u_pipeline", p);
        for (const LinkInfo& link : link_infos)
            if (link.of_pipeline() && is_there(link.when, config))
                taps.push_back(pipeline_tap(link, config, path, index));
        for (const std::string end : {"done", "pixel"})   // ports of a ray's end
            taps.push_back({end + index, tap, path, "rc_pipeline", end + "_valid", end + "_ready", end});
    }
    if (config.l2_sets == 0) return taps;
    const std::string l2 = ".u_top.gen_shared.u_l2";
    taps.push_back({"l2_req", tap, l2, "rc_l2", "req_valid_i", "req_ready_o", "req_i"});
    taps.push_back({"l2_rsp", tap, l2, "rc_l2", "rsp_valid_o", "", "rsp_o"});
    return taps;
}

/// Returns true if the module has a reset. Arithmetic cells have none.
bool has_reset(const std::string& module) {
    return module != "rc_unit_vector" && module != "rc_power" && module != "rc_log" &&
           module != "rc_path_length" && module != "rc_tmds";
}
/// Returns true if the module has a clock. Combinational cells have none.
bool has_clock(const std::string& module) { return module != "rc_log"; }

}   // namespace

std::string module_name(const std::string& module) { return module.substr(0, module.find(' ')); }

std::vector<std::pair<std::string, std::string>> parameter_values(const std::string& module) {
    std::vector<std::pair<std::string, std::string>> values;
    std::istringstream words(module.substr(module_name(module).size()));
    for (std::string word; words >> word;) {
        const std::size_t equal = word.find('=');
        if (equal == word.npos) throw std::logic_error("no value for the parameter " + word);
        values.emplace_back(word.substr(0, equal), word.substr(equal + 1));
    }
    return values;
}

std::vector<PortSpec> ports_of(const std::string& module, const Config& config) {
    using enum PortKind;
    if (std::vector<PortSpec> ports = board_ports(module_name(module)); !ports.empty()) return ports;
    if (module == "rc_chip") {
        std::vector<PortSpec> ports = taps_of_chip(config);
        for (const char* name : {"wb_cyc", "wb_stb", "wb_we", "wb_adr", "wb_dat", "hit_ready"})
            ports.push_back({name, fixed});
        for (const char* name : {"wb_ack", "wb_err", "running", "done"}) ports.push_back({name, plain});
        ports.push_back({"wb_read", plain, "", "", "", "", "wb_dat"});
        ports.push_back({"mem_req", out});
        ports.push_back({"mem_rsp", listen});
        return ports;
    }
    if (module == "rc_host")
        return {{"wb_cyc", fixed},
                {"wb_stb", fixed},
                {"wb_we", fixed},
                {"wb_adr", fixed},
                {"wb_dat", fixed},
                {"hit_fires", fixed},
                {"counter_there", fixed},
                {"counter", fixed},
                {"wb_read", plain, "", "", "", "", "wb_dat"},
                {"wb_ack", plain},
                {"wb_err", plain},
                {"start", plain},
                {"frame", plain},
                {"count", plain},
                {"clear", plain},
                {"which", plain, "", "", "", "", "counter"},
                {"running", plain},
                {"done", plain}};
    if (module == "rc_dispatch")
        return {{"frame", fixed},      {"start", fixed}, {"tile_ready", fixed},
                {"tile_fires", plain}, {"tile", plain},  {"cause", plain}};
    if (module == "rc_sched")
        return {{"frame", fixed}, {"start", fixed}, {"tile", granted}, {"slot", out},
                {"pixel", in},    {"hit", out},     {"cause", plain}};
    if (module == "rc_raygen") return {{"frame", fixed}, {"spawn", in}, {"slot", in}, {"ray", out}};
    if (module == "rc_trav") {
        std::vector<PortSpec> ports{
            {"frame", fixed}, {"start", listen},      {"ray", in},           {"node_req", out},
            {"node_rsp", in}, {"node_unit_req", out}, {"node_unit_rsp", in}, {"leaves", PortKind::fires},
            {"tested", in},   {"done", out},          {"cause", plain},      {"node_next", listen}};
        if (config.has_instances()) ports.push_back({"xform_req", out}), ports.push_back({"change", listen});
        return ports;
    }
    if (module == "rc_xform") return {{"req", in}, {"occupied", plain}, {"change", PortKind::fires}};
    if (module == "rc_tri" || std::ranges::any_of(node_units, [&](const NodeUnit& u) {
            return module == std::string("rc_") + unit_name(u.unit);
        }))
        return {{"req", in}, {"rsp", out}};
    if (module == "rc_list") {
        std::vector<PortSpec> ports{{"start", listen}, {"ray", listen},       {"leaves", listen},
                                    {"prim_req", out}, {"prim_rsp", in},      {"tri_req", out},
                                    {"tri_rsp", in},   {"tested", out},       {"done", in},
                                    {"closest", out},  {"prim_next", listen}, {"done_next", listen}};
        if (config.has_instances()) ports.push_back({"change", listen});
        return ports;
    }
    if (module == "rc_node_cache" || module == "rc_prim_cache" || module == "rc_l2")
        return {{"req", in}, {"rsp", out}, {"miss", out}, {"fill", listen}, {"outcome", plain}};
    if (module == "rc_shade") {
        std::vector<PortSpec> ports{
            {"frame", fixed}, {"slot", listen},      {"ray", listen}, {"closest", in}, {"surf_req", out},
            {"surf_rsp", in}, {"surf_waits", fixed}, {"spawn", out},  {"pixel", out},  {"cause", plain}};
        if (config.has_textures()) ports.push_back({"tex_req", out}), ports.push_back({"tex_rsp", listen});
        return ports;
    }
    if (module == "rc_tex")
        return {{"frame", fixed},       {"req", in},
                {"texel_req", out},     {"texel_rsp", in},
                {"texels_wait", fixed}, {"rsp", PortKind::fires},
                {"cause", plain}};
    if (module == "rc_log") return {{"x", fixed}, {"log", plain}};
    if (module == "rc_path_length")
        return {{"valid", fixed}, {"s1_phase", fixed}, {"s0_path", fixed},
                {"s0_t", fixed},  {"s0_d", fixed},     {"s3_path", plain}};
    if (module == "rc_unit_vector") return {{"valid", fixed}, {"v", fixed}, {"u", plain}};
    if (module == "rc_pass") {
        std::vector<PortSpec> ports{{"frame", fixed},
                                    {"valid", fixed},
                                    {"ray", fixed},
                                    {"state", fixed},
                                    {"hit", fixed},
                                    {"o", fixed},
                                    {"d", fixed},
                                    {"surface", fixed},
                                    {"top", fixed},
                                    {"place", fixed},
                                    {"material_valid", plain},
                                    {"material_ray", plain},
                                    {"material", plain},
                                    {"end_valid", plain},
                                    {"end_ray", plain},
                                    {"end_state", plain},
                                    {"changes", plain},
                                    {"leave", plain},
                                    {"spawn", plain},
                                    {"pixel", plain},
                                    {"push", plain},
                                    {"pushed", plain}};
        if (config.has_textures()) ports.push_back({"texel", fixed}), ports.push_back({"tex_req", plain});
        return ports;
    }
    if (module == "rc_power") return {{"valid", fixed}, {"c", fixed}, {"n", fixed}, {"power", plain}};
    throw std::logic_error("no module of the RTL that can be built alone is called " + module);
}

std::string adapter_source(const std::string& module, const Config& config) {
    std::string ports;
    for (const PortSpec& p : ports_of(module, config)) ports += port_line(module, p);
    return fmt::format(
        R"(// Generated: the library's side of sim/run/rtl/abi.hpp for {0}.
#include <stdexcept>
#include <string>
#include <vector>
#include "Vrc.h"
#include "verilated.h"
#include "verilated_sym_props.h"
#include "abi.hpp"

namespace {{
struct Handle {{
    VerilatedContext context;
    Vrc top;
    std::vector<RcPort> list;
    unsigned char no_reset = 0;
    explicit Handle(int seed) : top{{prepare(context, seed)}} {{
{1}    }}
    static VerilatedContext* prepare(VerilatedContext& context, int seed) {{
        context.randReset(2);
        context.randSeed(seed);
        context.fatalOnError(false);
        return &context;
    }}
    void add(const char* name, unsigned char* valid, unsigned char* ready, void* data, unsigned bytes) {{
        list.push_back({{name, valid, ready, static_cast<unsigned*>(data), bytes}});
    }}
    /// A signal inside, wherever Verilator has put it.
    void tap(const char* name, const char* path, const char* valid, const char* ready, const char* data) {{
        const VerilatedScope* scope = context.scopeFind(path);
        const auto find = [&](const char* signal) -> VerilatedVar* {{
            VerilatedVar* var = !*signal || !scope ? nullptr : scope->varFind(signal);
            if (*signal && !var) throw std::runtime_error(std::string("no signal ") + path + "." + signal);
            return var;
        }};
        const auto flag = [&](const char* signal) -> unsigned char* {{
            VerilatedVar* var = find(signal);
            return var ? static_cast<unsigned char*>(var->datap()) : nullptr;
        }};
        VerilatedVar* var = find(data);
        add(name, flag(valid), flag(ready), var->datap(), static_cast<unsigned>(var->totalSize()));
    }}
}};
Handle& of(void* handle) {{ return *static_cast<Handle*>(handle); }}
void* open(int seed) {{ return new Handle(seed); }}
// Verilator 5.006 books assertions and scopes on the thread's context, whichever model was opened last.
void enter(void* handle) {{ Verilated::threadContextp(&of(handle).context); }}
void close(void* handle) {{
    enter(handle);
    delete &of(handle);
}}
int eval(void* handle, int clock) {{
    enter(handle);
    {3};
    of(handle).top.eval();
    return of(handle).context.gotError();
}}
unsigned char* reset(void* handle) {{ return {2}; }}
unsigned ports(void* handle, const RcPort** list) {{
    *list = of(handle).list.data();
    return static_cast<unsigned>(of(handle).list.size());
}}
}}
extern "C" const RcModule rc_module{{open, close, eval, reset, ports}};
)",
        module, ports, has_reset(module_name(module)) ? "&of(handle).top.rst_ni" : "&of(handle).no_reset",
        has_clock(module) ? "of(handle).top.clk_i = static_cast<unsigned char>(clock)" : "(void)clock");
}

std::string wave_source() {
    return R"(#include <map>
#include <memory>
#include "verilated_fst_c.h"
#include "wave_abi.hpp"
extern "C" int rc_fst_error;
namespace {
std::map<void*, std::unique_ptr<VerilatedFstC>>& waves() {
    static std::map<void*, std::unique_ptr<VerilatedFstC>> all;
    return all;
}
void begin_wave(void* handle, const char* path) {
    enter(handle);
    auto& wave = waves()[handle];
    wave = std::make_unique<VerilatedFstC>();
    of(handle).context.traceEverOn(true);
    of(handle).top.trace(wave.get(), 99);
    rc_fst_error = 0;
    wave->open(path);
}
void dump_wave(void* handle, unsigned long long time) {
    enter(handle);
    waves().at(handle)->dump(static_cast<uint64_t>(time));
}
int end_wave(void* handle) {
    enter(handle);
    waves().erase(handle);
    return rc_fst_error;
}
}
extern "C" const RcWave rc_wave{begin_wave, dump_wave, end_wave};
)";
}

std::string adapter_vlt(const std::string& module, const Config& config) {
    std::set<std::string> lines;
    for (const PortSpec& p : ports_of(module, config))
        for (const std::string& signal : {p.valid, p.ready, p.data})
            if (!signal.empty())
                lines.insert(fmt::format("public_flat_rd -module \"{}\" -var \"{}\"\n", p.module, signal));
    std::string text = "`verilator_config\n";
    for (const std::string& line : lines) text += line;
    // Pipelines share one module, so that their code is compiled once. Its names hide those of the modules
    // around it.
    if (module == "rc_chip" && config.pipelines > 1)
        text += "no_inline -module \"rc_pipeline\"\nlint_off -rule VARHIDDEN\n";
    return text;
}

}   // namespace rayclock
