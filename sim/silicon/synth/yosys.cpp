// Runs Yosys in temporary folders.
#include "sim/silicon/synth/yosys.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include <unistd.h>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/interrupted.hpp"
#include "model/base/quote.hpp"
#include "sim/files/cache/results.hpp"
#include "sim/files/input.hpp"
#include "sim/files/process/interrupt.hpp"
#include "sim/files/process/process.hpp"
#include "sim/files/process/tools.hpp"
#include "sim/run/gen/rc_pkg.hpp"
#include "sim/run/rtl/builder.hpp"
#include "sim/run/rtl/sources.hpp"

namespace rayclock::synth {

namespace fs = std::filesystem;

const std::string& yosys_version() {
    static const std::string version = version_line({"yosys", "-V"});
    return version;
}

std::string synthesised_text(const std::string& text) {
    if (text.find("/*") != std::string::npos) return text;   // the sources have no such comments
    std::istringstream lines(text);
    std::string kept;
    int left_out = 0;   // depth within `ifndef SYNTHESIS
    for (std::string line; std::getline(lines, line); kept += '\n') {
        bool is_string = false;
        for (std::size_t i = 0; i < line.size(); ++i) {
            if (line[i] == '"') is_string = !is_string;
            if (!is_string && line.compare(i, 2, "//") == 0) line.resize(i);
        }
        line.resize(line.find_last_not_of(" \t\r") + 1);   // npos + 1: an empty line
        const std::string word = line.substr(std::min(line.find_first_not_of(" \t"), line.size()));
        const bool begins = word == "`ifndef SYNTHESIS";
        if (begins || (left_out > 0 && word.starts_with("`if")))
            ++left_out;
        else if (left_out > 0 && (word == "`endif" || (left_out == 1 && word == "`else")))
            --left_out;
        else if (left_out == 0)
            kept += line;
    }
    return kept;
}

const std::string& rtl_digest(RtlScope scope) {
    const auto digest_of = [](RtlScope sources) {
        std::string all;
        for (const RtlText& source : rtl_texts(sources))
            if (source.name.ends_with(".sv")) all += source.name + "\n" + synthesised_text(source.text);
        return results::hash_text(all);
    };
    if (scope == RtlScope::board) {
        static const std::string of_board = digest_of(RtlScope::board);
        return of_board;
    }
    static const std::string of_chip = digest_of(RtlScope::chip);
    return of_chip;
}

YosysFolder::YosysFolder(const fs::path& parent)
    : folder_("yosys", ::access(parent.c_str(), W_OK) == 0 ? parent : fs::temp_directory_path()) {}

bool YosysFolder::run(const Config& config, const std::string& read_flags, const std::string& script,
                      RtlScope scope) const {
    write("rc_pkg.sv", rc_package(config));
    // RC_ECP5 maps products to the device's own blocks: rtl/fixed/multipliers/rc_mul_limb.sv.
    std::string commands =
        "read_verilog -lib +/ecp5/cells_sim.v +/ecp5/cells_bb.v\nread_verilog -sv rc_pkg.sv\n";
    // Copies the sources into this folder. Yosys names cells after files, and the results of ABC and of a
    // placer depend on these names. So the netlist does not depend on the location of the sources.
    for (const RtlText& source : rtl_texts(scope)) {
        const fs::path name = fs::path("rtl") / source.name;
        if (name.extension() != ".sv") continue;   // skip the waivers
        fs::create_directories((folder_.path() / name).parent_path());
        write(name.c_str(), source.text);
        commands += fmt::format("read_verilog -sv -D RC_ECP5 {}{}\n", read_flags, name.string());
    }
    return run(commands + script);
}

bool YosysFolder::run(const std::string& script) const {
    write("run.ys", script);
    Process yosys({{"yosys", "-q", "run.ys"}, folder_.path(), path("log"), folder_.path()});
    try {
        yosys.wait("interrupted");
    } catch (const Interrupted&) {
        return false;
    }
    if (yosys.code() != 0) throw UserError("yosys failed: " + complaint_of(read_if_there(path("log"))));
    return true;
}

void YosysFolder::write(const char* file, const std::string& text) const {
    errno = 0;
    if (!(std::ofstream(path(file)) << text).flush())
        throw UserError(fmt::format("{}: cannot be written: {}", printable(path(file).string()),
                                    std::strerror(errno ? errno : EIO)));
}

std::string YosysFolder::text(const char* file) const {
    std::string bytes = read_if_there(path(file));
    if (bytes.empty()) throw UserError(fmt::format("yosys has not written {}; is the disk full?", file));
    return bytes;
}

}   // namespace rayclock::synth
