// The end of a sample: the sums of the pixel, whether another sample follows, and otherwise the
// pixel's colour. Part of rc_pass, which has the valid bits. Results are in the registers of s4.
// Model: finish() in model/unit/shade/pass/pass.cpp.
`default_nettype none
module rc_finish #(
  localparam int unsigned ValueBits = rc_pkg::ValueBits,
  localparam int unsigned SumBits   = rc_pkg::SumBits,
  localparam int unsigned Every     = rc_pkg::ShadeInterval
) (
  input  logic                   clk_i,
  input  rc_pkg::shade_frame_t   frame_i,
  input  logic [3:0]             valid_i,
  input  logic [Every-1:0]       phase_i,     // the cycle of s1
  input  rc_pkg::shade_state_t   s0_state_i,
  input  logic [3*ValueBits-1:0] s0_colour_i,
  output logic                   s4_more_o,
  output logic [3*SumBits-1:0]   s4_sum_o,
  output logic [3*ValueBits-1:0] s4_least_o,
  output logic [3*ValueBits-1:0] s4_most_o,
  output logic [3*ValueBits-1:0] s4_colour_o
);

  // s1: the number of samples so far, and their limit.
  logic [6:0] s0_done, all;
  logic       s0_some, s0_fourth, s3_some, s3_fourth, s3_same;
  logic [2:0] s2_same;
  logic [3*SumBits-1:0]   s0_sum, s3_sum;
  logic [3*ValueBits-1:0] s0_least, s0_most, s3_least, s3_most;

  assign all       = {3'd0, frame_i.side} * {3'd0, frame_i.side};
  assign s0_done   = {1'b0, s0_state_i.sample} + 7'd1;
  assign s0_some   = s0_done < all;
  assign s0_fourth = s0_done == 7'd4;
  assign s0_sum    = s0_state_i.sum;
  assign s0_least  = s0_state_i.least;
  assign s0_most   = s0_state_i.most;

  rc_shift_register #(.Width(2), .Stages(3)) u_flags (
    .clk_i, .enable_i(valid_i[2:0]), .data_i({s0_some, s0_fourth}),
    .data_o({s3_some, s3_fourth}));

  // s1: sums and extremes. s2: mean, and the contrast. s3: rounded mean.
  logic [ValueBits-1:0] s1_share_q, contrast;

  assign contrast = frame_i.contrast;

  always_ff @(posedge clk_i)
    if (valid_i[0]) s1_share_q <= s0_some ? frame_i.first_share : frame_i.share;

  localparam int unsigned UnitBits = rc_pkg::UnitBits;      // fraction bits of a value
  localparam int unsigned ProductW = SumBits + ValueBits;   // sum * share of a sample, U8.32
  logic [3*SumBits-1:0]  s1_sum;
  logic [3*ProductW-1:0] s1_product;

  rc_mul_held #(.AW(SumBits), .BW(ValueBits), .Signed(1'b0), .Products(3)) u_mean (
    .clk_i, .phase_i, .a_i(s1_sum), .b_i({3{s1_share_q}}), .p_o(s1_product));

  for (genvar k = 0; k < 3; k++) begin : gen_channel
    logic [SumBits-1:0]   s1_sum_q, s2_sum_q, s3_sum_q;
    logic [ValueBits-1:0] colour, least, most;
    logic [ValueBits-1:0] s1_least_q, s1_most_q, s2_least_q, s2_most_q, s3_least_q, s3_most_q;
    logic [ValueBits-1:0] s1_apart;
    logic                 s2_same_q;
    logic [ProductW-1:0]  s2_mean_q, s2_rounded;
    logic [ValueBits-1:0] s3_mean_q;

    assign colour   = s0_colour_i[k*ValueBits +: ValueBits];
    assign least    = s0_least[k*ValueBits +: ValueBits];
    assign most     = s0_most[k*ValueBits +: ValueBits];
    assign s1_sum[k*SumBits +: SumBits] = s1_sum_q;
    assign s1_apart = s1_most_q - s1_least_q;
    assign s2_rounded = s2_mean_q + ProductW'(rc_pkg::ProductHalf);

    always_ff @(posedge clk_i) begin
      if (valid_i[0]) begin
        s1_sum_q   <= s0_sum[k*SumBits +: SumBits] + SumBits'(colour);
        s1_least_q <= colour < least ? colour : least;
        s1_most_q  <= colour > most ? colour : most;
      end
      if (valid_i[1]) begin
        s2_sum_q   <= s1_sum_q;
        s2_least_q <= s1_least_q;
        s2_most_q  <= s1_most_q;
        s2_same_q  <= s1_apart <= contrast && contrast != '0;
        s2_mean_q  <= s1_product[k*ProductW +: ProductW];
      end
      if (valid_i[2]) begin
        s3_sum_q   <= s2_sum_q;
        s3_least_q <= s2_least_q;
        s3_most_q  <= s2_most_q;
        s3_mean_q  <= s2_rounded[ProductW-1:2*UnitBits] != '0 ? rc_pkg::ValueOne
                    : {1'b0, s2_rounded[UnitBits +: UnitBits]};
      end
      if (valid_i[3]) s4_colour_o[k*ValueBits +: ValueBits] <= s3_mean_q;
    end

    assign s2_same[k]                           = s2_same_q;
    assign s3_sum[k*SumBits +: SumBits]         = s3_sum_q;
    assign s3_least[k*ValueBits +: ValueBits]   = s3_least_q;
    assign s3_most[k*ValueBits +: ValueBits]    = s3_most_q;

    logic unused;
    assign unused = ^s2_rounded;
  end

  // s4: if the first four samples agree, no more follow.
  always_ff @(posedge clk_i) begin
    if (valid_i[2]) s3_same <= &s2_same;
    if (valid_i[3]) begin
      s4_more_o  <= s3_some && !(s3_fourth && s3_same);
      s4_sum_o   <= s3_sum;
      s4_least_o <= s3_least;
      s4_most_o  <= s3_most;
    end
  end

  logic unused;
  assign unused = ^{frame_i, s0_state_i};
endmodule
`default_nettype wire
