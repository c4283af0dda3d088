#pragma once
// Mutant schemata: one copy of the sources that holds many faults, each asleep until its number is called
// (Untch, Offutt, Harrold 1993, "Mutation analysis using mutant schemata"). So one build serves them all.
#include <filesystem>
#include <map>
#include <set>

#include "tests/meta/campaign/faults.hpp"

namespace rayclock::campaign {

/// A changed expression. Several of one number are one fault.
struct Mutant {
    int number = 0;
    std::string file;   ///< below the source tree
    int line = 0;
    Region region;
    Fault fault;
    std::string added;   ///< items of the module that the changed expression needs
    std::size_t added_at = 0;
};

/// Which number is called: a file that holds it. The RTL reads it when it starts to run.
class Caller {
public:
    explicit Caller(std::filesystem::path file) : file_(std::move(file)) {}
    void call(int number) const;
    const std::filesystem::path& file() const { return file_; }

private:
    std::filesystem::path file_;
};

std::string text_of(const std::filesystem::path& file);
int line_of(const std::string& text, std::size_t at);

/// Every fault of every file below `folder` of the source tree, in the order of the files.
std::vector<Mutant> all_faults(const std::filesystem::path& source, const std::string& folder,
                               Language language);

/// Copies `source`/`folder` to `to`, with the mutants in it. Throws std::logic_error if two change
/// overlapping text.
void write_schema(const std::filesystem::path& source, const std::string& folder,
                  const std::filesystem::path& to, const std::vector<Mutant>& mutants, Language language,
                  const Caller& caller);

/// Returns the numbers of the mutants that a compiler's message names. In the copy each mutant has a file
/// name of its own (`line).
std::set<int> named_in(const std::string& said);

}   // namespace rayclock::campaign
