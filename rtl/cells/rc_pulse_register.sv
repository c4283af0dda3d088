// An event that is told a cycle later for each register on its way (rc_path_register), which reset clears; in
// a relaxed chip at once.
`default_nettype none
module rc_pulse_register #(
  parameter int unsigned Stages = rc_pkg::Cut
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
