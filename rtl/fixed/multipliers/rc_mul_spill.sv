// Exact product of two signed numbers that are one or two bits wider than a multiplier block,
// without latency.
//
// One block multiplies the highest bits of both operands; sums in LUTs add the remaining bits. It
// is part of rc_mul, where Yosys 0.23 would use a second block for three bits. Proof:
// tests/formal/mul_spill.sv.
`default_nettype none
module rc_mul_spill #(
  parameter  int unsigned AW    = 20,
  parameter  int unsigned BW    = 20,
  parameter  int unsigned Block = 18,   // bits of the block's operands
  localparam int unsigned PW    = AW + BW
) (
  input  logic signed [AW-1:0] a_i,
  input  logic signed [BW-1:0] b_i,
  output logic signed [PW-1:0] p_o
);
  localparam int unsigned ALow = AW - Block;
  localparam int unsigned BLow = BW - Block;

  if (AW <= Block || BW <= Block) begin : gen_refuse
    $error("rc_mul_spill: AW and BW must be above Block");
  end

  logic signed [Block-1:0]   a_high, b_high;
  logic signed [2*Block-1:0] high;
  logic signed [PW-1:0]      low;   // a_low b + 2^ALow a_high b_low

  assign a_high = a_i[AW-1:ALow];
  assign b_high = b_i[BW-1:BLow];
  assign high   = (2*Block)'(a_high) * (2*Block)'(b_high);

  always_comb begin
    low = '0;
    for (int i = 0; i < ALow; i++) if (a_i[i]) low = low + (PW'(b_i) <<< i);
    for (int i = 0; i < BLow; i++) if (b_i[i]) low = low + (PW'(a_high) <<< (ALow + i));
  end

  // p = 2^(ALow + BLow) a_high b_high + low
  assign p_o = $signed({high, {(ALow + BLow){1'b0}}}) + low;
endmodule
`default_nettype wire
