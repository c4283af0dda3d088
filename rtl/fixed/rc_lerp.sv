// Linear interpolation between a and b with one product: one a + w (b - a) = (one - w) a + w b,
// where one = 2^Frac. Exact: the result has Frac more fraction bits than a and b, and lies between
// one a and one b, so its sign bit is 0. No latency.
`default_nettype none
module rc_lerp #(
  parameter int unsigned Width = 8,   // of a and b, unsigned
  parameter int unsigned Frac  = 8    // of the weight w, in [0, 1)
) (
  input  logic [Width-1:0]      a_i,
  input  logic [Width-1:0]      b_i,
  input  logic [Frac-1:0]       weight_i,
  output logic [Width+Frac-1:0] value_o
);
  logic signed [Width:0]      step;
  logic signed [Frac:0]       weight;
  logic signed [Width+Frac:0] product;

  assign step    = $signed({1'b0, b_i}) - $signed({1'b0, a_i});
  assign weight  = $signed({1'b0, weight_i});
  assign product = step * weight;
  assign value_o = {a_i, {Frac{1'b0}}} + product[Width+Frac-1:0];

  logic unused;
  assign unused = product[Width+Frac];
endmodule
`default_nettype wire
