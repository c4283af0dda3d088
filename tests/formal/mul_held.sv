// Property of rc_mul_held: if operands stay stable for Every cycles, all their products are right
// in the last one. With Late operands phase_i is late as well, so the last cycle is phase Every - 1
// - Late.
module mul_held #(
  parameter  int unsigned AW       = 3,
  parameter  int unsigned BW       = 3,
  parameter  bit          Signed   = 1'b1,
  parameter  int unsigned Products = 3,
  parameter  int unsigned Every    = 2,
  parameter  int unsigned Late     = 0,
  localparam int unsigned Told     = Every - 1 - Late,
  localparam int unsigned PW       = AW + BW
) (
  input logic                   clk_i,
  input logic [Every-1:0]       phase_i,
  input logic [Products*AW-1:0] a_i,
  input logic [Products*BW-1:0] b_i
);
  logic [Products*PW-1:0] p_o;
  rc_mul_held #(.AW(AW), .BW(BW), .Signed(Signed), .Products(Products), .Every(Every),
    .Late(Late)) u_dut (
    .clk_i(clk_i), .phase_i(phase_i), .a_i(a_i), .b_i(b_i), .p_o(p_o));

  // Operands that were held for all turns before the last one.
  logic [Every-1:0]       turn_q = '0;
  logic [Every-2:0]       held_q = '0;
  logic [Products*AW-1:0] a_q;
  logic [Products*BW-1:0] b_q;
  always @(posedge clk_i) begin
    turn_q <= phase_i;
    held_q <= phase_i[Every-2:0] & ({held_q, 1'b0} | 1'b1);
    a_q    <= a_i;
    b_q    <= b_i;
  end
  always @* begin
    assume (phase_i[Every-1:1] == turn_q[Every-2:0]);
    assume ((phase_i & (phase_i - 1'b1)) == '0);
    if (phase_i[Every-1:1] != '0) assume (a_i == a_q && b_i == b_q);
  end
  logic [Products-1:0] is_product;
  for (genvar i = 0; i < Products; i++) begin : gen_product
    logic [PW-1:0] a, b;
    assign a = {{BW{Signed && a_i[i*AW+AW-1]}}, a_i[i*AW +: AW]};
    assign b = {{AW{Signed && b_i[i*BW+BW-1]}}, b_i[i*BW +: BW]};
    assign is_product[i] = p_o[i*PW +: PW] == a * b;
  end
  always @* if (phase_i[Told] && held_q[Told-1]) begin
    a_products: assert (is_product == '1);
  end
endmodule
