#pragma once
// Programs that this program runs, and that never outlive it.
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace rayclock {

/// What to run, and where.
struct Launch {
    std::vector<std::string> words;   ///< the program, as a path or a name in PATH, and its arguments: no
                                      ///< shell sees them
    std::filesystem::path folder;     ///< to run in, and where it keeps its temporary files; empty: this
                                      ///< program's
    std::filesystem::path output;     ///< what it prints goes there
    std::filesystem::path litter;     ///< removed if this program dies meanwhile; may be empty
    std::uint64_t most_output = 16 << 20;   ///< bytes; a program that prints more is ended
};

/// A running program with all that it has started. They end when this object does, and when this program
/// dies, however it dies: a guard, which is a process of its own, stands between and is told by the kernel.
/// Ctrl-C at a terminal reaches this program alone. The thread that starts a process must stay until it has
/// ended.
class Process {
public:
    /// Throws UserError if there is no such program, std::runtime_error if it cannot be started.
    explicit Process(const Launch& launch);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    /// Whether it has ended; does not wait. Throws UserError if it has printed too much.
    bool ended();
    /// Waits for its end, and gives its exit code. `meanwhile` is called some times a second. Throws
    /// Interrupted with this sentence after Ctrl-C.
    int wait(const char* stopped, const std::function<void()>& meanwhile = {});
    /// Exit code, or -1 if a signal ended it. Only after it has ended.
    int code() const { return code_; }

private:
    std::string name_;
    std::filesystem::path output_;
    std::uint64_t most_output_;
    pid_t guard_ = -1;
    int code_ = -1;
};

/// The path of a program in PATH, or empty if there is none. A name with a slash is a path.
std::filesystem::path find_program(const std::string& name);

/// What a tool says was wrong, fit for a sentence: the first line of its log with an error in it, or the last
/// line.
std::string complaint_of(const std::string& log);

/// What a short command prints on both outputs, without the last line's end, or empty if it fails, prints
/// more than a megabyte, or is not there. Throws Interrupted after Ctrl-C.
std::string output_of(const std::vector<std::string>& words);

}   // namespace rayclock
