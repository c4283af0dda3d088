// rc_board_memory and its model in every cycle, with a behavioural SDRAM: each client gets its own data, in
// order, and the host is served under full load.
#include "tests/board/memory/sdram_world.hpp"
#include "model/board/memory_clients.hpp"
#include "tests/support/machine/build_all.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

std::string memory_module(const SdramPart& part, int khz) {
    return "rc_board_memory " + sdram_parameters(part, khz);
}

/// How often each client offers, in percent of the cycles in which it may, and the share of other choices.
struct Load {
    int chip = 0, scan = 0, pixels = 0, host = 0, urgent = 0, host_writes = 50;
};

class MemoryRig {
public:
    MemoryRig(const SdramPart& part, int khz, unsigned seed)
        : part(part),
          config(format("default")),
          model(sdram_clocks(part, khz), config.mem_id_bits()),
          chip(part, khz),
          expected(part, chip),
          draw(seed),
          rtl_(config, memory_module(part, khz), int(seed)),
          pins_(rtl_) {
        set_offers();
        align_ = 0;
        rtl_.reset();
    }

    /// One cycle in which clients that are idle may offer.
    void step(const Load& load) {
        choose(load);
        set_offers();
        const bool aligns = align_every > 0 && model.init_done() && draw.below(align_every) == 0;
        align_ = aligns;
        if (aligns) model.align();
        rtl_.settle();
        const MemoryClients::Ready ready = model.ready();
        const RcPort& request = rtl_.port("mem_req");
        same(cycle, "mem_req_ready", *request.ready, ready.chip);
        same(cycle, "scan_req_ready", scan_ready_, ready.scan);
        same(cycle, "pix_req_ready", pix_ready_, ready.pixels);
        same(cycle, "host_req_ready", host_ready_, ready.host);
        same(cycle, "init_done", init_done_, model.init_done());
        take_beats();
        check_answers();

        const SdramChipPins pins = pins_.get();
        require_same_pins(cycle, pins, model.sdram());
        chip.clock(pins);
        const std::optional<std::uint16_t> dq = chip.dq();
        pins_.set_dq(dq ? *dq : std::uint16_t(draw.bits(16)));
        if (!chip.violations().empty()) FAIL(chip.violations().front().text);
        rtl_.clock();
        const Waiting waiting{!ready.chip, offers.scan.valid && !ready.scan,
                              offers.pixels.valid && !ready.pixels, offers.host.valid && !ready.host};
        const bool free = model.sdram().ready();
        accept(ready);
        model.clock(offers_of_cycle_);
        ++cycle;
        check_grant(waiting, free);
    }
    void drain() {
        for (int i = 0; i < 400; ++i) step({});
        REQUIRE(chip_reads_.empty());
        REQUIRE(scan_reads_.empty());
        REQUIRE(host_reads_.empty());
        REQUIRE(!pixel_write_);
        REQUIRE(!host_write_);
    }

    int align_every = 0;   ///< cycles between two alignments, at random; 0: none
    SdramPart part;
    Config config;
    MemoryClients model;
    SdramChip chip;
    ExpectedMemory expected;
    Draw draw;
    ClientOffers offers;
    std::uint64_t cycle = 0;
    std::uint64_t chips = 0, scans = 0, pixels = 0, hosts = 0;   ///< granted
    std::uint64_t longest_scan = 0;     ///< cycles from an offer of scan to its last beat
    std::uint64_t most_overtaken = 0;   ///< requests granted while one of the host waits
    std::vector<char> order;            ///< of granted requests: c, s, p, h

private:
    struct ChipRead {
        std::uint32_t id;
        LineBeats beats;
    };
    struct BeatReads {
        LineBeats beats;
        std::size_t at = 0;
        std::uint64_t offered = 0;
    };
    struct Write {
        WriteLine line;
        std::size_t at = 0;
    };
    /// Clients with a request that has not been granted.
    struct Waiting {
        bool chip = false, scan = false, pixels = false, host = false;
        int count() const { return chip + scan + pixels + host; }
    };

    void choose(const Load& load) {
        last_ = next_address(draw, part, last_);
        if (!offers.chip.valid) {
            offers.chip = {draw.percent(load.chip), std::uint32_t(draw.bits(config.mem_id_bits())), last_};
        }
        if (!offers.scan.valid) {
            offers.scan = {draw.percent(load.scan), last_, false};
            scan_offered_ = cycle;
        }
        offers.scan.urgent = draw.percent(load.urgent);
        if (!offers.pixels.valid && !pixel_write_) {
            offers.pixels = {draw.percent(load.pixels), last_};
            next_pixels_ = random_line(draw, true);
        }
        if (!offers.host.valid && !host_write_) {
            offers.host = {draw.percent(load.host), draw.percent(load.host_writes), last_};
            next_host_ = random_line(draw, false);
        }
    }
    void set_offers() {
        const RcPort& request = rtl_.port("mem_req");
        *request.valid = offers.chip.valid;
        MemReq payload;
        payload.id = offers.chip.id;
        payload.addr = offers.chip.addr;
        set_data(request, payload, config);
        scan_valid_ = offers.scan.valid;
        scan_addr_ = offers.scan.addr;
        scan_urgent_ = offers.scan.urgent;
        pix_valid_ = offers.pixels.valid;
        pix_addr_ = offers.pixels.addr;
        host_valid_ = offers.host.valid;
        host_is_write_ = offers.host.is_write;
        host_addr_ = offers.host.addr;
    }
    /// The clients whose request was accepted withdraw it. The chip's request then waits in the memory.
    void accept(const MemoryClients::Ready& r) {
        offers_of_cycle_ = offers;
        if (r.chip && offers.chip.valid) {
            held_ = offers.chip;
            offers.chip.valid = false;
        }
        if (r.scan) offers.scan.valid = false;
        if (r.pixels) offers.pixels.valid = false;
        if (r.host) offers.host.valid = false;
    }
    /// One client is granted if the controller is free and a client waits, else none. The priorities are
    /// stated here apart from the model.
    void check_grant(const Waiting& waiting, bool free) {
        const MemoryClients::Ready& r = model.ready();
        const Waiting granted{waiting.chip && r.chip, r.scan, r.pixels, r.host};
        same(cycle, "grants", std::uint64_t(granted.count()), free && waiting.count() > 0);
        const bool others = waiting.chip || waiting.pixels, urgent = offers_of_cycle_.scan.urgent;
        if (granted.host && overtaken_ < 15) same(cycle, "others", others || waiting.scan, 0);
        if (granted.scan && !urgent) same(cycle, "others than scan", others, 0);
        if (granted.chip || granted.pixels) same(cycle, "an urgent scan", waiting.scan && urgent, 0);
        if (!granted.host && granted.count() > 0)
            same(cycle, "a host that is due", waiting.host && overtaken_ >= 15, 0);
        begin(granted);
        if (!waiting.host || granted.host)
            overtaken_ = 0;
        else
            most_overtaken = std::max(most_overtaken, overtaken_ += std::uint64_t(granted.count()));
    }
    /// The granted request passes to the controller, which serves requests in order.
    void begin(const Waiting& granted) {
        if (granted.chip) {
            chip_reads_.push_back({held_.id, expected.line(held_.addr)});
            ++chips;
            order.push_back('c');
        } else if (granted.scan) {
            scan_reads_.push_back({expected.line(offers_of_cycle_.scan.addr), 0, scan_offered_});
            ++scans;
            order.push_back('s');
        } else if (granted.pixels) {
            pixel_write_ = Write{next_pixels_};
            next_pixels_.apply(expected.line(offers_of_cycle_.pixels.addr));
            ++pixels;
            order.push_back('p');
        } else if (granted.host) {
            if (offers_of_cycle_.host.is_write) {
                host_write_ = Write{next_host_};
                next_host_.apply(expected.line(offers_of_cycle_.host.addr));
            } else {
                host_reads_.push_back({expected.line(offers_of_cycle_.host.addr)});
            }
            ++hosts;
            order.push_back('h');
        }
    }
    void take_beats() {
        same(cycle, "pix_next", pix_next_, model.pixels_next());
        same(cycle, "host_next", host_next_, model.host_next());
        pix_data_ = draw.bits(16);
        pix_mask_ = draw.bits(2);
        host_data_ = draw.bits(16);
        if (pixel_write_) {
            pix_data_ = pixel_write_->line.beats[pixel_write_->at];
            pix_mask_ = pixel_write_->line.masks[pixel_write_->at];
        }
        if (host_write_) host_data_ = host_write_->line.beats[host_write_->at];
        if (model.pixels_next()) {
            if (!pixel_write_) FAIL("a beat of pixels is taken without a write");
            if (++pixel_write_->at == 32) pixel_write_.reset();
        }
        if (model.host_next()) {
            if (!host_write_) FAIL("a beat of the host is taken without a write");
            if (++host_write_->at == 32) host_write_.reset();
        }
    }
    void check_beat(const char* what, std::deque<BeatReads>& reads, bool valid, std::uint64_t data) {
        if (!valid) return;
        if (reads.empty()) FAIL(what << ": a beat comes without a read");
        BeatReads& read = reads.front();
        same(cycle, what, data, read.beats[read.at]);
        if (++read.at < 32) return;
        if (&reads == &scan_reads_) longest_scan = std::max(longest_scan, cycle - read.offered);
        reads.pop_front();
    }
    void check_answers() {
        same(cycle, "scan_rd_valid", scan_rd_valid_, model.scan_beat());
        same(cycle, "host_rd_valid", host_rd_valid_, model.host_beat());
        check_beat("scan_rd_data", scan_reads_, model.scan_beat(), scan_rd_data_);
        check_beat("host_rd_data", host_reads_, model.host_beat(), host_rd_data_);
        const RcPort& answer = rtl_.port("mem_rsp");
        same(cycle, "mem_rsp_fires", *answer.valid, model.answers());
        if (!model.answers()) return;
        if (chip_reads_.empty()) FAIL("an answer comes without a read");
        const MemRsp rsp = get_data<MemRsp>(answer, config);
        same(cycle, "id", rsp.id, model.answer_id());
        same(cycle, "the oldest id", rsp.id, chip_reads_.front().id);
        for (std::size_t word = 0; word < 16; ++word)
            same(cycle, "a word of the line", rsp.line[word],
                 std::uint32_t(chip_reads_.front().beats[2 * word]) |
                     std::uint32_t(chip_reads_.front().beats[2 * word + 1]) << 16);
        chip_reads_.pop_front();
    }

    RtlModule rtl_;
    SdramPorts pins_;
    Signal align_{rtl_, "align"}, init_done_{rtl_, "init_done"}, scan_valid_{rtl_, "scan_req_valid"},
        scan_addr_{rtl_, "scan_req_addr"}, scan_urgent_{rtl_, "scan_urgent"},
        pix_valid_{rtl_, "pix_req_valid"}, pix_addr_{rtl_, "pix_req_addr"}, pix_data_{rtl_, "pix_data"},
        pix_mask_{rtl_, "pix_mask"}, host_valid_{rtl_, "host_req_valid"},
        host_is_write_{rtl_, "host_req_write"}, host_addr_{rtl_, "host_req_addr"},
        host_data_{rtl_, "host_wr_data"}, scan_ready_{rtl_, "scan_req_ready"},
        scan_rd_valid_{rtl_, "scan_rd_valid"}, scan_rd_data_{rtl_, "scan_rd_data"},
        pix_ready_{rtl_, "pix_req_ready"}, pix_next_{rtl_, "pix_next"}, host_ready_{rtl_, "host_req_ready"},
        host_next_{rtl_, "host_next"}, host_rd_valid_{rtl_, "host_rd_valid"},
        host_rd_data_{rtl_, "host_rd_data"};
    ClientOffers offers_of_cycle_;
    ClientOffers::Chip held_;   ///< the chip's request that was accepted last
    std::uint32_t last_ = 0;
    std::uint64_t scan_offered_ = 0;
    std::uint64_t overtaken_ = 0;
    WriteLine next_pixels_, next_host_;
    std::deque<ChipRead> chip_reads_;
    std::deque<BeatReads> scan_reads_, host_reads_;
    std::optional<Write> pixel_write_, host_write_;
};

std::uint64_t longest_without(const std::vector<char>& order, char client) {
    std::uint64_t longest = 0, now = 0;
    for (const char c : order) longest = std::max(longest, now = c == client ? 0 : now + 1);
    return longest;
}

}   // namespace

TEST_CASE("the RTL of the board's memory is built", "[.build]") {
    std::vector<RtlJob> jobs;
    for (const SdramPart& part : sdram_parts())
        jobs.push_back({memory_module(part, 75'000), part.name, format("default")});
    build_all(jobs);
}

TEST_CASE("model and RTL of the board's memory agree in every cycle, and each client gets its data",
          "[memory][lockstep]") {
    const SdramPart& part = sdram_part(GENERATE(as<std::string>{}, "as4c32m16sb", "is42s16160g"));
    const unsigned seed = GENERATE(1u, 2u);
    CAPTURE(part.name, seed);
    MemoryRig rig(part, 75'000, seed);
    rig.align_every = 3000;
    while (!rig.model.init_done()) rig.step({10, 10, 10, 10, 50});
    for (int phase = 0; phase < 120; ++phase) {
        const auto some = [&] { return rig.draw.coin() ? rig.draw.below(101) : rig.draw.below(4); };
        const Load load{some(), some(), some(), some(), some(), some()};
        for (int i = 0; i < 3000; ++i) rig.step(load);
        if (rig.draw.below(4) == 0) rig.drain();
    }
    rig.drain();
    REQUIRE(rig.expected.chip_agrees());
    CHECK(rig.chips > 1000);
    CHECK(rig.scans > 1000);
    CHECK(rig.pixels > 500);
    CHECK(rig.hosts > 100);
}

TEST_CASE("under full load chip and pixels take turns, and the host is served after 15 others",
          "[memory][fair]") {
    MemoryRig rig(sdram_part("as4c32m16sb"), 75'000, 1);
    while (!rig.model.init_done()) rig.step({});
    SECTION("no scan") {
        for (int i = 0; i < 40'000; ++i) rig.step({100, 0, 100, 100, 0});
        REQUIRE(rig.most_overtaken == 15);
        REQUIRE(longest_without(rig.order, 'c') <= 2);
        // Pixels do not offer while a line of theirs is written.
        REQUIRE(longest_without(rig.order, 'p') <= 3);
    }
    SECTION("an urgent scan goes first") {
        for (int i = 0; i < 40'000; ++i) rig.step({100, 100, 100, 100, 100});
        REQUIRE(rig.most_overtaken == 15);
        REQUIRE(longest_without(rig.order, 's') <= 1);
    }
    SECTION("another scan waits for chip and pixels, but goes before the host") {
        for (int i = 0; i < 40'000; ++i) rig.step({1, 100, 2, 100, 0});
        REQUIRE(rig.most_overtaken == 15);
        REQUIRE(rig.scans > 250);
        REQUIRE(rig.chips > 250);
        REQUIRE(rig.pixels > 250);
    }
}

TEST_CASE("an urgent scan waits for three lines and a refresh at most", "[memory][fair]") {
    const SdramPart& part = sdram_part("as4c32m16sb");
    const SdramClocks c = sdram_clocks(part, 75'000);
    MemoryRig rig(part, 75'000, 4);
    while (!rig.model.init_done()) rig.step({});
    for (int i = 0; i < 400'000; ++i) rig.step({100, 3, 100, 100, 100});
    // The current line, the next one, one of the host that is due, and its own: each may be in another row of
    // the same bank, and turn the bus.
    const std::uint64_t line = std::uint64_t(32 + c.rp + c.rcd + c.wr + c.cl + 9),
                        refresh = std::uint64_t(c.rp + c.rfc + c.rcd + c.ras);
    REQUIRE(rig.scans > 1000);
    REQUIRE(rig.longest_scan <= 4 * line + refresh);
    REQUIRE(rig.longest_scan > 100);
}

TEST_CASE("figures of the board's memory", "[.figures]") {
    MemoryRig rig(sdram_part("as4c32m16sb"), 75'000, 4);
    while (!rig.model.init_done()) rig.step({});
    for (int i = 0; i < 400'000; ++i) rig.step({100, 3, 100, 100, 100});
    std::printf("full load with an urgent scan, 400000 cycles: %zu lines, longest scan %lu cycles\n",
                rig.order.size(), static_cast<unsigned long>(rig.longest_scan));
}

TEST_CASE("skipped quiet cycles of the board's memory change nothing", "[memory][skip]") {
    const SdramClocks clocks = sdram_clocks(sdram_part("is42s16160g"), 100'000);
    MemoryClients stepped(clocks, 4), skipped(clocks, 4);
    Draw draw(9);
    const auto both = [&](const ClientOffers& offers) {
        REQUIRE(stepped.ready() == skipped.ready());
        REQUIRE(stepped.answers() == skipped.answers());
        REQUIRE(stepped.pixels_next() == skipped.pixels_next());
        REQUIRE(stepped.scan_beat() == skipped.scan_beat());
        REQUIRE(stepped.sdram().pins().command == skipped.sdram().pins().command);
        stepped.clock(offers);
        skipped.clock(offers);
    };
    while (!stepped.init_done()) both({});
    std::uint64_t skips = 0;
    for (int i = 0; i < 3000; ++i) {
        ClientOffers offers;
        offers.chip = {draw.percent(40), std::uint32_t(draw.bits(4)), std::uint32_t(draw.bits(19))};
        offers.scan = {draw.percent(20), std::uint32_t(draw.bits(19)), draw.coin()};
        offers.pixels = {draw.percent(20), std::uint32_t(draw.bits(19))};
        offers.host = {draw.percent(40), draw.coin(), std::uint32_t(draw.bits(19))};
        both(offers);
        for (int k = draw.coin() ? draw.below(120) : 0; k > 0; --k) both({});
        const std::uint64_t some = std::min(skipped.quiet_cycles(), draw.bits(draw.coin() ? 2 : 10));
        skips += some;
        skipped.skip(some);
        for (std::uint64_t k = 0; k < some; ++k) {
            REQUIRE_FALSE(stepped.answers());
            stepped.clock({});
        }
    }
    REQUIRE(skips > 10'000);
}
