// Makes rays: a request becomes a ray with the reciprocals of its direction.
//
// Accepts a context's new pixel from sched and, if the chip shades, rays from shade, which go
// first. A camera ray begins at the eye and goes through the middle of its pixel, or through its
// sample. Other rays come with origin and direction.
//
// Latency rc_pkg::RaygenLatency + 1 (result queue), one ray every rc_pkg::RaygenInterval cycles,
// answers in order. Model: model/unit/raygen/raygen.hpp. The host scales the camera vectors so that
// every sum fits and none is too short. It holds frame_i while rays are in flight.
`default_nettype none
module rc_raygen (
  input  logic           clk_i,
  input  logic           rst_ni,
  input  rc_pkg::frame_t frame_i,
  // From shade; 0 unless the chip shades
  input  logic           spawn_valid_i,
  output logic           spawn_ready_o,
  input  rc_pkg::spawn_t spawn_i,
  // From sched
  input  logic           slot_valid_i,
  output logic           slot_ready_o,
  input  rc_pkg::slot_t  slot_i,
  // To trav and list
  output logic           ray_valid_o,
  input  logic           ray_ready_i,
  output rc_pkg::ray_t   ray_o,
  output logic           occupied_o      // begins no ray: the last one is in division
);
  localparam int unsigned M            = rc_pkg::DirBits;
  localparam int unsigned RayDirBits   = rc_pkg::RayDirBits;
  localparam int unsigned R1           = rc_pkg::RecipBits + 1;
  localparam int unsigned PixelBits    = rc_pkg::PixelBits;
  localparam int unsigned ExpBits      = rc_pkg::ExpBits;
  localparam int unsigned Every        = rc_pkg::RaygenInterval;
  localparam int unsigned SampleL      = rc_pkg::Supersampling ? rc_pkg::SampleStages : 0;
  localparam int unsigned SubBits      = rc_pkg::Supersampling ? rc_pkg::SubPixelBits : 0;
  localparam int unsigned PositionW    = PixelBits + 1 + SubBits;   // position, signed
  localparam int unsigned GuardDirBits = rc_pkg::GuardDirBits;
  localparam int unsigned GuardSumW    = GuardDirBits + SubBits;
  localparam int unsigned RecipL       = rc_pkg::RecipStages;

  // Stages that hold the pixel's steps, and the ray's direction.
  localparam int unsigned Step    = SampleL + rc_pkg::PixelStages;
  localparam int unsigned Dir     = Step + rc_pkg::DirectionStages + 1;
  // In a chip for streams RaygenLatency is shorter. It has no rc_raygen, but tools also parse this.
  localparam int unsigned Latency = rc_pkg::IsStream ? Dir + RecipL : rc_pkg::RaygenLatency;

  // s0: requests. A new pixel is a camera ray through its first sample.
  logic                      req_valid, req_ready;
  logic [rc_pkg::SpawnW-1:0] req_flat;
  rc_pkg::spawn_t            req, new_pixel;

  always_comb begin
    new_pixel      = '0;
    new_pixel.ray  = slot_i.ray;
    new_pixel.kind = rc_pkg::RayCamera;
    new_pixel.x    = slot_i.x;
    new_pixel.y    = slot_i.y;
  end

  if (rc_pkg::Shading) begin : gen_merge
    rc_priority_merge #(.Width(rc_pkg::SpawnW)) u_req (
      .clk_i, .rst_ni,
      .first_valid_i(spawn_valid_i), .first_ready_o(spawn_ready_o), .first_i(spawn_i),
      .second_valid_i(slot_valid_i), .second_ready_o(slot_ready_o), .second_i(new_pixel),
      .valid_o(req_valid), .ready_i(req_ready), .data_o(req_flat));
  end else begin : gen_pixels
    logic unused;
    assign unused        = ^{spawn_valid_i, spawn_i};
    assign req_valid     = slot_valid_i;
    assign slot_ready_o  = req_ready;
    assign spawn_ready_o = 1'b0;
    assign req_flat      = new_pixel;
  end

  assign req = req_flat;

  // Admission: an answer has a place in the result queue. valid[i]: stage i holds a ray.
  logic               admit;
  logic [Latency-1:0] valid_q;
  logic [Latency:0]   valid;

  assign valid = {valid_q, admit};

  rc_credited_pipeline #(.Credits(rc_pkg::RaygenQueue), .Stages(Latency)) u_stages (
    .clk_i, .rst_ni, .req_valid_i(req_valid), .req_ready_o(req_ready), .occupied_i(occupied_o),
    .leave_i(ray_valid_o && ray_ready_i), .admit_o(admit), .valid_q_o(valid_q));

  if (Every > 1) begin : gen_occupied
    logic occupied_q;   // a register, because the sources that wait are far away
    assign occupied_o = occupied_q;

    always_ff @(posedge clk_i) occupied_q <= rst_ni && |valid[Every-2:0];
  end else begin : gen_never_occupied
    assign occupied_o = 1'b0;
  end

  // enable[i]: the register after stage i accepts its input (rtl/README.md, Relaxed and fast).
  logic [Latency:0] enable;

  assign enable = valid | {(Latency+1){rc_pkg::PathCut != 0}};

  // Fields of the request that the ray takes unchanged: its number, the set of primitives that it
  // tests, and its home. This record omits members that the chip does not have.
  localparam int unsigned TagW = rc_pkg::SpawnTagW;
  rc_pkg::ray_t       new_ray;
  rc_pkg::shear_t     shear;   // of the sheared test
  rc_pkg::spawn_tag_t s0_tag, end_tag;
  logic [TagW-1:0]    end_tag_flat;

  rc_interval_delay #(.Width(TagW), .Stages(Latency), .Every(Every)) u_tag (
    .clk_i, .rst_ni, .enable_i(enable[Latency-1:0]), .valid_i(valid[Latency-1:0]),
    .data_i(s0_tag), .data_o(end_tag_flat));

  assign end_tag     = end_tag_flat;
  assign s0_tag.ray  = req.ray;
  assign new_ray.ray = end_tag.ray;

  if (rc_pkg::HasTextures) begin : gen_holes
    assign s0_tag.holes  = req.holes;
    assign new_ray.holes = end_tag.holes;
  end

  if (rc_pkg::Planes) begin : gen_partial
    assign s0_tag.is_partial  = req.is_partial;
    assign new_ray.is_partial = end_tag.is_partial;
  end

  if (rc_pkg::Spheres) begin : gen_self
    assign s0_tag.self       = req.self;
    assign s0_tag.is_inside  = req.is_inside;
    assign new_ray.self      = end_tag.self;
    assign new_ray.is_inside = end_tag.is_inside;
  end

  if (rc_pkg::HasHomes) begin : gen_home
    assign s0_tag.home    = req.home;
    assign s0_tag.home_o  = req.home_o;
    assign s0_tag.home_d  = req.home_d;
    assign new_ray.home   = end_tag.home;
    assign new_ray.home_o = end_tag.home_o;
    assign new_ray.home_d = end_tag.home_d;
  end

  // Position in the picture, in pixels with SubBits of fraction, at the start of stage SampleL.
  logic [rc_pkg::FrameW-1:0]   frame_flat;
  logic signed [PositionW-1:0] x, y;

  assign frame_flat = frame_i;

  if (rc_pkg::Supersampling) begin : gen_sample
    logic signed [SubBits-1:0] offset_x, offset_y;
    logic [PixelBits-1:0]      wait_x, wait_y;

    rc_sample u_sample (
      .clk_i, .enable_i(enable[SampleL-1:0]), .side_i(frame_i.side), .stride_i(frame_i.stride),
      .jitter_i(frame_i.jitter), .seed_i(frame_i.seed), .x_i(req.x), .y_i(req.y),
      .sample_i(req.sample),
      .x_o(offset_x), .y_o(offset_y));

    rc_shift_register #(.Width(2 * PixelBits), .Stages(SampleL)) u_pixel (
      .clk_i, .enable_i(enable[SampleL-1:0]), .data_i({req.x, req.y}), .data_o({wait_x, wait_y}));

    assign x = $signed({1'b0, wait_x, {SubBits{1'b0}}}) + PositionW'(offset_x);
    assign y = $signed({1'b0, wait_y, {SubBits{1'b0}}}) + PositionW'(offset_y);
  end else begin : gen_middle
    assign x = $signed({1'b0, req.x});
    assign y = $signed({1'b0, req.y});
  end

  // Camera vectors.
  logic [3*R1-1:0]           recip;
  logic [3*ExpBits-1:0]      len;
  logic [3*GuardDirBits-1:0] corner, right, down;
  logic [3*rc_pkg::CoordBits-1:0] eye;

  if (!rc_pkg::IsStream) begin : gen_camera_vectors   // tools also parse a chip for streams
    assign corner = frame_i.corner;
    assign right  = frame_i.right;
    assign down   = frame_i.down;
    assign eye    = frame_i.eye;
  end else begin : gen_no_camera
    assign {corner, right, down, eye} = '0;
  end

  // Axes: direction and reciprocal.
  logic [3*GuardSumW-1:0]  sum;
  logic [3*M-1:0]          made_dir;
  logic [3*RayDirBits-1:0] new_dir, dir_q, end_dir;
  logic                    is_short;

  for (genvar k = 0; k < 3; k++) begin : gen_axis
    // Pixel steps, modulo 2^GuardSumW, because only the sum is sure to fit. Of the multiplier's
    // sums the last one is in a register that a relaxed chip has as well.
    logic signed [GuardDirBits+PositionW-1:0] right_wide, down_wide;
    logic signed [GuardSumW-1:0]              s1_right_q, s1_down_q, s1_corner;

    rc_mul #(.AW(GuardDirBits), .BW(PositionW), .Stages(rc_pkg::PixelStages - 1)) u_right (
      .clk_i, .a_i($signed(right[k*GuardDirBits +: GuardDirBits])), .b_i(x), .p_o(right_wide));
    rc_mul #(.AW(GuardDirBits), .BW(PositionW), .Stages(rc_pkg::PixelStages - 1)) u_down (
      .clk_i, .a_i($signed(down[k*GuardDirBits +: GuardDirBits])), .b_i(y), .p_o(down_wide));

    always_ff @(posedge clk_i) begin
      if (enable[Step-1]) begin
        s1_right_q <= right_wide[GuardSumW-1:0];
        s1_down_q  <= down_wide[GuardSumW-1:0];
      end
    end

    // Their sum with the corner. rc_direction makes the direction from all three axes.
    assign s1_corner = GuardSumW'($signed(corner[k*GuardDirBits +: GuardDirBits])) <<< SubBits;
    // In a simulation, a sum without a ray costs no work.
    logic computes;
`ifdef SYNTHESIS
    assign computes = 1'b1;
`else
    assign computes = enable[Step];
`endif

    assign sum[k*GuardSumW +: GuardSumW] = computes ? s1_corner + s1_right_q + s1_down_q : '0;

    logic [R1+ExpBits-1:0] made;
    rc_recip #(.Every(Every)) u_recip (
      .clk_i, .rst_ni, .valid_i(Every > 1 ? valid[Dir] : enable[Dir]), .short_i(is_short),
      .d_i($signed(dir_q[k*RayDirBits +: RayDirBits])),
      .recip_o(made[R1-1:0]), .len_o(made[R1+ExpBits-1:R1]));

    if (Latency - Dir == RecipL) begin : gen_last
      assign {len[k*ExpBits +: ExpBits], recip[k*R1 +: R1]} = made;
    end else begin : gen_wait
      rc_shift_register #(.Width(R1 + ExpBits), .Stages(Latency - Dir - RecipL)) u_made (
        .clk_i, .enable_i(enable[Latency-1:Dir+RecipL]), .data_i(made),
        .data_o({len[k*ExpBits +: ExpBits], recip[k*R1 +: R1]}));
    end

    logic unused;
    assign unused = ^{right_wide, down_wide};
  end

  rc_direction #(.GuardSumW(GuardSumW)) u_direction (
    .clk_i, .enable_i(enable[Dir-2:Step]), .sum_i(sum), .dir_o(made_dir));

  // Direction and origin are delayed to match the reciprocals.
  always_ff @(posedge clk_i) if (enable[Dir-1]) dir_q <= new_dir;

  rc_interval_delay #(.Width(3 * RayDirBits), .Stages(Latency - Dir), .Every(Every)) u_dir (
    .clk_i, .rst_ni, .enable_i(enable[Latency-1:Dir]), .valid_i(valid[Latency-1:Dir]),
    .data_i(dir_q), .data_o(end_dir));

  if (rc_pkg::PrimitiveTest != rc_pkg::TestSheared) begin : gen_no_shear
    assign shear = '0;

    logic unused;
    assign unused = ^shear;
  end

  if (rc_pkg::Shading) begin : gen_spawned
    localparam int unsigned OriginWidth = rc_pkg::OriginWidth;
    localparam int unsigned N           = rc_pkg::CoordBits;
    logic [1:0]               kind, dir_kind_q, end_kind;
    logic [3*OriginWidth-1:0] spawn_o, camera_o, new_o, dir_o_q, end_o;
    logic [3*RayDirBits-1:0]  spawn_d;
    logic                     is_camera;

    // The ray of a new pixel has neither field: it may carry those of a waiting ray, which costs no
    // gates.
    rc_interval_delay #(.Width(2 + 3 * (OriginWidth + RayDirBits)), .Stages(Dir - 1), .Every(Every))
    u_spawned (
      .clk_i, .rst_ni, .enable_i(enable[Dir-2:0]), .valid_i(valid[Dir-2:0]),
      .data_i({req.kind, spawn_i.o, spawn_i.d}),
      .data_o({kind, spawn_o, spawn_d}));

    assign is_camera = kind == rc_pkg::RayCamera;

    for (genvar k = 0; k < 3; k++) begin : gen_eye
      assign new_dir[k*RayDirBits +: RayDirBits] = is_camera
                                                 ? RayDirBits'($signed(made_dir[k*M +: M]))
                                                 : spawn_d[k*RayDirBits +: RayDirBits];
      assign camera_o[k*OriginWidth +: OriginWidth] = {eye[k*N +: N], {(OriginWidth-N){1'b0}}};
    end

    assign new_o = is_camera ? camera_o : spawn_o;
    always_ff @(posedge clk_i) if (enable[Dir-1]) {dir_kind_q, dir_o_q} <= {kind, new_o};

    rc_interval_delay #(.Width(2 + 3 * OriginWidth), .Stages(Latency - Dir), .Every(Every)) u_head (
      .clk_i, .rst_ni, .enable_i(enable[Latency-1:Dir]), .valid_i(valid[Latency-1:Dir]),
      .data_i({dir_kind_q, dir_o_q}),
      .data_o({end_kind, end_o}));

    assign is_short = dir_kind_q != rc_pkg::RayShadow;

    assign new_ray.kind = end_kind;
    assign new_ray.o    = end_o;
  end else begin : gen_camera
    logic unused;
    assign unused    = ^{req};
    assign new_dir   = made_dir;
    assign is_short  = 1'b1;
    assign new_ray.o = eye;

    // The sheared triangle test needs slopes as well.
    if (rc_pkg::PrimitiveTest == rc_pkg::TestSheared) begin : gen_sheared
      localparam int unsigned ShearW = rc_pkg::ShearW;
      localparam int unsigned SlopeL = rc_pkg::SlopeStages;
      logic [ShearW-1:0] made, shear_flat;

      rc_slope u_slope (.clk_i, .enable_i(enable[Dir]), .d_i(dir_q), .shear_o(made));

      if (Latency - Dir == SlopeL) begin : gen_last
        assign shear_flat = made;
      end else begin : gen_wait
        rc_shift_register #(.Width(ShearW), .Stages(Latency - Dir - SlopeL)) u_made (
          .clk_i, .enable_i(enable[Latency-1:Dir+SlopeL]), .data_i(made), .data_o(shear_flat));
      end

      assign shear         = shear_flat;
      assign new_ray.axis  = shear.axis;
      assign new_ray.neg   = shear.neg;
      assign new_ray.size  = shear.size;
      assign new_ray.slope = shear.slope;

    end
  end

  // Result queue.
  logic                    queue_ready;
  logic [rc_pkg::RayW-1:0] ray_data;

  assign new_ray.d     = end_dir;
  assign new_ray.recip = recip;
  assign new_ray.len   = len;

  rc_fifo #(.Width(rc_pkg::RayW), .Depth(rc_pkg::RaygenQueue)) u_queue (
    .clk_i, .rst_ni, .valid_i(valid_q[Latency-1]), .ready_o(queue_ready), .data_i(new_ray),
    .valid_o(ray_valid_o), .ready_i(ray_ready_i), .data_o(ray_data));

  assign ray_o = ray_data;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni && valid_q[Latency-1])
    a_never_dropped: assert (queue_ready)
    else $error("a ray met a full queue");
`endif

  logic unused;
  assign unused = ^{queue_ready, frame_flat, req, valid[Latency], enable[Latency]};
endmodule
`default_nettype wire
