// The chip's clock. With Gates = 1 it stands still while the chip is idle, when an edge would
// change none of the chip's registers. A simulator then spends no time on the chip while bytes
// cross the UART. With Gates = 0 the clock is clk_i itself: for synthesis on an FPGA.
//
// The clock runs while a frame runs, while the chip's bus is in use, and for RestCycles after
// either. After a change of the chip's reset it runs for ResetCycles, the longest time in which a
// cache clears its tags.
`default_nettype none
module rc_chip_clock #(
  parameter int unsigned Gates       = 0,
  parameter int unsigned ResetCycles = 65536,
  parameter int unsigned RestCycles  = 64      // after a frame or a bus access
) (
  input  logic clk_i,
  input  logic rst_ni,        // of the board
  input  logic chip_rst_ni,
  input  logic bus_i,         // a bus access is in progress
  input  logic running_i,     // a frame is in progress
  output logic chip_clk_o
);
  if (Gates == 0) begin : gen_passes
    assign chip_clk_o = clk_i;

    logic unused;
    assign unused = ^{rst_ni, chip_rst_ni, bus_i, running_i};
  end else begin : gen_gates
    localparam int unsigned LeftW = $clog2(ResetCycles + 1);

    if (RestCycles < 1 || ResetCycles <= RestCycles) begin : gen_refuse
      $error("rc_chip_clock: RestCycles must be at least 1, and ResetCycles greater");
    end

    logic             chip_rst_nq, changes, is_used, open, open_q;
    logic [LeftW-1:0] left_q;   // cycles until the clock stops, if the chip stays idle

    assign changes = chip_rst_ni != chip_rst_nq;
    assign is_used = bus_i || running_i;
    assign open    = changes || is_used || left_q != '0;

    always_ff @(posedge clk_i) begin
      chip_rst_nq <= chip_rst_ni;
      if (!rst_ni || changes)                           left_q <= LeftW'(ResetCycles);
      else if (is_used && left_q < LeftW'(RestCycles))  left_q <= LeftW'(RestCycles);
      else if (left_q != '0)                            left_q <= left_q - 1'b1;
    end

    // The usual clock gate: the decision passes a latch in the low half of the period.
    always_latch if (!clk_i) open_q = open;
    assign chip_clk_o = clk_i && open_q;
  end
endmodule
`default_nettype wire
