#pragma once
// The timing gates of a DRAM's banks and buses.
#include <array>
#include <cstdint>
#include <vector>

#include "model/core/dram_parts.hpp"

namespace rayclock {

enum class DramCommand { activate, read, write, precharge, precharge_all, refresh };

/// The banks of a DRAM and its buses: the earliest time of each command. Time is counted in clocks of the
/// DRAM; every gate of the part is rounded up to whole clocks. One command per clock. Dram handles the
/// requests.
class DramBanks {
public:
    using Clock = std::int64_t;
    explicit DramBanks(const DramPart& part);

    bool is_open(int bank) const { return banks_[std::size_t(bank)].open; }
    bool has_open() const { return open_ > 0; }
    /// Returns the open row; valid only if the bank is open.
    std::uint32_t row(int bank) const { return banks_[std::size_t(bank)].row; }

    /// Returns the first clock at which the command keeps every gate, given the commands so far. The caller
    /// must make sure that the command makes sense (a read of an open row, a refresh of closed banks).
    /// precharge_all and refresh ignore the bank.
    Clock earliest(DramCommand command, int bank) const;
    bool allows(DramCommand command, int bank, Clock clock) const { return clock >= earliest(command, bank); }

    /// Issues the command; asserts that it is allowed.
    void issue(DramCommand command, int bank, std::uint32_t row, Clock clock);

private:
    struct Bank {
        Clock activate = 0, column = 0, precharge = 0;   // first clock that the bank's own gates allow
        std::uint32_t row = 0;
        bool open = false;
    };
    Clock clocks(int picoseconds) const { return (picoseconds + tck_ - 1) / tck_; }
    void close(Bank& bank, Clock clock);

    int tck_;
    Clock trcd_, trp_, tras_, trc_, trrd_, trrd_l_, tfaw_, trtp_, tccd_, tccd_l_, trfc_;
    // Limits from a read to a write, and from a write to a read and to a precharge.
    Clock to_write_, to_read_, to_precharge_;
    struct Group {
        Clock activate = 0, column = 0;   // first clock that the group's own gates allow
    };
    // Most memories have no groups, and skip the division.
    std::size_t group_index(int bank) const {
        return groups_.size() == 1 ? 0 : std::size_t(bank) % groups_.size();
    }
    Group& group_of(int bank) { return groups_[group_index(bank)]; }
    const Group& group_of(int bank) const { return groups_[group_index(bank)]; }

    std::vector<Bank> banks_;
    std::vector<Group> groups_;
    int open_ = 0;                                              // banks with an open row
    Clock command_ = 0, activate_ = 0, read_ = 0, write_ = 0;   // first clock that the shared gates allow
    std::array<Clock, 4> activates_{};                          // the last four activates, plus tFAW
    unsigned oldest_ = 0;                                       // the oldest of these
};

}   // namespace rayclock
