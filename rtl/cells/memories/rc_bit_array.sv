// An array of Marks one-bit registers without reset: one write port, and all bits readable in every
// cycle.
//
// A write takes effect in the next cycle. In a fast chip (Cut) it takes effect one cycle later:
// address and data come from registers that can be placed next to the bits.
`default_nettype none
module rc_bit_array #(
  parameter  int unsigned Marks  = 2,
  localparam int unsigned IndexW = Marks < 2 ? 1 : $clog2(Marks)
) (
  input  logic              clk_i,
  input  logic              rst_ni,
  input  logic              write_i,
  input  logic [IndexW-1:0] write_at_i,
  input  logic              mark_i,
  output logic [Marks-1:0]  marks_o
);
  if (Marks < 1) begin : gen_refuse
    $error("rc_bit_array: Marks must be at least 1");
  end

  logic              writes, mark;
  logic [IndexW-1:0] at;

  // Write port, registered in a fast chip.
  rc_path_register #(.Width(IndexW + 1)) u_what (
    .clk_i, .data_i({write_at_i, mark_i}), .data_o({at, mark}));
  rc_pulse_register u_writes (.clk_i, .rst_ni, .fires_i(write_i), .fires_o(writes));

  // Bits. An indexed write in a relaxed chip; one address comparator per bit in a fast chip.
  if (rc_pkg::PathCut == 0) begin : gen_indexed
    logic [Marks-1:0] marks_q;
    always_ff @(posedge clk_i) if (writes) marks_q[at] <= mark;
    assign marks_o = marks_q;
  end else begin : gen_compared
    for (genvar m = 0; m < Marks; m++) begin : gen_mark
      logic mark_q;
      always_ff @(posedge clk_i) if (writes && at == IndexW'(m)) mark_q <= mark;
      assign marks_o[m] = mark_q;
    end
  end
endmodule
`default_nettype wire
