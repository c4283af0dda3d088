// Registers that cut a long path in a fast chip: a delay of Stages cycles. In a relaxed chip Stages
// is 0 and this is a wire.
//
// The user accounts for the Stages cycles. Only model/core/stages.hpp defines how many a chip has.
`default_nettype none
module rc_path_register #(
  parameter int unsigned Width  = 1,
  parameter int unsigned Stages = rc_pkg::PathCut
) (
  input  logic             clk_i,
  input  logic [Width-1:0] data_i,
  output logic [Width-1:0] data_o
);
  if (Width < 1) begin : gen_refuse
    $error("rc_path_register: Width must be at least 1");
  end

  if (Stages == 0) begin : gen_wire
    assign data_o = data_i;

    logic unused;
    assign unused = clk_i;
  end else begin : gen_registers
    for (genvar i = 0; i < Stages; i++) begin : gen_stage
      logic [Width-1:0] data_q;
      if (i == 0) begin : gen_first
        always_ff @(posedge clk_i) data_q <= data_i;
      end else begin : gen_next
        always_ff @(posedge clk_i) data_q <= gen_stage[i-1].data_q;
      end
    end
    assign data_o = gen_stage[Stages-1].data_q;
  end
endmodule
`default_nettype wire
