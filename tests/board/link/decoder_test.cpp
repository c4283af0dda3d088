// The host's decoder of answers, without RTL: answers between any other bytes, and boards that send anything.
#include <catch2/catch.hpp>

#include "model/base/rng.hpp"
#include "tests/support/board/answers.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

std::vector<MemoryLine> any_lines(Rng& rng, std::size_t count) {
    std::vector<MemoryLine> lines(count);
    for (MemoryLine& line : lines)
        for (std::uint8_t& byte : line) byte = std::uint8_t(rng.next());
    return lines;
}

/// Garbage with many marks, kinds and heads.
std::vector<std::uint8_t> garbage(Rng& rng) {
    std::vector<std::uint8_t> bytes(std::size_t(rng.below(60)));
    for (std::uint8_t& byte : bytes) {
        const std::uint8_t likely[] = {0xc5, 0x3a, 0x85, 0x81, 16, 0};
        byte = rng.below(3) == 0 ? std::uint8_t(rng.next()) : likely[rng.below(6)];
    }
    return bytes;
}

}   // namespace

TEST_CASE("a packet has the bytes that its description lists", "[decoder]") {
    const std::vector<std::uint8_t> bytes =
        packet_bytes({LinkKind::write_register, 0x12, 0x8000'000a, 0, 0xdead'beef});
    const std::vector<std::uint8_t> head{0xc5, 0x3a, 2, 0x12, 0x0a, 0, 0, 0x80, 0, 0, 0xef, 0xbe, 0xad, 0xde};
    REQUIRE(bytes.size() == head.size() + 4);
    CHECK(std::equal(head.begin(), head.end(), bytes.begin()));
    // The check value of this CRC: the digits 1 to 9.
    const std::uint8_t digits[] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
    CHECK(link_checksum(digits) == 0xcbf4'3926);
    Rng rng(1);
    const std::vector<MemoryLine> lines = any_lines(rng, 17);
    CHECK(packet_bytes({LinkKind::write_lines, 0, 0, 16, 0, std::span(lines).first(16)}).size() ==
          link_packet_most);
    CHECK_THROWS_AS(packet_bytes({LinkKind::write_lines, 0, 0, 17, 0, lines}), std::logic_error);
    CHECK_THROWS_AS(packet_bytes({LinkKind::write_lines, 0, 0, 0, 0, {}}), std::logic_error);
    CHECK_THROWS_AS(packet_bytes({LinkKind::read_register, 0, 0, 1, 0, std::span(lines).first(1)}),
                    std::logic_error);
}

TEST_CASE("every answer is found between any other bytes, however they are cut", "[decoder]") {
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        std::vector<std::uint8_t> stream;
        std::vector<LinkAnswer> sent;
        for (int i = 0; i < 8; ++i) {
            const std::vector<std::uint8_t> before = garbage(rng);
            stream.insert(stream.end(), before.begin(), before.end());
            LinkAnswer answer;
            answer.sequence = std::uint8_t(rng.next());
            answer.value = std::uint32_t(rng.next());
            std::uint8_t kind = std::uint8_t(0x81 + rng.below(6));
            if (rng.below(4) == 0) {
                kind |= 0x40;
                answer.count = std::uint16_t(1 + rng.below(6));
                answer.reason = LinkReason(answer.count);
            } else if (kind == 0x85) {
                answer.count = std::uint16_t(1 + rng.below(16));
                answer.lines = any_lines(rng, answer.count);
            } else {
                answer.count = std::uint16_t(rng.next());
            }
            answer.kind = LinkKind(kind & 0x3f);
            const std::vector<std::uint8_t> bytes =
                answer_bytes(kind, answer.sequence, answer.value, answer.count, answer.lines);
            stream.insert(stream.end(), bytes.begin(), bytes.end());
            sent.push_back(answer);
        }
        AnswerDecoder decoder;
        std::size_t found = 0;
        const auto take = [&] {
            while (const std::optional<LinkAnswer> answer = decoder.next()) {
                REQUIRE(found < sent.size());
                CHECK(answer->kind == sent[found].kind);
                CHECK(answer->reason == sent[found].reason);
                CHECK(answer->sequence == sent[found].sequence);
                CHECK(answer->value == sent[found].value);
                CHECK(answer->count == sent[found].count);
                CHECK(answer->lines == sent[found].lines);
                ++found;
            }
        };
        for (std::size_t at = 0; at < stream.size();) {
            const std::size_t part = std::min(stream.size() - at, std::size_t(1 + rng.below(200)));
            decoder.push(std::span(stream).subspan(at, part));
            at += part;
            take();
        }
        for (std::size_t i = 0; i < link_packet_most; ++i) decoder.give_up(), take();
        CHECK(found == sent.size());
    }
}

TEST_CASE("an answer with any wrong bit is discarded", "[decoder]") {
    Rng rng(3);
    for (const std::uint8_t kind : std::initializer_list<std::uint8_t>{0x83, 0x85, 0xc4}) {
        const std::vector<MemoryLine> lines = any_lines(rng, kind == 0x85 ? 1 : 0);
        const std::vector<std::uint8_t> sound = answer_bytes(kind, 1, 2, 1, lines);
        for (std::size_t bit = 0; bit < 8 * sound.size(); ++bit) {
            std::vector<std::uint8_t> wrong = sound;
            wrong[bit / 8] ^= std::uint8_t(1 << bit % 8);
            AnswerDecoder decoder;
            decoder.push(wrong);
            for (std::size_t i = 0; i < wrong.size(); ++i) {
                REQUIRE_FALSE(decoder.next());
                decoder.give_up();
            }
        }
    }
    // Sound, but no answer: a command, a refusal without a reason, too many lines.
    for (const auto& bytes :
         {answer_bytes(0x03, 1, 2, 0), answer_bytes(0xc3, 1, 2, 0), answer_bytes(0xc3, 1, 2, 256),
          answer_bytes(0x85, 1, 2, 0), answer_bytes(0x85, 1, 2, 17, any_lines(rng, 17))}) {
        AnswerDecoder decoder;
        decoder.push(bytes);
        CHECK_FALSE(decoder.next());
    }
}

TEST_CASE("the host ends with one sentence whatever the board sends", "[decoder]") {
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        std::vector<std::uint8_t> script = answer_bytes(0x81, 0, 9, 0);   // a hello, so that more is tried
        for (int i = rng.below(20); i >= 0; --i) {
            const std::uint8_t kinds[] = {0x82, 0x83, 0x84, 0x85, 0x86, 0xc3, 0xc4, 0xff};
            const std::uint32_t values[] = {board_magic, link_version, 3, std::uint32_t(rng.next())};
            const std::uint16_t count = std::uint16_t(rng.below(18));
            const std::uint8_t kind = kinds[rng.below(8)];
            const std::vector<std::uint8_t> more =
                rng.below(5) == 0 ? garbage(rng)
                                  : answer_bytes(kind, std::uint8_t(rng.below(12)), values[rng.below(4)],
                                                 count, any_lines(rng, kind == 0x85 ? count : 0));
            script.insert(script.end(), more.begin(), more.end());
        }
        HostileBoard board(script);
        LinkSettings settings;
        settings.patience = LinkTime(20'000);
        settings.hello = 9;
        settings.tries = 3;
        BoardLink link(board, settings);
        std::vector<MemoryLine> lines(100);
        try {
            link.hello();
            link.read_lines(0, lines);
            link.write_lines(0, lines);
            link.lines_that_hold(0, lines);
        } catch (const UserError& error) {
            CHECK(std::string(error.what()).starts_with("t"));   // the port's name
        }
        CHECK(board.calls < 400'000);
    }
}
