// Products of several pairs that come together, like rc_mul_shared, but each b is split into two
// parts. So half as many multipliers suffice, and each computes a product in two cycles.
//
// Products * 2 parts share the multipliers. All products are ready rc_pkg::MulStages + Share - 1 +
// rc_pkg::PathCut cycles after the operands. Proof: tests/formal/mul_shared.sv.
`default_nettype none
module rc_mul_parts #(
  parameter  int unsigned AW       = 18,
  parameter  int unsigned BW       = 18,
  parameter  bit          Signed   = 1'b1,
  parameter  int unsigned Sums     = 1,      // levels of sums, as in rc_mul
  parameter  int unsigned Products = 1,
  parameter  int unsigned Share    = 2,
  localparam int unsigned PW       = AW + BW
) (
  input  logic                   clk_i,
  input  logic                   valid_i,   // operands come
  input  logic [Products*AW-1:0] a_i,       // product 0 lowest
  input  logic [Products*BW-1:0] b_i,
  output logic [Products*PW-1:0] p_o
);
  if (BW < 4) begin : gen_refuse
    $error("rc_mul_parts: BW must be at least 4");
  end

  // The lower part is unsigned, which takes one more bit in a multiplier of signed numbers.
  localparam int unsigned Low          = (BW - (Signed ? 1 : 0)) / 2;
  localparam int unsigned Half         = BW - Low;   // bits of a part
  localparam int unsigned HalfProductW = AW + Half;

  logic [2*Products*AW-1:0]           a;
  logic [2*Products*Half-1:0]         b;
  logic [2*Products*HalfProductW-1:0] halves, last;

  // product = upper half * 2^Low + lower half
  for (genvar i = 0; i < Products; i++) begin : gen_product
    logic [PW-1:0] upper, lower;
    assign a[2*i*AW +: 2*AW]     = {2{a_i[i*AW +: AW]}};
    assign b[2*i*Half +: 2*Half] = {b_i[i*BW+Low +: Half], Half'(b_i[i*BW +: Low])};
    assign lower = Signed ? PW'($signed(last[2*i*HalfProductW +: HalfProductW]))
                 : PW'(last[2*i*HalfProductW +: HalfProductW]);
    assign upper = {last[(2*i+1)*HalfProductW +: HalfProductW], {Low{1'b0}}};
    assign p_o[i*PW +: PW] = upper + lower;
  end

  // Halves.
  rc_mul_shared #(
    .AW(AW), .BW(Half), .Signed(Signed), .Sums(Sums), .Products(2 * Products), .Share(Share))
  u_halves (.clk_i, .valid_i, .a_i(a), .b_i(b), .p_o(halves));
  rc_path_register #(.Width(2 * Products * HalfProductW)) u_halves_made (
    .clk_i, .data_i(halves), .data_o(last));
endmodule
`default_nettype wire
