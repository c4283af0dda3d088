#pragma once
// Answers as a board sends them, written from docs/machine/board-link.md, and a board that answers anything.
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/board/link.hpp"

namespace rayclock::test {

/// Returns the bytes of an answer with these fields, sound or not. `kind` has the bits of an answer.
inline std::vector<std::uint8_t> answer_bytes(std::uint8_t kind, std::uint8_t sequence, std::uint32_t value,
                                              std::uint16_t count, std::span<const MemoryLine> lines = {}) {
    std::vector<std::uint8_t> bytes{0xc5, 0x3a, kind, sequence};
    for (int i = 0; i < 4; ++i) bytes.push_back(std::uint8_t(value >> 8 * i));
    for (int i = 0; i < 2; ++i) bytes.push_back(std::uint8_t(count >> 8 * i));
    for (const MemoryLine& line : lines) bytes.insert(bytes.end(), line.begin(), line.end());
    // IEEE 802.3, bit by bit.
    std::uint32_t crc = ~0u;
    for (std::size_t at = 2; at < bytes.size(); ++at) {
        crc ^= bytes[at];
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
    }
    for (int i = 0; i < 4; ++i) bytes.push_back(std::uint8_t(~crc >> 8 * i));
    return bytes;
}

/// A board that takes no notice of what it receives, and sends a script over and over.
class HostileBoard : public Channel {
public:
    explicit HostileBoard(std::vector<std::uint8_t> script) : script_(std::move(script)) {}
    Moved exchange(std::span<const std::uint8_t> out, std::span<std::uint8_t> in, LinkTime most) override {
        ++calls;
        Moved moved{out.size(), 0};
        for (; !script_.empty() && moved.read < in.size() && moved.read < 40; ++at_)
            in[moved.read++] = script_[at_ % script_.size()];
        time_ += moved.read > 0 ? LinkTime(10) : std::max(most, LinkTime(1));
        if (time_ > LinkTime(100'000)) throw LinkLost("test: the end of the script");
        return moved;
    }
    LinkTime now() override { return time_; }
    std::uint64_t calls = 0;

private:
    std::vector<std::uint8_t> script_;
    std::size_t at_ = 0;
    LinkTime time_{};
};

}   // namespace rayclock::test
