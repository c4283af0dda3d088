// Derived figures of a memory, and the look-up of memories by name.
#include "model/core/dram_parts.hpp"

#include <algorithm>

#include "model/base/nearest.hpp"
#include "model/core/config.hpp"
#include "model/core/dram_presets.hpp"

namespace rayclock {

int DramPart::bursts() const { return std::max(1, 8 * line_bytes / bus_bits / burst_length); }

std::int64_t longest_pause_ps(const DramPart& p) {
    const std::int64_t trrd = std::max(p.trrd, p.trrd_l), tccd = std::max(p.tccd, p.tccd_l);
    const std::int64_t gates = std::int64_t(p.trcd) + p.trp + p.tras + p.trc + trrd + p.tfaw + p.trtp +
                               p.twr + p.twtr + tccd + p.trfc;
    const std::int64_t data = std::int64_t(p.cl + p.bursts() * (p.burst_clocks() + tccd / p.tck)) * p.tck;
    return p.request_ps + gates + data + p.answer_ps;
}

std::int64_t peak_bytes_per_second(const DramPart& part) {
    const std::int64_t clocks = std::int64_t(part.bursts()) * part.burst_clocks();
    return std::int64_t(1'000'000'000'000) * line_bytes / (clocks * part.tck);
}

std::int64_t capacity_bytes(const DramPart& part) {
    return std::int64_t(part.row_bytes()) * part.rows * part.banks;
}

const DramPart& dram_part(const std::string& name) {
    static const DramPart all[]{sdr(), ddr3(), rpu(), sdr_half(), ddr4(), lpddr4(), hbm2(), board()};
    return by_name(all, name, "no memory part");
}

}   // namespace rayclock
