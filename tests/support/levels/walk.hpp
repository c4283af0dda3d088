#pragma once
// Walks rays through two levels like Walk, and counts the steps.
#include "model/trace/walk.hpp"

namespace rayclock {

/// The work of rays.
struct LevelCounts {
    /// Nodes of both levels, entered instances, and tested primitives.
    std::uint64_t visits = 0, changes = 0, tests = 0;
    LevelCounts& operator+=(const LevelCounts& other) {
        visits += other.visits, changes += other.changes, tests += other.tests;
        return *this;
    }
};

/// Walks rays one after the other.
class LevelWalk {
public:
    LevelWalk(const Frame& frame, const Decoder& decoder, const Config& config)
        : walk_(frame, config, decoder) {}

    Closest trace(const Ray& ray) {
        walk_.start_at(ray);
        walk_.run(*this);
        return walk_.closest();
    }
    const Best& best() const { return walk_.best(); }   ///< of the last ray
    const LevelCounts& counts() const { return counts_; }

    // Called by its own walk.
    template <class Steps> void visit(const Steps& steps) {
        counts_.changes += steps.enters();
        counts_.visits += !steps.enters();
    }
    void test(std::uint32_t) { ++counts_.tests; }
    void decided(std::uint32_t, bool) {}

private:
    Walk walk_;
    LevelCounts counts_;
};

}   // namespace rayclock
