#include <fstream>

#include <fmt/format.h>

#include "tests/meta/campaign/stages.hpp"
#include "tests/meta/campaign/state.hpp"

namespace rayclock::campaign {

namespace fs = std::filesystem;

namespace {

/// "file:line operator: what it does" of the faults that change nothing, as the page lists them, each with its reason.
std::set<std::string> equivalents(const fs::path& arguments) {
    std::set<std::string> all;
    std::ifstream in(arguments);
    for (std::string line; std::getline(in, line);) {
        const std::size_t end = line.find("`: ");
        if (line.starts_with("- `") && end != std::string::npos) all.insert(line.substr(3, end - 3));
    }
    return all;
}

struct Count {
    int all = 0, torture = 0, quick = 0, slow = 0;
};

void print(const char* what, const Count& c) {
    const auto share = [&](int part) { return c.all > 0 ? 100.0 * part / c.all : 0; };
    fmt::print("{}: {}; noticed by the torture set {} ({:.1f} %), with the quick tests {} ({:.1f} %), with slow ones {} ({:.1f} %)\n",
               what, c.all, c.torture, share(c.torture), c.quick, share(c.quick), c.slow, share(c.slow));
}

} // namespace

bool report(const fs::path& folder, const fs::path& arguments, double percent) {
    const Lines mutants = lines_of(folder / "mutants"), torture = lines_of(folder / "torture"), quick = lines_of(folder / "quick"),
                slow = lines_of(folder / "slow");
    const std::set<std::string> same = equivalents(arguments);
    Count drawn, rows;
    int equivalent = 0;
    for (const auto& [number, m] : mutants) {
        const bool by_torture = is_noticed(torture, number), by_quick = by_torture || is_noticed(quick, number),
                   by_slow = by_quick || is_noticed(slow, number);
        const std::string what = fmt::format("{}:{} {}: {}", m[1], m[2], m[3], m[4]);
        if (!by_slow && same.contains(what)) {
            ++equivalent;
            continue;
        }
        Count& count = number > first_row ? rows : drawn;
        ++count.all, count.torture += by_torture, count.quick += by_quick, count.slow += by_slow;
        if (number > first_row ? !by_torture : !by_slow) fmt::print("not noticed: {}\n", description(m));
    }
    fmt::print("{} cannot be built, {} change nothing\n", lines_of(folder / "refused").size(), equivalent);
    print("drawn", drawn);
    if (rows.all > 0) print("rows", rows);
    return drawn.slow * 100.0 >= percent * drawn.all;
}

} // namespace rayclock::campaign
