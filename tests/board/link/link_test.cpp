// rc_link under Verilator with the host's library at the other end of two wires of bytes: every command, and
// wires that lose, double, damage and insert bytes.
#include <algorithm>

#include "tests/support/board/answers.hpp"
#include "tests/board/link/link_board.hpp"
#include "tests/support/machine/build_all.hpp"
#include <catch2/catch.hpp>

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// A board, a link to it and their twin, in a session.
struct LinkBench {
    explicit LinkBench(int seed, LinkSettings settings = ByteBoard::settings())
        : board(seed), link(board, settings), twin(board, link, seed) {
        identity = link.hello();
    }
    ByteBoard board;
    BoardLink link;
    LinkTwin twin;
    BoardIdentity identity;
};

/// Sends a packet and returns the answers that come within some cycles.
std::vector<LinkAnswer> answers_to(ByteBoard& board, const std::vector<std::uint8_t>& bytes,
                                   int cycles = 2000) {
    board.to_board.insert(board.to_board.end(), bytes.begin(), bytes.end());
    for (int i = 0; i < cycles; ++i) board.step();
    AnswerDecoder decoder;
    const std::vector<std::uint8_t> got(board.to_host.begin(), board.to_host.end());
    board.to_host.clear();
    decoder.push(got);
    std::vector<LinkAnswer> answers;
    while (std::optional<LinkAnswer> answer = decoder.next()) answers.push_back(*answer);
    CHECK(decoder.discarded() == 0);
    return answers;
}
LinkAnswer answer_to(ByteBoard& board, const LinkCommand& command) {
    const std::vector<LinkAnswer> answers = answers_to(board, packet_bytes(command));
    REQUIRE(answers.size() == 1);
    CHECK(answers[0].kind == command.kind);
    CHECK(answers[0].sequence == command.sequence);
    return answers[0];
}

/// Random operations over wires with faults, until so many different packets were sent.
void abuse(int seed, std::uint64_t packets, int chance, int max_lines, int pace) {
    INFO("seed " << seed << ", " << chance << " faults of each kind in a million bytes");
    LinkSettings settings = ByteBoard::settings();
    settings.window = 1 + seed % link_history;
    settings.tries = 200;   // a packet of 16 lines often needs several
    LinkBench bench(seed, settings);
    bench.board.pace = pace;
    bench.board.memory_pause = 1 + seed % 6;
    bench.board.to_board_faults = bench.board.to_host_faults = Faults::all(chance);
    while (bench.link.counts().packets < packets) REQUIRE(bench.twin.act(max_lines));
    bench.board.to_board_faults = bench.board.to_host_faults = {};
    CHECK(bench.twin.agrees());
    std::vector<MemoryLine> all(LinkBoard::lines);
    bench.link.read_lines(0, all);
    CHECK(all == bench.board.memory);
    if (chance > 0) CHECK(bench.link.counts().repeated > 0);
}

}   // namespace

TEST_CASE("the RTL of the host link builds", "[.build]") {
    const Config config;
    std::vector<RtlJob> jobs;
    for (const int quiet : {ByteBoard::quiet, 1'500'000})
        jobs.push_back({"rc_link LineBits=10 QuietCycles=" + std::to_string(quiet), "bytes", config});
    build_all(jobs);
    SUCCEED("all are there");
}

TEST_CASE("a session begins with a hello, and the board says what it is", "[link]") {
    LinkBench bench(1);
    CHECK(bench.identity.version == link_version);
    CHECK(bench.identity.config_hash == 0x9abc'def0'1234'5678u);
    CHECK(bench.identity.lines == LinkBoard::lines);
    CHECK(bench.link.counts().repeated == 0);
}

TEST_CASE("registers and lines are written and read without a fault of the wires", "[link]") {
    LinkBench bench(2);
    for (int i = 0; i < 300; ++i) REQUIRE(bench.twin.act(40));
    CHECK(bench.twin.agrees());
    CHECK(bench.link.counts().repeated == 0);
    CHECK(bench.board.bad == 0);
    bench.link.write(BoardRegister::base, 99);
    CHECK(bench.link.read(BoardRegister::base) == 99);
}

TEST_CASE("the board refuses what it cannot do, and the session goes on", "[link]") {
    LinkBench bench(3);
    const auto reason = [](const auto& act) {
        try {
            act();
        } catch (const LinkRefused& refused) {
            CHECK(std::string(refused.what()).starts_with("test: the board refuses"));
            return refused.reason;
        }
        return LinkReason::done;
    };
    BoardLink& link = bench.link;
    std::vector<MemoryLine> lines(3);
    CHECK(reason([&] { link.read_register(RegisterSpace::chip, LinkBoard::registers); }) ==
          LinkReason::bus_error);
    CHECK(reason([&] { link.read_register(RegisterSpace::chip, 1 << 14); }) == LinkReason::bad_address);
    CHECK(reason([&] { link.read_register(RegisterSpace::board, 16); }) == LinkReason::bad_address);
    CHECK(reason([&] { link.read_register(RegisterSpace::board, 256); }) == LinkReason::bad_address);
    CHECK(reason([&] { link.write(BoardRegister::magic, 1); }) == LinkReason::bad_address);
    CHECK(reason([&] { link.write_lines(LinkBoard::lines - 2, lines); }) == LinkReason::bad_address);
    CHECK(reason([&] { link.read_lines(LinkBoard::lines - 2, lines); }) == LinkReason::bad_address);
    CHECK(reason([&] { link.read_lines(0x8000'0000u, lines); }) == LinkReason::bad_address);
    CHECK(reason([&] { link.check_lines(0, LinkBoard::lines + 1); }) == LinkReason::bad_address);
    CHECK(reason([&] { link.check_lines(0, 0); }) == LinkReason::bad_address);
    CHECK(reason([&] { link.read_lines(LinkBoard::lines - 3, lines); }) == LinkReason::done);
    CHECK(link.check_lines(0, LinkBoard::lines) ==
          link_checksum({bench.board.memory[0].data(), LinkBoard::lines * sizeof(MemoryLine)}));
    bench.board.chip_is_silent = true;
    CHECK(reason([&] { link.read_register(RegisterSpace::chip, 0); }) == LinkReason::bus_silence);
    bench.board.chip_is_silent = false;
    CHECK(bench.board.writes.empty());

    // A refusal in the middle of a window: the packets behind it are still answered.
    std::vector<MemoryLine> many(LinkBoard::lines);
    CHECK(reason([&] { link.write_lines(500, many); }) == LinkReason::bad_address);
    CHECK(bench.board.writes.size() <= LinkBoard::lines);
    CHECK(reason([&] { link.read_register(RegisterSpace::chip, 0); }) == LinkReason::done);
    CHECK(link.counts().repeated == 0);
}

TEST_CASE("a packet that is sent again is answered again, and not executed again", "[link]") {
    ByteBoard board(4);
    LinkCommand hello{LinkKind::hello, 250, 1234};
    CHECK(answer_to(board, {LinkKind::read_register, 250, 3}).reason == LinkReason::no_session);
    CHECK(answer_to(board, hello).value == 1234);
    std::vector<LinkCommand> sent;
    for (std::uint8_t i = 0; i < link_history; ++i) {
        // Numbers 251, 252, ..., 255, 0, ...: a write that counts, a read, or a refusal.
        const std::uint8_t sequence = std::uint8_t(251 + i);
        const LinkCommand command =
            i % 3 == 0   ? LinkCommand{LinkKind::write_register, sequence, i, 0, 1000u + i}
            : i % 3 == 1 ? LinkCommand{LinkKind::read_register, sequence, i - 1u}
                         : LinkCommand{LinkKind::read_register, sequence, LinkBoard::registers + i};
        sent.push_back(command);
        const LinkAnswer answer = answer_to(board, command);
        CHECK(answer.reason == (i % 3 == 2 ? LinkReason::bus_error : LinkReason::done));
        CHECK(answer.value == (i % 3 == 1 ? 999u + i : 0));
    }
    const std::size_t writes = board.writes.size();
    const std::uint64_t reads = board.reads;
    std::ranges::fill(board.chip, 0u);
    for (std::uint8_t i = 0; i < link_history; ++i) {
        const LinkAnswer answer = answer_to(board, sent[i]);
        CHECK(answer.reason == (i % 3 == 2 ? LinkReason::bus_error : LinkReason::done));
        CHECK(answer.value == (i % 3 == 1 ? 999u + i : 0));
    }
    CHECK(board.writes.size() == writes);
    CHECK(board.reads == reads);
    // Beyond the window on both sides: a gap, and the expected number.
    const std::uint8_t expected = std::uint8_t(251 + link_history);
    for (const int other : {1, 2, 100, 128, 200, 255 - link_history}) {
        const LinkAnswer gap = answer_to(board, {LinkKind::read_register, std::uint8_t(expected + other), 0});
        CHECK(gap.reason == LinkReason::gap);
        CHECK(gap.value == expected);
    }
    CHECK(board.reads == reads);
    CHECK(answer_to(board, {LinkKind::read_register, expected, 0}).reason == LinkReason::done);
    // A kind that does not exist is refused like any other command, and takes its number.
    CHECK(answer_to(board, {LinkKind(7), std::uint8_t(expected + 1)}).reason == LinkReason::bad_kind);
    CHECK(answer_to(board, {LinkKind(0), std::uint8_t(expected + 2)}).reason == LinkReason::bad_kind);
}

TEST_CASE("lines that are read again come from memory, without a write in between", "[link]") {
    ByteBoard board(5);
    answer_to(board, {LinkKind::hello, 0, 1});
    board.memory[7][0] = 42;
    const LinkCommand read{LinkKind::read_lines, 1, 6, 2};
    for (int i = 0; i < 3; ++i) {
        const LinkAnswer answer = answer_to(board, read);
        REQUIRE(answer.lines.size() == 2);
        CHECK(answer.lines[0] == board.memory[6]);
        CHECK(answer.lines[1] == board.memory[7]);
    }
    CHECK(answer_to(board, {LinkKind::read_register, 2, 0}).reason == LinkReason::done);
    CHECK(answer_to(board, read).lines.size() == 2);   // not the last packet any more
    CHECK(answer_to(board, {LinkKind::read_register, 3, 0}).reason == LinkReason::done);
}

TEST_CASE("a damaged packet has no effect and no answer, wherever the damage is", "[link]") {
    ByteBoard board(6);
    answer_to(board, {LinkKind::hello, 9, 1});
    const std::vector<std::uint8_t> sound = packet_bytes({LinkKind::write_register, 10, 3, 0, 5});
    for (std::size_t byte = 0; byte < sound.size(); ++byte)
        for (int bit = 0; bit < 8; ++bit) {
            std::vector<std::uint8_t> damaged = sound;
            damaged[byte] ^= std::uint8_t(1 << bit);
            INFO("byte " << byte << ", bit " << bit);
            REQUIRE(answers_to(board, damaged, ByteBoard::quiet + 200).empty());
        }
    CHECK(board.writes.empty());
    for (std::size_t length = 0; length < sound.size(); ++length) {   // cut off
        const std::vector<std::uint8_t> part(sound.begin(), sound.begin() + std::ptrdiff_t(length));
        REQUIRE(answers_to(board, part, ByteBoard::quiet + 200).empty());
    }
    CHECK(board.writes.empty());
    CHECK(answers_to(board, sound).size() == 1);
    CHECK(board.writes == std::vector<LinkBoard::Write>{{3, 5}});
}

TEST_CASE("a write of no line, or of more lines than fit, is dropped after its head and counted", "[link]") {
    ByteBoard board(10);
    answer_to(board, {LinkKind::hello, 0, 1});
    std::uint64_t dropped = 0;
    for (const unsigned count : {0u, 17u, 32u, 0xffffu}) {
        INFO(count << " lines");
        const std::vector<std::uint8_t> head{link_mark[0],
                                             link_mark[1],
                                             std::uint8_t(LinkKind::write_lines),
                                             1,
                                             0,
                                             0,
                                             0,
                                             0,
                                             std::uint8_t(count),
                                             std::uint8_t(count >> 8)};
        REQUIRE(answers_to(board, head, 500).empty());
        CHECK(board.bad == ++dropped);
        CHECK(answer_to(board, {LinkKind::read_register, std::uint8_t(dropped), 0}).reason ==
              LinkReason::done);
    }
    CHECK(board.bad == dropped);
    CHECK(std::ranges::all_of(board.memory, [](const MemoryLine& line) { return line == MemoryLine{}; }));
}

TEST_CASE("after any garbage the board answers within one packet, or after a silence", "[link]") {
    ByteBoard board(7);
    answer_to(board, {LinkKind::hello, 255, 1});
    Rng rng(7);
    for (int i = 0; i < 300; ++i) {
        INFO("garbage " << i);
        // Bytes with many marks and heads of large packets; then as many as the largest packet has, so that
        // whatever the garbage announced is complete.
        std::vector<std::uint8_t> garbage(std::size_t(rng.below(200)));
        for (std::uint8_t& byte : garbage) {
            const std::uint8_t likely[] = {link_mark[0], link_mark[1], 4, 16, 0};
            byte = rng.below(4) == 0 ? std::uint8_t(rng.next()) : likely[rng.below(5)];
        }
        const bool after_silence = i % 2 == 0;
        if (!after_silence) garbage.insert(garbage.end(), link_packet_most, 0);
        answers_to(board, garbage, after_silence ? int(ByteBoard::quiet + garbage.size() + 50) : 1);
        const std::vector<LinkAnswer> answers =
            answers_to(board, packet_bytes({LinkKind::read_register, std::uint8_t(i), 0}), 3000);
        REQUIRE(answers.size() == 1);
        REQUIRE(answers[0].reason == LinkReason::done);
    }
    CHECK(board.writes.empty());
}

TEST_CASE("the first mark is found behind its own first byte", "[link]") {
    for (const std::size_t before : {1u, 2u, 3u}) {
        ByteBoard board(8);
        std::vector<std::uint8_t> bytes(before, link_mark[0]);
        const std::vector<std::uint8_t> hello = packet_bytes({LinkKind::hello, 3, 8});
        bytes.insert(bytes.end(), hello.begin(), hello.end());
        CHECK(answers_to(board, bytes).size() == 1);
    }
}

TEST_CASE("answers to an earlier program are not taken for answers to this one", "[link]") {
    ByteBoard board(9);
    // The other program's hello had another number; the rest of its answers fit the new session.
    for (const std::vector<std::uint8_t>& old :
         {answer_bytes(0x81, 0, 76, 0), answer_bytes(0x83, 1, 1234, 0)})
        board.to_host.insert(board.to_host.end(), old.begin(), old.end());
    BoardLink link(board, ByteBoard::settings());
    CHECK(link.hello().version == link_version);
}

TEST_CASE("a lost packet or answer is sent again without waiting for a timeout", "[link]") {
    const auto cycles = [](std::uint64_t byte, bool of_answer) {
        LinkBench bench(51);
        const std::vector<MemoryLine> lines = bench.twin.random_lines(320);
        if (byte > 0 && of_answer) bench.board.lose_back = bench.board.bytes_back + byte;
        if (byte > 0 && !of_answer) bench.board.lose = bench.board.bytes_sent + byte;
        const std::uint64_t begin = bench.board.cycle;
        bench.link.write_lines(0, lines);
        CHECK(bench.link.counts().repeated >= (byte > 0));
        CHECK(bench.link.counts().repeated <= 8);
        CHECK(std::ranges::equal(lines, std::span(bench.board.memory).first(lines.size())));
        return bench.board.cycle - begin;
    };
    const std::uint64_t without = cycles(0, false);
    // The bytes of a window, once more. A timeout is more than twice as long, because the board may take 150
    // cycles for a line.
    for (const std::uint64_t byte : {600u, 5000u, 11'000u}) CHECK(cycles(byte, false) < without + 12'000);
    for (const std::uint64_t byte : {5u, 61u, 145u}) CHECK(cycles(byte, true) < without + 12'000);
}

TEST_CASE("a session begins behind garbage, and behind the half packet of a program that was killed",
          "[link]") {
    for (int seed = 0; seed < 40; ++seed) {
        INFO("seed " << seed);
        ByteBoard board(seed);
        Rng rng(std::uint64_t(seed) + 5);
        for (int i = rng.below(500); i > 0; --i) board.to_board.push_back(std::uint8_t(rng.next()));
        for (int i = rng.below(500); i > 0; --i) board.to_host.push_back(std::uint8_t(rng.next()));
        const std::vector<MemoryLine> lines(16);
        const std::vector<std::uint8_t> packet = packet_bytes({LinkKind::write_lines, 0, 0, 16, 0, lines});
        for (int i = 0, n = rng.below(int(packet.size())); i < n; ++i)
            board.to_board.push_back(packet[std::size_t(i)]);
        BoardLink link(board, ByteBoard::settings());
        CHECK(link.hello().lines == LinkBoard::lines);
        CHECK(board.writes.empty());
    }
}

TEST_CASE("nothing is lost, doubled or wrong when bytes are", "[faults][long]") {
    abuse(11, 4000, 50, 40, 1);
    abuse(12, 3000, 500, 20, 1);
    abuse(13, 3000, 3000, 1, 2);
}

TEST_CASE("nothing is lost, doubled or wrong in a million packets", "[faults][slow]") {
    // Many faults with small packets, few with large ones: else hardly any packet arrives.
    const std::pair<int, int> chance_and_lines[] = {{30, 30}, {100, 8}, {500, 3}, {2000, 1}};
    for (int seed = 0; seed < 40; ++seed) {
        const auto [chance, max_lines] = chance_and_lines[seed % 4];
        abuse(100 + seed, 25'000, chance, max_lines, 1 + seed % 3 / 2);
    }
}

TEST_CASE("an upload goes on where a cut cable stopped it", "[link]") {
    LinkBench bench(20);
    const std::vector<MemoryLine> lines = bench.twin.random_lines(LinkBoard::lines - 5);
    std::uint64_t done = 0, seen = 0;
    const Progress progress = [&](std::string_view what, std::uint64_t now, std::uint64_t total) {
        CHECK(what == "uploading lines");
        CHECK(now >= seen);
        CHECK(total == lines.size());
        seen = now;
    };
    int cuts = 0;
    for (; done < lines.size(); ++cuts) {
        REQUIRE(cuts < 100);
        bench.board.cut_after = bench.board.bytes_sent + 5001;
        bench.board.cut = false;
        try {
            bench.link.hello();
            bench.link.upload(3, lines, done, progress);
        } catch (const LinkLost&) {}
        CHECK(done == seen);
        // What is counted as done is in memory.
        CHECK(
            std::equal(lines.begin(), lines.begin() + std::ptrdiff_t(done), bench.board.memory.begin() + 3));
    }
    CHECK(cuts > 10);
    CHECK(std::ranges::equal(lines, std::span(bench.board.memory).subspan(3, lines.size())));
    // No packet was executed twice, except those whose answers the cut took.
    CHECK(bench.board.writes.size() <= lines.size() + std::size_t(cuts) * 8 * link_lines_most);
}

TEST_CASE("another program finds out by checksums how far an upload came", "[link]") {
    LinkBench bench(21);
    const std::vector<MemoryLine> lines = bench.twin.random_lines(900);
    for (const std::size_t there : {0u, 1u, 15u, 16u, 17u, 431u, 899u, 900u}) {
        std::copy(lines.begin(), lines.begin() + std::ptrdiff_t(there), bench.board.memory.begin() + 100);
        for (std::size_t i = there; i < lines.size(); ++i) {
            bench.board.memory[100 + i] = lines[i];
            bench.board.memory[100 + i][std::size_t(bench.board.rng.below(64))] ^= 1;
        }
        CHECK(bench.link.lines_that_hold(100, lines) == there);
    }
    std::uint64_t done = bench.link.lines_that_hold(100, std::span(lines).first(600));
    CHECK(done == 600);
}

TEST_CASE("a reset in the middle is reported, and the next session works", "[link]") {
    for (int seed = 0; seed < 20; ++seed) {
        INFO("seed " << seed);
        LinkBench bench(30 + seed);
        const std::vector<MemoryLine> lines = bench.twin.random_lines(800);
        std::uint64_t done = 0;
        const std::uint64_t at = std::uint64_t(1 + bench.board.rng.below(40));
        bool was_reset = false;
        const Progress progress = [&](std::string_view, std::uint64_t now, std::uint64_t) {
            if (now / link_lines_most < at || was_reset) return;
            for (int i = bench.board.rng.below(900); i > 0; --i) bench.board.step();
            bench.board.reset();
            was_reset = true;
        };
        REQUIRE_THROWS_AS(bench.link.upload(0, lines, done, progress), BoardReset);
        bench.link.hello();
        done = bench.link.lines_that_hold(0, lines);
        bench.link.upload(0, lines, done);
        CHECK(std::ranges::equal(lines, std::span(bench.board.memory).first(lines.size())));
    }
}

TEST_CASE("a board that does not answer is one sentence", "[link]") {
    ByteBoard board(40);
    LinkSettings settings = ByteBoard::settings();
    settings.tries = 3;
    BoardLink link(board, settings);
    board.to_board_faults.lost = 1'000'000;
    REQUIRE_THROWS_WITH(link.hello(), Catch::Contains("test: no rayclock board answers"));
    board.to_board_faults.lost = 0;
    link.hello();
    board.to_host_faults.lost = 1'000'000;
    REQUIRE_THROWS_WITH(link.read_register(RegisterSpace::chip, 1),
                        "test: the board does not answer any more (3 tries)");
    board.to_host_faults.lost = 0;
    link.hello();
    CHECK(link.read_register(RegisterSpace::chip, 1) == board.chip[1]);
    board.board[0] = 0x1234;
    REQUIRE_THROWS_WITH(link.hello(), Catch::Contains("not a rayclock board"));
    board.board[0] = board_magic, board.board[1] = 2;
    REQUIRE_THROWS_WITH(link.hello(),
                        "test: the board speaks version 2 of the link, and this program version 1");
}

TEST_CASE("a window of packets keeps the wire busy", "[link]") {
    // With eight packets in flight an upload takes hardly more cycles than its bytes do.
    LinkBench bench(50);
    bench.board.memory_pause = 2;
    const std::vector<MemoryLine> lines = bench.twin.random_lines(1000);
    const std::uint64_t begin = bench.board.cycle;
    bench.link.write_lines(0, lines);
    const double cycles = double(bench.board.cycle - begin);
    const double bytes = double(lines.size()) * 64;
    INFO(cycles / bytes << " cycles per byte");
    CHECK(cycles / bytes < 2.6);   // a byte a cycle, then 32 beats of two cycles each for 64 bytes
    CHECK(bench.link.counts().repeated == 0);
}
