#include "sim/rtl/compile.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <sstream>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "model/base/error.hpp"
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
const Words compiler_flags{"-std=c++17", "-O2", "-fPIC", "-fvisibility=default", "-w"};
// The widest payloads and a little beyond; memories are left out. What writes signals is as large as the chip
// itself, runs for a thousand cycles only, and is therefore not optimised.
const Words wave_verilator_flags{"--trace-fst", "--trace-max-width", "2048", "--trace-max-array", "64"};
const Words wave_compiler_flags{"-O0"};
constexpr std::size_t parts = 2;                      // compiled at the same time
constexpr std::uintmax_t support_bytes = 1'100'000;   // Verilator's own sources take as long as so much of
                                                      // what it makes

Words operator+(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

/// The tools' own words, or the cause if they are known for it.
[[noreturn]] void failed(const std::string& what, const fs::path& folder, const std::string& log) {
    if (log.find("No space left on device") != std::string::npos)
        throw UserError(folder.parent_path().string() +
                        ": no space is left for the RTL; set RAYCLOCK_CACHE to a folder with more");
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
        running.push_back(std::make_unique<Process>(Command{job.words, folder, folder / job.log, folder}));
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

/// Sources that include what Verilator has made, as many as are compiled at a time, and about as long each.
/// What writes waveforms comes in a part of its own.
void write_parts(const fs::path& folder, const Config& config, const std::string& module, Waves waves) {
    std::vector<std::pair<std::uintmax_t, std::string>> made;
    std::string wave_part;
    for (const auto& entry : fs::directory_iterator(folder / "obj")) {
        const std::string file = entry.path().filename();
        if (entry.path().extension() != ".cpp") continue;
        if (file.find("__Trace") == std::string::npos)
            made.emplace_back(entry.file_size(), file);
        else
            wave_part += fmt::format("#include \"{}\"\n", file);
    }
    std::sort(made.rbegin(), made.rend());   // large ones first
    std::array<std::string, parts> texts{adapter_source(module, config)};
    if (waves == Waves::yes) texts[0] += wave_source();
    std::array<std::uintmax_t, parts> sizes{support_bytes};
    for (const auto& [size, file] : made) {
        const std::size_t part = std::size_t(std::min_element(sizes.begin(), sizes.end()) - sizes.begin());
        sizes[part] += size;
        texts[part] += fmt::format("#include \"{}\"\n", file);
    }
    for (const char* part : {"verilated", "verilated_threads"})
        texts[0] += fmt::format("#include \"{}.cpp\"\n", part);
    for (std::size_t i = 0; i < parts; ++i) write_text(folder / fmt::format("part{}.cpp", i), texts[i]);
    write_text(folder / "abi.hpp", abi_text);
    if (waves == Waves::no) return;
    write_text(folder / "wave.cpp", "#include \"verilated_fst_c.cpp\"\n" + wave_part);
    write_text(folder / "wave_abi.hpp", wave_abi_text);
}

void compile(const fs::path& folder, const std::string& module, Waves waves,
             const std::function<void()>& meanwhile) {
    const std::string include = rtl_tools().verilator_root + "/include",
                      what = "the C++ compiler on the verilated " + module;
    const Words common = Words{"c++"} + compiler_flags +
                         Words{"-I.", "-Iobj", "-I" + include, "-I" + include + "/vltstd", "-c"};
    const bool writes_waves = waves == Waves::yes;
    std::vector<Job> jobs;
    Words link = Words{"c++", "-shared"};
    const auto add = [&](const std::string& part, const Words& flags) {
        jobs.push_back({common + flags + Words{part + ".cpp", "-o", part + ".o"}, part + ".log"});
        link.push_back(part + ".o");
    };
    const Words tracing = writes_waves ? Words{"-DVM_TRACE=1", "-DVM_TRACE_FST=1"} : Words{};
    for (std::size_t i = 0; i < parts; ++i) add(fmt::format("part{}", i), tracing);
    if (writes_waves) {
        add("wave", tracing + wave_compiler_flags);
        link.push_back("-lz");
    }
    run(folder, jobs, what, meanwhile);
    // Clang calls a function of that library where GCC has an instruction.
    if (rtl_tools().compiler.find("clang") != std::string::npos) link.push_back("-latomic");
    run(folder, {{link + Words{"-o", "module.so"}, "linker.log"}}, what, meanwhile);
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
    for (const Words& flags : {verilator_flags, compiler_flags})
        for (const std::string& flag : flags) all += " " + flag;
    for (const RtlText& source : rtl_texts()) all += "\n" + source.name + "\n" + source.text;
    if (waves == Waves::no) return all;
    all += wave_source() + wave_abi_text;
    for (const Words& flags : {wave_verilator_flags, wave_compiler_flags})
        for (const std::string& flag : flags) all += " " + flag;
    return all;
}

void make_library(const fs::path& folder, const Config& config, const std::string& module, Waves waves,
                  const Working& working) {
    // The compiler takes about this many times as long as Verilator, on any machine (docs/decisions.md).
    constexpr double compiler_share = 6;
    const Stopwatch verilating;
    verilate(folder, config, module, waves, [&] { working("Verilator", {}); });
    const double expected = verilating.seconds() * compiler_share;
    write_parts(folder, config, module, waves);
    const Stopwatch compiling;
    compile(folder, module, waves,
            [&] { working("the C++ compiler", std::max(0.0, expected - compiling.seconds())); });
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
