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

/// The commands of one call of BoardLink::run(), and the packets in flight.
class BoardLink::Window {
public:
    /// The arguments of BoardLink::run().
    Window(BoardLink& link, std::uint64_t n, const Make& make, const Answered& answered,
           const Advanced& advanced)
        : link_(link), n_(n), make_(make), answered_(answered), advanced_(advanced) {}

    void run();

private:
    /// A packet in flight.
    struct Sent {
        LinkCommand command;
        std::vector<std::uint8_t> bytes;
        bool is_answered = false;
        std::uint64_t order = 0;   ///< number of its last transmission
    };

    void fill();
    void exchange();
    /// Handles the end of an answer's time.
    void time_out();
    void take(LinkAnswer& answer);
    /// Sends the packets from the expected one on again.
    void fill_gap(std::size_t refused, std::size_t expected);
    void send(Sent& sent);
    void send_again(Sent& sent);
    /// Starts the time in which an answer must come.
    void restart();

    BoardLink& link_;
    std::uint64_t n_;   ///< commands; after a refusal, those that were sent
    const Make& make_;
    const Answered& answered_;
    const Advanced& advanced_;

    std::deque<Sent> flight_;   ///< commands base_, base_ + 1, ... in order
    std::uint64_t base_ = 0, orders_ = 0;
    std::optional<std::uint64_t> resent_from_;   ///< a gap that is being filled
    /// The first refusal. The packets in flight are still answered, so that both ends agree on the next
    /// number.
    std::optional<std::pair<LinkCommand, LinkReason>> refusal_;
    int tries_ = 0;
    LinkTime deadline_{};
};

void BoardLink::Window::run() {
    while (base_ < n_) {
        fill();
        exchange();
        if (link_.channel_.now() >= deadline_ && base_ != n_) time_out();
    }
    link_.counts_.discarded = link_.decoder_.discarded();
    if (refusal_) link_.refuse(refusal_->first, refusal_->second);
}

void BoardLink::Window::fill() {
    while (base_ + flight_.size() < n_ && flight_.size() < std::size_t(link_.settings_.window)) {
        Sent sent{make_(base_ + flight_.size()), {}, false, 0};
        sent.command.sequence = link_.sequence_++;
        sent.bytes = packet_bytes(sent.command);
        ++link_.counts_.packets;
        send(sent);
        flight_.push_back(std::move(sent));
        restart();
    }
}

void BoardLink::Window::exchange() {
    std::array<std::uint8_t, 4096> in;
    std::vector<std::uint8_t>& out = link_.out_;
    const LinkTime left = deadline_ - link_.channel_.now();
    const Channel::Moved moved = link_.channel_.exchange(out, in, std::max(left, LinkTime(0)));
    if (moved.written > 0) {
        out.erase(out.begin(), out.begin() + std::ptrdiff_t(moved.written));
        restart();
    }
    link_.decoder_.push(std::span(in).first(moved.read));
    while (std::optional<LinkAnswer> answer = link_.decoder_.next()) take(*answer);
}

void BoardLink::Window::time_out() {
    // Discard the apparent beginning of a packet. A whole packet may follow in its bytes.
    link_.decoder_.give_up();
    if (std::optional<LinkAnswer> answer = link_.decoder_.next()) {
        take(*answer);
        return;
    }
    if (++tries_ >= link_.settings_.tries)
        throw LinkLost(
            fmt::format("{}: the board does not answer any more ({} tries)", link_.settings_.name, tries_));
    resent_from_.reset();
    if (link_.out_.empty())
        for (Sent& sent : flight_)
            if (!sent.is_answered) send_again(sent);
    restart();
}

void BoardLink::Window::take(LinkAnswer& answer) {
    const std::uint8_t base_sequence = std::uint8_t(link_.sequence_ - flight_.size());
    const std::size_t i = std::uint8_t(answer.sequence - base_sequence);
    if (answer.reason == LinkReason::no_session) link_.refuse({}, answer.reason);
    if (i >= flight_.size() || flight_[i].is_answered) return;   // of an older packet, or a repetition
    if (answer.reason == LinkReason::gap) return fill_gap(i, std::uint8_t(answer.value - base_sequence));
    if (answer.kind != flight_[i].command.kind) return;
    flight_[i].is_answered = true;
    if (resent_from_ == base_ + i) resent_from_.reset();
    if (answer.reason == LinkReason::done && !refusal_) {
        answered_(base_ + i, answer);
    } else if (!refusal_) {
        refusal_.emplace(flight_[i].command, answer.reason);
        n_ = base_ + flight_.size();
    }
    // The board answers in order: the answers to packets that were sent before this one are lost.
    for (std::size_t k = 0; k < i; ++k)
        if (!flight_[k].is_answered && flight_[k].order < flight_[i].order) send_again(flight_[k]);
    while (!flight_.empty() && flight_.front().is_answered) flight_.pop_front(), ++base_;
    if (resent_from_ && *resent_from_ < base_) resent_from_.reset();
    if (advanced_ && !refusal_) advanced_(base_);
    tries_ = 0;
    restart();
}

void BoardLink::Window::fill_gap(std::size_t refused, std::size_t expected) {
    // Packets from the expected one on were lost. Until it is answered, further refusals of this kind come
    // from packets that are sent again already.
    if (expected >= refused || resent_from_) return;
    resent_from_ = base_ + expected;
    for (std::size_t k = expected; k < flight_.size(); ++k)
        if (!flight_[k].is_answered) send_again(flight_[k]);
    restart();
}

void BoardLink::Window::send(Sent& sent) {
    sent.order = ++orders_;
    link_.out_.insert(link_.out_.end(), sent.bytes.begin(), sent.bytes.end());
}

void BoardLink::Window::send_again(Sent& sent) {
    ++link_.counts_.repeated;
    send(sent);
}

void BoardLink::Window::restart() {
    const LinkSettings& settings = link_.settings_;
    std::size_t bytes = link_.out_.size();
    LinkTime work{};
    for (const Sent& sent : flight_) {
        bytes += sent.bytes.size() + answer_bytes(sent.command);
        work += settings.line * sent.command.count;
    }
    const LinkTime moved(std::uint64_t(bytes) * 10 * 1'000'000 / settings.baud);
    deadline_ = link_.channel_.now() + (settings.patience + work + moved) * settings.slower;
}

void BoardLink::run(std::uint64_t n, const Make& make, const Answered& answered, const Advanced& advanced) {
    Window(*this, n, make, answered, advanced).run();
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
