// Delays an event by Stages cycles: rc_path_register with a reset that clears the stages. In a
// relaxed chip Stages is 0 and this is a wire.
`default_nettype none
module rc_pulse_register #(
  parameter int unsigned Stages = rc_pkg::PathCut
) (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic fires_i,
  output logic fires_o
);
  if (Stages == 0) begin : gen_now
    assign fires_o = fires_i;

    logic unused;
    assign unused = ^{clk_i, rst_ni};
  end else begin : gen_later
    logic [Stages-1:0] fires_q;

    always_ff @(posedge clk_i) begin
      if (!rst_ni) fires_q <= '0;
      else         fires_q <= Stages'({fires_q, fires_i});
    end

    assign fires_o = fires_q[Stages-1];
  end
endmodule
`default_nettype wire
