// The tests by name, and what is demanded of them.
#include <algorithm>

#include "model/core/error.hpp"
#include "model/core/nearest.hpp"
#include "model/isect/tri.hpp"
#include "sim/stress/controls.hpp"

namespace rayclock::stress {

const std::vector<NamedTest>& named_tests() {
    static const std::vector<NamedTest> all = [] {
        std::vector<NamedTest> list{
            {"exact", "edge functions in whole numbers", tri_test, Walks::tree, 0, Demand::truth},
        };
        list.insert(list.end(), controls().begin(), controls().end());
        return list;
    }();
    return all;
}

const NamedTest& named_test(const std::string& name) {
    std::vector<std::string> names;
    for (const NamedTest& t : named_tests()) {
        if (name == t.name) return t;
        names.push_back(t.name);
    }
    throw UserError("--test: no test is called '" + name + "'" + did_you_mean(name, names));
}

bool meets_demand(const NamedTest& test, const std::vector<Cell>& cells) {
    Counts sound, leaky;
    for (const Cell& cell : cells)
        if (cell.test == test.name) (family(cell.family).leaks ? leaky : sound) += cell.counts;
    const bool leaks_where_it_must = leaky.rays == 0 || leaky.leaks > 0;
    switch (test.demand) {
    case Demand::truth: return leaks_where_it_must && sound.leaks == 0 && sound.double_hits == 0 && sound.oracle_mismatches == 0;
    case Demand::watertight: return leaks_where_it_must && sound.leaks == 0 && sound.double_hits == 0;
    case Demand::nothing: return true;
    case Demand::double_hits: return sound.double_hits > 0;
    case Demand::leaks: return sound.leaks > 0;
    case Demand::mismatches: return sound.oracle_mismatches > 0;
    }
    return false;
}

} // namespace rayclock::stress
