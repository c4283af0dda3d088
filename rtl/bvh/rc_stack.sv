// The rays' stacks of sibling groups, and the decision where a ray goes next. Part of
// rc_trav. s0 reads the top group of a ray; in s1 the group is there, and either the
// nearest inner child of the node is visited and the others pushed, or the stack is popped.
// A stop empties the stack: the ray is done. One ray is never in both stages.
// Model: model/bvh/stack.cpp.
`default_nettype none
module rc_stack (
  input  logic                        clk_i,
  input  logic                        rst_ni,
  input  logic                        s0_valid_i,
  input  logic [rc_pkg::RayBits-1:0]  s0_ray_i,
  input  logic                        s1_valid_i,
  input  rc_pkg::tested_t             s1_tested_i,
  input  rc_pkg::children_t           s1_children_i,
  output logic                        visit_o,
  output logic [rc_pkg::AddrBits-1:0] visit_base_o,
  output logic [rc_pkg::SlotBits-1:0] visit_slot_o,
  output logic                        done_o,
  output logic                        again_o
);
  localparam int unsigned I  = rc_pkg::RayBits;
  localparam int unsigned A  = rc_pkg::AddrBits;
  localparam int unsigned T  = rc_pkg::TBits;
  localparam int unsigned S  = rc_pkg::SlotBits;
  localparam int unsigned G  = rc_pkg::GroupBits;
  localparam int unsigned W  = rc_pkg::NodeWidth;
  localparam int unsigned H  = rc_pkg::StackBits;
  localparam int unsigned D  = rc_pkg::StackDepth;
  localparam int unsigned DB = D < 2 ? 1 : $clog2(D);
  // {below, base, count, t_near of W - 1 siblings, their slots}
  localparam int unsigned GroupW = T + A + G + (W - 1) * (T + S);

  // Height of every ray's stack; each is empty again when its ray is done, and before the
  // first one: used_q says whether the memory holds a context's.
  logic [rc_pkg::Contexts-1:0] used_q;
  logic [H-1:0] s0_kept, s0_height, s1_height_q, height_d, level;
  rc_ram #(.Width(H), .Depth(rc_pkg::Contexts)) u_height (
    .clk_i, .write_i(s1_valid_i), .write_addr_i(s1_tested_i.ray), .write_data_i(height_d),
    .read_addr_i(s0_ray_i), .read_data_o(s0_kept));
  assign s0_height = used_q[s0_ray_i] ? s0_kept : '0;

  logic              write;
  logic [GroupW-1:0] group_d, group;
  rc_ram_sync #(.Width(GroupW), .Depth(rc_pkg::Contexts * D)) u_groups (
    .clk_i,
    .write_i(write), .write_addr_i(address(s1_tested_i.ray, level)), .write_data_i(group_d),
    .read_i(s0_valid_i), .read_addr_i(address(s0_ray_i, s0_height - H'(1))), .read_data_o(group));

  localparam int unsigned AddrW = rc_pkg::Contexts * D < 2 ? 1 : $clog2(rc_pkg::Contexts * D);
  function automatic logic [AddrW-1:0] address(input logic [I-1:0] of, input logic [H-1:0] at);
    address = AddrW'(({{DB{1'b0}}, of} << $clog2(D)) | {{(I+DB-H){1'b0}}, at & H'(D - 1)});
  endfunction

  logic [T-1:0]       top_below, below;
  logic [A-1:0]       top_base;
  logic [G-1:0]       top_count;
  logic [(W-1)*T-1:0] top_near;
  logic [(W-1)*S-1:0] top_slot;
  assign {top_below, top_base, top_count, top_near, top_slot} = group;

  logic [W*T-1:0] near;
  logic [W*S-1:0] slot;
  assign near = s1_children_i.t_near;
  assign slot = s1_children_i.slot;

  logic stop;
  if (rc_pkg::Shading != 0) begin : gen_stop
    assign stop = s1_tested_i.stop;
  end else begin : gen_go_on
    assign stop = 1'b0;
  end

  logic forward, last_sibling, top_matters;
  assign forward      = !stop && s1_children_i.inner != '0 && near[T-1:0] <= s1_tested_i.t_best;
  assign top_matters  = top_near[T-1:0] <= s1_tested_i.t_best;
  assign last_sibling = top_count == G'(1);

  always_comb begin
    below = '1;
    if (s1_height_q != '0) below = top_near[T-1:0] < top_below ? top_near[T-1:0] : top_below;
    visit_o      = 1'b0;
    done_o       = 1'b0;
    again_o      = 1'b0;
    write        = 1'b0;
    level        = s1_height_q;
    height_d     = s1_height_q;
    visit_base_o = forward ? s1_children_i.base : top_base;
    visit_slot_o = forward ? slot[S-1:0] : top_slot[S-1:0];
    group_d      = {below, s1_children_i.base, s1_children_i.inner - G'(1), near[W*T-1:T],
                    slot[W*S-1:S]};
    if (s1_valid_i && forward) begin
      visit_o = 1'b1;
      if (s1_children_i.inner != G'(1)) begin
        write    = 1'b1;
        height_d = s1_height_q + H'(1);
      end
    end else if (s1_valid_i && (stop || s1_height_q == '0)) begin
      done_o   = 1'b1;
      height_d = '0;
    end else if (s1_valid_i && top_matters) begin
      visit_o  = 1'b1;
      level    = s1_height_q - H'(1);
      write    = !last_sibling;
      group_d  = {top_below, top_base, top_count - G'(1), top_near >> T, top_slot >> S};
      if (last_sibling) height_d = s1_height_q - H'(1);
    end else if (s1_valid_i && (s1_height_q == H'(1) || top_below > s1_tested_i.t_best)) begin
      done_o   = 1'b1;
      height_d = '0;
    end else if (s1_valid_i) begin
      again_o  = 1'b1;
      height_d = s1_height_q - H'(1);
    end
  end

  always_ff @(posedge clk_i) begin
    if (s0_valid_i) s1_height_q <= s0_height;
    if (!rst_ni)         used_q <= '0;
    else if (s1_valid_i) used_q[s1_tested_i.ray] <= 1'b1;
  end

`ifndef SYNTHESIS
  a_room: assert property (@(posedge clk_i) disable iff (!rst_ni)
                           s1_valid_i && forward && s1_children_i.inner != G'(1)
                               |-> s1_height_q != H'(D))
    else $error("the scene needs a deeper stack than its compilation said");
  a_one_stage: assert property (@(posedge clk_i) disable iff (!rst_ni)
                                s0_valid_i && s1_valid_i |-> s0_ray_i != s1_tested_i.ray)
    else $error("a ray is in both stages of trav");
`endif
endmodule
`default_nettype wire
