// Square root by digit recurrence without restoring, one or two bits of it a step.
//
// Answers floor(sqrt(square)), and whether something is left over. Latency Stages, no stall.
//
// Squares may come every Every cycles, with valid_i. Each stage of the pipeline makes as many steps,
// one after the other. If Every is 1, a stage works only if valid_i came with its operand.
// Then a square may stay longer, Held cycles, in each but the first stage: a step is made in the
// last of them. Proven: tests/formal/sqrt.sv.
`default_nettype none
module rc_sqrt #(
  parameter  int unsigned Stages  = 4,   // steps
  parameter  int unsigned Bits    = 2,   // of the root, a step
  parameter  int unsigned Every   = 1,
  parameter  int unsigned Held    = 1,
  localparam int unsigned RootW   = Bits * Stages,
  localparam int unsigned SquareW = 2 * RootW
) (
  input  logic               clk_i,
  input  logic               valid_i,
  input  logic [SquareW-1:0] square_i,
  output logic [RootW-1:0]   root_o,
  output logic               inexact_o
);
  if (Stages < 1 || Bits < 1 || Bits > 2 || (Every != 1 && Held != 1)) begin : gen_refuse
    $error("rc_sqrt: Stages must be at least 1, Bits 1 or 2, and Every or Held 1");
  end
  localparam int unsigned Last = (Stages + Every - 1) / Every - 1;   // stage
  localparam int unsigned RemW = RootW + 2;

  // valid[i]: step i is next.
  logic [Stages:0] valid;
  assign valid[0] = valid_i;
  for (genvar i = 0; i < Stages; i++) begin : gen_valid
    rc_cut #(.Width(1), .Stages(Held)) u_step (
      .clk_i, .data_i(valid[i]), .data_o(valid[i+1]));
  end

  // The square leaves its register at the top, two bits for each bit of the root. What is
  // left of it, less the root's square, lies between -2 root - 1 and 2 root: if it is not
  // negative, 4 root + 1 is taken from four times of it and the next two bits, else 4 root + 3 is
  // added; a bit of the root is set if it is not negative then.
  for (genvar i = 0; i <= Last; i++) begin : gen_stage
    localparam bit Again = Every > 1 && Stages - i * Every > 1;   // makes more than one step
    logic               here, comes;
    logic [RemW-1:0]    rem_q, rem_new, rem_d, between, rem_next;
    logic [RootW-1:0]   root_q, root_new, root_d;
    logic [SquareW-1:0] square_q, square_new, square_d;
    assign comes = valid[i*Every];
    if (i == 0) begin : gen_first
      assign rem_new    = '0;
      assign root_new   = '0;
      assign square_new = square_i;
    end else begin : gen_next
      assign rem_new    = gen_stage[i-1].rem_q;
      assign root_new   = gen_stage[i-1].root_q;
      assign square_new = gen_stage[i-1].square_q;
    end
    if (Again) begin : gen_again
      assign here     = 1'b1;
      assign rem_d    = comes ? rem_new : rem_q;
      assign root_d   = comes ? root_new : root_q;
      assign square_d = comes ? square_new : square_q;
    end else begin : gen_once
      assign here     = comes;
      assign rem_d    = rem_new;
      assign root_d   = root_new;
      assign square_d = square_new;
    end
    rc_addsub #(.Width(RemW)) u_first (
      .there_i(here), .minus_i(!rem_d[RemW-1]),
      .a_i({rem_d[RootW-1:0], square_d[SquareW-1 -: 2]}),
      .b_i({root_d, rem_d[RemW-1], 1'b1}), .sum_o(between));
    if (Bits == 1) begin : gen_one
      assign rem_next = between;
      always_ff @(posedge clk_i) begin
        if (here) begin
          root_q   <= {root_d[RootW-2:0], !between[RemW-1]};
          square_q <= square_d << 2;
        end
      end
      logic unused;
      assign unused = ^{rem_d[RemW-2], root_d[RootW-1]};
    end else begin : gen_two
      rc_addsub #(.Width(RemW)) u_second (
        .there_i(here), .minus_i(!between[RemW-1]),
        .a_i({between[RootW-1:0], square_d[SquareW-3 -: 2]}),
        .b_i({root_d[RootW-2:0], !between[RemW-1], between[RemW-1], 1'b1}), .sum_o(rem_next));
      always_ff @(posedge clk_i) begin
        if (here) begin
          root_q   <= {root_d[RootW-3:0], !between[RemW-1], !rem_next[RemW-1]};
          square_q <= square_d << 4;
        end
      end
      logic unused;
      assign unused = ^{rem_d[RemW-2], between[RemW-2], root_d[RootW-1]};
    end
    always_ff @(posedge clk_i) if (here) rem_q <= rem_next;
  end

  // Nothing is left if that is 0, or -2 root - 1; as in rc_divide.
  logic [RemW-1:0] end_rem, end_step;
  assign end_rem   = gen_stage[Last].rem_q;
  assign end_step  = {1'b0, gen_stage[Last].root_q, 1'b1};
  assign inexact_o = end_rem[RemW-1] ? (end_rem ^ end_step) != (end_rem | end_step) << 1
                                     : end_rem != '0;
  assign root_o    = gen_stage[Last].root_q;

  logic unused;
  assign unused = ^{valid[Stages], gen_stage[Last].square_q};
endmodule
`default_nettype wire
