// Converts a component of a unit vector (S1.16) to a component of a direction of M bits. No
// magnitude exceeds 2^(M-2). Combinational. Model: direction_of() in model/fixed/rounding.hpp.
`default_nettype none
module rc_to_direction #(
  localparam int unsigned AxisBits = rc_pkg::AxisBits,
  localparam int unsigned M = rc_pkg::DirBits
) (
  input  logic signed [AxisBits-1:0] unit_i,
  output logic signed [M-1:0]        d_o
);
  if (M >= 18) begin : gen_longer
    assign d_o = M'(unit_i) <<< (M - 18);
  end else begin : gen_shorter
    logic signed [18:0] rounded;

    assign rounded = 19'(unit_i) + $signed(19'(1 << (17 - M)));
    assign d_o     = M'(rounded >>> (18 - M));
  end
endmodule
`default_nettype wire
