// c^(n/16): c in 0..2^16 with UnitBits (16) of fraction, n of 14 bits with 4 of fraction. If c is
// 0, the result is 0.
//
// Latency: rc_pkg::PowerStages stages of Every cycles; one power per Every cycles; no stall. The
// user holds operands for Every cycles. A stage works only if valid_i came with them in its first
// cycle. Model and error bounds: model/fixed/power.hpp.
`default_nettype none
module rc_power #(
  parameter int unsigned Every = rc_pkg::ShadeInterval
) (
  input  logic        clk_i,
  input  logic        valid_i,
  input  logic [16:0] c_i,      // U1.16
  input  logic [13:0] n_i,
  output logic [16:0] power_o
);
  localparam int unsigned Stages = rc_pkg::PowerStages;
  localparam int unsigned LogW   = 30;
  localparam int unsigned ExpW   = 28;

  // phase: the cycle of each stage. ends[i]: a power leaves stage i.
  logic [Stages*Every-1:0] phase;
  logic [Stages-1:0]       ends;

  rc_phase #(.Stages(Stages), .Every(Every)) u_turns (
    .clk_i, .valid_i, .phase_o(phase), .ends_o(ends));

  // s1: normalises c: m = c 2^below, 2^16 <= m < 2^17.
  logic [4:0]  s0_below, s0_by, s1_below_q, s2_below_q;
  logic [16:0] s0_m;
  logic [15:0] s1_m_q;

  always_comb begin
    s0_below = 5'd17;   // c = 0
    if (rc_pkg::PassCut != 0 || ends[0])
      for (int i = 0; i < 17; i++) if (c_i[i]) s0_below = 5'd16 - 5'(i);
  end

  rc_path_register #(.Width(5), .Stages(rc_pkg::PassCut)) u_below (
    .clk_i, .data_i(s0_below), .data_o(s0_by));

  always_comb begin
    s0_m = '0;
    if (ends[0]) s0_m = c_i << s0_by;
  end

  always_ff @(posedge clk_i) begin
    if (ends[0]) begin
      s1_below_q <= s0_by;
      s1_m_q     <= s0_m[15:0];
    end
  end

  logic [13:0] s3_n;
  rc_shift_register #(.Width(14), .Stages(3)) u_n (
    .clk_i, .enable_i(ends[2:0]), .data_i(n_i), .data_o(s3_n));

  // s2, s3: -log2(c), U5.18.
  logic [LogW-1:0] log_mem [128];
  initial for (int i = 0; i < 128; i++) log_mem[i] = rc_pkg::Log[i*LogW +: LogW];

  logic [LogW-1:0] s2_entry_q;
  logic [8:0]      s2_frac_q;
  logic [20:0]     s2_more;
  logic [22:0]     s3_neg_q;
  logic            s3_zero_q;

  rc_mul_held #(.AW(12), .BW(9), .Signed(1'b0), .Every(Every)) u_more (
    .clk_i, .phase_i(phase[2*Every +: Every]), .a_i(s2_entry_q[11:0]), .b_i(s2_frac_q),
    .p_o(s2_more));

  always_ff @(posedge clk_i) begin
    if (ends[1]) begin
      s2_entry_q <= log_mem[s1_m_q[15:9]];
      s2_frac_q  <= s1_m_q[8:0];
      s2_below_q <= s1_below_q;
    end
    if (ends[2]) begin
      s3_neg_q  <= {s2_below_q, 18'd0} - {5'd0, s2_entry_q[29:12]} - {11'd0, s2_more[20:9]};
      s3_zero_q <= s2_below_q == 5'd17;
    end
  end

  // s4: the -log2 of the power, U15.18.
  logic [36:0] s3_product;
  logic [32:0] s4_y_q;
  logic        s4_none_q;

  rc_mul_held #(.AW(23), .BW(14), .Signed(1'b0), .Every(Every)) u_product (
    .clk_i, .phase_i(phase[3*Every +: Every]), .a_i(s3_neg_q), .b_i(s3_n), .p_o(s3_product));

  always_ff @(posedge clk_i) begin
    if (ends[3]) begin
      s4_y_q    <= s3_product[36:4];
      s4_none_q <= s3_zero_q;
    end
  end

  // s5, s6: 2^-fraction, U1.17. With more than 17 whole bits the result is 0.
  logic [ExpW-1:0] exp_mem [128];
  initial for (int i = 0; i < 128; i++) exp_mem[i] = rc_pkg::Exp[i*ExpW +: ExpW];

  logic [ExpW-1:0] s5_entry_q;
  logic [10:0]     s5_frac_q;
  logic [20:0]     s5_less;
  logic [4:0]      s5_whole_q, s6_whole_q;
  logic            s5_none_q, s6_none_q;
  logic [17:0]     s6_g_q;

  rc_mul_held #(.AW(10), .BW(11), .Signed(1'b0), .Every(Every)) u_less (
    .clk_i, .phase_i(phase[5*Every +: Every]), .a_i(s5_entry_q[9:0]), .b_i(s5_frac_q),
    .p_o(s5_less));

  always_ff @(posedge clk_i) begin
    if (ends[4]) begin
      s5_entry_q <= exp_mem[s4_y_q[17:11]];
      s5_frac_q  <= s4_y_q[10:0];
      s5_whole_q <= s4_y_q[22:18];
      s5_none_q  <= s4_none_q || s4_y_q[32:18] > 15'd17;
    end
    if (ends[5]) begin
      s6_g_q     <= s5_entry_q[27:10] - {8'd0, s5_less[20:11]};
      s6_whole_q <= s5_whole_q;
      s6_none_q  <= s5_none_q;
    end
  end

  // s7: shifts the result to its place and rounds it.
  logic [18:0] s6_sum, s6_up, s6_moved;
  logic [16:0] s7_power_q;

  assign s6_sum = {1'b0, s6_g_q} + (19'd1 << s6_whole_q);
  rc_path_register #(.Width(19), .Stages(rc_pkg::PassCut)) u_up (
    .clk_i, .data_i(s6_sum), .data_o(s6_up));
  assign s6_moved = s6_up >> s6_whole_q;
  always_ff @(posedge clk_i) if (ends[6]) s7_power_q <= s6_none_q ? '0 : s6_moved[17:1];
  assign power_o = s7_power_q;

  logic unused;
  assign unused = ^{phase, s0_m[16], s2_more[8:0], s3_product[3:0], s5_less[10:0],
                    s6_moved[18], s6_moved[0]};
endmodule
`default_nettype wire
