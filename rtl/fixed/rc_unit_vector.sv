// The direction of a vector: v / |v| with UnitBits (16) of fraction, each component in -2^16..2^16.
// The zero vector gives zero.
//
// Latency: rc_pkg::UnitStages stages of Every cycles; one vector per Every cycles; no stall. The
// user holds the vector for Every cycles. A stage works only if valid_i came with it in its first
// cycle. Model and error bounds: model/fixed/unit_vector.hpp.
`default_nettype none
module rc_unit_vector #(
  parameter int unsigned VectorW = 44,   // bits of a component, signed
  parameter int unsigned Every   = rc_pkg::ShadeInterval
) (
  input  logic                 clk_i,
  input  logic                 valid_i,
  input  logic [3*VectorW-1:0] v_i,     // [axis]
  output logic [53:0]          u_o      // [axis] S1.16
);
  localparam int unsigned Stages  = rc_pkg::UnitStages;
  localparam int unsigned LengthW = $clog2(VectorW + 1);   // bits of a component's length
  localparam int unsigned EntryW  = 29;

  // phase: the cycle of each stage. ends[i]: a vector leaves stage i.
  logic [Stages*Every-1:0] phase;
  logic [Stages-1:0]       ends;

  rc_phase #(.Stages(Stages), .Every(Every)) u_turns (
    .clk_i, .valid_i, .phase_o(phase), .ends_o(ends));

  // s1: magnitudes and signs.
  logic [3*VectorW-1:0] s0_size, s1_size_q;
  logic [2:0]           s0_neg, end_neg;

  for (genvar k = 0; k < 3; k++) begin : gen_size
    logic [VectorW-1:0] v;
    assign v = v_i[k*VectorW +: VectorW];
    assign s0_neg[k] = v[VectorW-1];
    assign s0_size[k*VectorW +: VectorW] = v[VectorW-1] ? -v : v;
  end

  always_ff @(posedge clk_i) if (ends[0]) s1_size_q <= s0_size;
  rc_shift_register #(.Width(3), .Stages(Stages)) u_neg (
    .clk_i, .enable_i(ends), .data_i(s0_neg), .data_o(end_neg));

  // s2: bit length of the longest component.
  logic [VectorW-1:0]   s1_any, s1_any_late;
  logic [LengthW-1:0]   s1_len, s2_len_q;
  logic [3*VectorW-1:0] s2_size_q;

  assign s1_any = s1_size_q[0 +: VectorW] | s1_size_q[VectorW +: VectorW]
                | s1_size_q[2*VectorW +: VectorW];
  rc_path_register #(.Width(VectorW), .Stages(rc_pkg::PassCut)) u_any (
    .clk_i, .data_i(s1_any), .data_o(s1_any_late));

  always_comb begin
    s1_len = '0;
    if (ends[1])
      for (int i = 0; i < VectorW; i++) if (s1_any_late[i]) s1_len = LengthW'(i) + 1'b1;
  end

  always_ff @(posedge clk_i) begin
    if (ends[1]) begin
      s2_len_q  <= s1_len;
      s2_size_q <= s1_size_q;
    end
  end

  // s3: truncates so that the longest component has 17 bits.
  logic [50:0] s2_a, s3_a_q, s4_a_q;
  for (genvar k = 0; k < 3; k++) begin : gen_cut
    logic [VectorW+16:0] moved;
    always_comb begin
      moved = '0;
      if (ends[2]) moved = {s2_size_q[k*VectorW +: VectorW], 17'd0} >> s2_len_q;
    end
    assign s2_a[k*17 +: 17] = moved[16:0];

    logic unused;
    assign unused = ^moved[VectorW+16:17];
  end

  always_ff @(posedge clk_i) if (ends[2]) s3_a_q <= s2_a;

  // s4: squares.
  logic [3*34-1:0] s3_square, s4_square_q;

  rc_mul_held #(.AW(17), .BW(17), .Signed(1'b0), .Products(3), .Every(Every)) u_squares (
    .clk_i, .phase_i(phase[3*Every +: Every]), .a_i(s3_a_q), .b_i(s3_a_q), .p_o(s3_square));

  always_ff @(posedge clk_i) begin
    if (ends[3]) begin
      s4_square_q <= s3_square;
      s4_a_q      <= s3_a_q;
    end
  end

  // s5: their sum, between 2^32 and 3 * 2^34, in units of 2^17. Below 2^34 it is multiplied by 4.
  logic [35:0] s4_sum;
  logic        s4_low, s5_low_q;
  logic [18:0] s5_sum_q;

  assign s4_sum = {2'd0, s4_square_q[0 +: 34]} + {2'd0, s4_square_q[34 +: 34]}
      + {2'd0, s4_square_q[68 +: 34]};
  assign s4_low = s4_sum[35:34] == '0;

  always_ff @(posedge clk_i) begin
    if (ends[4]) begin
      s5_sum_q <= s4_low ? s4_sum[33:15] : s4_sum[35:17];
      s5_low_q <= s4_low;
    end
  end

  // s6, s7: r = 2^18 / sqrt(sum). A zero vector has an index beyond the table; then r is not used.
  logic [EntryW-1:0] root_mem [512];
  initial for (int i = 0; i < 512; i++)
    root_mem[i] = i < 384 ? rc_pkg::InverseRoot[(i % 384)*EntryW +: EntryW] : '0;

  logic [EntryW-1:0] s6_entry_q;
  logic [9:0]        s6_frac_q;
  logic [19:0]       s6_less;
  logic [18:0]       s7_r_q;
  logic [8:0]        s5_index;

  assign s5_index = s5_sum_q[18:10] - 9'd128;

  rc_mul_held #(.AW(10), .BW(10), .Signed(1'b0), .Every(Every)) u_less (
    .clk_i, .phase_i(phase[6*Every +: Every]), .a_i(s6_entry_q[9:0]), .b_i(s6_frac_q),
    .p_o(s6_less));

  always_ff @(posedge clk_i) begin
    if (ends[5]) begin
      s6_entry_q <= root_mem[s5_index];
      s6_frac_q  <= s5_sum_q[9:0];
    end
    if (ends[6]) s7_r_q <= s6_entry_q[28:10] - {9'd0, s6_less[19:10]};
  end

  // s8: a r, rounded. The components wait from s4 to s7.
  logic [50:0] s7_a;
  logic        s7_low;

  rc_shift_register #(.Width(51), .Stages(3)) u_a (
    .clk_i, .enable_i(ends[6:4]), .data_i(s4_a_q), .data_o(s7_a));
  rc_shift_register #(.Width(1), .Stages(2)) u_low (
    .clk_i, .enable_i(ends[6:5]), .data_i(s5_low_q), .data_o(s7_low));

  localparam logic [37:0] SizeHalf = 38'd1 << 18;   // half the last bit that s8_size_q keeps

  logic [3*36-1:0] s7_product;
  rc_mul_held #(.AW(17), .BW(19), .Signed(1'b0), .Products(3), .Every(Every)) u_products (
    .clk_i, .phase_i(phase[7*Every +: Every]), .a_i(s7_a), .b_i({3{s7_r_q}}), .p_o(s7_product));

  for (genvar k = 0; k < 3; k++) begin : gen_out
    logic [35:0] product;
    logic [36:0] doubled;
    logic [37:0] whole;
    logic [16:0] s8_size_q, size;
    logic [17:0] answer;

    assign product = s7_product[k*36 +: 36];
    assign doubled = s7_low ? {product, 1'b0} : {1'b0, product};
    assign whole   = {1'b0, doubled} + SizeHalf;
    assign size    = whole[37:35] != '0 ? rc_pkg::ValueOne : {1'b0, whole[34:19]};
    always_ff @(posedge clk_i) if (ends[7]) s8_size_q <= size;
    assign answer = end_neg[k] ? -{1'b0, s8_size_q} : {1'b0, s8_size_q};
    assign u_o[k*18 +: 18] = answer;

    logic unused;
    assign unused = ^whole[18:0];
  end

  logic unused;
  assign unused = ^{phase, s6_less[9:0], s4_sum[14:0]};
endmodule
`default_nettype wire
