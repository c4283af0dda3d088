// The steps of a build, and their entries in the cache.
#include "sim/run/rtl/builder.hpp"

#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/interrupted.hpp"
#include "model/base/stopwatch.hpp"
#include "sim/files/cache/hash.hpp"
#include "sim/files/process/interrupt.hpp"
#include "sim/files/process/tools.hpp"
#include "sim/files/scratch.hpp"
#include "sim/run/rtl/adapter.hpp"
#include "sim/run/rtl/compile.hpp"
#include "sim/run/rtl/gates.hpp"

namespace rayclock {

namespace fs = std::filesystem;

namespace {

std::atomic<Form> form{Form::rtl};

std::mutex reporter_mutex;
std::function<void(const BuildStep&)> reporter;

/// Reports the progress of one build.
class Report {
public:
    explicit Report(std::string what) : what_(std::move(what)) {}
    Report(const Report&) = delete;
    ~Report() {
        if (told_) update("", {});
    }
    double seconds() const { return watch_.seconds(); }
    void update(const char* stage, std::optional<double> left) {
        told_ = true;
        const std::lock_guard lock(reporter_mutex);
        if (reporter) reporter({what_, stage, seconds(), left});
    }

private:
    std::string what_;
    Stopwatch watch_;
    bool told_ = false;
};

/// Waits while another program builds the same entry. Throws Interrupted after Ctrl-C.
void take(BuildLock& lock, Report& report) {
    while (!lock.take()) {
        if (interrupted()) throw Interrupted("interrupted while another program built the RTL");
        report.update("another program builds it", {});
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
}

/// Returns the beginning of an entry's name, a hash of the inputs. A hash of the tools follows it.
std::string entry_begin(const Config& config, const std::string& module, Waves waves) {
    return fmt::format("{}-{:016x}-", module_name(module),
                       hash_of(build_inputs(config, module, waves, form)));
}

std::string made_by() {
    const RtlTools& tools = rtl_tools();
    const std::string all =
        fmt::format("verilator {}, {}\ncompiler {}\n", tools.verilator, tools.verilator_root, tools.compiler);
    return form == Form::rtl ? all : all + fmt::format("yosys {}\n", gates_tool());
}

/// Builds an entry in a folder of its own, unless the entry exists. Returns true if it built it.
bool provide(const fs::path& entry, Report& report, const std::function<void(const fs::path& folder)>& make) {
    if (is_whole(entry)) return false;
    BuildLock lock(entry);
    take(lock, report);
    if (is_whole(entry)) return false;   // another program has just built it
    clear_place(entry);
    WorkFolder work(entry);
    make(work.path());
    seal(work.path(), made_by());
    work.publish(entry);
    return true;
}

}   // namespace

void report_builds(std::function<void(const BuildStep&)> next) {
    const std::lock_guard lock(reporter_mutex);
    reporter = std::move(next);
}

void build_netlists() {
    if (gates_tool().empty())
        throw UserError("yosys is not installed, and netlists come from it: apt-get install yosys");
    form = Form::netlist;
}

std::string lint_rtl(const Config& config, const std::string& module) {
    check_rtl(config);
    if (rtl_tools().verilator.empty()) throw UserError(rtl_tools().problem);
    const TemporaryFolder folder("rayclock-lint");
    return lint_library(folder.path(), config, module);
}

RtlBuild build_rtl(const Config& config, const std::string& module, Waves waves) {
    check_rtl(config);
    open_cache();
    const std::string begin = entry_begin(config, module, waves);
    if (!rtl_tools().problem.empty()) {
        const fs::path entry = whole_entry(begin);
        if (entry.empty()) throw UserError(rtl_tools().problem);
        return {library_of(entry), true, 0};
    }
    const std::uint64_t tools = hash_of(made_by());
    const fs::path entry = rtl_cache() / fmt::format("{}{:016x}", begin, tools),
                   support = rtl_cache() / fmt::format("{}{:016x}-{:016x}", support_begin,
                                                       hash_of(support_inputs(waves)), tools);
    if (is_whole(entry)) return {library_of(entry), true, 0};

    const std::string form_name = form == Form::rtl ? "the RTL" : "the netlist";
    Report report(fmt::format("{} of '{}'{}",
                              module == "rc_chip" ? form_name
                              : form == Form::rtl ? module
                                                  : form_name + " of " + module,
                              config.name, waves == Waves::yes ? " for waveforms" : ""));
    const auto update = [&](const char* stage, std::optional<double> left) { report.update(stage, left); };
    // Build one after the other, so that a killed build leaves at most the folder in which its own tools
    // work.
    provide(support, report, [&](const fs::path& folder) { make_support(folder, waves, update); });
    fs::path netlist;
    if (form == Form::netlist) {
        const fs::path gates =
            rtl_cache() / fmt::format("{}{:016x}-{:016x}", netlist_begin,
                                      hash_of(gates_inputs(config, module)), hash_of(gates_tool()));
        provide(gates, report, [&](const fs::path& folder) { make_gates(folder, config, module, update); });
        netlist = library_of(gates);
    }
    const bool made = provide(entry, report, [&](const fs::path& folder) {
        make_library(folder, config, module, waves, library_of(support), netlist, update);
    });
    return {library_of(entry), !made, made ? report.seconds() : 0};
}

void forget_rtl(const RtlBuild& build) {
    BuildLock lock(build.library.parent_path());
    if (lock.take()) clear_place(build.library.parent_path());
}

}   // namespace rayclock
