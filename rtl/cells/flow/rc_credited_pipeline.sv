// The front of a pipeline that never stalls: a credit counter that admits a request only if the
// result queue has room for its answer, and the valid bits of the stages.
//
// admit_o: a request enters. valid_q_o[i]: it entered i + 1 cycles ago. req_ready_o does not depend
// on req_valid_i. The consumer of the result queue reports each answer that leaves (leave_i).
`default_nettype none
module rc_credited_pipeline #(
  parameter int unsigned Credits = 4,   // answers that the result queue holds
  parameter int unsigned Stages  = 1
) (
  input  logic              clk_i,
  input  logic              rst_ni,
  // Admission
  input  logic              req_valid_i,
  output logic              req_ready_o,
  input  logic              occupied_i,   // the unit accepts no request in this cycle
  // From the result queue
  input  logic              leave_i,
  // To the stages
  output logic              admit_o,
  output logic [Stages-1:0] valid_q_o
);

  logic is_open;

  assign req_ready_o = is_open && !occupied_i;
  assign admit_o     = req_valid_i && req_ready_o;

  rc_credit_counter #(.Credits(Credits)) u_credits (
    .clk_i, .rst_ni, .admit_i(admit_o), .leave_i, .open_o(is_open));

  if (Stages < 1) begin : gen_refuse
    $error("rc_credited_pipeline: Stages must be at least 1");
  end

  localparam int unsigned Held = Stages < 1 ? 1 : Stages;   // tools continue after $error

  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q_o <= '0;
    else         valid_q_o <= Held'({valid_q_o, admit_o});
  end
endmodule
`default_nettype wire
