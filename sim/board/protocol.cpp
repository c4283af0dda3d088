// Encoding of packets and decoding of answers.
#include "sim/board/protocol.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include <zlib.h>

namespace rayclock {

namespace {

// Places in a packet: mark, kind, sequence, address or value, count, payload, checksum.
constexpr std::size_t kind_at = 2, sequence_at = 3, address_at = 4, count_at = 8, payload_at = 10,
                      checksum_bytes = 4;
constexpr std::uint8_t answer_bit = 0x80, refusal_bit = 0x40;

void append(std::vector<std::uint8_t>& bytes, std::uint32_t value, int count) {
    for (int i = 0; i < count; ++i) bytes.push_back(std::uint8_t(value >> 8 * i));
}
std::uint32_t number(std::span<const std::uint8_t> bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = bytes.size(); i-- > 0;) value = value << 8 | bytes[i];
    return value;
}

}   // namespace

std::uint32_t link_checksum(std::span<const std::uint8_t> bytes, std::uint32_t before) {
    return std::uint32_t(crc32_z(before, bytes.data(), bytes.size()));
}

std::vector<std::uint8_t> packet_bytes(const LinkCommand& command) {
    const bool writes = command.kind == LinkKind::write_lines;
    if (writes ? command.lines.size() != command.count || command.count < 1 || command.count > link_lines_most
               : !command.lines.empty())
        throw std::logic_error("a packet writes 1 to 16 lines");
    std::vector<std::uint8_t> bytes(link_mark.begin(), link_mark.end());
    append(bytes, std::uint32_t(command.kind), 1);
    append(bytes, command.sequence, 1);
    append(bytes, command.address, 4);
    append(bytes, command.count, 2);
    if (command.kind == LinkKind::write_register) append(bytes, command.value, 4);
    for (const MemoryLine& line : command.lines) bytes.insert(bytes.end(), line.begin(), line.end());
    append(bytes, link_checksum(std::span(bytes).subspan(kind_at)), checksum_bytes);
    return bytes;
}

void AnswerDecoder::push(std::span<const std::uint8_t> bytes) {
    bytes_.erase(bytes_.begin(), bytes_.begin() + std::ptrdiff_t(from_));
    from_ = 0;
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

void AnswerDecoder::give_up() {
    if (!rest().empty()) drop(1);
}

std::optional<LinkAnswer> AnswerDecoder::next() {
    for (;;) {
        // A mark, or the first byte of one at the end.
        std::span<const std::uint8_t> all = rest();
        const auto mark = std::search(all.begin(), all.end(), link_mark.begin(), link_mark.end());
        const bool is_half = mark == all.end() && !all.empty() && all.back() == link_mark[0];
        drop(std::size_t(mark - all.begin()) - is_half);
        all = rest();
        if (all.size() < payload_at) return {};

        LinkAnswer answer;
        const std::uint8_t kind = all[kind_at];
        answer.kind = LinkKind(kind & ~(answer_bit | refusal_bit));
        answer.sequence = all[sequence_at];
        answer.value = number(all.subspan(address_at, 4));
        answer.count = std::uint16_t(number(all.subspan(count_at, 2)));
        const bool is_refusal = kind & refusal_bit,
                   has_lines = answer.kind == LinkKind::read_lines && !is_refusal;
        if (is_refusal) answer.reason = LinkReason(answer.count);
        if (!(kind & answer_bit) || (is_refusal && (answer.count < 1 || answer.count > 255)) ||
            (has_lines && (answer.count < 1 || answer.count > link_lines_most))) {
            drop(1);
            continue;
        }
        const std::size_t payload = has_lines ? answer.count * sizeof(MemoryLine) : 0,
                          end = payload_at + payload;
        if (all.size() < end + checksum_bytes) return {};
        if (number(all.subspan(end, checksum_bytes)) != link_checksum(all.subspan(kind_at, end - kind_at))) {
            drop(1);
            continue;
        }
        if (has_lines) {
            answer.lines.resize(answer.count);
            std::memcpy(answer.lines.data(), all.data() + payload_at, payload);
        }
        from_ += end + checksum_bytes;
        return answer;
    }
}

}   // namespace rayclock
