// Prints how many faults each set of tests has noticed.
#include <fmt/format.h>

#include "tests/meta/campaign/stages.hpp"
#include "tests/meta/campaign/state.hpp"

namespace rayclock::campaign {

namespace fs = std::filesystem;

namespace {

struct Count {
    int all = 0, torture = 0, quick = 0, slow = 0;
};

void print(const char* what, const Count& c) {
    const auto share = [&](int part) { return c.all > 0 ? 100.0 * part / c.all : 0; };
    fmt::print(
        "{}: {}; noticed by the torture set {} ({:.1f} %), with the quick tests {} ({:.1f} %), with slow "
        "ones {} ({:.1f} %)\n",
        what, c.all, c.torture, share(c.torture), c.quick, share(c.quick), c.slow, share(c.slow));
}

}   // namespace

bool report(const fs::path& folder, const fs::path& page, double percent) {
    const Lines mutants = lines_of(folder / "mutants"), torture = lines_of(folder / "torture"),
                quick = lines_of(folder / "quick"), slow = lines_of(folder / "slow");
    const std::set<std::string> same = argued(page);
    Count drawn, rows;
    int equivalent = 0;
    for (const auto& [number, m] : mutants) {
        const bool by_torture = is_noticed(torture, number),
                   by_quick = by_torture || is_noticed(quick, number),
                   by_slow = by_quick || is_noticed(slow, number);
        if (!by_slow && same.contains(description(m))) {
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

}   // namespace rayclock::campaign
