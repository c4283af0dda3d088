#pragma once
// Figures of the SDR SDRAM chips that ULX3S boards carry, and the timings of a controller in clocks.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rayclock {

/// One chip, 16 bits wide, four banks. Times in ps, as its data sheet states them.
struct SdramPart {
    std::string name, source;
    int row_bits = 13;                                ///< 8192 rows in a bank
    int column_bits = 10;                             ///< columns of 16 bits in a row
    std::int64_t tck_cl2 = 10'000, tck_cl3 = 7'000;   ///< shortest clock for a CAS latency of 2 and of 3
    std::int64_t trcd = 0;                            ///< activation to read or write of the bank
    std::int64_t trp = 0;                             ///< precharge to activation, refresh, mode register
    std::int64_t tras = 0, tras_longest = 0;          ///< activation to precharge
    std::int64_t trc = 0;                             ///< activation to activation of the same bank
    std::int64_t trrd = 0;                            ///< activation to activation of another bank
    std::int64_t twr = 0;                             ///< last data written to precharge
    int twr_clocks = 0;                               ///< and at least so many clocks
    std::int64_t trfc = 0;                            ///< refresh to the next command
    int tmrd_clocks = 0;                              ///< mode register to the next command
    std::int64_t trefi = 0;                           ///< average interval of refreshes
    std::int64_t retention = 64'000'000'000;          ///< every row is refreshed in this time
    std::int64_t initial_wait = 0;                    ///< from power and clock to the first command
    int initial_refreshes = 2;                        ///< before the first activation
    std::uint64_t bytes() const { return std::uint64_t(8) << (row_bits + column_bits); }
    int line_bits() const { return row_bits + 2 + column_bits - 5; }   ///< of a line's number
};

/// Returns the chip called `name`; throws UserError for an unknown name. sdram_parts() lists all.
const SdramPart& sdram_part(std::string_view name);
const std::vector<SdramPart>& sdram_parts();

/// Gates in clocks of the controller, and its other parameters. Mirror of the parameters of
/// rtl/board/memory/rc_sdram.sv: timings are rounded up with the period rounded down to 1 ps, and the
/// interval of refreshes is rounded down with the period rounded up.
struct SdramClocks {
    int row_bits = 0, column_bits = 0;
    int cl = 0;   ///< CAS latency
    int rcd = 0, rp = 0, wr = 0, rfc = 0, refi = 0, mrd = 0;
    int ras = 0;   ///< long enough to imply tRC; tRRD needs no gate, because a column command lies between
    int initial_wait = 0, initial_refreshes = 0;
    int read_delay = 0;   ///< additional clocks until read data are captured (rc_sdram.sv)
};
/// Returns the clocks of a controller at `khz`, with the smallest CAS latency that the chip allows. Throws
/// UserError if the chip does not allow this clock.
SdramClocks sdram_clocks(const SdramPart& part, int khz, int read_delay = 0);
/// Throws UserError if the chip does not allow this clock.
void check_sdram_clock(const SdramPart& part, int khz);

/// Returns the parameters of rc_sdram and rc_board_memory for this chip, as "Name=value" with blanks between.
std::string sdram_parameters(const SdramPart& part, int khz, int read_delay = 0);

}   // namespace rayclock
