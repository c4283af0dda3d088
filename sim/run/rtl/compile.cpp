// Calling Verilator, the C++ compiler and the linker, with their flags.
#include "sim/run/rtl/compile.hpp"

#include <algorithm>
#include <chrono>
#include <sstream>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "model/base/stopwatch.hpp"
#include "sim/files/cache/libraries.hpp"
#include "sim/files/input.hpp"
#include "sim/files/process/process.hpp"
#include "sim/files/process/tools.hpp"
#include "sim/run/gen/rc_pkg.hpp"
#include "sim/run/rtl/adapter.hpp"
#include "sim/run/rtl/gates.hpp"
#include "sim/run/rtl/sources.hpp"

namespace rayclock {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

// The texts of sim/run/rtl/abi.hpp, wave_abi.hpp and sim/view/wave/fst_io.h.
extern const char *const abi_text, *const wave_abi_text, *const fst_io_text;

namespace {

// --x-assign/--x-initial unique: registers without reset start at seeded random values.
const Arguments verilator_flags{"--cc",   "-Wall",       "--assert", "-O3",      "--x-assign",
                                "unique", "--x-initial", "unique",   "--prefix", "Vrc"};
/// Returns the compiler's flags, with those of RAYCLOCK_CXXFLAGS split at blanks.
Arguments compiler_flags() {
    Arguments words{"-std=c++17", "-O2", "-fPIC", "-fvisibility=default", "-w"};
    std::istringstream rest(added_flags());
    for (std::string word; rest >> word;) words.push_back(word);
    return words;
}
// A netlist has many unused pins, so lint and style warnings are off. UNOPTFLAT takes a vector for a loop if
// one of its bits depends on another; a true loop would not settle in the simulation. Other warnings still
// count. A netlist is simulated for some thousand cycles, and -O1 compiles its many lines in half the time.
const Arguments netlist_verilator_flags{"-Wno-lint", "-Wno-style", "-Wno-UNOPTFLAT"},
    netlist_compiler_flags{"-O1"};
// Code that runs once, at the start of a simulation, compiles in a third of the time without optimisation.
const Arguments start_flags{"-O0"};
// A small module is one source, since all parts read the same headers. A medium module has its start code in
// a second source. A large one, the whole chip, is divided into sources that are compiled at the same time.
constexpr std::uintmax_t small_module = 200'000, large_module = 2'000'000;
// The limit covers the widest payloads; memories are left out. The code that writes signals is as large as
// the chip itself and runs for only a thousand cycles, so it is not optimised.
const Arguments wave_verilator_flags{"--trace-fst", "--trace-max-width", "2048", "--trace-max-array", "64"};
const Arguments wave_compiler_flags{"-O0"};
// A user waits for this build after the first divergence, and it mostly runs for less time than it takes to
// build.
const Arguments tracing{"-DVM_TRACE=1", "-DVM_TRACE_FST=1", "-O1"};

Arguments operator+(Arguments words, const Arguments& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

/// Returns the arguments that select the top module and set its parameters.
Arguments top_module(const std::string& module) {
    Arguments words{"--top-module", module_name(module)};
    for (const auto& [name, value] : parameter_values(module)) words.push_back("-G" + name + "=" + value);
    return words;
}

void verilate(const fs::path& folder, const Config& config, const std::string& module, Waves waves,
              const fs::path& netlist, const std::function<void()>& meanwhile) {
    Arguments files{"gates.vlt", "netlist.v"};
    if (netlist.empty()) {
        files = stage_sources(folder, config, module);
    } else {
        fs::copy_file(netlist, folder / "netlist.v");
        write_text(folder / "gates.vlt", gates_vlt());
    }
    write_text(folder / "taps.vlt", adapter_vlt(module, config));
    const Arguments words =
        Arguments{"verilator"} + verilator_flags + (netlist.empty() ? Arguments{} : netlist_verilator_flags) +
        (waves == Waves::yes ? wave_verilator_flags : Arguments{}) +
        (netlist.empty() ? top_module(module) : Arguments{"--top-module", module_name(module)}) +
        Arguments{"--Mdir", "obj", "taps.vlt"} + files;
    const std::string what = fmt::format("verilator on {} of {}{}", module_name(module),
                                         rtl_sources().string(), replacements_text());
    run_tools(folder, {{words, "verilator.log"}}, what, meanwhile);
    if (const std::string log = read_if_there(folder / "verilator.log");
        log.find("%Warning") != std::string::npos)
        throw std::runtime_error("verilator -Wall warns about " + module + ":\n" + log.substr(0, 2000));
}

struct Source {
    std::string name, text;
    Arguments flags;
};
Source support_source(Waves waves) {
    const char* const text = "#include \"verilated.cpp\"\n#include \"verilated_threads.cpp\"\n";
    if (waves == Waves::no) return {"support", text, {}};
    // fst_io.h defines macros for the last file alone, so all headers that this file includes go before it.
    const std::string headers =
        "#include <algorithm>\n#include <iterator>\n#include <sstream>\n"
        "#include <list>\n#include <fstream>\n"
        "#include \"verilated_intrinsics.h\"\n#include \"verilated_fst_c.h\"\n";
    return {"support", text + headers + fst_io_text + "#include \"verilated_fst_c.cpp\"\n", tracing};
}

/// Returns the sources that include Verilator's output: one, or several of about the same size, and one for
/// the start code. The code that writes waveforms is a source of its own.
std::vector<Source> divided(const fs::path& folder, const Config& config, const std::string& module,
                            Waves waves, Form form) {
    const Arguments flags = (waves == Waves::yes ? tracing : Arguments{}) +
                            (form == Form::netlist ? netlist_compiler_flags : Arguments{});
    Source wave{"wave", "#include \"verilated_fst_c.h\"\n", tracing + wave_compiler_flags};
    std::vector<std::pair<std::uintmax_t, std::string>> made;
    std::uintmax_t all = 0;
    for (const auto& entry : fs::directory_iterator(folder / "obj")) {
        const std::string file = entry.path().filename();
        if (entry.path().extension() != ".cpp") continue;
        if (file.find("__Trace") != std::string::npos) {
            wave.text += fmt::format("#include \"{}\"\n", file);
            continue;
        }
        made.emplace_back(entry.file_size(), file);
        all += entry.file_size();
    }
    std::sort(made.rbegin(), made.rend());   // large ones first
    const bool small = all < small_module;
    std::vector<Source> sources;
    for (std::size_t i = 0; i < (all < large_module ? 1 : 2); ++i)
        sources.push_back({fmt::format("part{}", i), i == 0 ? adapter_source(module, config) : "", flags});
    Source start{"start", "", flags + start_flags};
    if (waves == Waves::yes) sources[0].text += wave_source();
    std::vector<std::uintmax_t> sizes(sources.size());
    for (const auto& [size, file] : made) {
        const std::size_t part = std::size_t(std::min_element(sizes.begin(), sizes.end()) - sizes.begin());
        // Verilator's name for code that runs once at the start.
        const bool once = !small && file.find("__Slow") != std::string::npos;
        (once ? start : sources[part]).text += fmt::format("#include \"{}\"\n", file);
        if (!once) sizes[part] += size;
    }
    // Link it last: if several objects define a function, the linker takes the first.
    if (!small) sources.push_back(start);
    if (waves == Waves::yes) sources.push_back(wave);
    return sources;
}

void compile(const fs::path& folder, const std::vector<Source>& sources, const std::string& what,
             const std::function<void()>& meanwhile) {
    const std::string include = rtl_tools().verilator_root + "/include";
    const Arguments common = Arguments{"c++"} + compiler_flags() +
                             Arguments{"-I.", "-Iobj", "-I" + include, "-I" + include + "/vltstd", "-c"};
    std::vector<ToolJob> jobs;
    for (const auto& [name, text, flags] : sources) {
        write_text(folder / (name + ".cpp"), text);
        jobs.push_back({common + flags + Arguments{name + ".cpp", "-o", name + ".o"}, name + ".log"});
    }
    run_tools(folder, jobs, what, meanwhile);
}

void link(const fs::path& folder, const std::vector<Source>& sources, const std::string& what,
          const Arguments& others, const std::function<void()>& meanwhile) {
    Arguments words{"c++", "-shared"};
    for (const Source& source : sources) words.push_back(source.name + ".o");
    words = words + others;
    // Clang calls a function of that library where GCC uses an instruction.
    if (rtl_tools().compiler.find("clang") != std::string::npos) words.push_back("-latomic");
    run_tools(folder, {{words + Arguments{"-o", "module.so"}, "linker.log"}}, what, meanwhile);
}

}   // namespace

std::string build_inputs(const Config& config, const std::string& module, Waves waves, Form form) {
    std::string all =
        rc_package(config) + adapter_source(module, config) + adapter_vlt(module, config) + abi_text;
    const auto add = [&](const std::vector<Arguments>& flags) {
        for (const Arguments& some : flags)
            for (const std::string& flag : some) all += " " + flag;
    };
    for (const auto& [name, value] : parameter_values(module)) all += " " + name + "=" + value;
    add({verilator_flags, compiler_flags(), start_flags});
    if (form == Form::rtl) {
        all += source_inputs(module);
    } else {
        all += gates_inputs(config, module) + gates_vlt();
        add({netlist_verilator_flags, netlist_compiler_flags});
    }
    if (waves == Waves::no) return all;
    all += wave_source() + wave_abi_text;
    add({wave_verilator_flags, wave_compiler_flags, tracing});
    return all;
}

std::string support_inputs(Waves waves) {
    std::string all;
    for (const Arguments& flags : {compiler_flags(), support_source(waves).flags})
        for (const std::string& flag : flags) all += " " + flag;
    return waves == Waves::no ? all : all + fst_io_text;
}

void make_support(const fs::path& folder, Waves waves, const Working& working) {
    compile(folder, {support_source(waves)}, "the C++ compiler on Verilator's own sources",
            [&] { working("the C++ compiler", {}); });
    tidy(folder, library_of(folder));
}

void make_library(const fs::path& folder, const Config& config, const std::string& module, Waves waves,
                  const fs::path& support, const fs::path& netlist, const Working& working) {
    // The compiler takes about this many times as long as Verilator, on any machine (docs/decisions/rtl.md).
    constexpr double compiler_share = 3;
    const Stopwatch verilating;
    verilate(folder, config, module, waves, netlist, [&] { working("Verilator", {}); });
    const double expected = verilating.seconds() * compiler_share;
    const Stopwatch compiling;
    const auto meanwhile = [&] {
        working("the C++ compiler", std::max(0.0, expected - compiling.seconds()));
    };
    const std::string what = "the C++ compiler on the verilated " + module_name(module);
    write_text(folder / "abi.hpp", abi_text);
    if (waves == Waves::yes) write_text(folder / "wave_abi.hpp", wave_abi_text);
    const std::vector<Source> sources =
        divided(folder, config, module, waves, netlist.empty() ? Form::rtl : Form::netlist);
    compile(folder, sources, what, meanwhile);
    fs::copy_file(support, folder / support_name);
    link(folder, sources, what, waves == Waves::no ? Arguments{support_name} : Arguments{support_name, "-lz"},
         meanwhile);
    tidy(folder, library_of(folder));
}

std::string lint_library(const fs::path& folder, const Config& config, const std::string& module) {
    const Arguments files = stage_sources(folder, config, module);
    Process lint({Arguments{"verilator", "--lint-only", "-Wall"} + top_module(module) + files, folder,
                  folder / "lint.log", folder});
    lint.wait("interrupted: nothing is written");
    // Newer versions of Verilator add a report in lines that begin with a dash.
    std::istringstream log(read_if_there(folder / "lint.log"));
    std::string found;
    for (std::string line; std::getline(log, line);)
        if (!line.starts_with("- ")) found += (found.empty() ? "" : "\n") + line;
    return found;
}

}   // namespace rayclock
