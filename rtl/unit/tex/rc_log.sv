// Logarithm to base 2 with LevelFrac fraction bits. The five bits below the highest set bit index a
// table of fractions. The logarithm of 0 counts as 0. Combinational. Model: log_of() in
// model/unit/tex/texel.hpp.
`default_nettype none
module rc_log #(
  parameter  int unsigned Width = 16,
  localparam int unsigned Frac  = rc_pkg::LevelFrac,
  localparam int unsigned LogW  = 5 + Frac,
  localparam int unsigned IndexBits = rc_pkg::LogIndexBits
) (
  input  logic [Width-1:0] x_i,
  output logic [LogW-1:0]  log_o
);
  if (Width > 32) begin : gen_refuse
    $error("rc_log: Width must be at most 32");
  end

  // The bits below the highest set bit, padded with zeros at the end.
  logic [Width+IndexBits-1:0] padded;
  logic [4:0]                 whole;
  logic [IndexBits-1:0]       index;

  assign padded = {x_i, {IndexBits{1'b0}}};

  always_comb begin
    whole = '0;
    index = '0;
    for (int i = 0; i < Width; i++)
      if (x_i[i]) begin
        whole = 5'(i);
        index = padded[i +: IndexBits];
      end
  end

  assign log_o = x_i == '0 ? '0 : {whole, rc_pkg::LogFraction[index*Frac +: Frac]};

  logic unused;
  assign unused = padded[Width+IndexBits-1];
endmodule
`default_nettype wire
