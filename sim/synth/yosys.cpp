#include "sim/synth/yosys.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "sim/engine/engine.hpp"
#include "sim/gen/rc_pkg.hpp"
#include "sim/rtl/builder.hpp"
#include "sim/jobs/cache.hpp"

namespace rayclock::synth {

namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// Runs a program in a folder, its output in `log` there; the exit code, or -1 if it could not be started or
/// was stopped. Not std::system(), which makes this program deaf to Ctrl-C.
int run_in(const fs::path& folder, std::vector<std::string> words, const char* log) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, log, O_CREAT | O_WRONLY | O_TRUNC, 0644);
    posix_spawn_file_actions_adddup2(&actions, 1, 2);
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    pid_t child = 0;
    const int error = posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) return -1;
    int status = 0;
    for (;;) {
        const pid_t done = waitpid(child, &status, WNOHANG);
        if (done == child) return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        if (done < 0 && errno != EINTR) return -1;
        if (interrupted()) kill(child, SIGKILL);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
}

}   // namespace

const std::string& yosys_version() {
    static const std::string version = [] {
        FILE* pipe = popen("yosys -V 2>/dev/null", "r");
        std::string line;
        if (!pipe) return line;
        for (int c = 0; (c = std::fgetc(pipe)) != EOF && c != '\n';) line += char(c);
        return pclose(pipe) == 0 ? line : std::string{};
    }();
    return version;
}

const std::string& rtl_digest() {
    static const std::string digest = [] {
        std::string all;
        for (const fs::path& file : rtl_files()) all += file.filename().string() + "\n" + text_of(file);
        return jobs::hash_text(all);
    }();
    return digest;
}

YosysFolder::YosysFolder(const fs::path& beside) {
    std::string name = (beside / "yosys-XXXXXX").string();
    if (!mkdtemp(name.data())) name = (fs::temp_directory_path() / "rayclock-yosys-XXXXXX").string();
    if (!fs::exists(name) && !mkdtemp(name.data())) throw std::runtime_error(name + ": cannot be made");
    path_ = name;
}

YosysFolder::~YosysFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

bool YosysFolder::run(const Config& config, const std::string& read_flags, const std::string& script) const {
    std::ofstream(path_ / "rc_pkg.sv") << rc_package(config);
    std::string commands = "read_verilog -sv rc_pkg.sv\n";
    for (const fs::path& file : rtl_files())
        commands += fmt::format("read_verilog -sv {}\"{}\"\n", read_flags, fs::absolute(file).string());
    return run(commands + script);
}

bool YosysFolder::run(const std::string& script) const {
    std::ofstream(path_ / "run.ys") << script;
    const int code = run_in(path_, {"yosys", "-q", "run.ys"}, "log");
    if (interrupted()) return false;
    if (code != 0) throw std::runtime_error("yosys failed:\n" + text("log").substr(0, 2000));
    return true;
}

std::string YosysFolder::text(const char* file) const { return text_of(path_ / file); }

}   // namespace rayclock::synth
