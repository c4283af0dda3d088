// Quotient bits of a division by restoring steps, one or two bits a stage.
//
// The user hands over the partial remainder rem < den that is left after the bits
// above, and the dividend's lower bits, top first, in low_i (Bits * Stages bits, zeros
// where nothing follows). Answers floor((rem * 2^(Bits Stages) + low) / den), and
// whether a remainder is left. Latency Stages, throughput 1 per cycle, no stall; a
// stage works only if `valid_i` came with its operands.
`default_nettype none
module rc_divide #(
  parameter  int unsigned Width  = 8,   // of den and rem
  parameter  int unsigned Stages = 4,
  parameter  int unsigned Bits   = 2,   // of the quotient, a stage
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
  if (Width < 1 || Stages < 1 || Bits < 1 || Bits > 2) begin : gen_refuse
    $error("rc_divide: Width and Stages must be at least 1, and Bits 1 or 2");
  end
  // Dividend bits leave the shift register at the top as quotient bits enter below.
  for (genvar i = 0; i < Stages; i++) begin : gen_stage
    logic             valid_q, valid_d;
    logic [Width-1:0] rem_q, den_q, rem_d, den_d;
    logic [QuoW-1:0]  quo_q, quo_d;
    if (i == 0) begin : gen_first
      assign valid_d = valid_i;
      assign rem_d   = rem_i;
      assign den_d   = den_i;
      assign quo_d   = low_i;
    end else begin : gen_next
      assign valid_d = gen_stage[i-1].valid_q;
      assign rem_d   = gen_stage[i-1].rem_q;
      assign den_d   = gen_stage[i-1].den_q;
      assign quo_d   = gen_stage[i-1].quo_q;
    end
    // A restoring step, or two.
    logic [Width:0]   first, first_less, second, second_less;
    logic [Width-1:0] between;
    always_comb begin
      first       = '0;
      first_less  = '0;
      between     = '0;
      second      = '0;
      second_less = '0;
      if (valid_d) begin
        first       = {rem_d, quo_d[QuoW-1]};
        first_less  = first - {1'b0, den_d};
        between     = first_less[Width] ? first[Width-1:0] : first_less[Width-1:0];
        second      = {between, quo_d[QuoW-Bits]};
        second_less = second - {1'b0, den_d};
      end
    end
    always_ff @(posedge clk_i) begin
      valid_q <= valid_d;
      if (valid_d) den_q <= den_d;
    end
    if (Bits == 1) begin : gen_one
      always_ff @(posedge clk_i) begin
        if (valid_d) begin
          rem_q <= between;
          quo_q <= QuoW'({quo_d, !first_less[Width]});
        end
      end
      logic unused;
      assign unused = ^second_less;
    end else begin : gen_two
      always_ff @(posedge clk_i) begin
        if (valid_d) begin
          rem_q <= second_less[Width] ? second[Width-1:0] : second_less[Width-1:0];
          quo_q <= QuoW'({quo_d, !first_less[Width], !second_less[Width]});
        end
      end
    end
  end

  assign quo_o     = gen_stage[Stages-1].quo_q;
  assign inexact_o = gen_stage[Stages-1].rem_q != '0;

  logic unused;
  assign unused = ^{gen_stage[Stages-1].valid_q, gen_stage[Stages-1].den_q};
endmodule
`default_nettype wire
