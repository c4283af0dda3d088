// Selects the flag of the head of a queue, out of Flags flags.
//
// A relaxed chip selects in the same cycle. A fast chip selects when the entry comes to the head
// (rc_fifo_peek), and flag_o is a register from then on. No cycle changes. The user must keep a
// flag stable from the cycle in which its number comes to the head until that entry leaves.
`default_nettype none
module rc_bit_prefetch #(
  parameter  int unsigned Flags  = 2,
  localparam int unsigned IndexW = Flags < 2 ? 1 : $clog2(Flags)
) (
  input  logic              clk_i,
  input  logic              rst_ni,
  // Flags, and the head of the queue
  input  logic [Flags-1:0]  flags_i,
  input  logic              head_valid_i,
  input  logic [IndexW-1:0] head_i,
  // From rc_fifo_peek: in a fast chip, an entry comes to the head, and its number
  input  logic              next_fires_i,
  input  logic [IndexW-1:0] next_i,
  // To the user
  output logic              flag_o
);
  if (Flags < 1) begin : gen_refuse
    $error("rc_bit_prefetch: Flags must be at least 1");
  end

  if (rc_pkg::PathCut == 0) begin : gen_now
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
