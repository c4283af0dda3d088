#pragma once
// The host's end of the link to the board: sessions, registers and lines of memory over bytes that may be
// lost, doubled or damaged. docs/machine/board-link.md describes the packets.
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/base/error.hpp"
#include "model/base/progress.hpp"
#include "sim/board/protocol.hpp"

namespace rayclock {

/// The board stopped answering, or its port is gone. Acknowledged commands stay executed.
class LinkLost : public UserError {
public:
    using UserError::UserError;
};
/// The board was reset in the middle of a session. Call hello() for a new one; memory may have changed.
class BoardReset : public UserError {
public:
    using UserError::UserError;
};
/// The board refuses a command, which then has no effect.
class LinkRefused : public UserError {
public:
    LinkRefused(const std::string& sentence, LinkReason reason) : UserError(sentence), reason(reason) {}
    LinkReason reason;
};

using LinkTime = std::chrono::microseconds;

/// Bytes to and from a board, and the time. Port (sim/board/port.hpp) is the channel of a real board.
class Channel {
public:
    virtual ~Channel() = default;
    struct Moved {
        std::size_t written = 0, read = 0;   ///< bytes
    };
    /// Sends bytes from the beginning of `out`, as many as it can at once, and receives bytes into `in`. If
    /// neither is possible, waits until one is, but not longer than `most`. Throws LinkLost if the port is
    /// gone.
    virtual Moved exchange(std::span<const std::uint8_t> out, std::span<std::uint8_t> in, LinkTime most) = 0;
    virtual LinkTime now() = 0;   ///< since an arbitrary moment
};

/// Timeouts and window of a link.
struct LinkSettings {
    std::string name = "the port";   ///< of the port, for messages
    std::uint32_t baud = 3'000'000;
    /// Time for an answer, in addition to the time of all bytes in flight. It must be longer than the silence
    /// after which the board discards a partial packet (20 ms).
    LinkTime patience{250'000};
    /// Longest time that the board needs to read a line for check_lines(): some hundred cycles.
    LinkTime line{4};
    /// Factor of all timeouts after the answer to the hello. 1 is for a real board.
    int slower = 1;
    int tries = 8;    ///< times that a packet is sent without any answer, before the board counts as lost
    int window = 8;   ///< packets in flight, at most link_history
    std::optional<std::uint32_t> hello{};   ///< number of the first hello; none: a random one
};

/// The identity that a board reports.
struct BoardIdentity {
    std::uint32_t version = 0;       ///< of packets and board registers
    std::uint64_t config_hash = 0;   ///< of the configuration of its bitstream
    std::uint64_t lines = 0;         ///< of memory
};

/// A link to a board. Every function returns after the board has executed its commands, in order and each of
/// them once. All throw LinkLost, BoardReset and LinkRefused.
class BoardLink {
public:
    /// Throws std::logic_error if a setting is outside its range.
    explicit BoardLink(Channel& channel, LinkSettings settings = {});

    /// Begins a session, which must precede everything else, and again after BoardReset. Throws UserError if
    /// the other end is another device or another version.
    BoardIdentity hello();

    std::uint32_t read_register(RegisterSpace space, std::uint32_t number);
    void write_register(RegisterSpace space, std::uint32_t number, std::uint32_t value);
    std::uint32_t read(BoardRegister number) {
        return read_register(RegisterSpace::board, std::uint32_t(number));
    }
    void write(BoardRegister number, std::uint32_t value) {
        write_register(RegisterSpace::board, std::uint32_t(number), value);
    }

    /// Reads lines of memory from line `first` on.
    void read_lines(std::uint32_t first, std::span<MemoryLine> lines);

    /// Writes lines of memory from line `first` on, except the first `done` lines. Counts in `done` the
    /// lines that the board has acknowledged. After LinkLost a further call with the same arguments continues
    /// from there. After BoardReset, `done` must come from lines_that_hold().
    void upload(std::uint32_t first, std::span<const MemoryLine> lines, std::uint64_t& done,
                const Progress& progress = {});
    void write_lines(std::uint32_t first, std::span<const MemoryLine> lines) {
        std::uint64_t done = 0;
        upload(first, lines, done);
    }

    /// Returns the number of lines before the first one that memory does not hold yet. The board computes
    /// checksums, so few bytes are sent.
    std::uint64_t lines_that_hold(std::uint32_t first, std::span<const MemoryLine> lines);
    /// Returns the CRC-32 of 1 to 65535 lines of memory.
    std::uint32_t check_lines(std::uint32_t first, std::uint16_t count);

    /// Counts since the start of the program.
    struct Counts {
        std::uint64_t packets = 0;     ///< different packets that were sent
        std::uint64_t repeated = 0;    ///< packets that were sent again
        std::uint64_t discarded = 0;   ///< bytes received that belong to no answer
    };
    const Counts& counts() const { return counts_; }
    LinkTime now() { return channel_.now(); }   ///< of the channel
    int slower() const { return settings_.slower; }

private:
    class Window;
    using Make = std::function<LinkCommand(std::uint64_t i)>;
    using Answered = std::function<void(std::uint64_t i, LinkAnswer& answer)>;
    using Advanced = std::function<void(std::uint64_t done)>;

    /// Executes commands 0 to n - 1, several in flight. Calls `answered` once for each, perhaps out of order,
    /// and `advanced` with the number of commands that are done without a gap.
    void run(std::uint64_t n, const Make& make, const Answered& answered, const Advanced& advanced = {});
    LinkAnswer one(const LinkCommand& command);
    void greet();
    [[noreturn]] void refuse(const LinkCommand& command, LinkReason reason) const;

    Channel& channel_;
    LinkSettings settings_;
    AnswerDecoder decoder_;
    std::vector<std::uint8_t> out_;   ///< bytes that the channel has not taken
    std::uint8_t sequence_ = 0;       ///< of the next new packet
    std::uint32_t greeting_ = 0;      ///< number of the next hello
    Counts counts_;
};

}   // namespace rayclock
