#pragma once
// What a campaign's folder remembers, so that it goes on where it was stopped. Each file has a line for each
// fault: fields parted by tabs, the number first.
//   mutants   number, file, line, operator, what it does
//   refused   the same, of those that cannot be built
//   torture, quick, slow   number, "noticed" or "survived", seconds, what noticed it
#include "tests/meta/campaign/schema.hpp"

namespace rayclock::campaign {

using Lines = std::map<int, std::vector<std::string>>;
Lines lines_of(const std::filesystem::path& file);

void write_list(const std::filesystem::path& file, const std::vector<Mutant>& mutants);

bool is_noticed(const Lines& results, int number);

struct Verdict {
    bool noticed = false;
    std::string by;   ///< the case that saw it, or how the process ended
    double seconds = 0;
};
void append(const std::filesystem::path& file, int number, const Verdict& verdict);

/// "rtl/engine/bvh/rc_box.sv:80 comparison: ...", of a line of `mutants`.
std::string description(const std::vector<std::string>& mutant);

/// Descriptions of the faults that change nothing, as the page lists them: a line "- `description`: reason"
/// for each.
std::set<std::string> argued(const std::filesystem::path& page);

/// Numbers from here on are rows of a table.
inline constexpr int first_row = 10000;

}   // namespace rayclock::campaign
