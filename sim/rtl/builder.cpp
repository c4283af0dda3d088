#include "sim/rtl/builder.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "model/core/error.hpp"
#include "sim/gen/rc_pkg.hpp"
#include "sim/rtl/adapter.hpp"

namespace rayclock {

namespace fs = std::filesystem;

namespace {

// --x-assign/--x-initial unique: registers without reset start at seeded random values.
constexpr const char* verilator_flags = "--cc -Wall --assert -O3 --x-assign unique --x-initial unique --prefix Vrc";
constexpr const char* compiler_flags = "-std=c++17 -O2 -fPIC -fvisibility=default -w";
constexpr std::size_t parts = 2;   // compiled at the same time

std::string text_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) throw std::runtime_error("cannot read " + path.string());
    return text.str();
}

void write_text(const fs::path& path, const std::string& text) {
    std::ofstream file(path, std::ios::binary);
    file << text;
    if (!file.flush()) throw UserError(path.string() + ": cannot write the RTL cache here; set RAYCLOCK_CACHE to a folder that can be written");
}

/// FNV-1a, 64 bits.
std::uint64_t hash(const std::string& text) {
    std::uint64_t h = 0xcbf29ce484222325u;
    for (const unsigned char c : text) h = (h ^ c) * 0x100000001b3u;
    return h;
}

std::string quoted(const fs::path& path) {
    std::string text(1, '\'');
    for (const char c : path.string()) {
        if (c == '\'') text.append("'\\'");
        text.push_back(c);
    }
    text.push_back('\'');
    return text;
}

/// Runs a shell command with its output in `log`; throws with the log's first lines if it fails.
void run(const std::string& command, const fs::path& log, const std::string& what) {
    if (std::system((command + " > " + quoted(log) + " 2>&1").c_str()) == 0) return;
    std::string text = text_of(log);
    if (text.size() > 2000) text.resize(2000);
    throw std::runtime_error(what + " failed:\n" + text);
}

std::string output_of(const std::string& command) {
    std::string text;
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return text;
    for (int c = 0; (c = std::fgetc(pipe)) != EOF;) text += char(c);
    const int status = pclose(pipe);
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return status == 0 ? text : std::string{};
}

const std::string& verilator_root() {
    static const std::string root = output_of("verilator --getenv VERILATOR_ROOT 2>/dev/null");
    if (root.empty()) throw UserError("verilator is not installed, and the RTL needs it; 'rayclock doctor' tells what is missing");
    return root;
}

/// Held while one library is built, so that other processes wait for it instead of building it too. Released by the
/// system if this process dies.
class BuildLock {
public:
    explicit BuildLock(const std::string& path) : file_(open(path.c_str(), O_CREAT | O_RDWR, 0644)) {
        if (file_ < 0) throw UserError(path + ": cannot write the RTL cache here; set RAYCLOCK_CACHE to a folder that can be written");
        flock(file_, LOCK_EX);
    }
    ~BuildLock() { close(file_); }
    BuildLock(const BuildLock&) = delete;
    BuildLock& operator=(const BuildLock&) = delete;

private:
    int file_;
};

void make_library(const fs::path& folder, const Config& config, const std::string& module) {
    write_text(folder / "rc_pkg.sv", rc_package(config));
    write_text(folder / "taps.vlt", adapter_vlt(module, config));
    std::string files = quoted(rtl_sources() / "lint.vlt") + " " + quoted(folder / "taps.vlt") + " " + quoted(folder / "rc_pkg.sv");
    for (const fs::path& file : rtl_files()) files += " " + quoted(file);
    run(fmt::format("verilator {} --top-module {} --Mdir {} {}", verilator_flags, module, quoted(folder / "obj"), files),
        folder / "verilator.log", "verilator on " + module);
    if (const std::string log = text_of(folder / "verilator.log"); log.find("%Warning") != std::string::npos)
        throw std::runtime_error("verilator -Wall warns about " + module + ":\n" + log.substr(0, 2000));

    std::vector<std::pair<std::uintmax_t, fs::path>> made;   // large ones first, so that both halves take about as long
    for (const auto& entry : fs::directory_iterator(folder / "obj"))
        if (entry.path().extension() == ".cpp") made.emplace_back(entry.file_size(), entry.path());
    std::sort(made.rbegin(), made.rend());
    std::array<std::string, parts> texts{adapter_source(module, config)};
    std::array<std::uintmax_t, parts> sizes{};
    for (const auto& [size, file] : made) {
        const std::size_t part = std::size_t(std::min_element(sizes.begin(), sizes.end()) - sizes.begin());
        sizes[part] += size;
        texts[part] += fmt::format("#include \"{}\"\n", file.string());
    }
    for (const char* part : {"verilated", "verilated_threads"}) texts[0] += fmt::format("#include \"{}/include/{}.cpp\"\n", verilator_root(), part);
    const std::string includes = fmt::format("-I{} -I{} -I{} -I{}", quoted(RAYCLOCK_SOURCE_DIR), quoted(folder / "obj"),
                                             quoted(fs::path(verilator_root()) / "include"), quoted(fs::path(verilator_root()) / "include/vltstd"));
    std::string compile, objects;
    for (std::size_t i = 0; i < parts; ++i) {
        const fs::path source = folder / fmt::format("part{}.cpp", i), object = folder / fmt::format("part{}.o", i);
        write_text(source, texts[i]);
        objects += " " + quoted(object);
        compile += fmt::format("c++ {} {} -c {} -o {} & p{}=$!; ", compiler_flags, includes, quoted(source), quoted(object), i);
    }
    for (std::size_t i = 0; i < parts; ++i) compile += fmt::format("{}wait $p{}", i ? " && " : "", i);
    run(fmt::format("({} && c++ -shared {} -o {})", compile, objects, quoted(folder / "module.so")), folder / "compiler.log",
        "the C++ compiler on the verilated " + module);
}

} // namespace

fs::path rtl_sources() {
    if (const char* chosen = std::getenv("RAYCLOCK_RTL"); chosen && *chosen) return chosen;
    return fs::path(RAYCLOCK_SOURCE_DIR) / "rtl";
}

std::vector<fs::path> rtl_files() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(rtl_sources()))
        if (entry.path().extension() == ".sv" && entry.path().filename() != "rc_pkg.sv") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

fs::path rtl_cache() {
    if (const char* chosen = std::getenv("RAYCLOCK_CACHE"); chosen && *chosen) return chosen;
    if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg && *xdg) return fs::path(xdg) / "rayclock";
    if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".cache/rayclock";
    return fs::temp_directory_path() / "rayclock-cache";
}

std::string lint_rtl(const Config& config, const std::string& module) {
    check_rtl(config);
    const fs::path folder = fs::temp_directory_path() / fmt::format("rayclock-lint-{}", getpid());   // lint.vlt knows the package by its name
    fs::create_directories(folder);
    write_text(folder / "rc_pkg.sv", rc_package(config));
    std::string files = quoted(rtl_sources() / "lint.vlt") + " " + quoted(folder / "rc_pkg.sv");
    for (const fs::path& file : rtl_files()) files += " " + quoted(file);
    const std::string found = output_of(fmt::format("verilator --lint-only -Wall --top-module {} {} 2>&1; true", module, files));
    fs::remove_all(folder);
    return found;
}

RtlBuild build_rtl(const Config& config, const std::string& module) {
    check_rtl(config);
    const auto start = std::chrono::steady_clock::now();
    std::string everything = rc_package(config) + adapter_source(module, config) + adapter_vlt(module, config) + verilator_flags + compiler_flags + verilator_root();
    for (const fs::path& file : rtl_files()) everything += text_of(file);
    const fs::path folder = rtl_cache() / fmt::format("{}-{:016x}", module, hash(everything));
    RtlBuild result{folder / "module.so", true, 0};
    if (fs::exists(result.library)) return result;

    std::error_code error;
    fs::create_directories(rtl_cache(), error);
    if (error) throw UserError(rtl_cache().string() + ": cannot make the RTL cache here (" + error.message() + "); set RAYCLOCK_CACHE to a folder that can be written");
    const BuildLock lock(folder.string() + ".lock");
    if (fs::exists(result.library)) return result;   // somebody else has just built it
    const fs::path work = folder.string() + fmt::format(".{}", getpid());
    fs::create_directories(work);
    try {
        make_library(work, config, module);
    } catch (...) {
        fs::remove_all(work, error);
        throw;
    }
    fs::remove_all(work / "obj", error);
    for (std::size_t i = 0; i < parts; ++i)
        for (const char* end : {"cpp", "o"}) fs::remove(work / fmt::format("part{}.{}", i, end), error);
    fs::rename(work, folder);
    result.was_cached = false;
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

} // namespace rayclock
