// Tracks the work in a pipeline in which each piece stays Every cycles in each of Stages stages.
//
// Bit s * Every + c of phase_o is set while a piece is in cycle c of stage s. A reset is
// unnecessary: a stage that works on invalid data does no harm.
`default_nettype none
module rc_phase #(
  parameter int unsigned Stages = 2,
  parameter int unsigned Every  = 1
) (
  input  logic                    clk_i,
  input  logic                    valid_i,   // the first cycle of the first stage
  output logic [Stages*Every-1:0] phase_o,
  output logic [Stages-1:0]       ends_o     // the last cycle of each stage
);
  if (Stages < 2 || Every < 1) begin : gen_refuse
    $error("rc_phase: Stages must be at least 2, and Every at least 1");
  end

  logic [Stages*Every-1:1] phase_q;
  assign phase_o = {phase_q, valid_i};
  always_ff @(posedge clk_i) phase_q <= phase_o[Stages*Every-2:0];

  for (genvar i = 0; i < Stages; i++) begin : gen_ends
    assign ends_o[i] = phase_o[i*Every+Every-1];
  end
endmodule
`default_nettype wire
