#include "sim/rtl/compile.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/stopwatch.hpp"
#include "sim/files/input.hpp"
#include "sim/gen/rc_pkg.hpp"
#include "sim/rtl/adapter.hpp"
#include "sim/rtl/cache.hpp"
#include "sim/rtl/interrupt.hpp"
#include "sim/rtl/process.hpp"
#include "sim/rtl/sources.hpp"
#include "sim/rtl/tools.hpp"

namespace rayclock {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

extern const char *const abi_text, *const wave_abi_text;   // sim/rtl/abi.hpp, wave_abi.hpp

namespace {

// --x-assign/--x-initial unique: registers without reset start at seeded random values.
const Words verilator_flags{"--cc",   "-Wall",       "--assert", "-O3",      "--x-assign",
                            "unique", "--x-initial", "unique",   "--prefix", "Vrc"};
std::string added_flags() {
    const char* const added = std::getenv("RAYCLOCK_CXXFLAGS");
    return added ? added : "";
}
/// With what is added, as a shell would divide it without quotes.
Words compiler_flags() {
    Words words{"-std=c++17", "-O2", "-fPIC", "-fvisibility=default", "-w"};
    std::istringstream rest(added_flags());
    for (std::string word; rest >> word;) words.push_back(word);
    return words;
}
// What runs once, at a simulation's start, compiles in a third of the time without optimising.
const Words start_flags{"-O0"};
// A small module is one source, since each reads the same headers; what starts a middling one is compiled
// apart. A large one, the whole chip, is divided, and its sources are compiled at the same time.
constexpr std::uintmax_t small_module = 200'000, large_module = 2'000'000;
// The widest payloads and a little beyond; memories are left out. What writes signals is as large as the chip
// itself, runs for a thousand cycles only, and is therefore not optimised.
const Words wave_verilator_flags{"--trace-fst", "--trace-max-width", "2048", "--trace-max-array", "64"};
const Words wave_compiler_flags{"-O0"};
// It is built while somebody waits for the first divergence, and mostly runs for less than it takes to build.
const Words tracing{"-DVM_TRACE=1", "-DVM_TRACE_FST=1", "-O1"};

Words operator+(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

/// The tools' own words, or the cause if they are known for it.
[[noreturn]] void failed(const std::string& what, const fs::path& folder, const std::string& log) {
    if (log.find("No space left on device") != std::string::npos)
        throw UserError(folder.parent_path().string() +
                        ": no space is left for the RTL; set RAYCLOCK_CACHE to a folder with more");
    if (const std::size_t error = log.find("error: ");
        error != log.npos && what.starts_with("the C++ compiler") && !added_flags().empty())
        throw UserError(fmt::format("RAYCLOCK_CXXFLAGS={}: the C++ compiler says: {}",
                                    printable(added_flags()),
                                    printable(log.substr(error, log.find('\n', error) - error))));
    throw std::runtime_error(what + " failed:\n" + log.substr(0, 2000));
}

/// Runs commands at the same time in a folder, each with its output in a log there. The first that fails ends
/// all others.
struct Job {
    Words words;
    std::string log;
};
void run(const fs::path& folder, const std::vector<Job>& jobs, const std::string& what,
         const std::function<void()>& meanwhile) {
    std::vector<std::unique_ptr<Process>> running;
    for (const Job& job : jobs)
        running.push_back(std::make_unique<Process>(Launch{job.words, folder, folder / job.log, folder}));
    for (std::size_t left = jobs.size(); left > 0;) {
        for (std::size_t i = 0; i < jobs.size(); ++i) {
            if (!running[i] || !running[i]->ended()) continue;
            if (running[i]->code() != 0) failed(what, folder, read_if_there(folder / jobs[i].log));
            running[i].reset();
            --left;
        }
        if (interrupted()) throw std::runtime_error("interrupted while RTL was built: nothing of it is kept");
        if (meanwhile) meanwhile();
        if (left > 0) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
}

/// Copies of the sources, under names that no tool trips over, in a folder that tools are run in: they see no
/// path of the user's. Returns the names that Verilator is given.
Words stage_sources(const fs::path& folder, const Config& config) {
    Words files;
    for (const RtlText& source : rtl_texts()) {
        const fs::path copy = folder / "rtl" / source.name;
        fs::create_directories(copy.parent_path());
        write_text(copy, source.text);
        files.push_back("rtl/" + source.name);
    }
    write_text(folder / "rtl/rc_pkg.sv", rc_package(config));
    files.insert(files.begin() + 1, "rtl/rc_pkg.sv");   // after the waivers
    return files;
}

void verilate(const fs::path& folder, const Config& config, const std::string& module, Waves waves,
              const std::function<void()>& meanwhile) {
    const Words files = stage_sources(folder, config);
    write_text(folder / "taps.vlt", adapter_vlt(module, config));
    const Words words = Words{"verilator"} + verilator_flags +
                        (waves == Waves::yes ? wave_verilator_flags : Words{}) +
                        Words{"--top-module", module, "--Mdir", "obj", "taps.vlt"} + files;
    const std::string what = fmt::format("verilator on {} of {}", module, rtl_sources().string());
    run(folder, {{words, "verilator.log"}}, what, meanwhile);
    if (const std::string log = read_if_there(folder / "verilator.log");
        log.find("%Warning") != std::string::npos)
        throw std::runtime_error("verilator -Wall warns about " + module + ":\n" + log.substr(0, 2000));
}

struct Source {
    std::string name, text;
    Words flags;
};
Source support_source(Waves waves) {
    const char* const text = "#include \"verilated.cpp\"\n#include \"verilated_threads.cpp\"\n";
    if (waves == Waves::no) return {"support", text, {}};
    return {"support", std::string(text) + "#include \"verilated_fst_c.cpp\"\n", tracing};
}

/// Sources that include what Verilator has made: one, or some of about the same size and one for the start.
/// What writes waveforms comes in a source of its own.
std::vector<Source> divided(const fs::path& folder, const Config& config, const std::string& module,
                            Waves waves) {
    const Words flags = waves == Waves::yes ? tracing : Words{};
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
        const bool once = !small && file.find("__Slow") != std::string::npos;   // Verilator's name for it
        (once ? start : sources[part]).text += fmt::format("#include \"{}\"\n", file);
        if (!once) sizes[part] += size;
    }
    // It is linked last: of a function that stands in several the linker takes the first.
    if (!small) sources.push_back(start);
    if (waves == Waves::yes) sources.push_back(wave);
    return sources;
}

void compile(const fs::path& folder, const std::vector<Source>& sources, const std::string& what,
             const std::function<void()>& meanwhile) {
    const std::string include = rtl_tools().verilator_root + "/include";
    const Words common = Words{"c++"} + compiler_flags() +
                         Words{"-I.", "-Iobj", "-I" + include, "-I" + include + "/vltstd", "-c"};
    std::vector<Job> jobs;
    for (const auto& [name, text, flags] : sources) {
        write_text(folder / (name + ".cpp"), text);
        jobs.push_back({common + flags + Words{name + ".cpp", "-o", name + ".o"}, name + ".log"});
    }
    run(folder, jobs, what, meanwhile);
}

void link(const fs::path& folder, const std::vector<Source>& sources, const std::string& what,
          const Words& others, const std::function<void()>& meanwhile) {
    Words words{"c++", "-shared"};
    for (const Source& source : sources) words.push_back(source.name + ".o");
    words = words + others;
    // Clang calls a function of that library where GCC has an instruction.
    if (rtl_tools().compiler.find("clang") != std::string::npos) words.push_back("-latomic");
    run(folder, {{words + Words{"-o", "module.so"}, "linker.log"}}, what, meanwhile);
}

/// Leaves the library alone.
void tidy(const fs::path& folder) {
    std::vector<fs::path> rest;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path() != library_of(folder)) rest.push_back(entry.path());
    for (const fs::path& path : rest) fs::remove_all(path);
}

}   // namespace

std::string ingredients(const Config& config, const std::string& module, Waves waves) {
    std::string all =
        rc_package(config) + adapter_source(module, config) + adapter_vlt(module, config) + abi_text;
    for (const Words& flags : {verilator_flags, compiler_flags(), start_flags})
        for (const std::string& flag : flags) all += " " + flag;
    for (const RtlText& source : rtl_texts()) all += "\n" + source.name + "\n" + source.text;
    if (waves == Waves::no) return all;
    all += wave_source() + wave_abi_text;
    for (const Words& flags : {wave_verilator_flags, wave_compiler_flags, tracing})
        for (const std::string& flag : flags) all += " " + flag;
    return all;
}

std::string support_ingredients(Waves waves) {
    std::string all;
    for (const Words& flags : {compiler_flags(), support_source(waves).flags})
        for (const std::string& flag : flags) all += " " + flag;
    return all;
}

void make_support(const fs::path& folder, Waves waves, const Working& working) {
    compile(folder, {support_source(waves)}, "the C++ compiler on Verilator's own sources",
            [&] { working("the C++ compiler", {}); });
    tidy(folder);
}

void make_library(const fs::path& folder, const Config& config, const std::string& module, Waves waves,
                  const fs::path& support, const Working& working) {
    // The compiler takes about this many times as long as Verilator, on any machine (docs/decisions.md).
    constexpr double compiler_share = 3;
    const Stopwatch verilating;
    verilate(folder, config, module, waves, [&] { working("Verilator", {}); });
    const double expected = verilating.seconds() * compiler_share;
    const Stopwatch compiling;
    const auto meanwhile = [&] {
        working("the C++ compiler", std::max(0.0, expected - compiling.seconds()));
    };
    const std::string what = "the C++ compiler on the verilated " + module;
    write_text(folder / "abi.hpp", abi_text);
    if (waves == Waves::yes) write_text(folder / "wave_abi.hpp", wave_abi_text);
    const std::vector<Source> sources = divided(folder, config, module, waves);
    compile(folder, sources, what, meanwhile);
    fs::copy_file(support, folder / support_name);
    link(folder, sources, what, waves == Waves::no ? Words{support_name} : Words{support_name, "-lz"},
         meanwhile);
    tidy(folder);
}

std::string lint_library(const fs::path& folder, const Config& config, const std::string& module) {
    const Words files = stage_sources(folder, config);
    Process lint({Words{"verilator", "--lint-only", "-Wall", "--top-module", module} + files, folder,
                  folder / "lint.log", folder});
    while (!lint.ended()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    // Newer versions add a report on themselves, in lines that begin with a dash.
    std::istringstream log(read_if_there(folder / "lint.log"));
    std::string found;
    for (std::string line; std::getline(log, line);)
        if (!line.starts_with("- ")) found += (found.empty() ? "" : "\n") + line;
    return found;
}

}   // namespace rayclock
