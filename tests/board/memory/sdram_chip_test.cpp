// The behavioural SDRAM notices each violation of the data sheet: hand-made commands at the bound and one
// clock before it, and controllers with one wrong gate.
#include <functional>

#include "tests/board/memory/sdram_world.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

constexpr int code_mode = 0, code_refresh = 1, code_precharge = 2, code_activate = 3, code_write = 4,
              code_read = 5, code_stop = 6, code_nop = 7;

/// A chip with commands by hand.
class Bench {
public:
    explicit Bench(const std::string& name = "as4c32m16sb", int khz = 100'000) : chip(sdram_part(name), khz) {
        wait_ = int(sdram_part(name).initial_wait / (1'000'000'000 / khz));
    }
    void give(int code, std::uint32_t ba = 0, std::uint32_t a = 0) {
        pins.cs_n = false;
        pins.ras_n = code >> 2 & 1;
        pins.cas_n = code >> 1 & 1;
        pins.we_n = code & 1;
        pins.ba = ba;
        pins.a = a;
        edge();
        pins.ras_n = pins.cas_n = pins.we_n = true;
    }
    void nops(int n) {
        for (int i = 0; i < n; ++i) give(code_nop);
    }
    /// A command so many clocks after the last one.
    void after(int clocks, int code, std::uint32_t ba = 0, std::uint32_t a = 0) {
        nops(clocks - 1);
        give(code, ba, a);
    }
    void power_up() { nops(wait_); }
    /// The right start, up to the end of tMRD.
    void start(std::uint32_t cl = 2) {
        power_up();
        give(code_precharge, 0, 0x400);
        after(3, code_refresh);
        after(7, code_refresh);
        after(7, code_mode, 0, cl << 4 | 3);
        nops(2);
    }
    void drive(bool on, std::uint16_t dq = 0, std::uint32_t mask = 0) {
        pins.driven = on;
        pins.dq = dq;
        pins.dqm = mask;
    }
    /// A write of eight beats from `first` on.
    void write(std::uint32_t bank, std::uint32_t column, std::uint16_t first) {
        for (std::uint16_t i = 0; i < 8; ++i) {
            drive(true, std::uint16_t(first + i), 0);
            give(i == 0 ? code_write : code_nop, bank, column);
        }
        drive(false);
    }
    std::vector<SdramFault> faults() const {
        std::vector<SdramFault> kinds;
        for (const auto& v : chip.violations()) kinds.push_back(v.fault);
        return kinds;
    }

    SdramChip chip;
    SdramChipPins pins;
    std::vector<std::optional<std::uint16_t>> seen;   ///< what the chip drives after each edge

private:
    void edge() {
        chip.clock(pins);
        seen.push_back(chip.dq());
    }
    int wait_;
};

using Fault = SdramFault;
using Script = std::function<void(Bench&, int)>;
struct Rule {
    Fault fault;
    int least;   ///< clocks that the script may be given
    Script script;
};

/// Scripts that are right with `least` clocks, and break one rule with one clock less. At 100 MHz.
const Rule rules[] = {
    {Fault::trcd, 3,
     [](Bench& b, int n) {
         b.give(code_activate, 1, 5);
         b.after(n, code_read, 1, 0);
     }},
    {Fault::trcd, 3,
     [](Bench& b, int n) {
         b.give(code_activate, 1, 5);
         b.drive(true);
         b.after(n, code_write, 1, 0);
     }},
    {Fault::trp, 3,
     [](Bench& b, int n) {
         b.give(code_activate, 2, 5);
         b.after(20, code_precharge, 2);
         b.after(n, code_activate, 2, 6);
     }},
    {Fault::trp, 3,
     [](Bench& b, int n) {
         b.give(code_activate, 2, 5);
         b.after(20, code_precharge, 0, 0x400);
         b.after(n, code_refresh);
     }},
    {Fault::trp, 3,
     [](Bench& b, int n) {
         b.give(code_activate, 2, 5);
         b.after(20, code_precharge, 2);
         b.after(n, code_mode, 0, 0x23);
     }},
    {Fault::tras, 5,
     [](Bench& b, int n) {
         b.give(code_activate, 3, 5);
         b.after(n, code_precharge, 3);
     }},
    {Fault::trrd, 2,
     [](Bench& b, int n) {
         b.give(code_activate, 0, 5);
         b.after(n, code_activate, 1, 5);
     }},
    {Fault::twr, 2,
     [](Bench& b, int n) {
         b.give(code_activate, 0, 5);
         b.nops(4);
         b.write(0, 16, 1);
         b.after(n, code_precharge, 0);
     }},
    {Fault::trfc, 7,
     [](Bench& b, int n) {
         b.give(code_refresh);
         b.after(n, code_activate, 0, 5);
     }},
    {Fault::trfc, 7,
     [](Bench& b, int n) {
         b.give(code_refresh);
         b.after(n, code_refresh);
     }},
    {Fault::tmrd, 2,
     [](Bench& b, int n) {
         b.give(code_mode, 0, 0x23);
         b.after(n, code_activate, 0, 5);
     }},
    // Driven two clocks after the last read data: one idle clock between.
    {Fault::contention, 11,
     [](Bench& b, int n) {
         b.give(code_activate, 0, 5);
         b.after(3, code_read, 0, 0);
         b.nops(n - 1);
         b.write(0, 8, 1);
     }},
};

/// Returns true if all violations have this kind and there is one.
bool only(const Bench& bench, Fault fault) {
    const auto faults = bench.faults();
    return !faults.empty() && std::ranges::all_of(faults, [&](Fault f) { return f == fault; });
}

}   // namespace

TEST_CASE("the SDRAM chip allows each gate at its bound and refuses one clock less", "[sdram][chip]") {
    int index = 0;
    for (const Rule& rule : rules) {
        CAPTURE(index, int(rule.fault), rule.least);
        ++index;
        Bench sound, broken;
        sound.start();
        rule.script(sound, rule.least);
        REQUIRE(sound.faults().empty());
        broken.start();
        rule.script(broken, rule.least - 1);
        REQUIRE(only(broken, rule.fault));
        const std::string text = broken.chip.violations()[0].text;
        CAPTURE(text);
        REQUIRE(text.starts_with("Cycle "));
        REQUIRE(text.ends_with("."));
    }
}

TEST_CASE("the SDRAM chip refuses an activation within tRC", "[sdram][chip]") {
    // Of this part tRAS and tRP together are shorter than tRC: at 125 MHz 5 + 3 clocks against 8, so the row
    // is closed before tRAS here.
    Bench bench("is42s16160g", 125'000);
    bench.power_up();
    bench.give(code_precharge, 0, 0x400);
    bench.after(3, code_refresh);
    bench.after(8, code_refresh);
    bench.after(8, code_mode, 0, 0x33);
    bench.after(2, code_activate, 0, 1);
    bench.after(4, code_precharge, 0);
    bench.after(3, code_activate, 0, 2);
    REQUIRE(bench.faults() == std::vector<Fault>{Fault::tras, Fault::trc});
}

TEST_CASE("the SDRAM chip demands its start in order", "[sdram][chip]") {
    SECTION("right") {
        Bench b;
        b.start();
        REQUIRE(b.faults().empty());
    }
    SECTION("a command one clock early") {
        Bench b;
        b.nops(19'999);
        b.give(code_precharge, 0, 0x400);
        REQUIRE(only(b, Fault::early_command));
    }
    SECTION("no precharge of all banks") {
        Bench b;
        b.power_up();
        b.give(code_precharge, 0, 0);
        REQUIRE(only(b, Fault::initial_order));
    }
    SECTION("one refresh only") {
        Bench b;
        b.power_up();
        b.give(code_precharge, 0, 0x400);
        b.after(3, code_refresh);
        b.after(7, code_mode, 0, 0x23);
        REQUIRE(only(b, Fault::initial_order));
    }
    SECTION("no mode register") {
        Bench b;
        b.power_up();
        b.give(code_precharge, 0, 0x400);
        b.after(3, code_refresh);
        b.after(7, code_refresh);
        b.after(7, code_activate, 0, 1);
        REQUIRE(only(b, Fault::initial_order));
    }
    SECTION("a mode of other bursts, another latency, or an extended mode") {
        const std::uint32_t mode = GENERATE(0x22u, 0x2bu, 0x43u, 0x223u);
        Bench b;
        b.start();
        b.give(code_mode, 0, mode);
        REQUIRE(only(b, Fault::mode));
    }
    SECTION("a clock that is too fast for the CAS latency") {
        Bench b("as4c32m16sb", 110'000);
        b.nops(2000);
        b.start(2);
        REQUIRE(only(b, Fault::clock));
    }
}

TEST_CASE("the SDRAM chip refuses commands in the wrong state of a bank", "[sdram][chip]") {
    Bench b;
    b.start();
    SECTION("an open bank is activated") {
        b.give(code_activate, 0, 1);
        b.after(30, code_activate, 0, 2);
        REQUIRE(only(b, Fault::bank_open));
    }
    SECTION("a closed bank is read") {
        b.give(code_read, 0, 0);
        REQUIRE(only(b, Fault::bank_closed));
    }
    SECTION("another bank is written") {
        b.give(code_activate, 0, 1);
        b.drive(true);
        b.after(5, code_write, 1, 0);
        REQUIRE(only(b, Fault::bank_closed));
    }
    SECTION("a refresh meets an open bank") {
        b.give(code_activate, 3, 1);
        b.after(30, code_refresh);
        REQUIRE(only(b, Fault::bank_open));
    }
    SECTION("the mode register meets an open bank") {
        b.give(code_activate, 3, 1);
        b.after(30, code_mode, 0, 0x23);
        REQUIRE(only(b, Fault::bank_open));
    }
    SECTION("auto precharge, burst stop, power-down") {
        b.give(code_activate, 0, 1);
        SECTION("auto precharge") { b.after(5, code_read, 0, 0x400); }
        SECTION("burst stop") { b.after(5, code_stop); }
        SECTION("power-down") {
            b.pins.cke = false;
            b.nops(1);
        }
        REQUIRE(only(b, Fault::unsupported));
    }
    SECTION("a row stays open too long") {
        b.give(code_activate, 0, 1);
        b.after(10'001, code_precharge, 0);
        REQUIRE(only(b, Fault::tras_longest));
    }
    SECTION("write data are not driven") {
        b.give(code_activate, 0, 1);
        b.after(5, code_write, 0, 0);
        REQUIRE(only(b, Fault::undriven));
    }
}

TEST_CASE("the SDRAM chip refuses a column that does not exist", "[sdram][chip]") {
    const std::string name = GENERATE(as<std::string>{}, "as4c32m16sb", "is42s16160g");
    Bench b(name);
    b.nops(20'000);
    b.start();
    b.give(code_activate, 0, 1);
    b.after(5, code_read, 0, 512);
    REQUIRE(b.faults().empty() == (name == "as4c32m16sb"));
    if (name != "as4c32m16sb") REQUIRE(only(b, Fault::column));
}

TEST_CASE("the SDRAM chip refuses to keep a row for more than 64 ms", "[sdram][chip]") {
    Bench b("as4c32m16sb", 50'000);
    b.start();
    for (int i = 0; i < 8191; ++i) b.after(390, code_refresh);
    b.nops(3'200'000 - 8191 * 390 - 10);
    REQUIRE(b.faults().empty());   // one row has waited for almost 64 ms
    b.nops(20);
    REQUIRE(b.faults() == std::vector<Fault>{Fault::retention});
}

TEST_CASE("the SDRAM chip holds bytes, masks them, and answers after the CAS latency", "[sdram][chip]") {
    const std::uint32_t cl = GENERATE(2u, 3u);
    Bench b;
    b.start(cl);
    b.give(code_activate, 2, 77);
    b.nops(4);
    b.write(2, 40, 0x1000);
    // The lower byte of beat 3 is written again, with the column order of a wrapped burst.
    for (std::uint32_t i = 0; i < 8; ++i) {
        b.drive(true, std::uint16_t(0xaa00 + i), i == 6 ? 2 : 3);
        b.give(i == 0 ? code_write : code_nop, 2, 45);
    }
    b.drive(false);
    b.nops(2);
    b.seen.clear();
    b.give(code_read, 2, 40);
    b.nops(12);
    REQUIRE(b.faults().empty());
    for (std::size_t i = 0; i < b.seen.size(); ++i) {
        CAPTURE(i, cl);
        const bool drives = i >= cl - 1 && i < cl + 7;
        REQUIRE(b.seen[i].has_value() == drives);
        if (drives) {
            const std::uint16_t at = std::uint16_t(i - (cl - 1));
            REQUIRE(*b.seen[i] == (at == 3 ? 0x1006 : 0x1000 + at));
        }
    }
    REQUIRE(b.chip.peek(2, 77, 41) == 0x1001);
    REQUIRE(b.chip.unwritten_reads() == 0);
    b.give(code_read, 2, 48);
    b.nops(12);
    REQUIRE(b.chip.unwritten_reads() == 8);
}

TEST_CASE("DQM masks the read data of two clocks later", "[sdram][chip]") {
    Bench b;
    b.start(3);
    b.give(code_activate, 2, 77);
    b.nops(4);
    b.write(2, 40, 0x1000);
    b.nops(2);
    b.seen.clear();
    b.give(code_read, 2, 40);
    for (int i = 1; i < 12; ++i) {
        b.drive(false, 0, i == 4 ? 3 : i == 6 ? 1 : 0);
        b.nops(1);
    }
    // The beat that is valid at edge 6 is on the pins from edge 5 on.
    REQUIRE_FALSE(b.seen[5].has_value());
    REQUIRE(b.seen[6] == std::uint16_t(0x1004));
    REQUIRE(b.seen[7] == std::uint16_t(0x10ff));
    REQUIRE(b.seen[8] == std::uint16_t(0x1006));
}

TEST_CASE("the SDRAM chip notices a controller with one wrong gate", "[sdram][chip]") {
    struct Wrong {
        Fault fault;
        int khz;
        std::function<void(SdramClocks&)> change;
    };
    const Wrong wrong[] = {
        {Fault::trcd, 142'857, [](SdramClocks& c) { --c.rcd; }},
        {Fault::trp, 142'857, [](SdramClocks& c) { --c.rp; }},
        {Fault::tras, 142'857, [](SdramClocks& c) { --c.ras; }},
        {Fault::twr, 142'857, [](SdramClocks& c) { --c.wr; }},
        {Fault::trfc, 142'857, [](SdramClocks& c) { --c.rfc; }},
        {Fault::clock, 142'857, [](SdramClocks& c) { c.cl = 2; }},
        {Fault::early_command, 75'000, [](SdramClocks& c) { c.initial_wait -= 10; }},
        {Fault::initial_order, 75'000, [](SdramClocks& c) { c.initial_refreshes = 1; }},
        {Fault::retention, 50'000, [](SdramClocks& c) { c.refi += 5; }},
        {Fault::column, 75'000, [](SdramClocks& c) { ++c.column_bits; }},
    };
    for (const Wrong& w : wrong) {
        CAPTURE(int(w.fault));
        const SdramPart& part = sdram_part(w.fault == Fault::column ? "is42s16160g" : "as4c32m16sb");
        SdramClocks clocks = sdram_clocks(part, w.khz);
        for (const bool is_changed : {false, true}) {
            if (is_changed) w.change(clocks);
            Sdram model(clocks);
            SdramChip chip(part, w.khz);
            Draw draw(5);
            std::uint32_t last = 0;
            const int cycles = w.fault == Fault::retention ? 3'400'000 : 1'000'000;
            int pause = 0;
            for (int i = 0; i < cycles && chip.violations().empty(); ++i) {
                chip.clock(chip_pins(model.pins()));
                Sdram::Request request;
                pause -= pause > 0;
                const bool offers = model.ready() && pause == 0 && w.fault != Fault::retention;
                if (offers) {
                    request = {draw.percent(30), last = next_address(draw, part, last), 0};
                    if (draw.percent(10)) pause = draw.below(60);
                }
                model.clock(offers ? &request : nullptr);
            }
            if (is_changed)
                REQUIRE((!chip.violations().empty() && chip.violations()[0].fault == w.fault));
            else
                REQUIRE(chip.violations().empty());
        }
    }
}
