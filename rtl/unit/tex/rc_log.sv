// Logarithm to base 2 with LevelFrac fraction bits, rounded down, by linear interpolation between
// powers of two (Mitchell 1962). The logarithm of 0 counts as 0. Combinational. Model: log_of() in
// model/unit/tex/texel.hpp.
`default_nettype none
module rc_log #(
  parameter  int unsigned Width = 16,
  localparam int unsigned Frac  = rc_pkg::LevelFrac,
  localparam int unsigned LogW  = 5 + Frac
) (
  input  logic [Width-1:0] x_i,
  output logic [LogW-1:0]  log_o
);
  if (Width > 32) begin : gen_refuse
    $error("rc_log: Width must be at most 32");
  end

  // The bits below the highest one that is set, with zeros behind the lowest.
  logic [Width+Frac-1:0] padded;

  assign padded = {x_i, {Frac{1'b0}}};

  always_comb begin
    log_o = '0;
    for (int i = 0; i < int'(Width); i++)
      if (x_i[i]) log_o = {5'(i), padded[i +: Frac]};
  end

  logic unused;
  assign unused = padded[Width+Frac-1];
endmodule
`default_nettype wire
