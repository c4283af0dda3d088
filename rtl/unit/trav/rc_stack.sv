// The rays' stacks of sibling groups, and the decision where a ray goes next. Part of rc_trav.
//
// s0 reads the top group of a ray. In s1 the group is ready. The ray then visits the nearest inner
// child of the node and pushes its siblings, or it pops the stack. A stop empties the stack: the
// ray is done. A ray is never in two stages.
//
// A fast chip has rc_pkg::StackStages more stages between s1 and the decision (`end`). The address,
// the memory, its output register and the comparisons take one cycle each. Model:
// model/unit/trav/stack.hpp.
`default_nettype none
module rc_stack (
  input  logic                        clk_i,
  input  logic                        rst_ni,
  // s0
  input  logic                        s0_valid_i,
  input  logic [rc_pkg::RayBits-1:0]  s0_ray_i,
  // s1
  input  logic                        s1_valid_i,
  input  rc_pkg::tested_t             s1_tested_i,
  input  rc_pkg::children_t           s1_children_i,
  // At the end: visit a node, done, or another turn
  output logic                        visit_o,
  output logic [rc_pkg::AddrBits-1:0] visit_base_o,
  output logic [rc_pkg::SlotBits-1:0] visit_slot_o,
  output logic                        done_o,
  output logic                        again_o
);
  localparam int unsigned RayBits    = rc_pkg::RayBits;
  localparam int unsigned TBits      = rc_pkg::TBits;
  localparam int unsigned SlotBits   = rc_pkg::SlotBits;
  localparam int unsigned GroupBits  = rc_pkg::GroupBits;
  localparam int unsigned NodeWidth  = rc_pkg::NodeWidth;
  localparam int unsigned StackBits  = rc_pkg::StackBits;
  localparam int unsigned StackDepth = rc_pkg::StackDepth;
  localparam int unsigned LevelW     = StackDepth < 2 ? 1 : $clog2(StackDepth);
  localparam int unsigned GroupW     = rc_pkg::StackGroupW;

  localparam int unsigned Late = rc_pkg::StackStages;
  localparam int unsigned Cut  = rc_pkg::PathCut;
  localparam int unsigned AddrW = rc_pkg::Contexts * StackDepth < 2
                                ? 1 : $clog2(rc_pkg::Contexts * StackDepth);

  // Height of each ray's stack. used: the memory holds the context's height; before its first ray
  // the height is 0. The address of the top group ignores `used`, because the group of an empty
  // stack is unused.
  logic [rc_pkg::Contexts-1:0] used;
  logic                 end_valid;
  logic [RayBits-1:0]   end_ray;
  logic [StackBits-1:0] s0_stored, s1_stored_q, stored, stored_height, end_height, height_d, level;
  logic                 is_used;   // of s1; in a fast chip a cycle later, like stored

  rc_ram #(.Width(StackBits), .Depth(rc_pkg::Contexts)) u_height (
    .clk_i, .write_i(end_valid), .write_addr_i(end_ray), .write_data_i(height_d),
    .read_addr_i(s0_ray_i), .read_data_o(s0_stored));

  rc_flags #(.Flags(rc_pkg::Contexts)) u_used (
    .clk_i, .rst_ni, .clear_i(1'b0), .clear_at_i(RayBits'(0)), .set_i(end_valid),
    .set_at_i(end_ray), .flags_o(used));

  rc_bit_select #(.Flags(rc_pkg::Contexts)) u_is_used (
    .clk_i, .flags_i(used), .index_i(s1_tested_i.ray), .flag_o(is_used));

  rc_path_register #(.Width(StackBits)) u_stored (.clk_i, .data_i(s1_stored_q), .data_o(stored));

  assign stored_height = is_used ? stored : '0;

  // Address of the top group: read in s0, in a fast chip in s1.
  logic                 write, read;
  logic [RayBits-1:0]   read_ray;
  logic [StackBits-1:0] read_height;
  logic [GroupW-1:0]    read_group, group_flat;
  rc_pkg::stack_group_t group_d, group;

  if (Cut == 0) begin : gen_read_now
    assign {read, read_ray, read_height} = {s0_valid_i, s0_ray_i, s0_stored};
  end else begin : gen_read_late
    assign {read, read_ray, read_height} = {s1_valid_i, s1_tested_i.ray, s1_stored_q};
  end

  function automatic logic [AddrW-1:0] address(input logic [RayBits-1:0] of,
                                               input logic [StackBits-1:0] at);
    address = AddrW'(({{LevelW{1'b0}}, of} << $clog2(StackDepth))
                     | {{(RayBits+LevelW-StackBits){1'b0}}, at & StackBits'(StackDepth - 1)});
  endfunction

  // Groups. A fast chip writes one cycle late; the ray's next read is much later.
  logic              write_late;
  logic [AddrW-1:0]  write_addr, late_addr;
  logic [GroupW-1:0] late_group;

  assign write_addr = address(end_ray, level);
  rc_path_register #(.Width(AddrW + GroupW)) u_late (
    .clk_i, .data_i({write_addr, group_d}), .data_o({late_addr, late_group}));

  if (Cut == 0) begin : gen_write_now
    assign write_late = write;
  end else begin : gen_write_late
    logic write_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni) write_q <= 1'b0;
      else         write_q <= write;
    end
    assign write_late = write_q;
  end

  rc_ram_sync #(.Width(GroupW), .Depth(rc_pkg::Contexts * StackDepth)) u_groups (
    .clk_i, .write_i(write_late), .write_addr_i(late_addr), .write_data_i(late_group),
    .read_i(read), .read_addr_i(address(read_ray, read_height - StackBits'(1))),
    .read_data_o(read_group));

  rc_path_register #(.Width(GroupW)) u_group (.clk_i, .data_i(read_group), .data_o(group_flat));
  assign group = group_flat;

  // Comparisons of the ray's step, its new children and its top group.
  logic [rc_pkg::TestedW-1:0]   tested_flat;
  logic [rc_pkg::ChildrenW-1:0] children_flat, end_children_flat;
  logic [StackBits-1:0]         height;
  rc_pkg::tested_t              tested;
  rc_pkg::children_t            children, end_children;

  rc_path_register #(.Width(rc_pkg::TestedW + rc_pkg::ChildrenW), .Stages(Late - Cut)) u_step (
    .clk_i, .data_i({s1_tested_i, s1_children_i}), .data_o({tested_flat, children_flat}));

  rc_path_register #(.Width(StackBits), .Stages(Late - 2 * Cut)) u_now_height (
    .clk_i, .data_i(stored_height), .data_o(height));

  assign tested   = tested_flat;
  assign children = children_flat;

  logic [TBits-1:0]                  top_below, below;
  logic [(NodeWidth-1)*TBits-1:0]    top_near;
  logic [NodeWidth*TBits-1:0]        near;
  logic                              stop, forward, top_matters, below_matters;

  assign top_below = group.below;
  assign top_near  = group.t_near;
  assign near      = children.t_near;

  if (rc_pkg::Shading) begin : gen_stop
    assign stop = tested.stop;
  end else begin : gen_go_on
    assign stop = 1'b0;
  end

  assign forward       = !stop && children.inner != '0 && near[TBits-1:0] <= tested.t_best;
  assign top_matters   = top_near[TBits-1:0] <= tested.t_best;
  assign below_matters = top_below <= tested.t_best;

  always_comb begin
    below = '1;
    if (height != '0) below = top_near[TBits-1:0] < top_below ? top_near[TBits-1:0] : top_below;
  end

  // The end: results of the comparisons, and the new group.
  logic                              end_stop, end_forward, end_top_matters, end_below_matters;
  logic [TBits-1:0]                  end_below;
  logic [GroupW-1:0]                 end_group_flat;
  rc_pkg::stack_group_t              end_group;
  logic [(NodeWidth-1)*TBits-1:0]    end_group_near;
  logic [(NodeWidth-1)*SlotBits-1:0] end_group_slot;

  rc_path_register #(.Width(4 + TBits + GroupW + rc_pkg::ChildrenW + StackBits + RayBits)) u_end (
    .clk_i,
    .data_i({stop, forward, top_matters, below_matters, below, group_flat, children_flat, height,
             tested.ray}),
    .data_o({end_stop, end_forward, end_top_matters, end_below_matters, end_below,
             end_group_flat, end_children_flat, end_height, end_ray}));

  assign end_children   = end_children_flat;
  assign end_group      = end_group_flat;
  assign end_group_near = end_group.t_near;
  assign end_group_slot = end_group.slot;

  if (Late == 0) begin : gen_end_now
    assign end_valid = s1_valid_i;
  end else begin : gen_end_late
    logic [Late-1:0] valid_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni) valid_q <= '0;
      else         valid_q <= {valid_q[Late-2:0], s1_valid_i};
    end
    assign end_valid = valid_q[Late-1];
  end

  logic [NodeWidth*TBits-1:0]    end_near;
  logic [NodeWidth*SlotBits-1:0] end_slot;
  logic                          last_sibling;

  assign end_near     = end_children.t_near;
  assign end_slot     = end_children.slot;
  assign last_sibling = end_group.count == GroupBits'(1);

  // Decision: visit a child, pop a sibling, end the ray, or drop the group.
  always_comb begin
    visit_o      = 1'b0;
    done_o       = 1'b0;
    again_o      = 1'b0;
    write        = 1'b0;
    level        = end_height;
    height_d     = end_height;

    visit_base_o = end_forward ? end_children.base : end_group.base;
    visit_slot_o = end_forward ? end_slot[SlotBits-1:0] : end_group_slot[SlotBits-1:0];

    // The siblings of the visited child.
    group_d.below  = end_below;
    group_d.base   = end_children.base;
    group_d.count  = end_children.inner - GroupBits'(1);
    group_d.t_near = end_near[NodeWidth*TBits-1:TBits];
    group_d.slot   = end_slot[NodeWidth*SlotBits-1:SlotBits];

    if (end_valid && end_forward) begin
      visit_o = 1'b1;
      if (end_children.inner != GroupBits'(1)) begin
        write    = 1'b1;
        height_d = end_height + StackBits'(1);
      end
    end else if (end_valid && (end_stop || end_height == '0)) begin
      done_o   = 1'b1;
      height_d = '0;
    end else if (end_valid && end_top_matters) begin
      visit_o  = 1'b1;
      level    = end_height - StackBits'(1);
      write    = !last_sibling;

      group_d        = end_group;
      group_d.count  = end_group.count - GroupBits'(1);
      group_d.t_near = end_group_near >> TBits;
      group_d.slot   = end_group_slot >> SlotBits;
      if (last_sibling) height_d = end_height - StackBits'(1);
    end else if (end_valid && (end_height == StackBits'(1) || !end_below_matters)) begin
      done_o   = 1'b1;
      height_d = '0;
    end else if (end_valid) begin
      again_o  = 1'b1;
      height_d = end_height - StackBits'(1);
    end
  end

  always_ff @(posedge clk_i) if (s0_valid_i) s1_stored_q <= s0_stored;

  logic unused;   // partly unused: only compared
  assign unused = ^{children, near, group, top_near, end_near};

`ifndef SYNTHESIS
  always_ff @(posedge clk_i)
    if (rst_ni && end_valid && end_forward && end_children.inner != GroupBits'(1))
      a_room: assert (end_height != StackBits'(StackDepth))
      else $error("the scene needs a deeper stack than its compilation said");

  logic [rc_pkg::Contexts-1:0] inside_q;   // rays between s0 and the end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) inside_q <= '0;
    else begin
      if (end_valid)  inside_q[end_ray] <= 1'b0;
      if (s0_valid_i) inside_q[s0_ray_i] <= 1'b1;
    end
  end
  always_ff @(posedge clk_i) if (rst_ni && s0_valid_i)
    a_one_stage: assert (!inside_q[s0_ray_i])
    else $error("a ray is in two stages of trav");
  always_ff @(posedge clk_i) if (rst_ni && write_late && read)
    a_apart: assert (late_addr[AddrW-1 -: RayBits] != read_ray)
    else $error("a ray's group is written while it is read");
`endif
endmodule
`default_nettype wire
