#pragma once
// Runs Yosys as a separate program on the RTL of a configuration.
#include <filesystem>
#include <string>

#include "model/core/config.hpp"
#include "sim/files/scratch.hpp"
#include "sim/run/rtl/sources.hpp"

namespace rayclock::synth {

/// Returns the first line of `yosys -V`, or an empty string without Yosys. Runs the program once.
const std::string& yosys_version();

/// Returns a source without comments and without code that only simulation sees (`ifndef SYNTHESIS). Keys use
/// this text, so an edited comment does not invalidate a result that took an hour to route.
std::string synthesised_text(const std::string& text);

/// Returns the hash of synthesised_text() of all Verilog sources except the package. Reads them once.
const std::string& rtl_digest(RtlScope scope = RtlScope::chip);

/// A temporary folder for one run, removed at the end. It lies in `parent`, or among the temporary files if
/// `parent` is not writable.
class YosysFolder {
public:
    explicit YosysFolder(const std::filesystem::path& parent);

    /// Reads the package of a configuration and all sources, with `read_flags` for read_verilog, then runs
    /// the script in this folder. Returns false if interrupted(). Throws UserError with the tool's message if
    /// it fails.
    bool run(const Config& config, const std::string& read_flags, const std::string& script,
             RtlScope scope = RtlScope::chip) const;
    /// Runs the script alone.
    bool run(const std::string& script) const;

    /// Returns the content of a file that the run wrote. Throws UserError if the file is missing.
    std::string text(const char* file) const;
    /// Writes a file. Throws UserError if it cannot be written.
    void write(const char* file, const std::string& text) const;
    std::filesystem::path path(const char* file) const { return folder_.path() / file; }

private:
    TemporaryFolder folder_;
};

}   // namespace rayclock::synth
