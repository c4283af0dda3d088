// Counts multipliers and flip-flops of a pipeline with Yosys.
#include "sim/silicon/synth/netlist.hpp"

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "sim/files/cache/results.hpp"
#include "sim/run/frame/frame.hpp"
#include "sim/run/gen/rc_pkg.hpp"
#include "sim/run/rtl/builder.hpp"
#include "sim/silicon/synth/stat.hpp"
#include "sim/silicon/synth/yosys.hpp"

namespace rayclock::synth {

namespace fs = std::filesystem;

namespace {

// The multiplier steps of synth_ecp5. Products that are never needed in the same cycle share a multiplier.
// The script searches them within each module before it flattens the design. That finds the same products in
// a thirtieth of the time. Bits of registers that are constant, unused or part of a memory's port are not
// counted. `stat` counts at the end.
constexpr const char* script = R"(hierarchy -check -top rc_pipeline
proc
opt_expr
opt_clean
wreduce t:$mul
opt_clean
share t:$mul
flatten
opt -fast
techmap -map +/mul2dsp.v -map +/ecp5/dsp_map.v -D DSP_A_MAXWIDTH=18 -D DSP_B_MAXWIDTH=18 -D DSP_A_MINWIDTH=2 -D DSP_B_MINWIDTH=2 -D DSP_NAME=$__MUL18X18
memory -nomap
opt_clean
tee -q -o stat.json stat -width -json
)";

}   // namespace

bool exists_in_rtl(const Config& config) {
    try {
        check_rtl(config);
        return true;
    } catch (const UserError&) {
        return false;
    }
}

std::string netlist_key(const Config& config) {
    return fmt::format("package {} rtl {} script {} {} pipelines {}", results::hash_text(rc_package(config)),
                       rtl_digest(), results::hash_text(script), yosys_version(), config.pipelines);
}

std::optional<Netlist> count_netlist(const Config& config, const fs::path& work) {
    const YosysFolder folder(work);
    if (!folder.run(config, "", script)) return std::nullopt;
    Netlist counts = counts_of(folder.text("stat.json"));
    counts.multipliers *= std::uint64_t(config.pipelines);
    counts.flip_flops *= std::uint64_t(config.pipelines);
    return counts;
}

}   // namespace rayclock::synth
