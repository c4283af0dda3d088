// Fuzzes the host's end of the link to a board.
#include "tests/support/board/answers.hpp"
#include "tests/fuzz/program/targets.hpp"

namespace rayclock::fuzz {

namespace {

std::span<const std::uint8_t> as_bytes(std::string_view text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// Everything that the decoder finds is in the input, byte by byte, and nothing hides an answer behind it.
void check_decoder(std::string_view text) {
    const std::vector<std::uint8_t> last = test::answer_bytes(0x83, 77, 0x1234'5678, 5);
    std::string all(text);
    all.append(last.begin(), last.end());
    AnswerDecoder decoder;
    for (std::size_t at = 0; at < all.size();) {   // in parts of all sizes
        const std::size_t part = std::min(all.size() - at, std::size_t(1 + std::uint8_t(all[at]) % 64));
        decoder.push(as_bytes(std::string_view(all).substr(at, part)));
        at += part;
    }
    bool found_last = false;
    std::size_t from = 0;
    for (std::size_t steps = 0; steps <= 2 * all.size(); ++steps) {
        while (const std::optional<LinkAnswer> answer = decoder.next()) {
            const bool refuses = answer->reason != LinkReason::done;
            demand(!refuses || answer->lines.empty(), "a refusal has no lines");
            demand(answer->lines.size() <= link_lines_most, "an answer has at most sixteen lines");
            const std::vector<std::uint8_t> bytes =
                test::answer_bytes(std::uint8_t(0x80 | (refuses ? 0x40 : 0) | int(answer->kind)),
                                   answer->sequence, answer->value, answer->count, answer->lines);
            const std::size_t at = all.find(std::string(bytes.begin(), bytes.end()), from);
            demand(at != all.npos, "an answer was received, after the one before it");
            from = at + bytes.size();
            found_last = bytes == last;
        }
        decoder.give_up();
    }
    demand(found_last, "an answer is found behind any bytes");
}

}   // namespace

void board_link(std::string_view bytes) {
    check_decoder(bytes);
    // The same bytes as fields of sound answers: kind, sequence, value, count. A hello goes before them.
    std::vector<std::uint8_t> script = test::answer_bytes(0x81, 0, 9, 0);
    const auto fields = as_bytes(bytes);
    for (std::size_t at = 0; at + 5 <= fields.size(); at += 5) {
        const std::uint8_t kind = std::uint8_t(0x80 | fields[at]);
        const std::uint16_t count = fields[at + 4];
        const std::vector<MemoryLine> lines(kind == 0x85 && count <= link_lines_most ? count : 0);
        const std::uint32_t value = fields[at + 2] == 'm' ? board_magic : fields[at + 2] & 3u;
        const std::vector<std::uint8_t> more =
            test::answer_bytes(kind, fields[at + 1] % 16, value, count, lines);
        script.insert(script.end(), more.begin(), more.end());
    }
    test::HostileBoard board(script);
    LinkSettings settings;
    settings.patience = LinkTime(2000);
    settings.hello = 9;
    settings.tries = 3;
    BoardLink link(board, settings);
    std::vector<MemoryLine> lines(40);
    std::uint64_t done = 0;
    passes([&] {
        link.hello();
        link.upload(0, lines, done);
        link.read_lines(0, lines);
        link.lines_that_hold(0, lines);
    });
    demand(done <= lines.size(), "no more lines are done than there are");
}

}   // namespace rayclock::fuzz
