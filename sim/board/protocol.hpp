#pragma once
// The packets between the host and the board: docs/machine/board-link.md describes them, and
// rtl/board/link/rc_link.sv and rtl/board/rc_board_registers.sv have the same constants.
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rayclock {

/// A line of the board's memory, its lowest address first.
using MemoryLine = std::array<std::uint8_t, 64>;

constexpr std::array<std::uint8_t, 2> link_mark{0xc5, 0x3a};   ///< the first bytes of every packet
constexpr std::uint32_t link_version = 1;                      ///< of the packets and the board's registers
constexpr std::uint32_t board_magic = 0x52434244;              ///< "RCBD": the board register 0
constexpr int link_lines_most = 16;                            ///< lines of memory in a packet
constexpr int link_history = 16;   ///< packets whose results the board keeps: the largest window
/// Bytes of a packet without its lines: mark, head of eight bytes, checksum.
constexpr std::size_t link_overhead = 2 + 8 + 4;
constexpr std::size_t link_packet_most = link_overhead + link_lines_most * sizeof(MemoryLine);

/// The command of a packet. An answer adds 0x80, a refusal 0xc0.
enum class LinkKind : std::uint8_t {
    hello = 1,        ///< address: any number, which the answer repeats
    write_register,   ///< a payload of four bytes, the low byte first
    read_register,    ///< value of the answer: the register
    write_lines,      ///< count: 1 to 16 lines, which are the payload
    read_lines,       ///< count: 1 to 16 lines, which are the payload of the answer
    check_lines,      ///< count: 1 to 65535 lines; value of the answer: their CRC-32
};
/// The reason of a refusal. A refused packet has no effect. `done`: the packet was executed.
enum class LinkReason : std::uint8_t {
    done,
    no_session,    ///< there was no hello since the board's reset
    gap,           ///< another sequence number is expected: the value of the answer
    bad_kind,      ///< unknown kind
    bad_address,   ///< no such register or line, or the register does not allow the access
    bus_error,     ///< the chip refuses the access
    bus_silence,   ///< the chip does not answer: it is held in reset
};

/// The owner of a register: bit 31 of the address.
enum class RegisterSpace : std::uint32_t { chip = 0, board = 0x8000'0000u };

/// The board's own registers, by number.
enum class BoardRegister : std::uint32_t {
    magic,
    version,
    hash_low,   ///< of the configuration of the bitstream
    hash_high,
    lines,     ///< of memory
    control,   ///< bit 0: the chip is held in reset; bit 1: starts a frame at the next vertical blank
    status,    ///< bit 0: the memory is initialised; 1: the frame is in memory; 2: a frame waits
    underruns,
    cycles,   ///< of the last frame with its flush; reading it keeps the upper word
    cycles_high,
    base,    ///< line of the first block of the picture that is shown
    width,   ///< pixels
    height,
    doubled,     ///< 1: each pixel is shown as 2x2
    faults,      ///< packets dropped (16 bits) and bytes dropped (upper 16 bits) since the reset
    draw_base,   ///< line of the first block of the picture that is drawn
};

/// A packet from the host.
struct LinkCommand {
    LinkKind kind = LinkKind::hello;
    std::uint8_t sequence = 0;
    std::uint32_t address = 0;             ///< a register, a line, or the number of a hello
    std::uint16_t count = 0;               ///< lines
    std::uint32_t value = 0;               ///< for a register
    std::span<const MemoryLine> lines{};   ///< the payload of write_lines
};

/// Returns the bytes of a packet. Throws std::logic_error if write_lines has not `count` lines, 1 to 16.
std::vector<std::uint8_t> packet_bytes(const LinkCommand& command);

/// A packet from the board.
struct LinkAnswer {
    LinkKind kind = LinkKind::hello;        ///< of the command; it may be an unknown number
    LinkReason reason = LinkReason::done;   ///< may be an unknown number
    std::uint8_t sequence = 0;
    std::uint32_t value = 0;
    std::uint16_t count = 0;           ///< as in the command; in a refusal: the reason
    std::vector<MemoryLine> lines{};   ///< of read_lines; empty in other answers
};

/// Finds answers in received bytes. Accepts any bytes, and discards bytes outside sound packets one by one.
/// It finds an answer if all bytes of the answer arrive, and if the bytes before them form complete packets
/// or were given up. Memory: the bytes of one packet and of the last push.
class AnswerDecoder {
public:
    void push(std::span<const std::uint8_t> bytes);
    /// Returns the next sound answer, or nothing if its bytes have not all arrived.
    std::optional<LinkAnswer> next();
    /// Discards the beginning of an incomplete packet. Call it after a silence, and then next().
    void give_up();
    std::uint64_t discarded() const { return discarded_; }   ///< bytes so far

private:
    std::span<const std::uint8_t> rest() const { return std::span(bytes_).subspan(from_); }
    void drop(std::size_t bytes) { from_ += bytes, discarded_ += bytes; }

    std::vector<std::uint8_t> bytes_;   ///< received; the first `from_` are done with
    std::size_t from_ = 0;
    std::uint64_t discarded_ = 0;
};

/// Returns the CRC-32 (IEEE 802.3) of bytes, continued from the checksum of the bytes before them.
std::uint32_t link_checksum(std::span<const std::uint8_t> bytes, std::uint32_t before = 0);

}   // namespace rayclock
