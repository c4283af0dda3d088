// The share of a ray's weight that a reflected or refracted ray gets, up to 2.
//
// F is Fresnel's term after Schlick (1994). If the material has it, a refracted ray gets transmit
// (1 - F), and a reflected ray gets mirror + transmit F. Otherwise they get transmit and mirror. On
// total reflection the reflected ray gets mirror + transmit.
//
// Part of rc_bounce. The share is in the registers of s7. All values have 16 fraction bits.
`default_nettype none
module rc_schlick #(
  localparam int unsigned ValueBits = rc_pkg::ValueBits,
  localparam int unsigned UnitBits  = rc_pkg::UnitBits,
  localparam int unsigned Every     = rc_pkg::ShadeInterval,
  localparam int unsigned ShareW    = ValueBits + 1   // up to 2
) (
  input  logic          clk_i,
  input  logic [6:0]    valid_i,
  input  logic [6*Every-1:0] phase_i,   // the cycle of each stage
  input  logic                 s0_refract_i,
  input  logic [ValueBits-1:0] s0_cosine_i,
  input  logic [ValueBits-1:0] s0_mirror_i,
  input  logic [ValueBits-1:0] s0_transmit_i,
  input  logic [ValueBits-1:0] s0_r0_i,
  input  logic                 s0_schlick_i,
  input  logic                 s0_total_i,
  output logic [ShareW-1:0] s7_share_o
);
  localparam int unsigned ProductW = 2 * ValueBits;   // product of two values

  // s3: (1 - cosine)^5, rounded after each of three products.
  logic [ValueBits-1:0] s0_q, s1_q, s2_q, s1_q2, s2_q4, s3_q5;
  logic [ProductW-1:0] s1_square_q, s2_square_q, s3_fifth_q;

  assign s0_q = rc_pkg::ValueOne - s0_cosine_i;

  rc_shift_register #(.Width(ValueBits), .Stages(1)) u_q1 (
    .clk_i, .enable_i(valid_i[0]), .data_i(s0_q), .data_o(s1_q));
  rc_shift_register #(.Width(ValueBits), .Stages(1)) u_q2 (
    .clk_i, .enable_i(valid_i[1]), .data_i(s1_q), .data_o(s2_q));

  logic [ProductW-1:0] s1_up, s2_up, s3_up;

  assign s1_up = s1_square_q + rc_pkg::ProductHalf;
  assign s2_up = s2_square_q + rc_pkg::ProductHalf;
  assign s3_up = s3_fifth_q + rc_pkg::ProductHalf;
  assign s1_q2 = s1_up[UnitBits +: ValueBits];
  assign s2_q4 = s2_up[UnitBits +: ValueBits];
  assign s3_q5 = s3_up[UnitBits +: ValueBits];

  // s5: F = R0 + (1 - R0) (1 - cosine)^5. s6: transmit times F, or times 1 - F.
  logic [ValueBits-1:0] s3_r0, s4_r0, s5_transmit;
  logic [ProductW-1:0] s4_rest_q, s4_up, s6_part_q, s6_up;
  logic [ValueBits-1:0] s5_schlick_q;
  logic        s5_refract;

  assign s4_up = s4_rest_q + rc_pkg::ProductHalf;
  assign s6_up = s6_part_q + rc_pkg::ProductHalf;

  rc_shift_register #(.Width(ValueBits), .Stages(3)) u_r0 (
    .clk_i, .enable_i(valid_i[2:0]), .data_i(s0_r0_i), .data_o(s3_r0));
  rc_shift_register #(.Width(ValueBits + 1), .Stages(5)) u_transmit (
    .clk_i, .enable_i(valid_i[4:0]), .data_i({s0_transmit_i, s0_refract_i}),
    .data_o({s5_transmit, s5_refract}));

  // Factors of each stage's product, and the products.
  logic [6*ValueBits-1:0] first, second;
  logic [6*ProductW-1:0]  product;

  assign first  = {s5_transmit, {ValueBits{1'b0}}, rc_pkg::ValueOne - s3_r0, s2_q4, s1_q2, s0_q};
  assign second = {s5_refract ? rc_pkg::ValueOne - s5_schlick_q : s5_schlick_q, {ValueBits{1'b0}},
                   s3_q5, s2_q, s1_q2, s0_q};

  for (genvar i = 0; i < 6; i++) begin : gen_product
    if (i != 4) begin : gen_stage
      rc_mul_held #(.AW(ValueBits), .BW(ValueBits), .Signed(1'b0)) u_product (
        .clk_i, .phase_i(phase_i[i*Every +: Every]), .a_i(first[i*ValueBits +: ValueBits]),
        .b_i(second[i*ValueBits +: ValueBits]), .p_o(product[i*ProductW +: ProductW]));
    end else begin : gen_sum
      assign product[i*ProductW +: ProductW] = '0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (valid_i[0]) s1_square_q <= product[0 +: ProductW];
    if (valid_i[1]) s2_square_q <= product[ProductW +: ProductW];
    if (valid_i[2]) s3_fifth_q  <= product[2*ProductW +: ProductW];
    if (valid_i[3]) begin
      s4_rest_q <= product[3*ProductW +: ProductW];
      s4_r0     <= s3_r0;
    end
    if (valid_i[4]) s5_schlick_q <= s4_r0 + s4_up[UnitBits +: ValueBits];
    if (valid_i[5]) s6_part_q <= product[5*ProductW +: ProductW];
  end

  // s7: the share.
  logic [ValueBits-1:0] s6_mirror, s6_transmit;
  logic              s6_refract, s6_schlick, s6_total;
  logic [ShareW-1:0] s6_plain, s6_fresnel, s6_mirrored;

  rc_shift_register #(.Width(2 * ValueBits + 3), .Stages(6)) u_wait (
    .clk_i, .enable_i(valid_i[5:0]),
    .data_i({s0_mirror_i, s0_transmit_i, s0_refract_i, s0_schlick_i, s0_total_i}),
    .data_o({s6_mirror, s6_transmit, s6_refract, s6_schlick, s6_total}));

  assign s6_plain    = {1'b0, s6_transmit};
  assign s6_fresnel  = {1'b0, s6_up[UnitBits +: ValueBits]};
  assign s6_mirrored = {1'b0, s6_mirror};

  always_ff @(posedge clk_i) begin
    if (valid_i[6])
      s7_share_o <= s6_refract ? (s6_schlick ? s6_fresnel : s6_plain)
                  : s6_mirrored + (s6_total ? s6_plain : s6_schlick ? s6_fresnel : '0);
  end

  logic unused;
  assign unused = ^{s1_up[ProductW-1], s1_up[UnitBits-1:0], s2_up[ProductW-1], s2_up[UnitBits-1:0],
                    s3_up[ProductW-1], s3_up[UnitBits-1:0], s4_up[ProductW-1], s4_up[UnitBits-1:0],
                    s6_up[ProductW-1], s6_up[UnitBits-1:0], first, second, product, phase_i};
endmodule
`default_nettype wire
