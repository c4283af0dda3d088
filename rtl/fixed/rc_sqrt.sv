// Square root by digit recurrence, two bits of it a stage.
//
// Answers floor(sqrt(square)), and whether something is left over. A square every Every cycles,
// which stays as long in each but the first of Stages stages; no stall. A stage works only if
// `valid_i` came with its operand. Proven: tests/formal/sqrt.sv.
`default_nettype none
module rc_sqrt #(
  parameter  int unsigned Stages  = 4,
  parameter  int unsigned Every   = 1,
  localparam int unsigned RootW   = 2 * Stages,
  localparam int unsigned SquareW = 2 * RootW
) (
  input  logic               clk_i,
  input  logic               valid_i,
  input  logic [SquareW-1:0] square_i,
  output logic [RootW-1:0]   root_o,
  output logic               inexact_o
);
  if (Stages < 1) begin : gen_refuse
    $error("rc_sqrt: Stages must be at least 1");
  end
  // The square leaves its register at the top, two bits for each bit of the root. What is
  // left of it so far, less the root's square, never exceeds twice the root.
  for (genvar i = 0; i < Stages; i++) begin : gen_stage
    logic               valid_q, valid_d;
    logic [RootW:0]     rem_q, rem_d;
    logic [RootW-1:0]   root_q, root_d;
    logic [SquareW-1:0] square_q, square_d;
    if (i == 0) begin : gen_first
      assign valid_d  = valid_i;
      assign rem_d    = '0;
      assign root_d   = '0;
      assign square_d = square_i;
    end else begin : gen_next
      rc_cut #(.Width(1), .Stages(Every - 1)) u_last (
        .clk_i, .data_i(gen_stage[i-1].valid_q), .data_o(valid_d));
      assign rem_d    = gen_stage[i-1].rem_q;
      assign root_d   = gen_stage[i-1].root_q;
      assign square_d = gen_stage[i-1].square_q;
    end
    // Two steps: a bit is set if (2 root + 1)^2 still fits.
    logic [RootW+2:0] first, second, first_less, second_less;
    logic [RootW:0]   between;
    always_comb begin
      first       = '0;
      second      = '0;
      first_less  = '0;
      second_less = '0;
      between     = '0;
      if (valid_d) begin
        first       = {rem_d, square_d[SquareW-1 -: 2]};
        first_less  = first - {1'b0, root_d, 2'b01};
        between     = first_less[RootW+2] ? first[RootW:0] : first_less[RootW:0];
        second      = {between, square_d[SquareW-3 -: 2]};
        second_less = second - {1'b0, root_d[RootW-2:0], !first_less[RootW+2], 2'b01};
      end
    end
    always_ff @(posedge clk_i) begin
      valid_q <= valid_d;
      if (valid_d) begin
        rem_q    <= second_less[RootW+2] ? second[RootW:0] : second_less[RootW:0];
        root_q   <= {root_d[RootW-3:0], !first_less[RootW+2], !second_less[RootW+2]};
        square_q <= square_d << 4;
      end
    end
    logic unused;
    assign unused = ^{first[RootW+2:RootW+1], first_less[RootW+1], second[RootW+2:RootW+1],
                      second_less[RootW+1], root_d[RootW-1]};
  end

  assign root_o    = gen_stage[Stages-1].root_q;
  assign inexact_o = gen_stage[Stages-1].rem_q != '0;

  logic unused;
  assign unused = ^{gen_stage[Stages-1].valid_q, gen_stage[Stages-1].square_q};
endmodule
`default_nettype wire
