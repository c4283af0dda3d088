// Quotient bits of a division without restoring, one or two bits a step.
//
// The user hands over the partial remainder rem < den that is left after the bits
// above, and the dividend's lower bits, top first, in low_i (Bits * Stages bits, zeros
// where nothing follows). Answers floor((rem * 2^(Bits Stages) + low) / den), and
// whether a remainder is left. Latency Stages, no stall.
//
// Operands may come every Every cycles, with valid_i. Each stage of the pipeline makes as many steps,
// one after the other. If Every is 1, a stage works only if valid_i came with its operands.
// Proven: tests/formal/divide.sv.
`default_nettype none
module rc_divide #(
  parameter  int unsigned Width  = 8,   // of den and rem
  parameter  int unsigned Stages = 4,   // steps
  parameter  int unsigned Bits   = 2,   // of the quotient, a step
  parameter  int unsigned Every  = 1,
  localparam int unsigned QuoW   = Bits * Stages
) (
  input  logic             clk_i,
  input  logic             valid_i,
  input  logic [Width-1:0] rem_i,
  input  logic [QuoW-1:0]  low_i,
  input  logic [Width-1:0] den_i,
  output logic [QuoW-1:0]  quo_o,
  output logic             inexact_o
);
  if (Width < 1 || Stages < 1 || Bits < 1 || Bits > 2 || Every < 1) begin : gen_refuse
    $error("rc_divide: Width, Stages and Every must be at least 1, and Bits 1 or 2");
  end
  localparam int unsigned Last = (Stages + Every - 1) / Every - 1;   // stage

  // valid[i]: step i is next.
  logic [Stages-1:0] valid_q;
  logic [Stages:0]   valid;
  assign valid = {valid_q, valid_i};
  always_ff @(posedge clk_i) valid_q <= valid[Stages-1:0];

  // What is left lies between -den and den: den is taken from twice of it if it is not negative, and
  // added if it is; a bit of the quotient is set if it is not negative then. Dividend bits leave
  // the shift register at the top as quotient bits enter below.
  for (genvar i = 0; i <= Last; i++) begin : gen_stage
    localparam bit Again = Every > 1 && Stages - i * Every > 1;   // makes more than one step
    logic             here, comes;
    logic [Width:0]   rem_q, rem_new, rem_d, between, rem_next;
    logic [Width-1:0] den_q, den_new, den_d;
    logic [QuoW-1:0]  quo_q, quo_new, quo_d;
    assign comes = valid[i*Every];
    if (i == 0) begin : gen_first
      assign rem_new = {1'b0, rem_i};
      assign den_new = den_i;
      assign quo_new = low_i;
    end else begin : gen_next
      assign rem_new = gen_stage[i-1].rem_q;
      assign den_new = gen_stage[i-1].den_q;
      assign quo_new = gen_stage[i-1].quo_q;
    end
    if (Again) begin : gen_again
      assign here  = 1'b1;
      assign rem_d = comes ? rem_new : rem_q;
      assign den_d = comes ? den_new : den_q;
      assign quo_d = comes ? quo_new : quo_q;
    end else begin : gen_once
      assign here  = comes;
      assign rem_d = rem_new;
      assign den_d = den_new;
      assign quo_d = quo_new;
    end
    rc_addsub #(.Width(Width + 1)) u_first (
      .there_i(here), .minus_i(!rem_d[Width]), .a_i({rem_d[Width-1:0], quo_d[QuoW-1]}),
      .b_i({1'b0, den_d}), .sum_o(between));
    if (Bits == 1) begin : gen_one
      assign rem_next = between;
      always_ff @(posedge clk_i) if (here) quo_q <= QuoW'({quo_d, !between[Width]});
    end else begin : gen_two
      rc_addsub #(.Width(Width + 1)) u_second (
        .there_i(here), .minus_i(!between[Width]), .a_i({between[Width-1:0], quo_d[QuoW-2]}),
        .b_i({1'b0, den_d}), .sum_o(rem_next));
      always_ff @(posedge clk_i)
        if (here) quo_q <= QuoW'({quo_d, !between[Width], !rem_next[Width]});
    end
    always_ff @(posedge clk_i) begin
      if (here) begin
        rem_q <= rem_next;
        den_q <= den_d;
      end
    end
  end

  // Nothing is left if that is 0, or -den: two numbers' sum is 0 if no bit of it is set when
  // every carry is made that the bits below can make.
  logic [Width:0] end_rem, end_den;
  assign end_rem   = gen_stage[Last].rem_q;
  assign end_den   = {1'b0, gen_stage[Last].den_q};
  assign inexact_o = end_rem[Width] ? (end_rem ^ end_den) != (end_rem | end_den) << 1
                                    : end_rem != '0;
  assign quo_o     = gen_stage[Last].quo_q;

  logic unused;
  assign unused = valid[Stages];
endmodule
`default_nettype wire
