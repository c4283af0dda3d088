// The length of the path from the eye to a hit, for the level of its texture: path + t |d|, rounded
// down and saturated. |d| counts as its largest component plus 3/8 of the second and 5/16 of the
// smallest. Part of rc_pass, which has the valid bits; the result is in the registers of s3. Model:
// path_to() in model/unit/shade/surface/surf.hpp.
`default_nettype none
module rc_path_length #(
  localparam int unsigned M     = rc_pkg::DirBits,
  localparam int unsigned TBits = rc_pkg::TBits,
  localparam int unsigned PathBits = rc_pkg::PathBits,
  localparam int unsigned Every = rc_pkg::ShadeInterval
) (
  input  logic             clk_i,
  input  logic [2:0]       valid_i,
  input  logic [Every-1:0] s1_phase_i,   // the cycle of stage 1
  input  logic [PathBits-1:0] s0_path_i,    // to the ray's origin
  input  logic [TBits-1:0] s0_t_i,
  input  logic [3*M-1:0]   s0_d_i,
  output logic [PathBits-1:0] s3_path_o
);
  localparam int unsigned LengthBits = rc_pkg::LengthBits;   // fraction bits of |d|
  localparam int unsigned LengthW    = LengthBits + 2;
  localparam int unsigned ProductW   = LengthW + TBits;

  // s1: |d|, in units of 2^(M-1).
  logic [M-1:0] size_x, size_y, size_z;   // 2^(M-1) is possible
  logic [M-1:0] larger, smaller, longest, second, shortest;   // of the first two; of all
  logic [M+1:0] length;
  logic [LengthW-1:0] s1_length_q;
  logic [TBits-1:0]   s1_t_q;
  logic [PathBits-1:0] s2_path;

  assign size_x = s0_d_i[M-1] ? -s0_d_i[0 +: M] : s0_d_i[0 +: M];
  assign size_y = s0_d_i[2*M-1] ? -s0_d_i[M +: M] : s0_d_i[M +: M];
  assign size_z = s0_d_i[3*M-1] ? -s0_d_i[2*M +: M] : s0_d_i[2*M +: M];

  assign larger   = size_x > size_y ? size_x : size_y;
  assign smaller  = size_x > size_y ? size_y : size_x;
  assign longest  = larger > size_z ? larger : size_z;
  assign second   = larger <= size_z ? larger : smaller > size_z ? smaller : size_z;
  assign shortest = smaller < size_z ? smaller : size_z;
  assign length   = {2'b0, longest} + {4'b0, second[M-1:2]} + {5'b0, second[M-1:3]}
                  + {4'b0, shortest[M-1:2]} + {6'b0, shortest[M-1:4]};

  // s2: the product. s3: the sum.
  logic [ProductW-1:0]          s1_product, s2_product_q;
  localparam int unsigned SumW  =   // one bit more than the longer term
      (ProductW - LengthBits > PathBits ? ProductW - LengthBits : PathBits) + 1;
  logic [SumW-1:0]              s2_sum;

  rc_mul_held #(.AW(LengthW), .BW(TBits), .Signed(1'b0)) u_product (
    .clk_i, .phase_i(s1_phase_i), .a_i(s1_length_q), .b_i(s1_t_q), .p_o(s1_product));

  rc_shift_register #(.Width(PathBits), .Stages(2)) u_path (
    .clk_i, .enable_i(valid_i[1:0]), .data_i(s0_path_i), .data_o(s2_path));

  assign s2_sum = SumW'(s2_product_q[ProductW-1:LengthBits]) + SumW'(s2_path);

  always_ff @(posedge clk_i) begin
    if (valid_i[0]) begin
      s1_length_q <= LengthW'(length >> (M - 1 - LengthBits));
      s1_t_q      <= s0_t_i;
    end
    if (valid_i[1]) s2_product_q <= s1_product;
    if (valid_i[2])
      s3_path_o <= s2_sum[SumW-1:PathBits] != '0 ? '1 : s2_sum[PathBits-1:0];
  end

  logic unused;
  assign unused = ^{s2_product_q, second, shortest};
endmodule
`default_nettype wire
