// Ray-triangle test with exact decisions, and the comparison with the best hit.
//
// Latency rc_pkg::TriLatency + 1 (result queue), throughput 1 per cycle, answers in
// order. Model: model/isect/tri.hpp, which has the formulas, the tie rule and the
// proven widths. A triangle seen edge-on never hits.
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
  localparam int unsigned E    = rc_pkg::EdgeBits;
  localparam int unsigned U    = rc_pkg::NumBits;
  localparam int unsigned I    = rc_pkg::RayBits;
  localparam int unsigned P    = rc_pkg::PrimBits;
  localparam int unsigned L    = rc_pkg::TriLatency;
  localparam int unsigned Pre  = 6;                 // stages before the divisions
  localparam int unsigned TailW = 1 + U + E + P;     // closer, num, det, prim

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

  // s1..s4: edge functions and what they decide.
  logic                s4_hit;
  logic signed [E-1:0] s4_det, s4_u, s4_v;
  logic signed [U-1:0] s4_num;
  rc_edges u_edges (
    .clk_i, .s0_valid_i(admit), .s1_valid_i(valid_q[0]), .s2_valid_i(valid_q[1]),
    .s3_valid_i(valid_q[2]),
    .s0_o_i(req_i.o), .s0_d_i(req_i.d), .s0_a_i(req_i.a), .s0_b_i(req_i.b), .s0_c_i(req_i.c),
    .s4_hit_o(s4_hit), .s4_det_o(s4_det), .s4_num_o(s4_num), .s4_u_o(s4_u), .s4_v_o(s4_v));

  // s1..s4: number and hit to beat wait.
  localparam int unsigned BestW = P + 1 + U + E + P;
  logic [BestW-1:0] s4_best;
  rc_delay #(.Width(BestW), .Stages(4)) u_best (
    .clk_i, .valid_i({valid_q[2:0], admit}),
    .data_i({req_i.prim, req_i.found, req_i.best_num, req_i.best_det, req_i.best_prim}),
    .data_o(s4_best));

  logic [P-1:0]        s4_prim, s4_best_prim;
  logic                s4_found;
  logic signed [U-1:0] s4_best_num;
  logic signed [E-1:0] s4_best_det;
  assign {s4_prim, s4_found, s4_best_num, s4_best_det, s4_best_prim} = s4_best;

  // s5: num / det against best_num / best_det, cross-multiplied; all four are positive.
  logic                s5_hit_q, s5_found_q, s5_first_q;
  logic [U+E-1:0]      s5_mine_q, s5_theirs_q;
  logic [U-1:0]        s5_num_q;
  logic [E-1:0]        s5_det_q, s5_u_q, s5_v_q;
  logic [P-1:0]        s5_prim_q;
  always_ff @(posedge clk_i) begin
    if (valid_q[3]) s5_hit_q <= s4_hit;
    if (valid_q[3] && s4_hit) begin
      s5_found_q <= s4_found;
      s5_first_q <= s4_prim <= s4_best_prim;
      if (s4_found) begin
        s5_mine_q   <= {{E{1'b0}}, s4_num} * {{U{1'b0}}, s4_best_det};
        s5_theirs_q <= {{E{1'b0}}, s4_best_num} * {{U{1'b0}}, s4_det};
      end
      s5_num_q  <= s4_num;
      s5_det_q  <= s4_det;
      s5_u_q    <= s4_u;
      s5_v_q    <= s4_v;
      s5_prim_q <= s4_prim;
    end
  end

  // s6: closer, or as close with a lower number.
  logic           s5_closer, s6_closer_q;
  logic [U-1:0]   s6_num_q;
  logic [E-1:0]   s6_det_q, s6_u_q, s6_v_q;
  logic [P-1:0]   s6_prim_q;
  assign s5_closer = s5_hit_q && (!s5_found_q || s5_mine_q < s5_theirs_q
                                  || (s5_mine_q == s5_theirs_q && s5_first_q));
  always_ff @(posedge clk_i) begin
    if (valid_q[4]) s6_closer_q <= s5_closer;
    if (valid_q[4] && s5_closer) begin
      s6_num_q  <= s5_num_q;
      s6_det_q  <= s5_det_q;
      s6_u_q    <= s5_u_q;
      s6_v_q    <= s5_v_q;
      s6_prim_q <= s5_prim_q;
    end
  end

  // s7..: divisions; numerator, determinant and number wait.
  logic s6_divide;
  assign s6_divide = valid_q[Pre-1] && s6_closer_q;
  logic [rc_pkg::TBits-1:0]  t;
  logic [rc_pkg::BaryBits:0] u, v;
  rc_hitdiv u_hitdiv (
    .clk_i, .valid_i(s6_divide), .num_i(s6_num_q), .det_i(s6_det_q), .u_i(s6_u_q), .v_i(s6_v_q),
    .t_o(t), .u_o(u), .v_o(v));

  localparam int unsigned D = L - Pre;
  logic [D-1:0]     closer_q;
  logic [TailW-2:0] tail;
  always_ff @(posedge clk_i) closer_q <= {closer_q[D-2:0], s6_divide};
  rc_delay #(.Width(TailW - 1), .Stages(D)) u_tail (
    .clk_i, .valid_i({closer_q[D-2:0], s6_divide}), .data_i({s6_num_q, s6_det_q, s6_prim_q}),
    .data_o(tail));

  logic                       queue_ready, closer;
  logic [rc_pkg::TriRspW-1:0] queue_data, rsp_data;
  assign closer     = closer_q[D-1];
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
  assign unused = queue_ready;
endmodule
`default_nettype wire
