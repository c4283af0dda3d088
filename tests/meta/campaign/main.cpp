// rc_campaign: faults by the hundred, drawn at random or from a table, and what notices them.
//
// rc_campaign rtl FOLDER SEED COUNT [ROWS]
//     Draws faults of rtl/ and runs the torture set on each. With ROWS, the file in which CMake writes the
//     rows of tests/meta/mutants/*.cmake, also on those.
// rc_campaign model FOLDER SEED COUNT BUILD [ROWS]
//     The same for the model's arithmetic, compared with the sound RTL.
// rc_campaign tests FOLDER BUILD PAGE quick|slow
//     Runs the tests of the build folder on faults that the torture set did not notice. PAGE lists equivalent
//     faults with reasons.
// rc_campaign report FOLDER PAGE PERCENT
//     Prints the shares of noticed faults. Returns 1 if they are below PERCENT. PAGE lists equivalent faults.
//
// FOLDER keeps all results. A command that is started again continues where it stopped.
#include <fmt/format.h>

#include "tests/meta/campaign/copies.hpp"
#include "tests/meta/campaign/stages.hpp"

namespace {

using namespace rayclock::campaign;
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const fs::path source = RAYCLOCK_SOURCE_DIR;

Order order_of(const Words& words, std::size_t rows_at) {
    const fs::path rows = words.size() > rows_at ? fs::absolute(words[rows_at]) : fs::path();
    return {fs::absolute(words[1]), std::stoull(words[2]), std::stoi(words[3]), rows};
}

int rtl(const Words& words) {
    const Order order = order_of(words, 4);
    if (!fs::exists(order.folder / "mutants")) make_rtl_copy(source, order);
    torture_rtl(order.folder);
    return 0;
}

int model(const Words& words) {
    const Order order = order_of(words, 5);
    if (!fs::exists(order.folder / "mutants")) make_model_copy(source, order);
    if (!fs::exists(order.folder / "rc_campaign"))
        link_with_faults(order.folder, fs::absolute(words[4]), "tests/meta/rc_campaign");
    return shell(fmt::format("'{0}/rc_campaign' faults '{0}'", order.folder.string())) == 0 ? 0 : 1;
}

int run(const Words& words) {
    const std::string what = words.empty() ? "" : words[0];
    const std::size_t n = words.size();
    if (what == "rtl" && (n == 4 || n == 5)) return rtl(words);
    if (what == "model" && (n == 5 || n == 6)) return model(words);
    if (what == "faults" && n == 2)
        return torture_model(words[1]), 0;   // `model` calls it, in the program with the faults
    if (what == "tests" && n == 5 && (words[4] == "quick" || words[4] == "slow"))
        return test_survivors(fs::absolute(words[1]), fs::absolute(words[2]), words[3], words[4] == "slow"),
               0;
    if (what == "report" && n == 4) return report(words[1], words[2], std::stod(words[3])) ? 0 : 1;
    fmt::print(stderr,
               "rc_campaign rtl FOLDER SEED COUNT [ROWS] | model FOLDER SEED COUNT BUILD [ROWS] | "
               "tests FOLDER BUILD PAGE quick|slow | report FOLDER PAGE PERCENT\n");
    return 2;
}

}   // namespace

int main(int argc, char** argv) {
    try {
        return run({argv + 1, argv + argc});
    } catch (const std::exception& e) {
        fmt::print(stderr, "rc_campaign: {}\n", e.what());
        return 1;
    }
}
