// Processes with a guard: this program -> guard -> the program to run. The guard is a child subreaper, so it
// also waits for the orphans of that program.
#include "sim/files/process/process.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "model/base/error.hpp"
#include "model/base/interrupted.hpp"
#include "model/base/quote.hpp"
#include "model/base/split.hpp"
#include "sim/files/process/interrupt.hpp"

namespace rayclock {

namespace fs = std::filesystem;

namespace {

// The kernel sends it when the parent dies, even if getppid() still names the parent. The parent sends
// SIGTERM.
constexpr int parent_died = SIGUSR1;
constexpr int could_not_start = 127, ended_by_signal = 126;   // exit codes of the guard, as a shell has them

/// All data that the child needs after fork(). It must not allocate there: another thread may have held the
/// allocator's lock.
struct Plan {
    std::string program, folder, output, litter;
    std::vector<std::string> words, variables;
    std::vector<char*> argv, envp;
    pid_t parent = getpid();
    sigset_t signals;   ///< the caller's mask, from before all signals were blocked

    explicit Plan(const Launch& launch)
        : program(find_program(launch.words.at(0)).string()),
          folder(launch.folder.string()),
          output(launch.output.empty() ? "/dev/null" : launch.output.string()),
          litter(launch.litter.string()),
          words(launch.words) {
        if (program.empty()) throw UserError(launch.words[0] + " is not installed, or not in PATH");
        for (char** v = environ; *v; ++v)
            if (folder.empty() || std::strncmp(*v, "TMPDIR=", 7) != 0) variables.emplace_back(*v);
        if (!folder.empty()) variables.push_back("TMPDIR=" + fs::absolute(folder).string());
        for (std::string& word : words) argv.push_back(word.data());
        for (std::string& variable : variables) envp.push_back(variable.data());
        argv.push_back(nullptr);
        envp.push_back(nullptr);
    }
};

/// Turns this process into the program. Does not allocate.
[[noreturn]] void become_program(const Plan& plan) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const int in = open("/dev/null", O_RDONLY),
              out = open(plan.output.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0644);
    if (in < 0 || out < 0 || dup2(in, 0) < 0 || dup2(out, 1) < 0 || dup2(out, 2) < 0) _exit(could_not_start);
    if (!plan.folder.empty() && chdir(plan.folder.c_str()) != 0) _exit(could_not_start);
    for (const int s : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGCHLD}) std::signal(s, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    execve(plan.program.c_str(), plan.argv.data(), plan.envp.data());
    _exit(could_not_start);
}

/// Kills the program's group and waits for its members: orphans become children of the guard. A member may
/// have left the group on purpose, as a compiler server does. Waits at most 0.33 s for such a member, because
/// Ctrl-C may take no more than one second.
void end_group(pid_t program) {
    kill(-program, SIGKILL);
    for (int i = 0; i < 66; ++i) {
        pid_t gone = 0;
        while ((gone = waitpid(-1, nullptr, WNOHANG)) > 0) {}
        if (gone < 0 && errno == ECHILD) return;
        const timespec pause{0, 5'000'000};
        nanosleep(&pause, nullptr);
    }
}

/// Runs the guard. It starts the program and ends it when the kernel reports the parent's death or the parent
/// sends SIGTERM. It keeps the parent's open files, and so its locks, until the litter is gone.
[[noreturn]] void guard(const Plan& plan) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, parent_died);
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    std::signal(SIGCHLD, SIG_DFL);
    sigset_t awaited;
    sigemptyset(&awaited);
    sigaddset(&awaited, SIGCHLD);
    sigaddset(&awaited, SIGTERM);
    sigaddset(&awaited, parent_died);
    bool orphan = getppid() != plan.parent, stop = orphan;   // the parent died before prctl()
    const pid_t program = stop ? -1 : fork();
    if (program == 0) become_program(plan);
    // Parent and child both call setpgid(), so it has happened before either continues.
    if (program > 0)
        setpgid(program, program);
    else if (!stop)
        _exit(could_not_start);
    while (!stop) {
        const int signal = sigwaitinfo(&awaited, nullptr);
        orphan = signal == parent_died;
        stop = orphan || signal == SIGTERM;
        int status = 0;
        if (stop || waitpid(program, &status, WNOHANG) != program) continue;
        kill(-program, SIGKILL);   // processes that the program left behind
        _exit(WIFEXITED(status) ? WEXITSTATUS(status) : ended_by_signal);
    }
    if (program > 0) end_group(program);
    if (orphan && !plan.litter.empty())
        execl("/bin/rm", "rm", "-rf", "--", plan.litter.c_str(), static_cast<char*>(nullptr));
    _exit(ended_by_signal);
}

}   // namespace

Process::Process(const Launch& launch)
    : name_(launch.words.at(0)), output_(launch.output), max_output_(launch.max_output) {
    Plan plan(launch);
    sigset_t all;
    sigfillset(&all);
    // Block all signals, so no handler of this program can run in the guard.
    pthread_sigmask(SIG_SETMASK, &all, &plan.signals);
    guard_ = fork();
    if (guard_ == 0) guard(plan);
    pthread_sigmask(SIG_SETMASK, &plan.signals, nullptr);
    if (guard_ < 0)
        throw UserError(
            fmt::format("{}: cannot be started ({})", printable(launch.words[0]), std::strerror(errno)));
}

Process::~Process() {
    if (guard_ < 0) return;
    kill(guard_, SIGTERM);
    while (waitpid(guard_, nullptr, 0) < 0 && errno == EINTR) {}
}

bool Process::ended() {
    if (guard_ < 0) return true;
    int status = 0;
    const pid_t done = waitpid(guard_, &status, WNOHANG);
    if (done == 0 || (done < 0 && errno == EINTR)) {
        std::error_code error;
        const std::uintmax_t printed = output_.empty() ? 0 : fs::file_size(output_, error);
        if (error || printed <= max_output_) return false;
        throw UserError(
            fmt::format("{} was ended: it has printed more than {} MB", printable(name_), max_output_ >> 20));
    }
    code_ = done == guard_ && WIFEXITED(status) && WEXITSTATUS(status) != ended_by_signal
                ? WEXITSTATUS(status)
                : -1;
    guard_ = -1;
    return true;
}

int Process::wait(const char* stopped, const std::function<void()>& meanwhile) {
    for (int turn = 0; !ended(); ++turn) {
        if (interrupted()) throw Interrupted(stopped);
        if (meanwhile) meanwhile();
        // Most programs end at once.
        std::this_thread::sleep_for(std::chrono::milliseconds(turn < 20 ? 1 : 10));
    }
    if (interrupted()) throw Interrupted(stopped);
    return code_;
}

std::string complaint_of(const std::string& log) {
    constexpr std::string_view error = "ERROR: ";
    std::string last, warning;   // Verilator's error "Exiting due to 1 warning(s)" does not name the warning
    for (const std::string& line : split(log, '\n')) {
        if (line.starts_with(error)) return printable(line.substr(error.size()));
        if (line.starts_with("%Warning") && warning.empty()) warning = line;
        if (line.starts_with("%Error: Exiting due to") && !warning.empty()) return printable(warning);
        for (const char* word : {"ERROR", "%Error", "error: "})
            if (line.find(word) != line.npos) return printable(line);
        if (line.find_first_not_of(" \t\r") != line.npos) last = line;
    }
    return last.empty() ? "it printed no error; is the disk full?" : printable(last);
}

fs::path find_program(const std::string& name) {
    const auto is_program = [](const fs::path& path) {
        std::error_code error;
        return fs::is_regular_file(path, error) && access(path.c_str(), X_OK) == 0;
    };
    if (name.find('/') != std::string::npos) return is_program(name) ? fs::absolute(name) : fs::path{};
    const char* list = std::getenv("PATH");
    std::string rest = list ? list : "";
    while (!rest.empty()) {
        const std::size_t end = rest.find(':');
        const fs::path path = fs::path(rest.substr(0, end)) / name;
        if (is_program(path)) return fs::absolute(path);
        rest = end == std::string::npos ? std::string{} : rest.substr(end + 1);
    }
    return {};
}

std::string output_of(const std::vector<std::string>& words) {
    if (find_program(words.at(0)).empty()) return {};
    const int file = memfd_create("output", MFD_CLOEXEC);
    if (file < 0) return {};
    std::string text;
    try {
        Process process({words, {}, fmt::format("/proc/self/fd/{}", file), {}, 1 << 20});
        std::array<char, 4096> block;
        ssize_t got = 0;   // the program opened the file itself, so this descriptor is still at offset 0
        const int code = process.wait("interrupted: nothing is written");
        while (code == 0 && (got = read(file, block.data(), block.size())) > 0)
            text.append(block.data(), std::size_t(got));
    } catch (const UserError&) {   // it printed too much, or could not be started
    } catch (...) {
        close(file);
        throw;
    }
    close(file);
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text;
}

}   // namespace rayclock
