#pragma once
// A Verilator and a compiler that make nothing, at once, so that what happens around them can be tried
// quickly.
#include <string>
#include <vector>

#include "tests/cli/program.hpp"

namespace rayclock::test {

/// Programs in a folder `bin` that is all of PATH, a cache, and RTL of a few lines. The library that is
/// "built" is a line of text.
class FakeTools {
public:
    explicit FakeTools(const std::string& cache = "cache");

    /// For run_program().
    std::vector<std::string> environment() const;
    std::string path(const std::string& file) const { return folder_.name(file); }
    std::string cache() const { return folder_.name(cache_); }
    const Folder& folder() const { return folder_; }

    /// Puts a shell script in the place of a tool.
    void replace(const std::string& tool, const std::string& script) const;
    void remove(const std::string& tool) const;

    /// `rayclock rtl`: builds, or finds what is built.
    Outcome rtl() const { return run_program({"rtl"}, environment()); }
    /// How often the compiler was called to compile or link a library: twice.
    int compilations() const;
    /// The only library of the cache; beside it lie Verilator's own sources, compiled.
    std::string entry() const;
    /// Names in the cache, without locks and those sources.
    std::vector<std::string> names() const;

    /// As the compiler, says its version and records its arguments, then runs `script`, in which $out is what
    /// it must make.
    static std::string compiler(const std::string& script = "echo built > \"$out\"",
                                const std::string& version = "12.2.0");
    /// What it makes has so many bytes. One source is enough for a few; of many there are two.
    static std::string verilator(const std::string& version = "5.006", int bytes = 1);
    static constexpr int many = 200'000;

private:
    Folder folder_;
    std::string cache_;
};

}   // namespace rayclock::test
