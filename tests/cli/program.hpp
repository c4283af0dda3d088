#pragma once
// Runs the built program as a user would.
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace rayclock::test {

struct Outcome {
    int code = -1;   ///< exit code, or -1 if a signal ended the program
    std::string out, err;
    double seconds = 0;   ///< of all threads
    double peak_mb = 0;   ///< most memory in use
};

/// `environment`: NAME=value, over the test's own.
Outcome run_program(const std::vector<std::string>& arguments,
                    const std::vector<std::string>& environment = {});

/// The same started by a shell, which may bend the streams and limits first: `script` runs the program as
/// "$@".
Outcome run_in_shell(const std::string& script, const std::vector<std::string>& arguments);

/// The same with a Ctrl-C after so many milliseconds.
Outcome run_and_interrupt(const std::vector<std::string>& arguments, int milliseconds);

/// The same with a signal as soon as `ready` says so, and after a minute at the latest.
Outcome run_and_stop(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
                     int signal, const std::function<bool()>& ready);

/// An empty folder of its own, removed in the end.
class Folder {
public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    std::string name(const std::string& file) const { return (path_ / file).string(); }
    std::string write(const std::string& file, const std::string& bytes) const;
    /// Every file and folder in it, hidden ones too, and what the files hold.
    std::map<std::string, std::string> contents() const;

private:
    std::filesystem::path path_;
};

std::string bytes_of(const std::string& file);

/// Exit code 2, nothing on standard output, and one sentence on standard error that has all `words`.
void check_refused(const Outcome& outcome, const std::vector<std::string>& words);

}   // namespace rayclock::test
