// Ray-triangle test, and the comparison with the best hit. Which test is a constant of the
// configuration: rc_edges decides exactly (model/isect/tri.hpp), rc_shear with rounded
// corners (model/isect/sheared.hpp); there are the formulas, tie rules and proven widths.
//
// Latency rc_pkg::TriLatency + 1 (result queue), throughput 1 per cycle, answers in
// order. A triangle seen edge-on never hits.
`default_nettype none
module rc_tri (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             req_valid_i,
  output logic             req_ready_o,
  input  rc_pkg::tri_req_t req_i,
  output logic             rsp_valid_o,
  input  logic             rsp_ready_i,
  output rc_pkg::tri_rsp_t rsp_o
);
  localparam bit          IsSheared = rc_pkg::PrimitiveTest == 1;
  localparam int unsigned N    = rc_pkg::CoordBits;
  localparam int unsigned M    = rc_pkg::DirBits;
  localparam int unsigned D    = rc_pkg::EdgeBits;   // of det, u, v
  localparam int unsigned U    = rc_pkg::NumBits;
  localparam int unsigned E    = 2 * N + M + 2;      // of den
  localparam int unsigned I    = rc_pkg::RayBits;
  localparam int unsigned P    = rc_pkg::PrimBits;
  localparam int unsigned L    = rc_pkg::TriLatency;
  localparam int unsigned Front = IsSheared ? 6 : 4; // stages before the comparison
  localparam int unsigned Pre   = Front + 2;         // and before the divisions
  localparam int unsigned TailW = 1 + U + D + P;     // closer, num, det, prim
  localparam int unsigned TriRayW = rc_pkg::TriRayBits;

  logic admit;
  assign admit = req_valid_i && req_ready_o;
  rc_door #(.Credits(rc_pkg::TriQueue)) u_door (
    .clk_i, .rst_ni, .admit_i(admit), .leave_i(rsp_valid_o && rsp_ready_i), .open_o(req_ready_o));

  logic [L-1:0] valid_q;
  logic [I-1:0] end_ray;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else         valid_q <= {valid_q[L-2:0], admit};
  end
  rc_delay #(.Width(I), .Stages(L)) u_ray (
    .clk_i, .valid_i({valid_q[L-2:0], admit}), .data_i(req_i.ray), .data_o(end_ray));

  // Stages up to Front: the ray and the triangle, and whether they meet. num / den is t,
  // num / det what is compared with other hits of the ray.
  logic [rc_pkg::TriReqW-1:0] req;
  logic [TriRayW-1:0]         tri_ray;
  logic [3*N-1:0]             s0_a, s0_b, s0_c;
  logic                       f0_hit;
  logic [D-1:0]               f0_det, f0_u, f0_v;
  logic [U-1:0]               f0_num;
  logic [E-1:0]               f0_den;
  assign req     = req_i;
  assign tri_ray = req[rc_pkg::TriReqW-I-1 -: TriRayW];
  assign s0_a    = req_i.a;
  assign s0_b    = req_i.b;
  assign s0_c    = req_i.c;
  if (IsSheared) begin : gen_sheared
    logic [M-1:0] f0_size;
    rc_shear u_shear (
      .clk_i, .valid_i({valid_q[4:0], admit}), .s0_shear_i(tri_ray[TriRayW-1:3*N]),
      .s0_o_i(tri_ray[3*N-1:0]), .s0_a_i(s0_a), .s0_b_i(s0_b), .s0_c_i(s0_c),
      .s6_hit_o(f0_hit), .s6_size_o(f0_size), .s6_det_o(f0_det), .s6_num_o(f0_num),
      .s6_u_o(f0_u), .s6_v_o(f0_v));
    assign f0_den = {{(E-D){1'b0}}, f0_det} * {{(E-M){1'b0}}, f0_size};
  end else begin : gen_exact
    rc_edges u_edges (
      .clk_i, .s0_valid_i(admit), .s1_valid_i(valid_q[0]), .s2_valid_i(valid_q[1]),
      .s3_valid_i(valid_q[2]),
      .s0_o_i(tri_ray[TriRayW-1:3*M]), .s0_d_i(tri_ray[3*M-1:0]), .s0_a_i(s0_a), .s0_b_i(s0_b),
      .s0_c_i(s0_c),
      .s4_hit_o(f0_hit), .s4_det_o(f0_det), .s4_num_o(f0_num), .s4_u_o(f0_u), .s4_v_o(f0_v));
    assign f0_den = f0_det;
  end

  // Meanwhile number and hit to beat wait.
  localparam int unsigned BestW = P + 1 + U + D + P;
  logic [BestW-1:0] f0_best;
  rc_delay #(.Width(BestW), .Stages(Front)) u_best (
    .clk_i, .valid_i({valid_q[Front-2:0], admit}),
    .data_i({req_i.prim, req_i.found, req_i.best_num, req_i.best_det, req_i.best_prim}),
    .data_o(f0_best));

  logic [P-1:0] f0_prim, f0_best_prim;
  logic         f0_found;
  logic [U-1:0] f0_best_num;
  logic [D-1:0] f0_best_det;
  assign {f0_prim, f0_found, f0_best_num, f0_best_det, f0_best_prim} = f0_best;

  // f1: num / det against best_num / best_det, cross-multiplied; all four are positive.
  logic           f1_hit_q, f1_found_q, f1_first_q;
  logic [U+D-1:0] f1_mine_q, f1_theirs_q;
  logic [U-1:0]   f1_num_q;
  logic [E-1:0]   f1_den_q;
  logic [D-1:0]   f1_det_q, f1_u_q, f1_v_q;
  logic [P-1:0]   f1_prim_q;
  always_ff @(posedge clk_i) begin
    if (valid_q[Front-1]) f1_hit_q <= f0_hit;
    if (valid_q[Front-1] && f0_hit) begin
      f1_found_q <= f0_found;
      f1_first_q <= f0_prim <= f0_best_prim;
      if (f0_found) begin
        f1_mine_q   <= {{D{1'b0}}, f0_num} * {{U{1'b0}}, f0_best_det};
        f1_theirs_q <= {{D{1'b0}}, f0_best_num} * {{U{1'b0}}, f0_det};
      end
      f1_num_q  <= f0_num;
      f1_den_q  <= f0_den;
      f1_det_q  <= f0_det;
      f1_u_q    <= f0_u;
      f1_v_q    <= f0_v;
      f1_prim_q <= f0_prim;
    end
  end

  // f2: closer, or as close with a lower number.
  logic         f1_closer, f2_closer_q;
  logic [U-1:0] f2_num_q;
  logic [E-1:0] f2_den_q;
  logic [D-1:0] f2_det_q, f2_u_q, f2_v_q;
  logic [P-1:0] f2_prim_q;
  assign f1_closer = f1_hit_q && (!f1_found_q || f1_mine_q < f1_theirs_q
                                  || (f1_mine_q == f1_theirs_q && f1_first_q));
  always_ff @(posedge clk_i) begin
    if (valid_q[Front]) f2_closer_q <= f1_closer;
    if (valid_q[Front] && f1_closer) begin
      f2_num_q  <= f1_num_q;
      f2_den_q  <= f1_den_q;
      f2_det_q  <= f1_det_q;
      f2_u_q    <= f1_u_q;
      f2_v_q    <= f1_v_q;
      f2_prim_q <= f1_prim_q;
    end
  end

  // Divisions; numerator, determinant and number wait.
  logic f2_divide;
  assign f2_divide = valid_q[Pre-1] && f2_closer_q;
  logic [rc_pkg::TBits-1:0]  t;
  logic [rc_pkg::BaryBits:0] u, v;
  localparam int unsigned Rest = L - Pre;
  rc_hitdiv #(.Stages(Rest), .E(E)) u_hitdiv (
    .clk_i, .valid_i(f2_divide), .num_i(f2_num_q), .den_i(f2_den_q), .det_i(f2_det_q),
    .u_i(f2_u_q), .v_i(f2_v_q), .t_o(t), .u_o(u), .v_o(v));

  logic [Rest-1:0]  closer_q;
  logic [TailW-2:0] tail;
  always_ff @(posedge clk_i) closer_q <= {closer_q[Rest-2:0], f2_divide};
  rc_delay #(.Width(TailW - 1), .Stages(Rest)) u_tail (
    .clk_i, .valid_i({closer_q[Rest-2:0], f2_divide}), .data_i({f2_num_q, f2_det_q, f2_prim_q}),
    .data_o(tail));

  logic                       queue_ready, closer;
  logic [rc_pkg::TriRspW-1:0] queue_data, rsp_data;
  assign closer     = closer_q[Rest-1];
  assign queue_data = closer ? {end_ray, 1'b1, tail, t, u, v}
                             : {end_ray, {(rc_pkg::TriRspW-I){1'b0}}};
  rc_fifo #(.Width(rc_pkg::TriRspW), .Depth(rc_pkg::TriQueue)) u_queue (
    .clk_i, .rst_ni, .valid_i(valid_q[L-1]), .ready_o(queue_ready), .data_i(queue_data),
    .valid_o(rsp_valid_o), .ready_i(rsp_ready_i), .data_o(rsp_data));
  assign rsp_o = rsp_data;

`ifndef SYNTHESIS
  a_never_dropped: assert property (@(posedge clk_i) disable iff (!rst_ni)
      valid_q[L-1] |-> queue_ready)
    else $error("an answer met a full queue");
`endif

  logic unused;
  assign unused = ^{queue_ready, req};
endmodule
`default_nettype wire
