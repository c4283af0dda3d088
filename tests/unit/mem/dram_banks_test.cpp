// dram: the parameters of the parts, and every gate of the banks on both sides.
#include <catch2/catch.hpp>

#include "model/core/config.hpp"
#include "model/base/error.hpp"
#include "model/mem/dram_banks.hpp"

using namespace rayclock;

TEST_CASE("every named memory but the ideal one is a part, and its figures are those of its data sheet",
          "[dram]") {
    for (const std::string& name : names_of<DramName>()) {
        if (name == "ideal")
            REQUIRE_THROWS_AS(dram_part(name), UserError);
        else
            REQUIRE(dram_part(name).name == name);
    }
    REQUIRE_THROWS_AS(dram_part("tape"), UserError);
    REQUIRE(peak_bytes_per_second(dram_part("sdr")) == 285'714'285);
    REQUIRE(peak_bytes_per_second(dram_part("ddr3")) == 1'333'333'333);
    REQUIRE(peak_bytes_per_second(dram_part("rpu")) == 351'988'736);
    REQUIRE(capacity_bytes(dram_part("sdr")) == 64 << 20);
    REQUIRE(capacity_bytes(dram_part("ddr3")) == 256 << 20);
    REQUIRE(capacity_bytes(dram_part("rpu")) == 64 << 20);
    REQUIRE(dram_part("sdr").bursts() == 4);
    REQUIRE(dram_part("ddr3").bursts() == 4);
    REQUIRE(dram_part("rpu").bursts() == 2);
    REQUIRE(peak_bytes_per_second(dram_part("ddr4")) == 19'207'683'073);
    REQUIRE(peak_bytes_per_second(dram_part("lpddr4")) == 6'400'000'000);
    REQUIRE(peak_bytes_per_second(dram_part("hbm2")) == 32'000'000'000);
    REQUIRE(capacity_bytes(dram_part("ddr4")) == std::int64_t(8) << 30);
    REQUIRE(capacity_bytes(dram_part("lpddr4")) == 512 << 20);
    REQUIRE(capacity_bytes(dram_part("hbm2")) == 1 << 30);
    REQUIRE(dram_part("lpddr4").bursts() == 2);
    REQUIRE(dram_part("hbm2").bursts() == 1);
}

TEST_CASE("each gate of a DRAM holds a command back until its clock and no longer", "[dram]") {
    struct Step {
        DramCommand command;
        int bank;
    };
    struct Gate {
        const char* name;
        int DramPart::*time;
        std::vector<Step> before;   // each issued as early as possible
        std::size_t from;           // the command from which the gate counts
        Step held;
    };
    const auto act = DramCommand::activate, rd = DramCommand::read, pre = DramCommand::precharge;
    const auto all = DramCommand::precharge_all, ref = DramCommand::refresh;
    const std::vector<Gate> gates{
        {"tRCD", &DramPart::trcd, {{act, 0}}, 0, {rd, 0}},
        {"tRAS", &DramPart::tras, {{act, 0}}, 0, {pre, 0}},
        {"tRAS, all", &DramPart::tras, {{act, 0}, {act, 1}}, 1, {all, 0}},
        {"tRP", &DramPart::trp, {{act, 0}, {pre, 0}}, 1, {act, 0}},
        {"tRP, refresh", &DramPart::trp, {{act, 0}, {pre, 0}}, 1, {ref, 0}},
        {"tRP, all", &DramPart::trp, {{act, 0}, {act, 1}, {all, 0}}, 2, {act, 1}},
        {"tRC", &DramPart::trc, {{act, 0}, {pre, 0}}, 0, {act, 0}},
        {"tRC, refresh", &DramPart::trc, {{act, 1}, {pre, 1}}, 0, {ref, 0}},
        {"tRRD", &DramPart::trrd, {{act, 0}}, 0, {act, 1}},
        {"tRRD, group", &DramPart::trrd_l, {{act, 0}}, 0, {act, 4}},
        {"tFAW", &DramPart::tfaw, {{act, 0}, {pre, 0}, {act, 1}, {act, 2}, {act, 3}}, 0, {act, 0}},
        {"tFAW, second",
         &DramPart::tfaw,
         {{act, 0}, {pre, 0}, {act, 1}, {pre, 1}, {act, 2}, {act, 3}, {act, 0}},
         2,
         {act, 1}},
        {"tRTP", &DramPart::trtp, {{act, 0}, {rd, 0}}, 1, {pre, 0}},
        {"tRTP, all", &DramPart::trtp, {{act, 0}, {rd, 0}}, 1, {all, 0}},
        {"tCCD", &DramPart::tccd, {{act, 0}, {rd, 0}}, 1, {rd, 0}},
        {"tCCD, banks", &DramPart::tccd, {{act, 0}, {act, 1}, {rd, 0}}, 2, {rd, 1}},
        {"tCCD, group", &DramPart::tccd_l, {{act, 0}, {act, 4}, {rd, 0}}, 2, {rd, 4}},
        {"tRFC", &DramPart::trfc, {{ref, 0}}, 0, {act, 2}},
        {"tRFC, refresh", &DramPart::trfc, {{ref, 0}}, 0, {ref, 0}},
    };
    const DramPart sheet =
        dram_part(GENERATE(as<std::string>{}, "sdr", "sdr_half", "ddr3", "rpu", "ddr4", "lpddr4", "hbm2"));
    for (const Gate& gate : gates)
        for (const int extra : {0, 1}) {   // a whole number of clocks, and one picosecond more
            // Long enough that no other gate binds. dram_test.cpp judges the data sheet's own values.
            DramPart part = sheet;
            part.banks = std::max(part.banks, 8);
            part.*gate.time = (part.*gate.time / part.tck + 60) * part.tck + extra;
            CAPTURE(part.name, gate.name, extra);
            DramBanks banks{part};
            std::vector<std::int64_t> given;
            for (const Step step : gate.before) {
                given.push_back(banks.earliest(step.command, step.bank));
                banks.issue(step.command, step.bank, 7, given.back());
            }
            const std::int64_t clock = given[gate.from] + (part.*gate.time + part.tck - 1) / part.tck;
            CHECK_FALSE(banks.allows(gate.held.command, gate.held.bank, clock - 1));
            CHECK(banks.allows(gate.held.command, gate.held.bank, clock));
        }
    DramPart part = sheet;
    part.tccd = part.tccd_l = part.trcd = 0;
    DramBanks banks{part};
    banks.issue(act, 0, 7, 0);
    REQUIRE(banks.earliest(rd, 0) == 1);   // one command per clock
    banks.issue(rd, 0, 7, 1);
    REQUIRE(banks.earliest(rd, 0) == 1 + part.burst_length / part.transfers);   // data do not overlap
    REQUIRE(banks.is_open(0));
    REQUIRE(banks.row(0) == 7);
}

TEST_CASE("the gates of a bank group do not hold back another group", "[dram]") {
    DramPart part = dram_part("ddr4");
    part.tccd_l = part.trrd_l = 100 * part.tck;
    DramBanks banks{part};
    banks.issue(DramCommand::activate, 0, 7, 0);
    CHECK(banks.earliest(DramCommand::activate, 1) == 4);   // tRRD_S
    CHECK(banks.earliest(DramCommand::activate, 4) == 100);
    banks.issue(DramCommand::activate, 1, 7, 4);
    banks.issue(DramCommand::read, 0, 7, 50);
    CHECK(banks.earliest(DramCommand::read, 1) == 54);   // tCCD_S
    CHECK(banks.earliest(DramCommand::read, 0) == 150);
}
