// Property of rc_mul_shared, and of rc_mul_parts with Parts = 1: Share - 1 cycles after the
// operands it gives all their products, for all values. Operands before and after are arbitrary, at
// least Share cycles away.
module mul_shared #(
  parameter  int unsigned AW       = 3,
  parameter  int unsigned BW       = 4,
  parameter  bit          Signed   = 1'b1,
  parameter  int unsigned Products = 3,
  parameter  int unsigned Share    = 2,
  parameter  int unsigned Parts    = 0,
  localparam int unsigned PW       = AW + BW
) (
  input logic                   clk_i,
  input logic                   valid_i,
  input logic [Products*AW-1:0] a_i,
  input logic [Products*BW-1:0] b_i
);
  logic [Products*PW-1:0] p_o;
  if (Parts != 0) begin : gen_parts
    rc_mul_parts #(.AW(AW), .BW(BW), .Signed(Signed), .Products(Products), .Share(Share)) u_dut (
      .clk_i(clk_i), .valid_i(valid_i), .a_i(a_i), .b_i(b_i), .p_o(p_o));
  end else begin : gen_whole
    rc_mul_shared #(.AW(AW), .BW(BW), .Signed(Signed), .Products(Products), .Share(Share)) u_dut (
      .clk_i(clk_i), .valid_i(valid_i), .a_i(a_i), .b_i(b_i), .p_o(p_o));
  end

  logic [Share-1:0]       valid_q = '0;
  logic [Products*AW-1:0] a_q;
  logic [Products*BW-1:0] b_q;
  always @(posedge clk_i) begin
    valid_q <= {valid_q[Share-2:0], valid_i};
    if (valid_i) begin
      a_q <= a_i;
      b_q <= b_i;
    end
  end
  always @* assume (!valid_i || valid_q[Share-2:0] == '0);
  logic [Products-1:0] is_product;
  for (genvar i = 0; i < Products; i++) begin : gen_product
    logic [PW-1:0] a, b;
    assign a = {{BW{Signed && a_q[i*AW+AW-1]}}, a_q[i*AW +: AW]};
    assign b = {{AW{Signed && b_q[i*BW+BW-1]}}, b_q[i*BW +: BW]};
    assign is_product[i] = p_o[i*PW +: PW] == a * b;
  end
  always @* if (valid_q[Share-2]) begin
    a_products: assert (is_product == '1);
  end
endmodule
