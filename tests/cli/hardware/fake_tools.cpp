// Writes the fake tools as shell scripts, and counts their calls.
#include "tests/cli/hardware/fake_tools.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include <catch2/catch.hpp>

namespace rayclock::test {

namespace fs = std::filesystem;

std::string FakeTools::compiler(const std::string& script, const std::string& version) {
    return "case \"$1\" in --version) echo 'c++ (Fake) " + version +
           "'; exit;; -dumpmachine) echo fake; exit;; esac\n"
           "echo \"$@\" >> \"$FAKE/calls\"\n"
           "while [ $# -gt 0 ]; do [ \"$1\" = -o ] && out=$2; shift; done\n" +
           script + "\n";
}

std::string FakeTools::verilator(const std::string& version, int bytes) {
    return "case \"$1\" in --version) echo 'Verilator " + version +
           " fake'; exit;; --getenv) echo \"$FAKE/root\"; exit;; esac\n"
           "echo \"$@\" >> \"$FAKE/verilated\"\n/bin/mkdir obj && /bin/head -c " +
           std::to_string(bytes) + " /dev/zero > obj/Vrc.cpp\n";
}

FakeTools::FakeTools(const std::string& cache) : cache_(cache) {
    for (const char* part : {"bin", "root/include", "rtl"}) fs::create_directories(folder_.name(part));
    folder_.write("root/include/verilated.h", "// fake\n");
    folder_.write("rtl/rc_top.sv", "module rc_top; endmodule\n");
    folder_.write("rtl/lint.vlt", "`verilator_config\n");
    replace("verilator", verilator());
    replace("c++", compiler());
}

std::vector<std::string> FakeTools::environment() const {
    return {"PATH=" + path("bin"), "FAKE=" + path("."), "RAYCLOCK_RTL=" + path("rtl"),
            "RAYCLOCK_CACHE=" + cache(), "VERILATOR_ROOT="};
}

void FakeTools::replace(const std::string& tool, const std::string& script) const {
    folder_.write("bin/" + tool, "#!/bin/sh\n" + script);
    fs::permissions(path("bin/" + tool), fs::perms::owner_all);
}

void FakeTools::remove(const std::string& tool) const { fs::remove(path("bin/" + tool)); }

int FakeTools::compilations() const {
    std::istringstream calls(content_of(path("calls")));
    int count = 0;
    for (std::string call; std::getline(calls, call);)
        count += call.find("-o support.o") == std::string::npos;
    return count;
}

std::vector<std::string> FakeTools::names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(cache()))
        if (const std::string name = entry.path().filename();
            entry.path().extension() != ".lock" &&
            !(name.starts_with("rc_verilated-") && name.find('.') == std::string::npos))
            names.push_back(name);
    std::sort(names.begin(), names.end());
    return names;
}

std::string FakeTools::entry() const {
    const std::vector<std::string> all = names();
    REQUIRE(all.size() == 1);
    return cache() + "/" + all[0];
}

}   // namespace rayclock::test
