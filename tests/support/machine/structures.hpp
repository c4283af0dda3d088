#pragma once
// The acceleration structures, for tests that hold for all of them.
#include <vector>

#include "model/engine/engines.hpp"

namespace rayclock::test {

/// Returns all structures that have nodes.
inline std::vector<Structure> tree_structures() {
    std::vector<Structure> all;
    for (int s = 0; s < int(names_of<Structure>().size()); ++s)
        if (Structure(s) != Structure::none) all.push_back(Structure(s));
    return all;
}
/// Returns one structure for each engine.
inline std::vector<Structure> engines() {
    std::vector<Structure> all;
    for_each_engine([&]<class E>(E) { all.push_back(E::structure); });
    return all;
}

}   // namespace rayclock::test
