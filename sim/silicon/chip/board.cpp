// Reads the sources of the board's top, and runs ecppack.
#include "sim/silicon/chip/board.hpp"

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/board/sdram_parts.hpp"
#include "sim/board/identity.hpp"
#include "sim/files/input.hpp"
#include "sim/files/process/process.hpp"
#include "sim/files/process/tools.hpp"
#include "sim/run/rtl/sources.hpp"
#include "sim/silicon/chip/nextpnr.hpp"

namespace rayclock::chip {

namespace fs = std::filesystem;

namespace {

/// Returns the path of ecppack. Prefers the one in nextpnr's folder with the same prefix ("yowasp-"), then
/// one in PATH.
fs::path packer() {
    const fs::path router = nextpnr().program;
    std::string name = router.filename().string();
    if (const std::size_t at = name.find("nextpnr-ecp5"); at != std::string::npos) {
        name.replace(at, std::string::npos, "ecppack");
        std::error_code error;
        if (fs::is_regular_file(router.parent_path() / name, error)) return router.parent_path() / name;
    }
    for (const char* other : {"ecppack", "yowasp-ecppack"})
        if (const fs::path found = find_program(other); !found.empty()) return found;
    throw UserError("ecppack is not installed; ./bootstrap chip in the sources of rayclock installs one");
}

}   // namespace

void check_pll(int khz) {
    if (khz != 75'000 && khz != 62'500)
        throw UserError(
            fmt::format("--clock {:g}: the board's PLL makes 75 or 62.5 MHz; give one of these", khz / 1e3));
}

std::string board_verilog() { return read_file((rtl_sources() / "ecp5/rc_ulx3s.v").string()); }

std::string board_pins() { return read_file((rtl_sources() / "ecp5/ulx3s.lpf").string()); }

std::string board_parameters(const Config& config, int khz) {
    return fmt::format("-chparam CLK_KHZ {} -chparam COLUMN_BITS {} -chparam CONFIG_HASH 64'h{:016x}", khz,
                       sdram_part(config.board_sdram).column_bits, config_hash(config));
}

std::string pin_registers() {
    // 13 bits of the address, 2 of the bank, 4 of the command, 2 masks and 16 of data leave; 16 of data
    // enter.
    return R"(select -set pads w:sdram_a w:sdram_ba w:sdram_csn w:sdram_rasn w:sdram_casn w:sdram_wen w:sdram_dqm w:dq_out
select -set registers @pads %a %ci1:+TRELLIS_FF[Q] t:TRELLIS_FF %i
select -assert-count 37 @registers
setattr -set syn_useioff 1 -set ioff_dir "output" @registers
select -set registers w:dq_in %a %co1:+TRELLIS_FF[DI] t:TRELLIS_FF %i
select -assert-count 16 @registers
setattr -set syn_useioff 1 -set ioff_dir "input" @registers
)";
}

const std::string& packer_version() {
    static const std::string version = version_line({packer().string(), "--version"});
    return version;
}

void pack_bitstream(const fs::path& folder, const char* textual, const char* bitstream) {
    Process process({{packer().string(), "--compress", textual, bitstream}, folder, folder / "log", folder});
    process.wait("interrupted");
    if (process.code() != 0)
        throw UserError("ecppack failed: " + complaint_of(read_if_there(folder / "log")));
    if (read_if_there(folder / bitstream).empty())
        throw UserError("ecppack has written no bitstream; is the disk full?");
}

}   // namespace rayclock::chip
