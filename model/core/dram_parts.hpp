#pragma once
// A memory part, and its derived figures.
#include <cstdint>
#include <string>

namespace rayclock {

/// A memory on a board: chips, clock and controller. Times are integers in picoseconds. Users round a gate up
/// to whole clocks, as data sheets require.
struct DramPart {
    std::string name, description;
    std::string source;   ///< origin of the figures

    // Organisation of all chips on the bus together.
    int bus_bits = 16;
    int transfers = 1;      ///< per clock: 1 single data rate, 2 double
    int burst_length = 8;   ///< transfers per read command
    int banks = 4;
    int bank_groups = 1;   ///< bank b is in group b % bank_groups
    int rows = 8192;       ///< per bank
    int columns = 1024;    ///< per row, one transfer each

    // Clock and gates.
    int tck = 0;        ///< clock period of commands and data
    int cl = 0;         ///< clocks from read to first data
    int trcd = 0;       ///< activate to read, same bank
    int trp = 0;        ///< precharge to activate or refresh
    int tras = 0;       ///< activate to precharge, same bank
    int trc = 0;        ///< activate to activate, same bank
    int trrd = 0;       ///< activate to activate, any bank
    int trrd_l = 0;     ///< the same in one bank group, if that takes longer
    int tfaw = 0;       ///< window for at most four activates; 0: none
    int trtp = 0;       ///< read to precharge, same bank
    int tccd = 0;       ///< read to read
    int tccd_l = 0;     ///< the same in one bank group, if that takes longer
    int cwl = 0;        ///< clocks from write to first data
    int twr = 15'000;   ///< last data of a write to precharge, same bank
    int twtr = 7'500;   ///< last data of a write to a read
    int trefi = 0;      ///< interval between refreshes of all banks
    int trfc = 0;       ///< refresh to activate or refresh

    // Controller.
    /// Time from the clock edge that accepts a request to the first command that it can cause.
    int request_ps = 0;
    int answer_ps = 0;   ///< from the last data to the answer on the chip's side
    int queue = 16;      ///< most requests that it holds
    int age_cap = 16;    ///< most later requests that may overtake a request

    int row_bytes() const { return columns * bus_bits / 8; }
    int burst_clocks() const { return burst_length / transfers; }
    /// Clocks without a driver on the data bus when it turns from reading to writing. A chip of single data
    /// rate needs one, the others two (JESD79-3F, 4.13.2.2: RL + tCCD + 2 tCK - WL from read to write).
    int turn_clocks() const { return transfers == 1 ? 1 : 2; }
    /// Read commands for one request of 64 bytes.
    int bursts() const;
};

/// Returns the throughput of 64-byte reads if the data bus never pauses.
std::int64_t peak_bytes_per_second(const DramPart& part);
std::int64_t capacity_bytes(const DramPart& part);

/// Returns a bound on the wait of a request while nothing else moves. In the worst case it arrives as a
/// refresh falls due, waits once for every gate of the part, and gives its bursts one after another.
std::int64_t longest_pause_ps(const DramPart& part);

/// Returns the memory of a DramName. Throws UserError for any other name and for `ideal`.
const DramPart& dram_part(const std::string& name);

}   // namespace rayclock
