// The whole board in four states: Icarus repeats a frame that Verilator has simulated, with registers that
// are unknown at power-on and read data that are unknown whenever the SDRAM drives none. Every output must
// have the value that it has in Verilator's simulation.
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

#include <fmt/ostream.h>

#include "sim/board/host.hpp"
#include "sim/board/identity.hpp"
#include "sim/files/input.hpp"
#include "sim/files/process/process.hpp"
#include "sim/files/scratch.hpp"
#include "sim/run/gen/rc_pkg.hpp"
#include "sim/run/rtl/sources.hpp"
#include "tests/board/stepped_board.hpp"
#include "tests/support/machine/frames.hpp"

namespace rayclock::test::four_state_test {

using namespace rayclock;

namespace {

constexpr int khz = 25'000;   // the least: a frame of the screen takes the fewest cycles

/// A channel that writes a line for each cycle: the inputs rx, "SDRAM drives" and its data, and the outputs.
class RecordedBoard : public SteppedBoard {
public:
    RecordedBoard(const Config& config, const BoardShape& shape, const std::filesystem::path& file)
        : SteppedBoard(config, shape), out_(file) {}
    void flush() { out_.flush(); }
    std::uint64_t cycles() const { return cycles_; }

private:
    void step() override {
        const SdramChipPins pins = board.memory_pins();
        const std::optional<std::uint16_t> dq = board.sdram().dq();
        const unsigned leds = board.leds() & 0x9fu;   // without LED 6, which is rx, and LED 5, which is of
                                                      // the video, whose clocks stand still
        const bool tx = board.tx();
        board.step();
        ++cycles_;
        const unsigned command = unsigned(pins.cke) << 4 | unsigned(pins.cs_n) << 3 |
                                 unsigned(pins.ras_n) << 2 | unsigned(pins.cas_n) << 1 | unsigned(pins.we_n);
        fmt::print(out_, "{:x} {:x} {:x} {:x} {:x} {:x} {:x} {:x} {:x} {:x} {:x}\n", int(board.rx()),
                   int(dq.has_value()), dq.value_or(0), int(tx), leds, command, pins.ba, pins.a, pins.dqm,
                   int(pins.driven), pins.dq);
    }

    std::ofstream out_;
    std::uint64_t cycles_ = 0;
};

constexpr const char* bench = R"(`timescale 1ns/1ps
`default_nettype none
module bench;
  reg clk = 0, rst_n = 0, rx = 1;
  reg [15:0] dq;
  wire tx, cke, cs_n, ras_n, cas_n, we_n, oe;
  wire [1:0] ba, dqm;
  wire [12:0] a;
  wire [15:0] dq_out;
  wire [7:0] tmds, led;

  rc_board #(.ClkKhz(25000), .Baud(5000000), .InitUs(5), .ConfigHash(`HASH)) board (
    .clk_i(clk), .rst_ni(rst_n), .pixel_clk_i(1'b0), .pixel_rst_ni(1'b0), .shift_clk_i(1'b0),
    .shift_rst_ni(1'b0), .rx_i(rx), .tx_o(tx), .sd_cke_o(cke), .sd_cs_no(cs_n), .sd_ras_no(ras_n),
    .sd_cas_no(cas_n), .sd_we_no(we_n), .sd_ba_o(ba), .sd_a_o(a), .sd_dqm_o(dqm), .sd_dq_o(dq_out),
    .sd_dq_oe_o(oe), .sd_dq_i(dq), .tmds_o(tmds), .led_o(led));

  integer file, got, cycles, i;
  reg e_rx, e_there, e_tx, e_oe;
  reg [15:0] e_in, e_dq;
  reg [7:0] e_led;
  reg [4:0] e_command;
  reg [1:0] e_ba, e_dqm;
  reg [12:0] e_a;

  task edges;
    begin
      #4 clk = 1;
      #5 clk = 0;
    end
  endtask

  initial begin
    file = $fopen("cycles.txt", "r");
    cycles = 0;
    dq = 16'hxxxx;
    for (i = 0; i < 5000; i = i + 1) #1 edges;   // the caches clear their tags
    rst_n = 1;
    for (i = 0; i < 100; i = i + 1) #1 edges;
    got = 11;
    while (got == 11) begin
      got = $fscanf(file, "%h %h %h %h %h %h %h %h %h %h %h", e_rx, e_there, e_in, e_tx, e_led, e_command,
                    e_ba, e_a, e_dqm, e_oe, e_dq);
      if (got == 11) begin
        rx = e_rx;
        dq = e_there ? e_in : 16'hxxxx;
        #1;
        if ({tx, led & 8'h9f, cke, cs_n, ras_n, cas_n, we_n, ba, a, dqm, oe} !==
            {e_tx, e_led, e_command, e_ba, e_a, e_dqm, e_oe} || (e_oe && ((!dqm[0] && dq_out[7:0] !== e_dq[7:0]) || (!dqm[1] && dq_out[15:8] !== e_dq[15:8])))) begin
          $display("FAIL cycle %0d: tx %b led %b pins %b%b%b%b%b ba %b a %b dqm %b oe %b dq %h, not tx %b led %b pins %b ba %b a %b dqm %b oe %b dq %h",
                   cycles, tx, led, cke, cs_n, ras_n, cas_n, we_n, ba, a, dqm, oe, dq_out, e_tx, e_led, e_command,
                   e_ba, e_a, e_dqm, e_oe, e_dq);
          $finish;
        end
        edges;
        cycles = cycles + 1;
      end
    end
    $display("PASS %0d cycles", cycles);
    $finish;
  end
endmodule
`default_nettype wire
)";

std::string run_in(const std::filesystem::path& folder, const std::string& command) {
    Process process({{"sh", "-c", command}, folder, folder / "log", {}});
    process.wait("interrupted");
    return read_file((folder / "log").string());
}

}   // namespace

TEST_CASE("the whole board draws a frame from unknown registers, without an unknown output",
          "[four_state][slow]") {
    if (find_program("iverilog").empty()) {
        WARN("iverilog is not installed: the board is not tried with it");
        return;
    }
    const TemporaryFolder folder("rayclock-board");
    const Config config = load_config({"small", {"dram=board", "scan_out=1", "pixel_writes=1"}});
    const Job job = make_shot("tetra:1", {8, 6}, config).job;
    const BoardShape shape{
        .khz = khz, .baud = khz * 200, .initial_wait_us = 5, .is_lit = false, .gates_clock = false};
    RecordedBoard recorded(config, shape, folder.path() / "cycles.txt");
    BoardLink link(recorded, {.baud = shape.baud, .hello = 1});
    BoardHost host(link, config, sdram_part(shape.sdram));
    std::uint64_t done = 0;
    host.load(job.image, done);
    CHECK(host.run(job.frame, LinkTime(1'000'000)).pixels.size() == 48);
    recorded.flush();
    std::ofstream sources(folder.path() / "board.sv");
    sources << rc_package(config);
    for (const RtlText& text : rtl_texts(RtlScope::board))
        if (text.name.ends_with(".sv")) sources << text.text;
    sources << bench;
    sources.close();
    const std::string log = run_in(
        folder.path(),
        fmt::format(
            "sed -f {} board.sv > icarus.sv && iverilog -g2012 -DSYNTHESIS -DHASH=64\\'h{:016x} -s bench -o "
            "board.vvp icarus.sv && vvp board.vvp",
            std::filesystem::absolute("sim/silicon/export/icarus.sed").string(), config_hash(config)));
    INFO(log);
    REQUIRE(recorded.cycles() > 400'000);   // the board waits for a vertical blank
    CHECK(log.find(fmt::format("PASS {} cycles\n", recorded.cycles())) != std::string::npos);
}

}   // namespace rayclock::test::four_state_test
