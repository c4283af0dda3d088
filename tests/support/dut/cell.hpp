#pragma once
// Tests a pipelined arithmetic cell without a credit counter: valid and operands go in, the answer comes a
// fixed number of cycles later.
#include <catch2/catch.hpp>
#include <deque>
#include <optional>

#include "sim/run/rtl/rtl_module.hpp"
#include "tests/support/cases/draw.hpp"

namespace rayclock::test {

/// Sends `count` operands to a cell, with idle cycles in between if `idle`, and compares in every cycle. The
/// answer must come after exactly `stages` cycles, one per cycle at full rate. It must stay until the next
/// one, because a stage works only if valid. make(draw) returns operands, drive(rtl, operands) sets them, and
/// answer(operands) is the expected value of `port`.
template <class Make, class Drive, class Answer>
void check_cell(const Config& config, const char* module, const char* port, int stages, unsigned seed,
                int count, bool idle, Make make, Drive drive, Answer answer) {
    using Operands = decltype(make(std::declval<Draw&>()));
    RtlModule rtl(config, module, int(seed));
    Draw draw{seed};
    std::deque<std::optional<Operands>> under_way(std::size_t(stages - 1), std::nullopt);
    std::optional<Operands> shown;
    for (int i = 0, sent = 0; sent < count || i < count + stages; ++i) {
        const Operands operands = make(draw);
        const std::uint32_t valid = !idle || draw.coin();
        std::memcpy(rtl.port("valid").data, &valid, rtl.port("valid").bytes);
        drive(rtl, operands);
        rtl.settle();
        if (shown) {
            INFO(module << ", seed " << seed << ", cycle " << i);
            Words words((rtl.port(port).bytes + 3) / 4);
            std::memcpy(words.data(), rtl.port(port).data, rtl.port(port).bytes);
            const Words expected = answer(*shown);
            if (words != expected)
                FAIL("got word 0 " << words[0] << " of " << words.size() << ", last " << words.back()
                                   << "; the model says " << expected[0] << ", " << expected.back());
        }
        under_way.push_back(valid ? std::optional(operands) : std::nullopt);
        if (under_way.front()) shown = under_way.front();
        under_way.pop_front();
        sent += valid != 0;
        rtl.clock();
    }
    REQUIRE(shown);
}

}   // namespace rayclock::test
