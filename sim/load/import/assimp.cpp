// Running the converter under prlimit.
#include "sim/load/import/assimp.hpp"

#include <algorithm>
#include <chrono>
#include <set>
#include <thread>

#include <fmt/format.h>

#include "sim/files/cache/libraries.hpp"
#include "sim/files/input.hpp"
#include "sim/files/process/interrupt.hpp"
#include "sim/files/process/process.hpp"
#include "sim/files/text.hpp"

namespace rayclock {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

/// Returns the last line of Assimp's log, or the part after "ERROR:" in it.
std::string last_words(const std::string& log) {
    std::string_view rest = log;
    std::string last;
    while (!rest.empty()) {
        std::string_view line = take_line(rest);
        if (const std::size_t error = line.find("ERROR:"); error != line.npos) line.remove_prefix(error + 6);
        if (std::string words = joined_words(line); !words.empty()) last = std::move(words);
    }
    return printable(last, 300);
}

/// Runs the process to its end. Returns false if a signal ended it or it ran out of time.
bool run(const Launch& launch, const AssimpLimits& limits, int& code) {
    Process process(launch);
    const auto end = Clock::now() + std::chrono::seconds(limits.seconds);
    while (!process.ended()) {
        if (interrupted())
            throw std::runtime_error("interrupted while Assimp was reading: nothing is written");
        if (Clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    code = process.code();
    return code >= 0;
}

}   // namespace

AssimpLimits::AssimpLimits(std::uint64_t file_bytes) {
    const std::uint64_t megabytes = file_bytes >> 20;
    processor_seconds = 10 + 5 * megabytes;
    seconds = 6 * processor_seconds;   // wall time, on a machine that is busy with other work
    memory_bytes = (2048 + 32 * megabytes) << 20;
    result_bytes = (256 + 32 * megabytes) << 20;
}

bool assimp_reads(const std::string& extension) {
    static const std::set<std::string> all{
        "3d",      "3mf",  "ac",   "ac3d", "acc", "amf",  "ase", "ask",    "b3d",  "blend",
        "cob",     "dxf",  "enff", "fbx",  "hmp", "ifc",  "iqm", "ifczip", "irr",  "irrmesh",
        "lwo",     "lws",  "lxo",  "md2",  "md3", "mdc",  "mdl", "ms3d",   "ndo",  "nff",
        "md5mesh", "ogex", "pmx",  "q3o",  "q3s", "scn",  "sib", "smd",    "step", "stp",
        "ter",     "uc",   "vta",  "x",    "x3d", "x3db", "xgl", "zae",    "zgl"};
    return all.contains(extension);
}

std::string assimp_glb(const fs::path& file, std::uint64_t file_bytes,
                       const std::optional<std::string>& unpacked) {
    const SourcePosition at{file.string()};
    const fs::path program = find_program(assimp_program), limiter = find_program("prlimit");
    if (program.empty() || limiter.empty())
        at.refuse(fmt::format("files of this kind are read by Assimp, which is not installed; install {}",
                              program.empty() ? assimp_package : "util-linux"));
    const AssimpLimits limits(file_bytes);
    const WorkFolder folder(fs::temp_directory_path() / "rayclock-assimp");
    fs::path source = fs::absolute(file);
    if (unpacked) {
        source = folder.path() / ("packed" + file.stem().extension().string());
        write_text(source, *unpacked);
    }
    const fs::path made = folder.path() / "made.glb", log = folder.path() / "log";
    Launch launch{
        {limiter.string(), fmt::format("--as={}", limits.memory_bytes),
         fmt::format("--cpu={}", limits.processor_seconds), fmt::format("--fsize={}", limits.result_bytes),
         "--core=0", program.string(), "export", source.string(), made.string(), "-fglb2"},
        folder.path(),
        log,
        folder.path()};
    int code = -1;
    if (!run(launch, limits, code))
        at.refuse(
            fmt::format("Assimp crashed, or needed more than {} s, {} MB of memory or {} MB for its result",
                        limits.processor_seconds, limits.memory_bytes >> 20, limits.result_bytes >> 20));
    std::error_code missing;
    if (code != 0 || !fs::exists(made, missing)) {
        const std::string said = last_words(read_if_there(log));
        at.refuse(said.empty() ? "Assimp cannot read it" : "Assimp cannot read it: " + said);
    }
    return read_file(made, file.string(), limits.result_bytes);
}

}   // namespace rayclock
