// Quotient bits of a non-restoring division, one or two bits per step.
//
// The user gives the partial remainder rem < den that is left after the higher bits. low_i holds
// the dividend's Bits * Stages lower bits, top bit first; all except the top Lows of them are
// zeros. Returns floor((rem * 2^(Bits Stages) + low) / den), and inexact_o if a remainder is left.
//
// Operands may come every Every cycles, with valid_i. Each stage of the pipeline makes Every steps,
// one after the other. So the latency is Stages cycles, without stalls. If Every is 1, a stage
// works only if valid_i came with its operands.
//
// Yosys merges the step registers of two dividers that work on the same steps. If the dividers lie
// far apart, one of them stores its step bits inverted (Apart). Proof: tests/formal/divide.sv.
`default_nettype none
module rc_divide #(
  parameter  int unsigned Width  = 8,   // of den and rem
  parameter  int unsigned Stages = 4,   // steps
  parameter  int unsigned Bits   = 2,   // of the quotient, per step
  parameter  int unsigned Every  = 1,
  parameter  int unsigned Lows   = Bits * Stages,
  parameter  bit          Apart  = 0,
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
  if (Width * Stages * Bits * Every < 1 || Bits > 2 || Lows > QuoW) begin : gen_refuse
    $error("rc_divide: Width, Stages and Every must be at least 1, Bits 1 or 2, Lows few enough");
  end

  localparam int unsigned Last  =   // index of the last stage
    Stages < 1 || Every < 1 ? 0 : (Stages + Every - 1) / Every - 1;
  localparam int unsigned Chunk = Bits * Every;   // bits of the quotient that a stage makes

  // valid[i]: step i is next.
  logic [Stages-1:0] valid_q;
  logic [Stages:0]   valid;

  assign valid = {valid_q ^ {Stages{Apart}}, valid_i};
  always_ff @(posedge clk_i) valid_q <= valid[Stages-1:0] ^ {Stages{Apart}};

  // The remainder lies between -den and den. A step doubles it and adds the next dividend bit. It
  // subtracts den if the remainder is not negative, and otherwise adds den. The quotient bit is set
  // if the result is not negative.
  for (genvar i = 0; i <= Last; i++) begin : gen_stage
    localparam int unsigned Steps = Stages - i * Every < Every ? Stages - i * Every : Every;
    localparam int unsigned Own   = Bits * Steps;
    localparam int unsigned LowW  = Lows > Chunk * i ? Lows - Chunk * i : 0;   // bits still to come
    localparam bit          Again = Steps > 1;
    logic             here, comes;
    logic [Width:0]   rem_q, rem_new, rem_d, between, rem_next;
    logic [Width-1:0] den;
    logic [1:0]       low;   // next bits of the dividend
    logic [Bits-1:0]  made;
    logic [Own-1:0]   own_q;
    logic [Chunk*i+Own-1:0] quo;

    assign comes = valid[i*Every];
    assign here  = Again || comes;

    // The divisor arrives one cycle before the remainder, so no multiplexer is needed.
    if (i > 0) begin : gen_den
      logic [Width-1:0] den_q;
      always_ff @(posedge clk_i) if (valid[i*Every-1]) den_q <= gen_stage[i-1].den;
      assign den     = den_q;
      assign rem_new = gen_stage[i-1].rem_q;
    end else if (Again) begin : gen_first_den
      logic [Width-1:0] den_q;
      always_ff @(posedge clk_i) if (comes) den_q <= den_i;
      assign den     = comes ? den_i : den_q;
      assign rem_new = {1'b0, rem_i};
    end else begin : gen_only_den
      assign den     = den_i;
      assign rem_new = {1'b0, rem_i};
    end

    assign rem_d = !Again || comes ? rem_new : rem_q;

    // Next bits of the dividend.
    if (LowW > 0) begin : gen_low
      logic [LowW-1:0] low_new, low_d, low_q;
      logic [LowW+1:0] padded;
      if (i == 0) begin : gen_first
        assign low_new = low_i[QuoW-1 -: LowW];
      end else begin : gen_next
        assign low_new = gen_stage[i-1].gen_low.low_q[LowW+Chunk-1 -: LowW];
      end

      assign low_d  = !Again || comes ? low_new : low_q;
      assign padded = {low_d, 2'b00};
      assign low    = padded[LowW+1 -: 2];

      always_ff @(posedge clk_i) if (here) low_q <= low_d << Bits;

      logic unused;
      assign unused = ^padded;
    end else begin : gen_no_low
      assign low = '0;
    end

    // Steps.
    rc_addsub #(.Width(Width + 1)) u_first (
      .minus_i(!rem_d[Width]), .a_i({rem_d[Width-1:0], low[1]}),
      .b_i({1'b0, den}), .sum_o(between));

    if (Bits == 1) begin : gen_one
      assign rem_next = between;
      assign made     = !between[Width];

      logic unused;
      assign unused   = low[0];
    end else begin : gen_two
      rc_addsub #(.Width(Width + 1)) u_second (
        .minus_i(!between[Width]), .a_i({between[Width-1:0], low[0]}),
        .b_i({1'b0, den}), .sum_o(rem_next));
      assign made     = {!between[Width], !rem_next[Width]};
    end

    always_ff @(posedge clk_i) begin
      if (here) begin
        rem_q <= rem_next;
        own_q <= Own'({own_q, made});
      end
    end

    // The bits of this stage join those of the stages before.
    if (i > 0) begin : gen_held
      logic [Chunk*i-1:0] held_q;
      always_ff @(posedge clk_i) if (comes) held_q <= gen_stage[i-1].quo;
      assign quo = {held_q, own_q};
    end else begin : gen_none_held
      assign quo = own_q;
    end
  end

  // The remainder is 0 if the result is 0 or -den. A sum of two numbers is 0 if it has no bit set
  // when the bits below generate every carry that they can.
  logic [Width-1:0] end_den_q;
  logic [Width:0]   end_rem, end_den;

  always_ff @(posedge clk_i) if (valid[Stages-1]) end_den_q <= gen_stage[Last].den;
  assign end_rem   = gen_stage[Last].rem_q;
  assign end_den   = {1'b0, end_den_q};
  assign inexact_o = end_rem[Width] ? (end_rem ^ end_den) != (end_rem | end_den) << 1
                                    : end_rem != '0;
  assign quo_o     = gen_stage[Last].quo;

  logic unused;
  assign unused = ^{valid[Stages], low_i};
endmodule
`default_nettype wire
