// The window of packets in flight, and the commands on it.
#include "sim/board/link.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <random>
#include <stdexcept>

#include <fmt/format.h>

namespace rayclock {

namespace {

constexpr std::uint64_t checked_most = 4096;   // lines in one command of lines_that_hold()

std::size_t answer_bytes(const LinkCommand& command) {
    return link_overhead + (command.kind == LinkKind::read_lines ? command.count * sizeof(MemoryLine) : 0);
}

std::string what_of(const LinkCommand& command) {
    const bool for_board = command.address & std::uint32_t(RegisterSpace::board);
    const std::string place = fmt::format("{} register {:#06x}", for_board ? "board's" : "chip's",
                                          command.address & ~std::uint32_t(RegisterSpace::board));
    const std::string lines = fmt::format("{} lines from line {} on", command.count, command.address);
    switch (command.kind) {
        case LinkKind::hello: return "a hello";
        case LinkKind::write_register: return "a write of the " + place;
        case LinkKind::read_register: return "a read of the " + place;
        case LinkKind::write_lines: return "a write of " + lines;
        case LinkKind::read_lines: return "a read of " + lines;
        case LinkKind::check_lines: return "a check of " + lines;
    }
    return "a packet";
}

std::string why(LinkReason reason) {
    switch (reason) {
        case LinkReason::bad_kind: return "it does not know this packet";
        case LinkReason::bad_address: return "there is no such address, or it does not allow this access";
        case LinkReason::bus_error: return "the chip does not allow this access now";
        case LinkReason::bus_silence: return "the chip does not answer; it may be held in reset";
        default: return fmt::format("reason {}", int(reason));
    }
}

}   // namespace

/// A packet in flight.
struct BoardLink::Sent {
    LinkCommand command;
    std::vector<std::uint8_t> bytes;
    bool is_answered = false;
    std::uint64_t order = 0;   ///< number of its last transmission
};

BoardLink::BoardLink(Channel& channel, LinkSettings settings)
    : channel_(channel), settings_(std::move(settings)) {
    if (settings_.tries < 1 || settings_.window < 1 || settings_.window > link_history ||
        settings_.baud < 1 || settings_.slower < 1)
        throw std::logic_error("settings of the link");
    greeting_ = settings_.hello ? *settings_.hello : std::uint32_t(std::random_device{}());
}

void BoardLink::refuse(const LinkCommand& command, LinkReason reason) const {
    if (reason == LinkReason::no_session)
        throw BoardReset(settings_.name + ": the board was reset meanwhile; begin again");
    throw LinkRefused(
        fmt::format("{}: the board refuses {}: {}", settings_.name, what_of(command), why(reason)), reason);
}

void BoardLink::run(std::uint64_t n, const Make& make, const Answered& answered,
                    const std::function<void(std::uint64_t)>& advanced) {
    std::deque<Sent> flight;   // commands base, base + 1, ... in order
    std::uint64_t base = 0, orders = 0;
    std::optional<std::uint64_t> resent_from;   // a gap that is being filled
    // The first refusal. The packets in flight are still answered, so that both ends agree on the next
    // number.
    std::optional<std::pair<LinkCommand, LinkReason>> refusal;
    int tries = 0;
    LinkTime deadline{};
    std::array<std::uint8_t, 4096> in;

    const auto restart = [&] {
        std::size_t bytes = out_.size();
        LinkTime work{};
        for (const Sent& sent : flight) {
            bytes += sent.bytes.size() + answer_bytes(sent.command);
            work += settings_.line * sent.command.count;
        }
        const LinkTime moved(std::uint64_t(bytes) * 10 * 1'000'000 / settings_.baud);
        deadline = channel_.now() + (settings_.patience + work + moved) * settings_.slower;
    };
    const auto send = [&](Sent& sent) {
        sent.order = ++orders;
        out_.insert(out_.end(), sent.bytes.begin(), sent.bytes.end());
    };
    const auto send_again = [&](Sent& sent) {
        ++counts_.repeated;
        send(sent);
    };

    const auto take = [&](LinkAnswer& answer) {
        const std::uint8_t base_sequence = std::uint8_t(sequence_ - flight.size());
        const std::size_t i = std::uint8_t(answer.sequence - base_sequence);
        if (answer.reason == LinkReason::no_session) refuse({}, answer.reason);
        if (i >= flight.size() || flight[i].is_answered) return;   // of an older packet, or a repetition
        if (answer.reason == LinkReason::gap) {
            // Packets from the expected one on were lost. Until it is answered, further refusals of this kind
            // come from packets that are sent again already.
            const std::size_t from = std::uint8_t(answer.value - base_sequence);
            if (from >= i || resent_from) return;
            resent_from = base + from;
            for (std::size_t k = from; k < flight.size(); ++k)
                if (!flight[k].is_answered) send_again(flight[k]);
            restart();
            return;
        }
        if (answer.kind != flight[i].command.kind) return;
        flight[i].is_answered = true;
        if (resent_from == base + i) resent_from.reset();
        if (answer.reason == LinkReason::done && !refusal) {
            answered(base + i, answer);
        } else if (!refusal) {
            refusal.emplace(flight[i].command, answer.reason);
            n = base + flight.size();
        }
        // The board answers in order: the answers to packets that were sent before this one are lost.
        for (std::size_t k = 0; k < i; ++k)
            if (!flight[k].is_answered && flight[k].order < flight[i].order) send_again(flight[k]);
        while (!flight.empty() && flight.front().is_answered) flight.pop_front(), ++base;
        if (resent_from && *resent_from < base) resent_from.reset();
        if (advanced && !refusal) advanced(base);
        tries = 0;
        restart();
    };

    while (base < n) {
        while (base + flight.size() < n && flight.size() < std::size_t(settings_.window)) {
            Sent sent{make(base + flight.size()), {}, false, 0};
            sent.command.sequence = sequence_++;
            sent.bytes = packet_bytes(sent.command);
            ++counts_.packets;
            send(sent);
            flight.push_back(std::move(sent));
            restart();
        }
        const LinkTime left = deadline - channel_.now();
        const Channel::Moved moved = channel_.exchange(out_, in, std::max(left, LinkTime(0)));
        if (moved.written > 0) {
            out_.erase(out_.begin(), out_.begin() + std::ptrdiff_t(moved.written));
            restart();
        }
        decoder_.push(std::span(in).first(moved.read));
        while (std::optional<LinkAnswer> answer = decoder_.next()) take(*answer);
        if (channel_.now() < deadline || base == n) continue;

        // Silence: discard the apparent beginning of a packet. A whole packet may follow in its bytes.
        decoder_.give_up();
        if (std::optional<LinkAnswer> answer = decoder_.next()) {
            take(*answer);
            continue;
        }
        if (++tries >= settings_.tries)
            throw LinkLost(
                fmt::format("{}: the board does not answer any more ({} tries)", settings_.name, tries));
        resent_from.reset();
        if (out_.empty())
            for (Sent& sent : flight)
                if (!sent.is_answered) send_again(sent);
        restart();
    }
    counts_.discarded = decoder_.discarded();
    if (refusal) refuse(refusal->first, refusal->second);
}

LinkAnswer BoardLink::one(const LinkCommand& command) {
    LinkAnswer result;
    run(
        1, [&](std::uint64_t) { return command; },
        [&](std::uint64_t, LinkAnswer& answer) { result = std::move(answer); });
    return result;
}

void BoardLink::greet() {
    LinkCommand hello;
    hello.sequence = sequence_;
    hello.address = greeting_++;
    const std::vector<std::uint8_t> bytes = packet_bytes(hello);
    std::array<std::uint8_t, 4096> in;
    out_.clear();
    for (int tries = 0; tries < settings_.tries; ++tries) {
        out_.insert(out_.end(), bytes.begin(), bytes.end());
        ++counts_.packets;
        // Older answers may come first: a whole window of lines.
        const LinkTime deadline =
            channel_.now() + settings_.patience +
            LinkTime(std::uint64_t(settings_.window) * link_packet_most * 10 * 1'000'000 / settings_.baud);
        for (LinkTime now = channel_.now(); now < deadline; now = channel_.now()) {
            const Channel::Moved moved = channel_.exchange(out_, in, deadline - now);
            out_.erase(out_.begin(), out_.begin() + std::ptrdiff_t(moved.written));
            decoder_.push(std::span(in).first(moved.read));
            while (const std::optional<LinkAnswer> answer = decoder_.next()) {
                if (answer->kind != LinkKind::hello || answer->value != hello.address ||
                    answer->sequence != hello.sequence || answer->reason != LinkReason::done)
                    continue;
                sequence_ = std::uint8_t(hello.sequence + 1);
                return;
            }
        }
        decoder_.give_up();   // an answer may follow the beginning of an incomplete packet
    }
    throw LinkLost(
        fmt::format("{}: no rayclock board answers; is it plugged in, loaded with a bitstream of "
                    "rayclock, and set to {} baud?",
                    settings_.name, settings_.baud));
}

BoardIdentity BoardLink::hello() {
    greet();
    const auto strange = [&](const std::string& what) {
        return UserError(fmt::format("{}: {}", settings_.name, what));
    };
    if (const std::uint32_t magic = read(BoardRegister::magic); magic != board_magic)
        throw strange(
            fmt::format("the device is not a rayclock board (its register 0 holds {:#010x})", magic));
    BoardIdentity board;
    board.version = read(BoardRegister::version);
    if (board.version != link_version)
        throw strange(fmt::format("the board speaks version {} of the link, and this program version {}",
                                  board.version, link_version));
    board.config_hash = read(BoardRegister::hash_low);
    board.config_hash |= std::uint64_t(read(BoardRegister::hash_high)) << 32;
    board.lines = read(BoardRegister::lines);
    return board;
}

std::uint32_t BoardLink::read_register(RegisterSpace space, std::uint32_t number) {
    return one({LinkKind::read_register, 0, std::uint32_t(space) | number}).value;
}

void BoardLink::write_register(RegisterSpace space, std::uint32_t number, std::uint32_t value) {
    one({LinkKind::write_register, 0, std::uint32_t(space) | number, 0, value});
}

std::uint32_t BoardLink::check_lines(std::uint32_t first, std::uint16_t count) {
    return one({LinkKind::check_lines, 0, first, count}).value;
}

void BoardLink::read_lines(std::uint32_t first, std::span<MemoryLine> lines) {
    const auto count = [&](std::uint64_t i) {
        return std::uint16_t(std::min<std::uint64_t>(link_lines_most, lines.size() - i * link_lines_most));
    };
    run((lines.size() + link_lines_most - 1) / link_lines_most,
        [&](std::uint64_t i) {
            return LinkCommand{LinkKind::read_lines, 0, first + std::uint32_t(i) * link_lines_most, count(i)};
        },
        [&](std::uint64_t i, LinkAnswer& answer) {
            if (answer.lines.size() != count(i))
                throw LinkLost(settings_.name + ": the board answers with another number of lines");
            std::ranges::copy(answer.lines, lines.begin() + std::ptrdiff_t(i * link_lines_most));
        });
}

void BoardLink::upload(std::uint32_t first, std::span<const MemoryLine> lines, std::uint64_t& done,
                       const Progress& progress) {
    const std::uint64_t from = done;
    const auto rest = lines.subspan(std::min<std::size_t>(from, lines.size()));
    run((rest.size() + link_lines_most - 1) / link_lines_most,
        [&](std::uint64_t i) {
            const std::size_t at = i * link_lines_most,
                              count = std::min<std::size_t>(link_lines_most, rest.size() - at);
            return LinkCommand{LinkKind::write_lines, 0, std::uint32_t(first + from + at),
                               std::uint16_t(count),  0, rest.subspan(at, count)};
        },
        [](std::uint64_t, LinkAnswer&) {},
        [&](std::uint64_t packets) {
            done = from + std::min<std::uint64_t>(packets * link_lines_most, rest.size());
            if (progress) progress("uploading lines", done, lines.size());
        });
}

std::uint64_t BoardLink::lines_that_hold(std::uint32_t first, std::span<const MemoryLine> lines) {
    const auto holds = [&](std::uint64_t from, std::uint64_t count) {
        const auto part = lines.subspan(from, count);
        const std::span bytes(part.empty() ? nullptr : part.front().data(), part.size_bytes());
        return check_lines(std::uint32_t(first + from), std::uint16_t(count)) == link_checksum(bytes);
    };
    std::uint64_t good = 0;
    while (good < lines.size()) {
        const std::uint64_t count = std::min(checked_most, lines.size() - good);
        if (holds(good, count)) {
            good += count;
            continue;
        }
        // Finds the first line that differs: all lines before `good` are equal, and one before `bad` differs.
        std::uint64_t bad = good + count;
        while (bad - good > 1) {
            const std::uint64_t half = (bad - good) / 2;
            (holds(good, half) ? good += half : bad = good + half);
        }
        break;
    }
    return good;
}

}   // namespace rayclock
