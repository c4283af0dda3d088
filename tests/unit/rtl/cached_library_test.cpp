// Cached RTL that is damaged or lies in a folder with an unusual name, with real libraries.
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "sim/run/rtl/builder.hpp"
#include "sim/run/rtl/rtl_module.hpp"
#include "tests/support/dut/cell.hpp"
#include "tests/support/dut/dut.hpp"

using namespace rayclock;
namespace fs = std::filesystem;

namespace {

/// Sets an environment variable temporarily.
class Variable {
public:
    Variable(const char* name, const std::string& value) : name_(name) {
        if (const char* old = std::getenv(name)) old_ = old;
        setenv(name, value.c_str(), 1);
    }
    ~Variable() { old_ ? setenv(name_, old_->c_str(), 1) : unsetenv(name_); }
    Variable(const Variable&) = delete;

private:
    const char* name_;
    std::optional<std::string> old_;
};

/// An empty folder whose name is difficult for makefiles.
struct OddFolder {
    fs::path path = fs::temp_directory_path() / ("rayclock's \"odd\" $x " + std::to_string(getpid()));
    OddFolder() { fs::create_directory(path); }
    ~OddFolder() { fs::remove_all(path); }
    OddFolder(const OddFolder&) = delete;
};

void script(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << "#!/bin/sh\n" << text;
    fs::permissions(file, fs::perms::owner_all);
}

/// Computes 1 / |(3, 4, 0)| with rc_unit_vector. It is enough that it runs.
void run(const Config& config) {
    RtlModule module(config, "rc_unit_vector");
    module.reset();
    module.clock();
    CHECK(module.port("u").bytes > 0);
}

}   // namespace

TEST_CASE("a library that is cut, gone or no library is built again before it is loaded", "[rtl]") {
    const Config config = test::format("default");
    const RtlBuild real = build_rtl(config, "rc_unit_vector");
    const OddFolder folder;
    // The tools found now only copy the library that the real ones built.
    script(folder.path / "bin/verilator", "/bin/mkdir obj; echo > obj/Vrc.cpp");
    script(folder.path / "bin/c++",
           "while [ $# -gt 0 ]; do [ \"$1\" = -o ] && out=$2; shift; done; /bin/cp '" +
               real.library.string() + "' $out");
    const Variable cache("RAYCLOCK_CACHE", folder.path / "cache"), path("PATH", folder.path / "bin");
    const fs::path library = build_rtl(config, "rc_unit_vector").library;
    REQUIRE(library != real.library);
    // This comes first: a library that was loaded from a path may stay mapped, and the loader then returns it
    // for that path.
    const fs::path other = folder.path / "other";
    std::ofstream(other) << "no library, but sealed as if it were one";
    fs::rename(other, library);
    seal(library.parent_path(), "");
    CHECK(build_rtl(config, "rc_unit_vector").was_cached);
    run(config);
    CHECK(fs::file_size(library) == fs::file_size(real.library));
    // Loading half of the library would end in SIGBUS. The truncated file replaces it by a rename for the
    // same reason.
    fs::copy_file(library, other);
    fs::resize_file(other, fs::file_size(other) / 2);
    fs::rename(other, library);
    run(config);
    CHECK(fs::file_size(library) == fs::file_size(real.library));
    fs::remove(library);
    run(config);
    CHECK(fs::file_size(library) == fs::file_size(real.library));
}

TEST_CASE("blanks, quotes and dollars in the paths of sources and cache do not matter", "[rtl]") {
    const Config config = test::format("default");
    const OddFolder folder;
    fs::copy(rtl_sources(), folder.path / "rtl", fs::copy_options::recursive);
    const Variable cache("RAYCLOCK_CACHE", folder.path / "cache"),
        sources("RAYCLOCK_RTL", folder.path / "rtl"), temporary("TMPDIR", folder.path);
    CHECK(lint_rtl(config, "rc_unit_vector") == "");
    run(config);
}
