#include "sim/sweep/netlist.hpp"

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

#include "model/core/error.hpp"
#include "sim/engine/engine.hpp"
#include "sim/gen/rc_pkg.hpp"
#include "sim/rtl/builder.hpp"

namespace rayclock::sweep {

namespace fs = std::filesystem;

namespace {

// The multiplier steps of synth_ecp5. Products that are never wanted in the same cycle share a multiplier; that is looked for
// within each module, before all become one, which finds the same and takes a thirtieth of the time. No bit of a register is
// counted that is constant, unused or part of a memory's port. Then `stat` counts.
constexpr const char* script = R"(hierarchy -check -top rc_pipeline
proc
opt_expr
opt_clean
wreduce t:$mul
opt_clean
share t:$mul
flatten
opt -fast
techmap -map +/mul2dsp.v -map +/ecp5/dsp_map.v -D DSP_A_MAXWIDTH=18 -D DSP_B_MAXWIDTH=18 -D DSP_A_MINWIDTH=2 -D DSP_B_MINWIDTH=2 -D DSP_NAME=$__MUL18X18
memory -nomap
opt_clean
tee -q -o stat.json stat -width -json
)";

std::string text_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// Runs a program in a folder, its output in `log` there; the exit code, or -1 if it could not be started or was stopped. Not
/// std::system(), which makes this program deaf to Ctrl-C.
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

/// Sums the widths of all registers and the multipliers in what `stat -width -json` says.
Netlist counts_of(const std::string& text) {
    const auto json = nlohmann::json::parse(text);
    Netlist counts;
    for (const auto& [type, count] : json.at("design").at("num_cells_by_type").items()) {
        if (type == "MULT18X18D") counts.multipliers += count.get<std::uint64_t>();
        const std::size_t width = type.rfind('_');   // $sdffe_18: a register of 18 bits
        if (type.find("dff") != std::string::npos && type[0] == '$' && width != std::string::npos)
            counts.flip_flops += std::stoull(type.substr(width + 1)) * count.get<std::uint64_t>();
    }
    return counts;
}

/// A folder of its own, removed in the end.
struct WorkFolder {
    fs::path path;
    explicit WorkFolder(const fs::path& beside) {
        std::string name = (beside / "yosys-XXXXXX").string();
        if (!mkdtemp(name.data())) name = (fs::temp_directory_path() / "rayclock-yosys-XXXXXX").string();
        if (!fs::exists(name) && !mkdtemp(name.data())) throw std::runtime_error(name + ": cannot be made");
        path = name;
    }
    ~WorkFolder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    WorkFolder(const WorkFolder&) = delete;
};

} // namespace

bool exists_in_rtl(const Config& config) {
    try {
        check_rtl(config);
        return true;
    } catch (const UserError&) {
        return false;
    }
}

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

std::string netlist_key(const Config& config) {
    static const std::string sources = [] {
        std::string all;
        for (const fs::path& file : rtl_files()) all += file.filename().string() + "\n" + text_of(file);
        return hash_text(all);
    }();
    return fmt::format("package {} rtl {} script {} {} pipelines {}", hash_text(rc_package(config)), sources, hash_text(script), yosys_version(),
                       config.pipelines);
}

std::optional<Netlist> count_netlist(const Config& config, const fs::path& work) {
    const WorkFolder folder(work);
    std::ofstream(folder.path / "rc_pkg.sv") << rc_package(config);
    std::string commands = "read_verilog -sv rc_pkg.sv\n";
    for (const fs::path& file : rtl_files()) commands += fmt::format("read_verilog -sv \"{}\"\n", fs::absolute(file).string());
    std::ofstream(folder.path / "run.ys") << commands << script;
    const int code = run_in(folder.path, {"yosys", "-q", "run.ys"}, "log");
    if (interrupted()) return std::nullopt;
    if (code != 0) throw std::runtime_error("yosys failed:\n" + text_of(folder.path / "log").substr(0, 2000));
    Netlist counts = counts_of(text_of(folder.path / "stat.json"));
    counts.multipliers *= std::uint64_t(config.pipelines);
    counts.flip_flops *= std::uint64_t(config.pipelines);
    return counts;
}

} // namespace rayclock::sweep
