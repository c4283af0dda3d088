#pragma once
// A stand-in for nextpnr that copies the files of a real run.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/cli/program.hpp"

namespace rayclock::test {

namespace fs = std::filesystem;

/// A nextpnr that copies the files of a real run, in its own folder with a cache.
class FakeNextpnr {
public:
    FakeNextpnr() { replace("true"); }

    /// Replaces the script that it runs before it copies the files, and its version.
    void replace(const std::string& script, const std::string& version = "nextpnr-0.11.1") const {
        const std::string real = source_folder() + "/tests/chip/real";
        folder_.write("nextpnr", "#!/bin/sh\n[ \"$1\" = --version ] && echo 'fake (Version " + version +
                                     ")' && exit\necho \"$@\" >> '" + calls() + "'\n" + script +
                                     " || exit 1\ncp '" + real + "'/report.json '" + real +
                                     "'/placed.json '" + real + "'/delays.sdf .\n");
        fs::permissions(folder_.name("nextpnr"), fs::perms::owner_all);
    }
    std::vector<std::string> environment() const {
        return {"RAYCLOCK_NEXTPNR=" + folder_.name("nextpnr"), "RAYCLOCK_CACHE=" + folder_.name("cache")};
    }
    ProgramRun run(std::vector<std::string> more = {}) const {
        return run_program(words(std::move(more)), environment());
    }
    static std::vector<std::string> words(std::vector<std::string> more) {
        more.insert(more.begin(), {"chip", "--config", "small", "--unit", "dispatch"});
        return more;
    }
    /// Returns the number of calls.
    int routed() const {
        const std::string lines = content_of(calls());
        return int(std::count(lines.begin(), lines.end(), '\n'));
    }
    std::string calls() const { return folder_.name("calls"); }
    /// Returns the number of names in the cache with this prefix.
    int kept(const std::string& begin) const {
        int n = 0;
        for (const auto& entry : fs::directory_iterator(folder_.name("cache/chip")))
            n += entry.path().filename().string().starts_with(begin);
        return n;
    }
    const TestFolder& folder() const { return folder_; }

private:
    TestFolder folder_;
};

}   // namespace rayclock::test
