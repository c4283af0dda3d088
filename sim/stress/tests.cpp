// The tests by name.
#include "model/core/error.hpp"
#include "model/core/nearest.hpp"
#include "model/isect/tri.hpp"
#include "sim/stress/run.hpp"

namespace rayclock::stress {

namespace {

const std::vector<NamedTest>& all_tests() {
    static const std::vector<NamedTest> all{
        {"exact", tri_test, true, 0},
    };
    return all;
}

} // namespace

const std::vector<std::string>& test_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        for (const NamedTest& t : all_tests()) list.push_back(t.name);
        return list;
    }();
    return names;
}

NamedTest named_test(const std::string& name) {
    for (const NamedTest& t : all_tests())
        if (t.name == name) return t;
    throw UserError("--test: no test is called '" + name + "'" + did_you_mean(name, test_names()));
}

} // namespace rayclock::stress
