// Pixel number -> camera ray with reciprocal direction.
//
// Latency rc_pkg::RaygenLatency + 1 (result queue), throughput 1 per cycle, answers in
// order. Model: model/raygen/raygen.hpp. The host scales the camera vectors so that
// every direction fits DirBits; frame_i does not change while rays are under way.
`default_nettype none
module rc_raygen (
  input  logic           clk_i,
  input  logic           rst_ni,
  input  rc_pkg::frame_t frame_i,
  input  logic           slot_valid_i,
  output logic           slot_ready_o,
  input  rc_pkg::slot_t  slot_i,
  output logic           ray_valid_o,
  input  logic           ray_ready_i,
  output rc_pkg::ray_t   ray_o
);
  localparam int unsigned M       = rc_pkg::DirBits;
  localparam int unsigned G       = rc_pkg::GuardDirBits;
  localparam int unsigned R1      = rc_pkg::RecipBits + 1;
  localparam int unsigned P       = rc_pkg::PixelBits;
  localparam int unsigned E       = rc_pkg::ExpBits;
  localparam int unsigned I       = rc_pkg::RayBits;
  localparam int unsigned Latency = rc_pkg::RaygenLatency;
  localparam int unsigned RecipL  = 1 + (rc_pkg::RecipBits + 1) / 2;   // of rc_recip

  logic admit;
  assign admit = slot_valid_i && slot_ready_o;
  rc_door #(.Credits(rc_pkg::RaygenQueue)) u_door (
    .clk_i, .rst_ni, .admit_i(admit), .leave_i(ray_valid_o && ray_ready_i), .open_o(slot_ready_o));

  // Ray number and direction wait beside the reciprocals.
  logic [Latency-1:0] valid_q;
  logic [I-1:0]       end_ray;
  logic [3*M-1:0]     s1_dir, s2_dir_q, end_dir;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else         valid_q <= {valid_q[Latency-2:0], admit};
    if (valid_q[0]) s2_dir_q <= s1_dir;
  end
  rc_delay #(.Width(I), .Stages(Latency)) u_ray (
    .clk_i, .valid_i({valid_q[Latency-2:0], admit}), .data_i(slot_i.ray), .data_o(end_ray));
  rc_delay #(.Width(3 * M), .Stages(Latency - 2)) u_dir (
    .clk_i, .valid_i(valid_q[Latency-2:1]), .data_i(s2_dir_q), .data_o(end_dir));

  logic [3*R1-1:0] recip;
  logic [3*E-1:0]  len;
  logic [3*G-1:0]  corner, right, down;
  logic [P-1:0]    s0_x, s0_y;
  assign corner = frame_i.corner;
  assign right  = frame_i.right;
  assign down   = frame_i.down;
  assign s0_x   = slot_i.x;
  assign s0_y   = slot_i.y;

  for (genvar k = 0; k < 3; k++) begin : gen_axis
    // s1: pixel steps; modulo 2^G, since only the sum is sure to fit.
    logic signed [G-1:0] s1_right_q, s1_down_q, s1_sum;
    always_ff @(posedge clk_i) begin
      if (admit) begin
        s1_right_q <= $signed(right[k*G +: G]) * $signed({{(G-P){1'b0}}, s0_x});
        s1_down_q  <= $signed(down[k*G +: G]) * $signed({{(G-P){1'b0}}, s0_y});
      end
    end
    // s2: direction, rounded to nearest, halves up (Q(M).0).
    assign s1_sum = $signed(corner[k*G +: G]) + s1_right_q + s1_down_q
                  + $signed({{(M){1'b0}}, 1'b1, {(rc_pkg::GuardBits-1){1'b0}}});
    assign s1_dir[k*M +: M] = s1_sum[G-1 -: M];
    logic [R1+E-1:0] made;
    rc_recip u_recip (
      .clk_i, .valid_i(valid_q[1]), .d_i($signed(s2_dir_q[k*M +: M])),
      .recip_o(made[R1-1:0]), .len_o(made[R1+E-1:R1]));
    if (Latency - 2 == RecipL) begin : gen_last
      assign {len[k*E +: E], recip[k*R1 +: R1]} = made;
    end else begin : gen_wait
      rc_delay #(.Width(R1 + E), .Stages(Latency - 2 - RecipL)) u_made (
        .clk_i, .valid_i(valid_q[Latency-2:RecipL+1]), .data_i(made),
        .data_o({len[k*E +: E], recip[k*R1 +: R1]}));
    end
    logic unused;
    assign unused = ^s1_sum[G-M-1:0];
  end

  localparam int unsigned TailW = 3 * rc_pkg::CoordBits + 3 * (M + R1 + E);
  logic                      queue_ready;
  logic [rc_pkg::RayW-1:0]   queue_data, ray_data;
  logic [TailW-1:0]          tail;
  assign tail = {frame_i.eye, end_dir, recip, len};
  // The sheared triangle test has slopes as well.
  if (rc_pkg::PrimitiveTest == 1) begin : gen_sheared
    localparam int unsigned ShearW = 3 * M + 3;
    localparam int unsigned SlopeL = 1 + M / 2;   // of rc_slope
    logic [ShearW-1:0] made, shear;
    rc_slope u_slope (.clk_i, .valid_i(valid_q[1]), .d_i(s2_dir_q), .shear_o(made));
    if (Latency - 2 == SlopeL) begin : gen_last
      assign shear = made;
    end else begin : gen_wait
      rc_delay #(.Width(ShearW), .Stages(Latency - 2 - SlopeL)) u_made (
        .clk_i, .valid_i(valid_q[Latency-2:SlopeL+1]), .data_i(made), .data_o(shear));
    end
    assign queue_data = {end_ray, shear, tail};
  end else begin : gen_plain
    assign queue_data = {end_ray, tail};
  end
  rc_fifo #(.Width(rc_pkg::RayW), .Depth(rc_pkg::RaygenQueue)) u_queue (
    .clk_i, .rst_ni, .valid_i(valid_q[Latency-1]), .ready_o(queue_ready), .data_i(queue_data),
    .valid_o(ray_valid_o), .ready_i(ray_ready_i), .data_o(ray_data));
  assign ray_o = ray_data;

`ifndef SYNTHESIS
  a_never_dropped: assert property (@(posedge clk_i) disable iff (!rst_ni)
      valid_q[Latency-1] |-> queue_ready)
    else $error("a ray met a full queue");
`endif

  logic unused;
  assign unused = ^{queue_ready, frame_i.width, frame_i.height, frame_i.root};
endmodule
`default_nettype wire
