#pragma once
// Runs the built program as a user would.
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace rayclock::test {

/// The outcome of a run.
struct Outcome {
    int code = -1;   ///< exit code, or -1 if a signal ended the program
    std::string out, err;
    double seconds = 0;   ///< processor time of all threads
    double peak_mb = 0;   ///< peak memory use
};

/// Returns the folder of the sources.
std::string source_folder();

/// Runs the program. `environment` has NAME=value, which override the test's own.
Outcome run_program(const std::vector<std::string>& arguments,
                    const std::vector<std::string>& environment = {});

/// Runs the program from a shell, which may redirect streams and set limits first: `script` runs the program
/// as "$@".
Outcome run_in_shell(const std::string& script, const std::vector<std::string>& arguments);

/// Runs the program and sends Ctrl-C after this number of milliseconds.
Outcome run_and_interrupt(const std::vector<std::string>& arguments, int milliseconds);

/// Runs the program and sends a signal when `ready` returns true, after a minute at the latest.
Outcome run_and_stop(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
                     int signal, const std::function<bool()>& ready);

/// A temporary folder, removed at the end.
class Folder {
public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    std::string name(const std::string& file) const { return (path_ / file).string(); }
    std::string write(const std::string& file, const std::string& bytes) const;
    /// Returns every file and folder in it, including hidden ones, with the content of files.
    std::map<std::string, std::string> contents() const;

private:
    std::filesystem::path path_;
};

std::string bytes_of(const std::string& file);

/// Requires exit code 2, no standard output, and one sentence on standard error that has all `words`.
void check_refused(const Outcome& outcome, const std::vector<std::string>& words);

}   // namespace rayclock::test
