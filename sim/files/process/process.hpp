#pragma once
// Running other programs, which never outlive this program.
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace rayclock {

/// The program to run, and its folder and output.
struct Launch {
    /// The program (a path or a name in PATH) and its arguments; not parsed by a shell.
    std::vector<std::string> words;
    /// Working folder and TMPDIR of the program; empty: those of this program.
    std::filesystem::path folder;
    std::filesystem::path output;   ///< file for standard output and standard error; empty: discard both
    std::filesystem::path litter;   ///< file or folder to remove if this program dies meanwhile; may be empty
    std::uint64_t max_output = 16 << 20;   ///< bytes; a program that prints more is killed
};

/// A running program and all of its children. They end with this object, and with this program, however it
/// dies. A guard process stands between the two programs, and the kernel signals it when this program dies.
/// Ctrl-C at a terminal reaches only this program. The thread that starts a process must live until the
/// process has ended.
class Process {
public:
    /// Starts the program. Throws UserError if it does not exist or the guard cannot be started. If the guard
    /// cannot start it, wait() returns 127.
    explicit Process(const Launch& launch);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    /// Returns true if the program has ended; does not wait. Throws UserError if it printed too much.
    bool ended();
    /// Waits for the end of the program and returns its exit code. Calls `meanwhile` every 10 ms or more
    /// often. Throws Interrupted with the sentence `stopped` after Ctrl-C.
    int wait(const char* stopped, const std::function<void()>& meanwhile = {});
    /// Returns the exit code, or -1 if a signal ended the program. Call it only after the program has ended.
    int code() const { return code_; }

private:
    std::string name_;
    std::filesystem::path output_;
    std::uint64_t max_output_;
    pid_t guard_ = -1;
    int code_ = -1;
};

/// Returns the path of a program in PATH, or an empty path if there is none. A name with a slash is a path.
std::filesystem::path find_program(const std::string& name);

/// Returns a tool's error message for use in a sentence: the first line of its log that holds an error, or
/// the last line.
std::string complaint_of(const std::string& log);

/// Runs a short command and returns what it prints on both outputs, without trailing newlines. Returns an
/// empty string if it does not exist, fails, or prints more than a megabyte. Throws Interrupted after Ctrl-C.
std::string output_of(const std::vector<std::string>& words);

}   // namespace rayclock
