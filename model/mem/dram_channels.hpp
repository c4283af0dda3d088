#pragma once
// Several DRAMs behind one memory port.
#include <vector>

#include "model/mem/dram.hpp"

namespace rayclock {

/// DRAMs of one kind side by side behind one port, with the interface of a single one. Neighbouring words of
/// 64 bytes lie in different channels. A request is accepted while every channel has room. If several
/// channels answer in one cycle, the answers leave one per cycle, lowest channel first. One channel behaves
/// exactly like a Dram.
class DramChannels {
public:
    DramChannels(const DramPart& part, int channels, int khz, int ids);

    using Answer = Dram::Answer;
    bool ready() const { return ready_; }
    bool valid() const { return valid_; }
    Answer answer() const { return answer_; }

    void clock(const Answer* request);

    bool is_idle() const;
    bool idle() const;
    bool writes() const;
    std::uint64_t now() const { return channels_[0].now(); }
    std::uint64_t quiet_until() const;
    void skip(std::uint64_t cycles);

    // With one channel only. With several, known() is 1 and the other two must not be called.
    std::uint64_t known() const { return count_ == 1 ? channels_[0].known() : 1; }
    template <class F> void each_known(std::uint64_t cycles, F&& f) const {
        channels_[0].each_known(cycles, f);
    }
    void pass(std::uint64_t cycles) {
        channels_[0].pass(cycles);
        mirror();
    }

    DramStatistics statistics() const;   ///< summed over the channels
    /// Cycles by the first cause that holds in any channel.
    std::uint64_t cycles(DramCause cause) const {
        return count_ == 1 ? channels_[0].cycles(cause) : causes_[std::size_t(cause)];
    }

    /// Logs the commands of a channel as they are issued, for tests.
    void record(int channel, std::vector<Dram::Issued>* log) { channels_[std::size_t(channel)].record(log); }

private:
    void gather();   // collects the channels' answers and state after a clock edge
    void mirror();   // does so for a single channel

    std::vector<Dram> channels_;
    std::uint32_t count_;
    bool ready_ = true, valid_ = false;
    Answer answer_{};
    Ring<Answer> waiting_;   // answers that came in the same cycle as others
    std::array<std::uint64_t, dram_causes> causes_{};
};

}   // namespace rayclock
