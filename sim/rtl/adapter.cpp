#include "sim/rtl/adapter.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace rayclock {

namespace {

std::string port_line(const std::string& module, const PortSpec& p) {
    const std::string& n = p.name;
    const auto line = [&](const std::string& valid, const std::string& ready, const std::string& data) {
        return fmt::format("        add(\"{}\", {}, {}, &{}, sizeof {});\n", n, valid, ready, data, data);
    };
    switch (p.kind) {
    case PortKind::in: return line("&top." + n + "_valid_i", "&top." + n + "_ready_o", "top." + n + "_i");
    case PortKind::out: return line("&top." + n + "_valid_o", "&top." + n + "_ready_i", "top." + n + "_o");
    case PortKind::fixed: return line("nullptr", "nullptr", "top." + n + "_i");
    case PortKind::listen: return line("&top." + n + "_fires_i", "nullptr", "top." + n + "_i");
    case PortKind::tap: break;
    }
    const std::string inner = "top.rootp->" + module + "__DOT__" + n;
    return line("&" + inner + "_valid", "&" + inner + "_ready", inner);
}

} // namespace

std::vector<PortSpec> ports_of(const std::string& module) {
    using enum PortKind;
    if (module == "rc_top")
        return {{"frame", fixed}, {"slot", tap}, {"ray", tap}, {"node_req", out}, {"node_rsp", in}, {"box_req", tap}, {"box_rsp", tap},
                {"prim_req", out}, {"prim_rsp", in}, {"tri_req", tap}, {"tri_rsp", tap}, {"step", tap}, {"hit", out}};
    if (module == "rc_sched") return {{"frame", fixed}, {"slot", out}, {"closest", in}, {"hit", out}};
    if (module == "rc_raygen") return {{"frame", fixed}, {"slot", in}, {"ray", out}};
    if (module == "rc_trav")
        return {{"frame", fixed}, {"ray", in}, {"step", in}, {"node_req", out}, {"node_rsp", in}, {"box_req", out}, {"done", out}};
    if (module == "rc_box" || module == "rc_tri") return {{"req", in}, {"rsp", out}};
    if (module == "rc_list")
        return {{"ray", listen}, {"box_rsp", in}, {"prim_req", out}, {"prim_rsp", in}, {"tri_req", out}, {"tri_rsp", in},
                {"step", out}, {"done", in}, {"closest", out}};
    if (module == "rc_node_cache" || module == "rc_prim_cache" || module == "rc_l2")
        return {{"req", in}, {"rsp", out}, {"miss", out}, {"fill", listen}};
    throw std::logic_error("no module of the RTL that can be built alone is called " + module);
}

std::string adapter_source(const std::string& module) {
    std::string ports;
    for (const PortSpec& p : ports_of(module)) ports += port_line(module, p);
    return fmt::format(R"(// Generated: the library's side of sim/rtl/abi.hpp for {0}.
#include <vector>
#include "Vrc.h"
#include "Vrc___024root.h"
#include "verilated.h"
#include "sim/rtl/abi.hpp"

namespace {{
struct Handle {{
    VerilatedContext context;
    Vrc top;
    std::vector<RcPort> list;
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
    of(handle).top.clk_i = static_cast<unsigned char>(clock);
    of(handle).top.eval();
    return of(handle).context.gotError();
}}
unsigned char* reset(void* handle) {{ return &of(handle).top.rst_ni; }}
unsigned ports(void* handle, const RcPort** list) {{
    *list = of(handle).list.data();
    return static_cast<unsigned>(of(handle).list.size());
}}
}}
extern "C" const RcModule rc_module{{open, close, eval, reset, ports}};
)", module, ports);
}

std::string adapter_vlt(const std::string& module) {
    std::string text = "`verilator_config\n";
    for (const PortSpec& p : ports_of(module))
        if (p.kind == PortKind::tap)
            for (const char* end : {"", "_valid", "_ready"})
                text += fmt::format("public_flat_rd -module \"{}\" -var \"{}{}\"\n", module, p.name, end);
    return text;
}

} // namespace rayclock
