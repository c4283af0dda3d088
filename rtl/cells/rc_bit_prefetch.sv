// One of many flags: that of the head of a queue. In a fast chip it is picked when the head comes
// (rc_fifo_peek), and is a register from then on. So a flag must not change from that cycle on, as
// long as its number is at the head.
`default_nettype none
module rc_bit_prefetch #(
  parameter  int unsigned Flags  = 2,
  localparam int unsigned IndexW = Flags < 2 ? 1 : $clog2(Flags)
) (
  input  logic              clk_i,
  input  logic              rst_ni,
  input  logic [Flags-1:0]  flags_i,
  input  logic              head_valid_i,
  input  logic [IndexW-1:0] head_i,
  input  logic              next_fires_i,   // in a fast chip: the head comes, and its number
  input  logic [IndexW-1:0] next_i,
  output logic              flag_o
);
  if (Flags < 1) begin : gen_refuse
    $error("rc_bit_prefetch: Flags must be at least 1");
  end
  if (rc_pkg::Cut == 0) begin : gen_now
    assign flag_o = flags_i[head_i];
    logic unused;
    assign unused = ^{clk_i, rst_ni, head_valid_i, next_fires_i, next_i};
  end else begin : gen_ahead
    logic flag_q;
    always_ff @(posedge clk_i) if (next_fires_i) flag_q <= flags_i[next_i];
    assign flag_o = flag_q;
`ifndef SYNTHESIS
    always_ff @(posedge clk_i) if (rst_ni && head_valid_i)
      a_same: assert (flag_q == flags_i[head_i])
      else $error("rc_bit_prefetch: a flag has changed while its number is at the head");
`endif
    logic unused;
    assign unused = ^{rst_ni, head_valid_i, head_i};
  end
endmodule
`default_nettype wire
