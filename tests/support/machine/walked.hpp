#pragma once
// The words of a trace, made from the steps of a walk.
#include <cstdint>
#include <vector>

#include "model/trace/trace.hpp"
#include "model/trace/walk.hpp"

namespace rayclock::test {

/// Appends the words of the ray on which `walk` has started, as described in Trace, assembled from Walk's
/// steps.
inline void append_walk(Walk& walk, std::vector<std::uint32_t>& words) {
    for (bool done = false; !done;) {
        const std::size_t head = words.size();
        words.push_back(walk.node());
        for (bool more = walk.visit_node(); more; more = walk.advance()) {
            words.push_back(walk.prim());
            walk.test_triangle();
        }
        if (words.size() > head + 1) {
            words.back() |= TestWord::last_flag;
            words[head] |= VisitWord::tests_flag;
        }
        const std::uint32_t turns = walk.decide(done);
        words[head] |= (done ? VisitWord::end_flag : 0) | turns << VisitWord::dropped_shift;
    }
}

}   // namespace rayclock::test
