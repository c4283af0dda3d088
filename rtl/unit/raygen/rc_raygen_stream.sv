// The unit raygen of a chip whose rays come from memory: a record becomes a ray with the
// reciprocals of its direction. It takes the place of rc_raygen, and has no camera.
//
// Latency rc_pkg::RaygenLatency + 1 (result queue), one ray every rc_pkg::RaygenInterval cycles,
// answers in order. Model: recorded_ray() in model/unit/raygen/raygen.hpp.
`default_nettype none
module rc_raygen_stream (
  input  logic            clk_i,
  input  logic            rst_ni,
  // From stream
  input  logic            record_valid_i,
  output logic            record_ready_o,
  input  rc_pkg::record_t record_i,
  // To trav and list
  output logic            ray_valid_o,
  input  logic            ray_ready_i,
  output rc_pkg::ray_t    ray_o,
  output logic            occupied_o      // begins no ray: the last one is in division
);
  localparam int unsigned RayDirBits = rc_pkg::RayDirBits;
  localparam int unsigned R1         = rc_pkg::RecipBits + 1;
  localparam int unsigned ExpBits    = rc_pkg::ExpBits;
  localparam int unsigned Latency    = rc_pkg::RaygenLatency;
  localparam int unsigned Every      = rc_pkg::RaygenInterval;
  localparam int unsigned RecordW    = rc_pkg::RecordW;

  // Admission: an answer has a place in the result queue. valid[i]: stage i holds a ray.
  logic               admit;
  logic [Latency-1:0] valid_q;
  logic [Latency:0]   valid;

  assign valid = {valid_q, admit};

  rc_credited_pipeline #(.Credits(rc_pkg::RaygenQueue), .Stages(Latency)) u_stages (
    .clk_i, .rst_ni, .req_valid_i(record_valid_i), .req_ready_o(record_ready_o),
    .occupied_i(occupied_o), .leave_i(ray_valid_o && ray_ready_i), .admit_o(admit),
    .valid_q_o(valid_q));

  if (Every > 1) begin : gen_occupied
    logic occupied_q;
    assign occupied_o = occupied_q;

    always_ff @(posedge clk_i) occupied_q <= rst_ni && |valid[Every-2:0];
  end else begin : gen_never_occupied
    assign occupied_o = 1'b0;
  end

  // s0: the record comes from the cache's queue. In a fast chip a stage accepts unconditionally, as
  // in rc_raygen.
  logic [Latency:0] enable;
  rc_pkg::record_t  s1_q;

  assign enable = valid | {(Latency+1){rc_pkg::PathCut != 0}};
  always_ff @(posedge clk_i) if (enable[0]) s1_q <= record_i;

  // s1: reciprocals of the direction.
  logic [3*RayDirBits-1:0] s1_d;
  logic [3*R1-1:0]         recip;
  logic [3*ExpBits-1:0]    len;
  logic                    s1_short;

  assign s1_d     = s1_q.d;
  assign s1_short = s1_q.kind != rc_pkg::RayShadow;

  for (genvar k = 0; k < 3; k++) begin : gen_axis
    rc_recip #(.Every(Every)) u_recip (
      .clk_i, .rst_ni, .valid_i(Every > 1 ? valid[1] : enable[1]), .short_i(s1_short),
      .d_i($signed(s1_d[k*RayDirBits +: RayDirBits])),
      .recip_o(recip[k*R1 +: R1]), .len_o(len[k*ExpBits +: ExpBits]));
  end

  // The record is delayed to match them.
  logic [RecordW-1:0] end_record;

  rc_interval_delay #(.Width(RecordW), .Stages(Latency - 1), .Every(Every)) u_record (
    .clk_i, .rst_ni, .enable_i(enable[Latency-1:1]), .valid_i(valid[Latency-1:1]),
    .data_i(s1_q), .data_o(end_record));

  // Result queue. With two levels no recorded ray has a home.
  rc_pkg::record_t         last;
  rc_pkg::ray_t            new_ray;
  logic                    queue_ready;
  logic [rc_pkg::RayW-1:0] ray_data;

  assign last = end_record;

  if (rc_pkg::IsStream) begin : gen_ray
    always_comb begin
      new_ray       = '0;
      new_ray.ray   = last.ray;
      new_ray.kind  = last.kind;
      new_ray.o     = last.o;
      new_ray.d     = last.d;
      new_ray.recip = recip;
      new_ray.len   = len;
    end
  end else begin : gen_no_ray   // tools also parse a chip without streams
    assign new_ray = '0;
  end

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
  assign unused = ^{queue_ready, valid[Latency], enable[Latency]};
endmodule
`default_nettype wire
