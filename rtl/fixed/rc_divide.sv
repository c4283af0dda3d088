// Quotient bits of a division by restoring steps, two bits a stage.
//
// The user hands over the partial remainder rem < den that is left after the bits
// above, and the dividend's lower bits, top first, in low_i (2 * Stages bits, zeros
// where nothing follows). Answers floor((rem * 2^(2 Stages) + low) / den), and
// whether a remainder is left. Latency Stages, throughput 1 per cycle, no stall; a
// stage works only if `valid_i` came with its operands.
`default_nettype none
module rc_divide #(
  parameter  int unsigned Width  = 8,   // of den and rem
  parameter  int unsigned Stages = 4,
  localparam int unsigned QuoW   = 2 * Stages
) (
  input  logic             clk_i,
  input  logic             valid_i,
  input  logic [Width-1:0] rem_i,
  input  logic [QuoW-1:0]  low_i,
  input  logic [Width-1:0] den_i,
  output logic [QuoW-1:0]  quo_o,
  output logic             inexact_o
);
  // {first bit, second bit, remainder} of two restoring steps.
  function automatic logic [Width+1:0] two_bits(
    input logic [Width-1:0] rem, input logic [Width-1:0] den, input logic [1:0] low);
    logic [Width:0]   first, second, first_less, second_less;
    logic [Width-1:0] between, last;
    first       = {rem, low[1]};
    first_less  = first - {1'b0, den};
    between     = first_less[Width] ? first[Width-1:0] : first_less[Width-1:0];
    second      = {between, low[0]};
    second_less = second - {1'b0, den};
    last        = second_less[Width] ? second[Width-1:0] : second_less[Width-1:0];
    two_bits    = {!first_less[Width], !second_less[Width], last};
  endfunction

  // Dividend bits leave the shift register at the top as quotient bits enter below.
  logic [Stages-1:0] valid_q;
  (* mem2reg *) logic [Width-1:0]  rem_q [Stages];
  (* mem2reg *) logic [Width-1:0]  den_q [Stages];
  (* mem2reg *) logic [QuoW-1:0]   quo_q [Stages];

  logic [Stages-1:0] valid_d;
  if (Stages > 1) begin : gen_valid
    assign valid_d = {valid_q[Stages-2:0], valid_i};
  end else begin : gen_valid_one
    assign valid_d = valid_i;
  end

  always_ff @(posedge clk_i) begin
    valid_q <= valid_d;
    if (valid_i) begin
      den_q[0] <= den_i;
      {quo_q[0][1:0], rem_q[0]} <= two_bits(rem_i, den_i, low_i[QuoW-1:QuoW-2]);
      quo_q[0][QuoW-1:2] <= low_i[QuoW-3:0];
    end
    for (int i = 1; i < Stages; i++) begin
      if (valid_q[i-1]) begin
        den_q[i] <= den_q[i-1];
        {quo_q[i][1:0], rem_q[i]} <= two_bits(rem_q[i-1], den_q[i-1], quo_q[i-1][QuoW-1:QuoW-2]);
        quo_q[i][QuoW-1:2] <= quo_q[i-1][QuoW-3:0];
      end
    end
  end

  assign quo_o     = quo_q[Stages-1];
  assign inexact_o = rem_q[Stages-1] != '0;
endmodule
`default_nettype wire
