#pragma once
// The acceleration structures, for tests that hold for all of them.
#include <vector>

#include "model/engine/engines.hpp"

namespace rayclock::test {

/// Returns one structure for each engine.
inline std::vector<Structure> engines() {
    std::vector<Structure> all;
    for_each_engine([&]<class E>(E) { all.push_back(E::structure); });
    return all;
}

}   // namespace rayclock::test
