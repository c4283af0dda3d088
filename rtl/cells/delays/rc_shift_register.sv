// Delays data by Stages stages to match a pipeline. Stage i accepts its input when enable_i[i] is
// set, that is, when stage i of the pipeline accepts the same work.
//
// It has no reset, because invalid data is never used.
`default_nettype none
module rc_shift_register #(
  parameter int unsigned Width  = 1,
  parameter int unsigned Stages = 1
) (
  input  logic              clk_i,
  input  logic [Stages-1:0] enable_i,
  input  logic [Width-1:0]  data_i,
  output logic [Width-1:0]  data_o
);
  if (Width < 1 || Stages < 1) begin : gen_refuse
    $error("rc_shift_register: Width and Stages must be at least 1");
  end

  for (genvar i = 0; i < Stages; i++) begin : gen_stage
    logic [Width-1:0] data_q, data_d;
    if (i == 0) begin : gen_first
      assign data_d = data_i;
    end else begin : gen_next
      assign data_d = gen_stage[i-1].data_q;
    end

    always_ff @(posedge clk_i) if (enable_i[i]) data_q <= data_d;
  end

  assign data_o = gen_stage[Stages-1].data_q;
endmodule
`default_nettype wire
