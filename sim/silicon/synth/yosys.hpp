#pragma once
// Yosys as a program of its own, on the RTL of a configuration.
#include <filesystem>
#include <string>

#include "model/core/config.hpp"
#include "sim/files/scratch.hpp"

namespace rayclock::synth {

/// First line of `yosys -V`, or empty if there is none. Asked once.
const std::string& yosys_version();

/// A source as synthesis reads it, line by line: without comments, and without what only a simulation sees
/// (`ifndef SYNTHESIS). So what took an hour to route is not lost by a word in a comment.
std::string synthesised_text(const std::string& text);

/// Hash of synthesised_text of all Verilog sources but the package. Read once.
const std::string& rtl_digest();

/// A folder of its own for one run, removed in the end. It lies in `beside`, or among the temporary files if
/// nothing can be written there.
class YosysFolder {
public:
    explicit YosysFolder(const std::filesystem::path& beside);

    /// Reads the package of a configuration and all sources (with `read_flags`, as for read_verilog), then
    /// runs the script in this folder. False if interrupted() meanwhile; UserError with the tool's complaint
    /// if it fails.
    bool run(const Config& config, const std::string& read_flags, const std::string& script) const;
    /// The script alone.
    bool run(const std::string& script) const;

    /// What the run has written. Throws UserError if it is not there.
    std::string text(const char* file) const;
    /// Throws UserError if it cannot be written.
    void write(const char* file, const std::string& text) const;
    std::filesystem::path path(const char* file) const { return folder_.path() / file; }

private:
    TemporaryFolder folder_;
};

}   // namespace rayclock::synth
