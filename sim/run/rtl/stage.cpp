// Staging of sources, and running of tools.
#include "sim/run/rtl/stage.hpp"

#include <chrono>
#include <cstdlib>
#include <memory>
#include <thread>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/interrupted.hpp"
#include "model/base/quote.hpp"
#include "sim/files/cache/libraries.hpp"
#include "sim/files/input.hpp"
#include "sim/files/process/interrupt.hpp"
#include "sim/files/process/process.hpp"
#include "sim/run/gen/rc_pkg.hpp"
#include "sim/run/rtl/board_ports.hpp"
#include "sim/run/rtl/sources.hpp"

namespace rayclock {

namespace fs = std::filesystem;

namespace {

/// Throws UserError with the tool's message, or with the cause if it is known.
[[noreturn]] void failed(const std::string& what, const fs::path& folder, const std::string& log) {
    // Below this free space, a tool may be unable to log its error.
    constexpr std::uintmax_t full = 64 << 10;
    std::error_code error_of_space;
    const fs::space_info space = fs::space(folder, error_of_space);
    if (log.find("No space left on device") != std::string::npos ||
        (!error_of_space && space.available < full))
        throw UserError(printable(folder.parent_path().string()) +
                        ": No space left on device for the RTL; set RAYCLOCK_CACHE to a folder with more");
    if (const std::size_t error = log.find("error: ");
        error != log.npos && what.starts_with("the C++ compiler") && !added_flags().empty())
        throw UserError(fmt::format("RAYCLOCK_CXXFLAGS={}: the C++ compiler says: {}",
                                    printable(added_flags()),
                                    printable(log.substr(error, log.find('\n', error) - error))));
    throw UserError(what + " failed: " + complaint_of(log));
}

}   // namespace

std::string added_flags() {
    const char* const added = std::getenv("RAYCLOCK_CXXFLAGS");
    return added ? added : "";
}

std::string source_inputs(const std::string& module) {
    std::string all;
    for (const RtlText& source : rtl_texts(scope_of(module))) all += "\n" + source.name + "\n" + source.text;
    return all;
}

std::vector<std::string> stage_sources(const fs::path& folder, const Config& config,
                                       const std::string& module) {
    std::vector<std::string> files;
    for (const RtlText& source : rtl_texts(scope_of(module))) {
        const fs::path copy = folder / "rtl" / source.name;
        std::error_code ignored;   // write_text() reports the error
        fs::create_directories(copy.parent_path(), ignored);
        write_text(copy, source.text);
        files.push_back("rtl/" + source.name);
    }
    write_text(folder / "rtl/rc_pkg.sv", rc_package(config));
    files.insert(files.begin() + 1, "rtl/rc_pkg.sv");   // after the waivers
    return files;
}

void run_tools(const fs::path& folder, const std::vector<ToolJob>& jobs, const std::string& what,
               const std::function<void()>& meanwhile) {
    std::vector<std::unique_ptr<Process>> running;
    for (const ToolJob& job : jobs)
        running.push_back(std::make_unique<Process>(Launch{job.words, folder, folder / job.log, folder}));
    for (std::size_t left = jobs.size(); left > 0;) {
        for (std::size_t i = 0; i < jobs.size(); ++i) {
            if (!running[i] || !running[i]->ended()) continue;
            if (running[i]->code() != 0) failed(what, folder, read_if_there(folder / jobs[i].log));
            running[i].reset();
            --left;
        }
        if (interrupted()) throw Interrupted("interrupted while RTL was built: nothing of it is kept");
        if (meanwhile) meanwhile();
        if (left > 0) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
}

void tidy(const fs::path& folder, const fs::path& kept) {
    std::vector<fs::path> rest;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path() != kept) rest.push_back(entry.path());
    for (const fs::path& path : rest) fs::remove_all(path);
}

}   // namespace rayclock
