#pragma once
// Checks a memory's prediction of when it next changes against its actual behaviour.
#include <catch2/catch.hpp>

namespace rayclock::test {

/// Steps one of two equal memories to the time at which the other predicts the next possible change, and
/// skips the other to it. Returns false and does nothing if that time is now or never. `now` is the number of
/// cycles that both have run.
template <class M> bool pass_quiet(M& stepped, M& skipped, std::uint64_t& now) {
    const std::uint64_t until = skipped.quiet_until();
    if (skipped.valid() || until == ~std::uint64_t(0) || until <= now) return false;
    const bool ready = stepped.ready();
    for (std::uint64_t t = now; t < until; ++t) {
        REQUIRE_FALSE(stepped.valid());
        REQUIRE(stepped.ready() == ready);
        stepped.clock(nullptr);
    }
    skipped.skip(until - now);
    now = until;
    return true;
}

}   // namespace rayclock::test
