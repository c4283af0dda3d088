// A copy of the RTL that contains all drawn faults, and a switch that chooses one.
#include <cstdlib>

#include <fmt/format.h>

#include "sim/run/rtl/builder.hpp"
#include "sim/explore/torture/torture.hpp"
#include "tests/meta/campaign/copies.hpp"
#include "tests/meta/campaign/draw.hpp"
#include "tests/meta/campaign/rows.hpp"
#include "tests/meta/campaign/state.hpp"

namespace rayclock::campaign {

namespace fs = std::filesystem;

namespace {

/// Numbers of the mutants that Verilator refuses, on the first chip where it refuses any.
std::set<int> refused(const fs::path& source, const fs::path& folder, const std::vector<Mutant>& mutants) {
    write_schema(source, "rtl", folder / "rtl", mutants, Language::verilog, caller_of(folder));
    for (const std::string& chip : torture_chips()) {
        const std::string said = lint_rtl(torture_chip(chip));
        std::string errors;
        for (std::size_t at = said.find("%Error"); at != std::string::npos; at = said.find("%Error", at + 1))
            errors += said.substr(at, said.find('\n', at) - at) + "\n";
        if (errors.empty() && said.find("%Warning") == std::string::npos) continue;
        const std::set<int> out = named_in(errors.empty() ? said : errors);
        if (out.empty())
            throw std::runtime_error("the copy of the RTL cannot be built:\n" + said.substr(0, 2000));
        return out;
    }
    return {};
}

}   // namespace

Caller caller_of(const fs::path& folder) { return Caller(folder / "called"); }

void use_rtl_copy(const fs::path& folder) {
    setenv("RAYCLOCK_RTL", (folder / "rtl").c_str(), 1);
    setenv("RAYCLOCK_CACHE", (folder / "cache").c_str(), 1);
}

void make_rtl_copy(const fs::path& source, const Order& order) {
    fs::create_directories(order.folder);
    use_rtl_copy(order.folder);
    Draw draw(all_faults(source, "rtl", Language::verilog), order.seed);
    std::vector<std::string> others;
    std::vector<Mutant> rows, mutants, out;
    if (!order.rows.empty()) rows = all_rows(source, order.rows, "rtl/", others);
    for (;;) {
        while (int(mutants.size()) < order.count) {
            std::optional<Mutant> m = draw.next();
            if (!m) break;
            mutants.push_back(std::move(*m));
        }
        std::vector<Mutant> all = mutants;
        all.insert(all.end(), rows.begin(), rows.end());
        const std::set<int> numbers = refused(source, order.folder, all);
        if (numbers.empty()) {
            write_list(order.folder / "refused", out);
            write_list(order.folder / "mutants", all);
            break;
        }
        for (const Mutant& m : all)
            if (numbers.contains(m.number)) out.push_back(m);
        for (std::vector<Mutant>* list : {&mutants, &rows})
            std::erase_if(*list, [&](const Mutant& m) { return numbers.contains(m.number); });
    }
    fmt::print("{} faults drawn, {} cannot be built; rows that one copy cannot hold: {}\n", mutants.size(),
               out.size(), others.size());
    for (const std::string& name : others) fmt::print("  {}\n", name);
}

}   // namespace rayclock::campaign
