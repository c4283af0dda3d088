#pragma once
// The other end of a UART, in the clock cycles of the board: a transmitter and a receiver whose
// bits last any fraction of cycles.
#include <cstdint>
#include <deque>

namespace rayclock {

/// Sends bytes as a level of the line: 8N1, back to back.
class SerialSender {
public:
    explicit SerialSender(double bit) : bit_(bit) {}
    std::deque<std::uint8_t> bytes;   ///< still to be sent

    /// Returns the level of the line in a cycle. Call it once in each cycle.
    bool level(std::uint64_t cycle) {
        const double now = double(cycle);
        if (now < edge_) return frame_ & 1;
        if (left_ > 0) {
            frame_ >>= 1;
        } else if (!bytes.empty()) {
            if (now >= edge_ + 1) edge_ = now;   // the line was idle; else the stop bit has just ended
            frame_ = 0x200u | std::uint32_t(bytes.front()) << 1;
            left_ = 10;
            bytes.pop_front();
        } else {
            return true;
        }
        --left_;
        edge_ += bit_;
        return frame_ & 1;
    }
    bool is_idle(std::uint64_t cycle) const { return left_ == 0 && bytes.empty() && double(cycle) >= edge_; }

private:
    double bit_, edge_ = 0;
    std::uint32_t frame_ = 1;
    int left_ = 0;   // bits after the present one
};

/// Receives bytes from the level of the line, sampled in the middle of each bit.
class SerialReceiver {
public:
    explicit SerialReceiver(double bit) : bit_(bit) {}
    std::deque<std::uint8_t> bytes;
    std::uint64_t faults = 0;   ///< bytes without a stop bit

    void see(std::uint64_t cycle, bool level) {
        if (bits_ < 0) {
            if (level) return;
            bits_ = 0;
            sample_ = double(cycle) + bit_ / 2;
            return;
        }
        if (double(cycle) < sample_) return;
        sample_ += bit_;
        value_ = std::uint32_t(level) << 9 | value_ >> 1;
        if (++bits_ < 10) return;
        bits_ = -1;
        if (level)
            bytes.push_back(std::uint8_t(value_ >> 1));
        else
            ++faults;
    }

private:
    double bit_, sample_ = 0;
    std::uint32_t value_ = 0;
    int bits_ = -1;
};

}   // namespace rayclock
