// The gates between the commands of a DRAM.
#include "model/mem/dram_banks.hpp"

#include <algorithm>
#include <cassert>

namespace rayclock {

DramBanks::DramBanks(const DramPart& part)
    : tck_(part.tck),
      trcd_(clocks(part.trcd)),
      trp_(clocks(part.trp)),
      tras_(clocks(part.tras)),
      trc_(clocks(part.trc)),
      trrd_(clocks(part.trrd)),
      trrd_l_(std::max(trrd_, clocks(part.trrd_l))),
      tfaw_(clocks(part.tfaw)),
      trtp_(clocks(part.trtp)),
      // All reads have one latency, so reads a burst apart never collide on the bus.
      tccd_(std::max(clocks(part.tccd), Clock(part.burst_clocks()))),
      tccd_l_(std::max(tccd_, clocks(part.tccd_l))),
      trfc_(clocks(part.trfc)),
      to_write_(part.cl + part.burst_clocks() + part.turn_clocks() - part.cwl),
      to_read_(part.cwl + part.burst_clocks() + clocks(part.twtr)),
      to_precharge_(part.cwl + part.burst_clocks() + clocks(part.twr)),
      banks_(std::size_t(part.banks)),
      groups_(std::size_t(part.bank_groups)) {}

DramBanks::Clock DramBanks::earliest(DramCommand command, int bank) const {
    Clock at = command_;
    switch (command) {
        case DramCommand::activate:
            at = std::max({at, banks_[std::size_t(bank)].activate, activate_, group_of(bank).activate,
                           activates_[oldest_]});
            break;
        case DramCommand::read:
            at = std::max({at, banks_[std::size_t(bank)].column, read_, group_of(bank).column});
            break;
        case DramCommand::write:
            at = std::max({at, banks_[std::size_t(bank)].column, write_, group_of(bank).column});
            break;
        case DramCommand::precharge: at = std::max(at, banks_[std::size_t(bank)].precharge); break;
        case DramCommand::precharge_all:
            for (const Bank& b : banks_)
                if (b.open) at = std::max(at, b.precharge);
            break;
        case DramCommand::refresh:   // tRP, tRC and tRFC, as for an activate of every bank
            for (const Bank& b : banks_) at = std::max(at, b.activate);
            break;
    }
    return at;
}

void DramBanks::close(Bank& bank, Clock clock) {
    bank.open = false;
    --open_;
    bank.activate = std::max(bank.activate, clock + trp_);
}

void DramBanks::issue(DramCommand command, int bank, std::uint32_t row, Clock clock) {
    assert(allows(command, bank, clock) && "a DRAM command keeps every gate");
    command_ = clock + 1;
    Bank& own = banks_[std::size_t(bank)];
    switch (command) {
        case DramCommand::activate:
            assert(!own.open && "only a closed bank is activated");
            own.open = true;
            own.row = row;
            ++open_;
            own.column = clock + trcd_;
            own.precharge = clock + tras_;
            own.activate = clock + trc_;
            activate_ = clock + trrd_;
            group_of(bank).activate = clock + trrd_l_;
            activates_[oldest_] = clock + tfaw_;
            oldest_ = (oldest_ + 1) % 4;
            break;
        case DramCommand::read:
            assert(own.open && own.row == row && "only an open row is read");
            own.precharge = std::max(own.precharge, clock + trtp_);
            read_ = clock + tccd_;
            write_ = clock + std::max(tccd_, to_write_);
            group_of(bank).column = clock + tccd_l_;
            break;
        case DramCommand::write:
            assert(own.open && own.row == row && "only an open row is written");
            own.precharge = std::max(own.precharge, clock + to_precharge_);
            write_ = clock + tccd_;
            read_ = clock + std::max(tccd_, to_read_);
            group_of(bank).column = clock + tccd_l_;
            break;
        case DramCommand::precharge:
            assert(own.open && "only an open bank is precharged");
            close(own, clock);
            break;
        case DramCommand::precharge_all:
            for (Bank& b : banks_)
                if (b.open) close(b, clock);
            break;
        case DramCommand::refresh:
            assert(open_ == 0 && "only closed banks are refreshed");
            for (Bank& b : banks_) b.activate = clock + trfc_;
            break;
    }
}

}   // namespace rayclock
