// The figures of each SDRAM chip, with their sources.
#include "model/board/sdram_parts.hpp"

#include <algorithm>

#include "model/base/error.hpp"
#include "model/base/nearest.hpp"
#include "model/base/quote.hpp"

namespace rayclock {

namespace {

/// The controller gives more refreshes at the start than either data sheet demands (2); Micron's sheet and
/// others ask for 8 of similar chips.
constexpr int initial_refreshes = 8;

// On ULX3S boards v3.0.7. Gates: as the preset `sdr` in model/core/dram_presets.cpp, from the data sheet's
// Table 16, column -7.
SdramPart as4c32m16sb() {
    SdramPart p;
    p.name = "as4c32m16sb";
    p.source = "AS4C32M16SB-7TCN data sheet, Table 16 and the section on power-up";
    p.column_bits = 10;
    p.trcd = 21'000;
    p.trp = 21'000;
    p.tras = 42'000;
    p.tras_longest = 100'000'000;
    p.trc = 63'000;
    p.trrd = 14'000;
    p.twr = 14'000;
    p.twr_clocks = 2;
    p.trfc = 63'000;
    p.tmrd_clocks = 2;
    p.trefi = 7'800'000;
    p.initial_wait = 200'000'000;
    return p;
}

// On ULX3S boards v3.0.8. Editions of the data sheet state 15 ns and 20 ns for tRCD and tRP of grade -7. The
// longer value is right for either.
SdramPart is42s16160g() {
    SdramPart p;
    p.name = "is42s16160g";
    p.source = "IS42S16160G-7 data sheet, AC electrical characteristics; tRCD and tRP: the longer value";
    p.column_bits = 9;
    p.trcd = 20'000;
    p.trp = 20'000;
    p.tras = 37'000;
    p.tras_longest = 100'000'000;
    p.trc = 60'000;
    p.trrd = 14'000;
    p.twr = 14'000;
    p.twr_clocks = 2;
    p.trfc = 60'000;
    p.tmrd_clocks = 2;
    p.trefi = 7'800'000;
    p.initial_wait = 100'000'000;
    return p;
}

}   // namespace

const std::vector<SdramPart>& sdram_parts() {
    static const std::vector<SdramPart> all{as4c32m16sb(), is42s16160g()};
    return all;
}

const SdramPart& sdram_part(std::string_view name) {
    for (const SdramPart& part : sdram_parts())
        if (part.name == name) return part;
    std::vector<std::string> names;
    for (const SdramPart& part : sdram_parts()) names.push_back(part.name);
    throw UserError("no SDRAM is called " + shown(name) + did_you_mean(name, names));
}

namespace {

/// "75", "62.5": kHz in MHz.
std::string mhz_text(int khz) {
    std::string text = std::to_string(khz / 1000) + "." + std::to_string(1000 + khz % 1000).substr(1);
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text;
}

int cas_latency(const SdramPart& part, int khz) {
    const std::int64_t period = 1'000'000'000 / khz;
    if (period < part.tck_cl3)
        throw UserError("the SDRAM " + part.name + " allows a clock of at most " +
                        mhz_text(int(1'000'000'000 / part.tck_cl3)) + " MHz, not " + mhz_text(khz));
    return period >= part.tck_cl2 ? 2 : 3;
}

}   // namespace

void check_sdram_clock(const SdramPart& part, int khz) { cas_latency(part, khz); }

SdramClocks sdram_clocks(const SdramPart& part, int khz, int read_delay) {
    const std::int64_t giga = 1'000'000'000, shorter = giga / khz, longer = (giga + khz - 1) / khz;
    const auto clocks = [&](std::int64_t ps) { return int((ps + shorter - 1) / shorter); };
    SdramClocks c;
    c.row_bits = part.row_bits;
    c.column_bits = part.column_bits;
    c.cl = cas_latency(part, khz);
    c.rcd = clocks(part.trcd);
    c.rp = clocks(part.trp);
    c.ras = std::max(clocks(part.tras), clocks(part.trc) - c.rp);
    c.wr = std::max(clocks(part.twr), part.twr_clocks);
    c.rfc = clocks(part.trfc);
    c.refi = int(part.trefi / longer);
    c.mrd = part.tmrd_clocks;
    c.initial_wait = clocks(part.initial_wait);
    c.initial_refreshes = initial_refreshes;
    c.read_delay = read_delay;
    return c;
}

std::string sdram_parameters(const SdramPart& part, int khz, int read_delay) {
    const std::pair<const char*, std::int64_t> all[] = {
        {"ClkKhz", khz},
        {"RowBits", part.row_bits},
        {"ColumnBits", part.column_bits},
        {"Cl", cas_latency(part, khz)},
        {"RcdPs", part.trcd},
        {"RpPs", part.trp},
        {"RasPs", part.tras},
        {"RcPs", part.trc},
        {"RrdPs", part.trrd},
        {"WrPs", part.twr},
        {"WrClocks", part.twr_clocks},
        {"RfcPs", part.trfc},
        {"RefiPs", part.trefi},
        {"MrdClocks", part.tmrd_clocks},
        {"InitUs", part.initial_wait / 1'000'000},
        {"InitRefreshes", initial_refreshes},
        {"ReadDelay", read_delay},
    };
    std::string text;
    for (const auto& [name, value] : all)
        text += (text.empty() ? "" : " ") + (name + ("=" + std::to_string(value)));
    return text;
}

}   // namespace rayclock
