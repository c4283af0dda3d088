// Product of two limbs of at most 18 bits, each signed or unsigned, shifted to its place in a wider
// product. One multiplier block with its own registers, latency 2. Part of rc_mul.
//
// With RC_ECP5 defined it instantiates the ECP5's block, because Yosys 0.23 leaves the block's
// registers unused. Otherwise the same function is inferred.
`default_nettype none
module rc_mul_limb #(
  parameter int unsigned AW      = 18,
  parameter int unsigned BW      = 18,
  parameter bit          ASigned = 1'b1,
  parameter bit          BSigned = 1'b1,
  parameter int unsigned PW      = 36,   // width of the wider product
  parameter int unsigned Place   = 0     // bits below the limbs' product
) (
  input  logic                 clk_i,
  input  logic        [AW-1:0] a_i,
  input  logic        [BW-1:0] b_i,
  output logic signed [PW-1:0] p_o
);
  if (AW < 1 || AW > 18 || BW < 1 || BW > 18) begin : gen_refuse
    $error("rc_mul_limb: AW and BW must lie in 1..18");
  end

  // Operands, extended to 18 bits.
  logic [17:0] a, b;
  assign a = {{(18-AW){ASigned && a_i[AW-1]}}, a_i};
  assign b = {{(18-BW){BSigned && b_i[BW-1]}}, b_i};

  logic [35:0] p;
  logic        minus;   // sign of the product

`ifdef RC_ECP5
  localparam bit IsBlock = AW > 2 && BW > 2;   // smaller products take less area in LUTs
`else
  localparam bit IsBlock = 1'b0;
`endif

  if (IsBlock) begin : gen_block
`ifdef RC_ECP5
    MULT18X18D #(
      .REG_INPUTA_CLK("CLK0"), .REG_INPUTB_CLK("CLK0"), .REG_OUTPUT_CLK("CLK0")) u_block (
      .CLK0(clk_i), .CE0(1'b1), .RST0(1'b0),
      .SIGNEDA(ASigned), .SIGNEDB(BSigned), .SOURCEA(1'b0), .SOURCEB(1'b0),
      .A17(a[17]), .A16(a[16]), .A15(a[15]), .A14(a[14]), .A13(a[13]), .A12(a[12]),
      .A11(a[11]), .A10(a[10]), .A9(a[9]), .A8(a[8]), .A7(a[7]), .A6(a[6]),
      .A5(a[5]), .A4(a[4]), .A3(a[3]), .A2(a[2]), .A1(a[1]), .A0(a[0]),
      .B17(b[17]), .B16(b[16]), .B15(b[15]), .B14(b[14]), .B13(b[13]), .B12(b[12]),
      .B11(b[11]), .B10(b[10]), .B9(b[9]), .B8(b[8]), .B7(b[7]), .B6(b[6]),
      .B5(b[5]), .B4(b[4]), .B3(b[3]), .B2(b[2]), .B1(b[1]), .B0(b[0]),
      .P35(p[35]), .P34(p[34]), .P33(p[33]), .P32(p[32]), .P31(p[31]), .P30(p[30]),
      .P29(p[29]), .P28(p[28]), .P27(p[27]), .P26(p[26]), .P25(p[25]), .P24(p[24]),
      .P23(p[23]), .P22(p[22]), .P21(p[21]), .P20(p[20]), .P19(p[19]), .P18(p[18]),
      .P17(p[17]), .P16(p[16]), .P15(p[15]), .P14(p[14]), .P13(p[13]), .P12(p[12]),
      .P11(p[11]), .P10(p[10]), .P9(p[9]), .P8(p[8]), .P7(p[7]), .P6(p[6]),
      .P5(p[5]), .P4(p[4]), .P3(p[3]), .P2(p[2]), .P1(p[1]), .P0(p[0]));
`endif
  end else begin : gen_inferred
    logic [17:0]        a_q, b_q;
    logic signed [18:0] a_signed, b_signed;
    logic signed [35:0] p_q;

    assign a_signed = $signed({ASigned && a_q[17], a_q});
    assign b_signed = $signed({BSigned && b_q[17], b_q});

    always_ff @(posedge clk_i) begin
      a_q <= a;
      b_q <= b;
      p_q <= a_signed * b_signed;
    end
    assign p = p_q;
  end

  // Shift to the place in the wider product.
  assign minus = (ASigned || BSigned) && p[35];

  if (Place >= PW) begin : gen_beyond
    assign p_o = '0;

    logic unused;
    assign unused = ^{p, minus};
  end else begin : gen_placed
    logic [PW+Place+35:0] wide;
    assign wide = {{(PW+Place){minus}}, p} << Place;
    assign p_o  = wide[PW-1:0];

    logic unused;
    assign unused = ^{wide[PW+Place+35:PW]};
  end
endmodule
`default_nettype wire
