// The position of a sample relative to the pixel's middle, right and down, in 1/256 of a pixel.
//
// A pixel has side x side cells. Sample s lies in cell s * stride mod side^2. It lies in the cell's
// middle. With jitter a hash of seed, pixel and sample gives its place in the cell. The hash is
// Jenkins's one at a time (1997), over the words x, y and s.
//
// Latency rc_pkg::SampleStages, throughput 1 per cycle, no stall; stage i works when enable_i[i] is
// set. Model: sample_offset() in model/scene/whitted.cpp. The host ensures that side is in 1..8,
// stride at most side, and s below side^2.
`default_nettype none
module rc_sample #(
  localparam int unsigned PixelBits  = rc_pkg::PixelBits,
  localparam int unsigned SampleBits = rc_pkg::SampleBits,
  localparam int unsigned Stages     = rc_pkg::SampleStages,
  localparam int unsigned SubBits    = rc_pkg::SubPixelBits
) (
  input  logic                  clk_i,
  input  logic [Stages-1:0]     enable_i,
  // From the frame
  input  logic [3:0]            side_i,
  input  logic [SampleBits-1:0] stride_i,
  input  logic                  jitter_i,
  input  logic [31:0]           seed_i,
  // Sample
  input  logic [PixelBits-1:0]  x_i,
  input  logic [PixelBits-1:0]  y_i,
  input  logic [SampleBits-1:0] sample_i,
  // Position
  output logic signed [SubBits-1:0] x_o,   // right
  output logic signed [SubBits-1:0] y_o    // down
);
  if (Stages != 4 || SubBits != 8) begin : gen_refuse
    $error("rc_sample: SampleStages must be 4, and SubPixelBits 8");
  end

  // Mixes one word into the hash.
  function automatic logic [31:0] mix(input logic [31:0] h, input logic [31:0] word);
    logic [31:0] sum, folded;
    sum    = h + word;
    folded = sum + (sum << 10);
    mix    = folded ^ (folded >> 6);
  endfunction

  // One step of s * stride mod side^2, from the top bit of s on.
  logic [SampleBits:0] cells;
  assign cells = (SampleBits+1)'(side_i) * (SampleBits+1)'(side_i);

  function automatic logic [SampleBits-1:0] take(input logic [SampleBits-1:0] at, input logic more,
      input logic [SampleBits-1:0] stride, input logic [SampleBits:0] all);
    logic [SampleBits+1:0] far, once;
    far  = {1'b0, at, 1'b0} + (more ? {2'b00, stride} : '0);
    once = far >= {1'b0, all} ? far - {1'b0, all} : far;
    take = once >= {1'b0, all} ? SampleBits'(once - {1'b0, all}) : SampleBits'(once);
  endfunction

  // s1, s2: x and y, and three bits of s each. s3: s, the last mix, the cell's column and row.
  logic [31:0]           s1_hash_q, s2_hash_q, s2_last, s2_turned;
  logic [15:0]           s3_hash_q;
  logic [PixelBits-1:0]  s1_y_q;
  logic [SampleBits-1:0] s0_at, s1_at, s1_at_q, s2_at_q, s1_sample_q, s2_sample_q;
  logic [2:0]            s3_column_q, s3_row_q;

  always_comb begin
    s0_at = '0;
    s1_at = s1_at_q;
    for (int i = SampleBits - 1; i >= 0; i--) begin
      if (i >= SampleBits / 2) s0_at = take(s0_at, sample_i[i], stride_i, cells);
      else            s1_at = take(s1_at, s1_sample_q[i], stride_i, cells);
    end
  end

  assign s2_last   = mix(s2_hash_q, 32'(s2_sample_q));
  assign s2_turned = s2_last + (s2_last << 3);

  logic [SampleBits-1:0] s2_left;
  logic [2:0]            s2_row;

  always_comb begin
    s2_left = s2_at_q;
    s2_row  = '0;
    for (int i = 2; i >= 0; i--) begin
      if (s2_left >= SampleBits'(side_i) << i) begin
        s2_left   = s2_left - (SampleBits'(side_i) << i);
        s2_row[i] = 1'b1;
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (enable_i[0]) begin
      s1_hash_q   <= mix(seed_i, 32'(x_i));
      s1_y_q      <= y_i;
      s1_sample_q <= sample_i;
      s1_at_q     <= s0_at;
    end
    if (enable_i[1]) begin
      s2_hash_q   <= mix(s1_hash_q, 32'(s1_y_q));
      s2_sample_q <= s1_sample_q;
      s2_at_q     <= s1_at;
    end
    if (enable_i[2]) begin   // lower half of the hash: h ^ h >> 11, and h << 15 added
      s3_hash_q   <= s2_turned[15:0] ^ s2_turned[26:11]
                     ^ {s2_turned[0] ^ s2_turned[11], 15'd0};
      s3_column_q <= s2_left[2:0];
      s3_row_q    <= s2_row;
    end
  end

  // s4: {cell, place in it} / side, minus half a pixel. Cell and place are U3.8, the share of a
  // pixel that a cell takes, 1 / side, is U1.14 and rounded up. Then the 8 fraction bits of the
  // product, U4.22, that stay are exact.
  localparam int unsigned ShareFrac = 14;
  localparam int unsigned OverW     = 3 + SubBits + ShareFrac + 1;
  localparam int unsigned Top       = ShareFrac + SubBits - 1;   // the fraction bit of half a pixel
  logic [ShareFrac:0] share;

  always_comb begin
    share = (ShareFrac+1)'(1 << ShareFrac);
    for (int i = 2; i <= 8; i++)
      if (side_i == 4'(i)) share = (ShareFrac+1)'(((1 << ShareFrac) - 1 + i) / i);
  end

  localparam logic [SubBits-1:0] Middle = SubBits'(1) << (SubBits - 1);
  logic [SubBits-1:0] s3_right, s3_down;
  logic [OverW-1:0]   s3_over_x, s3_over_y;

  assign s3_right  = jitter_i ? s3_hash_q[0 +: SubBits] : Middle;
  assign s3_down   = jitter_i ? s3_hash_q[SubBits +: SubBits] : Middle;
  assign s3_over_x = OverW'({s3_column_q, s3_right}) * OverW'(share);
  assign s3_over_y = OverW'({s3_row_q, s3_down}) * OverW'(share);

  always_ff @(posedge clk_i) begin
    if (enable_i[3]) begin
      x_o <= {~s3_over_x[Top], s3_over_x[ShareFrac +: SubBits-1]};
      y_o <= {~s3_over_y[Top], s3_over_y[ShareFrac +: SubBits-1]};
    end
  end

  logic unused;
  assign unused = ^{s2_left, s2_turned, s3_over_x, s3_over_y};
endmodule
`default_nettype wire
