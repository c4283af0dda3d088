#pragma once
// A fake Verilator and compiler that finish at once, so that everything around them can be tested quickly.
#include <string>
#include <vector>

#include "tests/cli/program.hpp"

namespace rayclock::test {

/// Programs in a folder `bin` that is the whole PATH, a cache, and RTL of a few lines. The "built" library is
/// a line of text.
class FakeTools {
public:
    explicit FakeTools(const std::string& cache = "cache");

    /// Returns the environment for run_program().
    std::vector<std::string> environment() const;
    std::string path(const std::string& file) const { return folder_.name(file); }
    std::string cache() const { return folder_.name(cache_); }
    const TestFolder& folder() const { return folder_; }

    /// Replaces a tool by a shell script.
    void replace(const std::string& tool, const std::string& script) const;
    void remove(const std::string& tool) const;

    /// Runs `rayclock rtl`, which builds RTL or finds it built.
    ProgramRun rtl() const { return run_program({"rtl"}, environment()); }
    /// Returns how often the compiler was called to compile or link a library. A build takes two calls.
    int compilations() const;
    /// Returns the only library of the cache. Verilator's compiled sources are next to it.
    std::string entry() const;
    /// Returns the names in the cache, without locks and Verilator's sources.
    std::vector<std::string> names() const;

    /// Returns a compiler script. It prints its version and records its arguments, then runs `script`, which
    /// must make $out.
    static std::string compiler(const std::string& script = "echo built > \"$out\"",
                                const std::string& version = "12.2.0");
    /// Returns a Verilator script whose output has this number of bytes. A small output has one source, a
    /// large one two.
    static std::string verilator(const std::string& version = "5.006", int bytes = 1);
    static constexpr int many = 200'000;

private:
    TestFolder folder_;
    std::string cache_;
};

}   // namespace rayclock::test
