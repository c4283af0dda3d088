#pragma once
// What a memory says of the time until which nothing changes in it, held against what then happens.
#include <catch2/catch.hpp>

namespace rayclock::test {

/// Steps one of two memories that are alike to where the other says that something could change, and skips
/// the other one there; false, and does nothing, if that is now or never. `now`: cycles that both have seen.
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
