#pragma once
#include <cstdint>
#include <string>

namespace rayclock {

/// A memory on a board: chips, clock and controller. Times are picoseconds, integers only; a gate that is no
/// multiple of the clock is rounded up by whoever uses it, as data sheets ask.
struct DramPart {
    std::string name, description;
    std::string source;   ///< where the figures come from

    // Organisation, of all chips on the bus together.
    int bus_bits = 16;
    int transfers = 1;      ///< per clock: 1 single data rate, 2 double
    int burst_length = 8;   ///< transfers that one read command gives
    int banks = 4;
    int bank_groups = 1;   ///< of the banks; bank b is in group b % bank_groups
    int rows = 8192;       ///< of a bank
    int columns = 1024;    ///< of a row, one transfer each

    // Clock and gates.
    int tck = 0;        ///< clock; commands and data are given on it
    int cl = 0;         ///< clocks from read to first data
    int trcd = 0;       ///< activate to read, same bank
    int trp = 0;        ///< precharge to activate or refresh
    int tras = 0;       ///< activate to precharge, same bank
    int trc = 0;        ///< activate to activate, same bank
    int trrd = 0;       ///< activate to activate, any bank
    int trrd_l = 0;     ///< the same in one bank group, if that takes longer
    int tfaw = 0;       ///< at most four activates in it; 0: no such gate
    int trtp = 0;       ///< read to precharge, same bank
    int tccd = 0;       ///< read to read
    int tccd_l = 0;     ///< the same in one bank group, if that takes longer
    int cwl = 0;        ///< clocks from write to first data
    int twr = 15'000;   ///< last data of a write to precharge, same bank
    int twtr = 7'500;   ///< last data of a write to a read
    int trefi = 0;      ///< one refresh of all banks in every such time
    int trfc = 0;       ///< refresh to activate or refresh

    // Controller.
    int request_ps = 0;   ///< from the clock edge that accepts a request to the first command it can cause
    int answer_ps = 0;    ///< from the last data to the answer on the chip's side
    int queue = 16;       ///< requests it holds
    int age_cap = 16;     ///< later requests that may go before one

    int row_bytes() const { return columns * bus_bits / 8; }
    int burst_clocks() const { return burst_length / transfers; }
    /// Clocks in which nobody drives the data bus, as it turns from reading to writing: a chip of single data
    /// rate needs one, others two (JESD79-3F, 4.13.2.2: RL + tCCD + 2 tCK - WL from read to write).
    int turn_clocks() const { return transfers == 1 ? 1 : 2; }
    /// Read commands that one request of 64 bytes takes.
    int bursts() const;
};

/// What reads of 64 bytes could bring if the data bus never paused.
std::int64_t peak_bytes_per_second(const DramPart& part);
std::int64_t capacity_bytes(const DramPart& part);

/// No request waits longer than this while nothing else moves: it comes as a refresh falls due, every gate of
/// the part stands in its way once, and all its bursts follow one another.
std::int64_t longest_pause_ps(const DramPart& part);

/// The memory of that name in names_of<DramName>(); `ideal` is none of these. Throws UserError for any other
/// name.
const DramPart& dram_part(const std::string& name);

}   // namespace rayclock
