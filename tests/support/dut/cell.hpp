#pragma once
// A pipelined arithmetic cell without a door: valid and operands in, the answer a fixed number of cycles
// later.
#include <catch2/catch.hpp>
#include <deque>
#include <optional>

#include "sim/run/rtl/rtl_module.hpp"
#include "tests/support/cases/draw.hpp"

namespace rayclock::test {

/// Hands `count` operands to a cell, with idle cycles between them if `idle`, and compares in every cycle:
/// the answer must come after exactly `stages` cycles, one in each cycle if asked so, and stay until the next
/// one (a stage works only if valid). make(draw) gives operands, drive(rtl, operands) sets them,
/// answer(operands) is what must come out of `port`.
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
