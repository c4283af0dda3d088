// The walk through the tree. Of the children that the ray meets, the leaves go to list and the
// inner children wait here. After list has tested the leaves and returned the distance to beat, the
// ray takes a step. If no leaf can matter it takes the step immediately. A step visits the nearest
// inner child that can still matter, and pushes its siblings on the ray's stack as one group. If no
// inner child can matter, the step pops the stack.
//
// An answer of box is accepted in every cycle, and passes three stages. A signal's prefix names its
// stage.
//
// - rsp0 is box's answer.
// - rsp1 moves the leaves to the front, and compares them with the distance to beat.
// - rsp2 sends the leaves to list, which always accepts them, and stores the inner children.
//
// In a relaxed chip the stages lie in one cycle. In a fast chip there is a register before rsp1 and
// rsp2. Rays without leaves wait in a separate queue; rays that list has tested go first.
//
// Stage 0 accepts a step and reads the top of the ray's stack. Stage 1 decides the next node or the
// ray's end. A popped group whose nearest child is too far passes through both stages again, before
// new steps. `below` is the smallest t_near of all groups under the popped one. If `below` is too
// far as well, the ray ends instead.
//
// A new ray starts at the root when no other node waits. A node from memory goes on to box, with
// its ray, in the same cycle.
//
// With two levels an instance from memory goes on to xform, with the original ray. The transformed
// ray is stored in a second memory, and goes on to the root of the mesh before new rays start. The
// stack and the distance to beat stay. The line's kind, node of the scene or node of a mesh,
// selects which of the two rays box gets. If scene and meshes have different structures, each has
// its own unit (decide, mesh), and both units' answers share one link.
//
// Model: model/unit/trav/trav.hpp. The compiled scene must not need more than StackDepth groups.
`default_nettype none
module rc_trav (
  input  logic                           clk_i,
  input  logic                           rst_ni,
  input  rc_pkg::frame_t                 frame_i,
  // From raygen: a ray starts, and a ray arrives
  input  logic                           start_fires_i,
  input  rc_pkg::start_t                 start_i,
  input  logic                           ray_valid_i,
  output logic                           ray_ready_o,
  input  rc_pkg::ray_t                   ray_i,
  // To and from node_cache
  output logic                           node_req_valid_o,
  input  logic                           node_req_ready_i,
  output rc_pkg::node_req_t              node_req_o,
  input  logic                           node_rsp_valid_i,
  output logic                           node_rsp_ready_o,
  input  rc_pkg::node_rsp_t              node_rsp_i,
  // In a fast chip: the next one comes, and its ray
  input  logic                           node_next_fires_i,
  input  logic [rc_pkg::RayBits-1:0]     node_next_i,
  // To and from the node unit
  output logic                           node_unit_req_valid_o,
  input  logic                           node_unit_req_ready_i,
  output logic [rc_pkg::NodeReqBits-1:0] node_unit_req_o,
  input  logic                           node_unit_rsp_valid_i,
  output logic                           node_unit_rsp_ready_o,
  input  rc_pkg::node_answer_t           node_unit_rsp_i,
  // With two structures: to the node unit of the meshes
  output logic                           mesh_req_valid_o,
  input  logic                           mesh_req_ready_i,
  output logic [rc_pkg::MeshReqBits-1:0] mesh_req_o,
  // To and from list
  output logic                           leaves_fires_o,
  output rc_pkg::leaves_t                leaves_o,
  input  logic                           tested_valid_i,
  output logic                           tested_ready_o,
  input  rc_pkg::tested_t                tested_i,
  output logic                           done_valid_o,
  input  logic                           done_ready_i,
  output rc_pkg::done_t                  done_o,
  output logic                           done_next_fires_o,  // in a fast chip: the next one comes
  output rc_pkg::done_t                  done_next_o,
  // What it did: rc_pkg::trav_cause_e
  output logic [rc_pkg::CauseBits-1:0]   cause_o,
  // With two levels: to and from xform
  output logic                           xform_req_valid_o,
  input  logic                           xform_req_ready_i,
  output rc_pkg::xform_req_t             xform_req_o,
  input  logic                           change_fires_i,
  input  rc_pkg::change_t                change_i
);
  localparam int unsigned RayBits    = rc_pkg::RayBits;
  localparam int unsigned AddrBits   = rc_pkg::AddrBits;
  localparam int unsigned Contexts   = rc_pkg::Contexts;
  localparam int unsigned RayDirBits = rc_pkg::RayDirBits;
  localparam int unsigned TBits      = rc_pkg::TBits;
  localparam int unsigned SlotBits   = rc_pkg::SlotBits;
  localparam int unsigned NodeWidth  = rc_pkg::NodeWidth;
  localparam int unsigned OffsetBits = rc_pkg::OffsetBits;
  localparam int unsigned CountBits  = rc_pkg::CountBits;

  // ---- Rays. Their fields for the node unit wait here for the ray's nodes.
  localparam int unsigned NodeRayW = rc_pkg::NodeUnitRayW;

  logic                    ray_fires, fields_valid;
  logic [3*RayDirBits-1:0] ray_d;
  logic [RayBits-1:0]      fields_ray;
  logic [NodeRayW-1:0]     new_fields, fields_flat;
  rc_pkg::node_unit_ray_t  ray_fields;

  assign ray_fires = ray_valid_i && ray_ready_o;
  assign ray_d     = ray_i.d;

  // DirBits only: shadow rays fill RayDirBits.
  logic is_short;

  if (rc_pkg::Shading) begin : gen_kinds
    assign is_short = ray_i.kind != rc_pkg::RayShadow;
  end else begin : gen_camera
    assign is_short = 1'b1;
  end

  rc_node_ray u_node_ray (
    .clk_i, .rst_ni, .valid_i(ray_fires), .ray_i(ray_i.ray), .o_i(ray_i.o), .d_i(ray_d),
    .recip_i(ray_i.recip), .len_i(ray_i.len), .short_i(is_short),
    .valid_o(fields_valid), .ray_o(fields_ray), .fields_o(new_fields));

  rc_ram_prefetch #(.Width(NodeRayW), .Depth(Contexts)) u_ray (
    .clk_i, .rst_ni, .write_i(fields_valid), .write_addr_i(fields_ray), .write_data_i(new_fields),
    .head_addr_i(node_rsp_i.ray), .next_fires_i(node_next_fires_i),
    .next_addr_i(node_next_i), .read_data_o(fields_flat));

  assign ray_fields = fields_flat;

  // ---- Nodes from memory, with their rays.
  logic [rc_pkg::NodeRspW-1:0] node_rsp;   // {ray, node}: the node's format is unknown here
  rc_pkg::node_unit_req_t      node_unit_req;
  rc_pkg::mesh_req_t           mesh_req;
  rc_pkg::xform_ray_t          new_xform_ray, xform_ray;   // what xform needs, without the origin
  rc_pkg::xform_req_t          xform_req;

  assign node_rsp           = node_rsp_i;
  assign node_unit_req.ray  = node_rsp_i.ray;
  assign node_unit_req.node = node_rsp[rc_pkg::NodeBits-1:0];
  assign node_unit_req_o    = node_unit_req;

  if (rc_pkg::Levels == 1) begin : gen_nodes
    assign node_unit_req.ray_fields                        = ray_fields;
    assign node_unit_req_valid_o                           = node_rsp_valid_i;
    assign node_rsp_ready_o                                = node_unit_req_ready_i;
    assign mesh_req_valid_o                                = 1'b0;
    assign mesh_req_o                                      = '0;
    assign xform_req_valid_o                               = 1'b0;
    assign xform_req_o                                     = '0;
    assign {mesh_req, new_xform_ray, xform_ray, xform_req} = '0;

    logic unused;
    assign unused = ^{xform_req_ready_i, mesh_req_ready_i, mesh_req, new_xform_ray, xform_ray,
                      xform_req};
  end else begin : gen_instances
    localparam int unsigned XformRayW = rc_pkg::XformRayW;
    localparam int unsigned MeshRayW  = rc_pkg::MeshRayW;
    logic [XformRayW-1:0] xform_ray_flat;
    logic                 mesh_fields_valid, mesh_is_short, in_mesh, is_instance;
    logic [RayBits-1:0]   mesh_fields_ray;
    logic [MeshRayW-1:0]  new_mesh_fields, mesh_ray_fields;

    assign new_xform_ray.d = ray_d;

    if (rc_pkg::HasHomes) begin : gen_homes
      assign new_xform_ray.kind   = ray_i.kind;
      assign new_xform_ray.home   = ray_i.home;
      assign new_xform_ray.home_o = ray_i.home_o;
      assign new_xform_ray.home_d = ray_i.home_d;
      assign mesh_is_short        = change_i.kind != rc_pkg::RayShadow;
    end else begin : gen_no_homes
      assign mesh_is_short = 1'b1;
    end

    rc_node_ray #(.Structure(rc_pkg::MeshStructure), .FieldsW(MeshRayW)) u_change (
      .clk_i, .rst_ni, .valid_i(change_fires_i), .ray_i(change_i.ray), .o_i(change_i.o),
      .d_i(change_i.d), .recip_i(change_i.recip), .len_i(change_i.len), .short_i(mesh_is_short),
      .valid_o(mesh_fields_valid), .ray_o(mesh_fields_ray), .fields_o(new_mesh_fields));

    rc_ram_prefetch #(.Width(XformRayW), .Depth(Contexts)) u_xform_ray (
      .clk_i, .rst_ni, .write_i(ray_fires), .write_addr_i(ray_i.ray),
      .write_data_i(new_xform_ray), .head_addr_i(node_rsp_i.ray),
      .next_fires_i(node_next_fires_i), .next_addr_i(node_next_i), .read_data_o(xform_ray_flat));

    rc_ram_prefetch #(.Width(MeshRayW), .Depth(Contexts)) u_mesh_ray (
      .clk_i, .rst_ni, .write_i(mesh_fields_valid), .write_addr_i(mesh_fields_ray),
      .write_data_i(new_mesh_fields), .head_addr_i(node_rsp_i.ray),
      .next_fires_i(node_next_fires_i), .next_addr_i(node_next_i), .read_data_o(mesh_ray_fields));

    assign xform_ray         = xform_ray_flat;
    assign in_mesh           = node_rsp_i.what == rc_pkg::LineMeshNode;
    assign is_instance       = node_rsp_i.what == rc_pkg::LinePlacement;
    assign xform_req_valid_o = node_rsp_valid_i && is_instance;

    if (rc_pkg::MeshStructure == rc_pkg::Structure) begin : gen_same
      assign node_unit_req.ray_fields = in_mesh ? mesh_ray_fields : ray_fields;
      assign node_unit_req_valid_o    = node_rsp_valid_i && !is_instance;
      assign node_rsp_ready_o         = is_instance ? xform_req_ready_i : node_unit_req_ready_i;
      assign mesh_req_valid_o         = 1'b0;
      assign mesh_req                 = '0;
      assign mesh_req_o               = '0;

      logic unused;
      assign unused = ^{mesh_req_ready_i, mesh_req};
    end else begin : gen_own
      assign mesh_req.ray        = node_rsp_i.ray;
      assign mesh_req.ray_fields = mesh_ray_fields;
      assign mesh_req.node       = node_rsp[rc_pkg::MeshNodeBits-1:0];

      assign node_unit_req.ray_fields = ray_fields;
      assign node_unit_req_valid_o    = node_rsp_valid_i && !is_instance && !in_mesh;
      assign mesh_req_valid_o         = node_rsp_valid_i && in_mesh;
      assign mesh_req_o               = mesh_req;
      assign node_rsp_ready_o         = is_instance ? xform_req_ready_i
                                      : in_mesh     ? mesh_req_ready_i : node_unit_req_ready_i;
    end

    // The fields of the instance lie lowest in a request.
    always_comb begin
      xform_req     = rc_pkg::XformReqW'(node_rsp[rc_pkg::PlacementW-1:0]);
      xform_req.ray = node_rsp_i.ray;
      xform_req.o   = ray_fields.o;
      xform_req.d   = xform_ray.d;
    end

    if (rc_pkg::HasHomes) begin : gen_home_request
      always_comb begin
        xform_req_o        = xform_req;
        xform_req_o.kind   = xform_ray.kind;
        xform_req_o.home   = xform_ray.home;
        xform_req_o.home_o = xform_ray.home_o;
        xform_req_o.home_d = xform_ray.home_d;
      end
    end else begin : gen_request
      assign xform_req_o = xform_req;
    end

`ifndef SYNTHESIS
    always_ff @(posedge clk_i) if (rst_ni && mesh_fields_valid && node_rsp_valid_i)
      a_mesh_ray_first: assert (mesh_fields_ray != node_rsp_i.ray)
      else $error("a mesh's node is there before the ray in its space");
`endif
  end

  // ---- Answers: the node unit's answer (rsp0, then rsp1), and the ray's distance to beat.
  rc_pkg::node_answer_t           rsp1;
  logic [rc_pkg::NodeAnswerW-1:0] rsp0, rsp1_flat;
  logic                           rsp0_fires, rsp2_fires;
  logic [TBits-1:0]               rsp1_t_best;

  assign rsp0                  = node_unit_rsp_i;
  assign rsp0_fires            = node_unit_rsp_valid_i;
  assign node_unit_rsp_ready_o = 1'b1;

  logic [NodeWidth-1:0] rsp1_within;   // children that lie no farther

  rc_t_best #(.Nears(NodeWidth)) u_t_best (
    .clk_i, .rst_ni, .start_fires_i, .start_i,
    .write_i(tested_valid_i && tested_ready_o), .write_ray_i(tested_i.ray),
    .write_t_best_i(tested_i.t_best), .read_ray_i(node_unit_rsp_i.ray),
    .read_t_best_o(rsp1_t_best), .near_i(rsp1.t_near), .within_o(rsp1_within));

  rc_path_register #(.Width(rc_pkg::NodeAnswerW)) u_rsp1 (
    .clk_i, .data_i(rsp0), .data_o(rsp1_flat));
  assign rsp1 = rsp1_flat;

  // Leaves: moved to the front of the entries.
  logic [SlotBits-1:0]             rsp1_inner;
  logic [NodeWidth*TBits-1:0]      leaf_near;
  logic [NodeWidth*OffsetBits-1:0] rsp1_offset, leaf_offset;
  logic [NodeWidth*CountBits-1:0]  leaf_count;
  logic [NodeWidth*SlotBits-1:0]   rsp1_slot;

  assign rsp1_inner  = rsp1.inner[SlotBits-1:0];   // NodeWidth inner children leave no leaves
  assign rsp1_offset = rsp1.offset;

  always_comb begin
    leaf_near   = rsp1.t_near;
    leaf_offset = rsp1.offset;
    leaf_count  = rsp1.count;
    for (int b = 0; b < SlotBits; b++)
      if (rsp1_inner[b]) begin
        leaf_near   = leaf_near >> (TBits << b);
        leaf_offset = leaf_offset >> (OffsetBits << b);
        leaf_count  = leaf_count >> (CountBits << b);
      end
  end

  for (genvar i = 0; i < NodeWidth; i++) begin : gen_slot   // an inner child is a line, two halves
    assign rsp1_slot[i*SlotBits +: SlotBits] = rsp1_offset[i*OffsetBits + 1 +: SlotBits];
  end

  rc_pkg::leaves_t              rsp1_leaves, leaves;
  rc_pkg::children_t            rsp1_children;
  logic [rc_pkg::LeavesW-1:0]   leaves_flat;
  logic [rc_pkg::ChildrenW-1:0] children;
  logic [TBits-1:0]             leaves_t_best;

  assign rsp1_leaves.ray    = rsp1.ray;
  assign rsp1_leaves.base   = rsp1.base;
  assign rsp1_leaves.leaves = rsp1.leaves;
  assign rsp1_leaves.t_near = leaf_near;
  assign rsp1_leaves.offset = leaf_offset;
  assign rsp1_leaves.count  = leaf_count;

  assign rsp1_children.base   = rsp1.base;
  assign rsp1_children.inner  = rsp1.inner;
  assign rsp1_children.t_near = rsp1.t_near;
  assign rsp1_children.slot   = rsp1_slot;

  rc_path_register #(.Width(rc_pkg::LeavesW + rc_pkg::ChildrenW + TBits)) u_moved (
    .clk_i, .data_i({rsp1_leaves, rsp1_children, rsp1_t_best}),
    .data_o({leaves_flat, children, leaves_t_best}));
  assign leaves = leaves_flat;

  // Leaves go to list if the nearest can matter. A fast chip compares all children one cycle
  // earlier, and selects the nearest leaf's result. A few hundred cells of list get it from a
  // register.
  logic                       leafless_fires;
  logic [NodeWidth*TBits-1:0] leaves_near;

  assign leaves_near = leaves.t_near;

  if (rc_pkg::PathCut == 0) begin : gen_in_now
    logic matters;
    assign matters        = leaves.leaves != '0 && leaves_near[TBits-1:0] <= leaves_t_best;
    assign rsp2_fires     = rsp0_fires;
    assign leaves_fires_o = rsp2_fires && matters;
    assign leafless_fires = rsp2_fires && !matters;
  end else begin : gen_in_late   // two registers
    logic matters, rsp1_fires_q, rsp2_fires_q, leaves_fires_q, leafless_fires_q;

    always_comb begin
      matters = 1'b0;
      for (int i = 0; i < NodeWidth; i++)
        if (rsp1_inner == SlotBits'(i) && rsp1_within[i]) matters = rsp1.leaves != '0;
    end

    always_ff @(posedge clk_i) begin
      rsp1_fires_q     <= rst_ni && rsp0_fires;
      rsp2_fires_q     <= rst_ni && rsp1_fires_q;
      leaves_fires_q   <= rst_ni && rsp1_fires_q && matters;
      leafless_fires_q <= rst_ni && rsp1_fires_q && !matters;
    end

    assign rsp2_fires     = rsp2_fires_q;
    assign leaves_fires_o = leaves_fires_q;
    assign leafless_fires = leafless_fires_q;
  end

  assign leaves_o = leaves;

  // ---- Steps: rays whose leaves are tested, and rays without leaves.
  logic               leafless_valid, leafless_ready, step_valid, step_ready;
  logic [RayBits-1:0] leafless_ray;
  logic [TBits-1:0]   leafless_t_best;
  rc_pkg::tested_t    leafless;

  rc_queue #(.Width(RayBits + TBits), .Depth(Contexts)) u_leafless (
    .clk_i, .rst_ni, .push_i(leafless_fires), .data_i({leaves.ray, leaves_t_best}),
    .valid_o(leafless_valid), .pop_i(leafless_valid && leafless_ready),
    .data_o({leafless_ray, leafless_t_best}));

  always_comb begin
    leafless        = '0;
    leafless.ray    = leafless_ray;
    leafless.t_best = leafless_t_best;
  end

  rc_pkg::tested_t            step;
  logic [rc_pkg::TestedW-1:0] step_flat;

  rc_priority_merge #(.Width(rc_pkg::TestedW)) u_step (
    .clk_i, .rst_ni,
    .first_valid_i(tested_valid_i), .first_ready_o(tested_ready_o), .first_i(tested_i),
    .second_valid_i(leafless_valid), .second_ready_o(leafless_ready), .second_i(leafless),
    .valid_o(step_valid), .ready_i(step_ready), .data_o(step_flat));

  assign step = step_flat;

  // A ray in recirculation counts as work if no step waits behind it.
  always_comb begin
    if (step_valid) cause_o = step_ready ? rc_pkg::TravBusyWork : rc_pkg::TravStalledRecirculation;
    else            cause_o = step_ready ? rc_pkg::TravStarvedList : rc_pkg::TravBusyWork;
  end

  // ---- Stage 0 of a step. A returning ray has priority over a new step. It has no new children
  // and no stop.
  logic               again_q, step_fires;
  logic [RayBits-1:0] again_ray_q, s0_ray;
  logic [TBits-1:0]   again_t_best_q;
  rc_pkg::tested_t    again_tested;

  assign step_ready = !again_q;
  assign step_fires = step_valid && step_ready;
  assign s0_ray     = again_q ? again_ray_q : step.ray;

  always_comb begin
    again_tested        = '0;
    again_tested.ray    = again_ray_q;
    again_tested.t_best = again_t_best_q;
  end

  // ---- Stage 1 of a step: the ray's children.
  logic                         s1_valid_q, s1_again_q;
  logic [rc_pkg::TestedW-1:0]   s1_tested_q, end_tested_flat;
  logic [rc_pkg::ChildrenW-1:0] stored_children, s1_children;   // inner children of each ray's node
  rc_pkg::tested_t              s1_tested, end_tested;

  assign s1_tested   = s1_tested_q;
  assign s1_children = s1_again_q ? '0 : stored_children;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) s1_valid_q <= 1'b0;
    else         s1_valid_q <= again_q || step_fires;
    s1_again_q <= again_q;
    if (again_q)         s1_tested_q <= again_tested;
    else if (step_fires) s1_tested_q <= step;
  end

  rc_ram_prefetch #(.Width(rc_pkg::ChildrenW), .Depth(Contexts)) u_children (
    .clk_i, .rst_ni, .write_i(rsp2_fires), .write_addr_i(leaves.ray), .write_data_i(children),
    .head_addr_i(s1_tested.ray), .next_fires_i(step_fires), .next_addr_i(step.ray),
    .read_data_o(stored_children));

  rc_path_register #(.Width(rc_pkg::TestedW), .Stages(rc_pkg::StackStages)) u_wait (
    .clk_i, .data_i(s1_tested_q), .data_o(end_tested_flat));
  assign end_tested = end_tested_flat;

  // ---- Last stage of a step: the stack decides.
  logic                visit, done, again;
  logic [AddrBits-1:0] visit_base;
  logic [SlotBits-1:0] visit_slot;

  rc_stack u_stack (
    .clk_i, .rst_ni, .s0_valid_i(again_q || step_fires), .s0_ray_i(s0_ray),
    .s1_valid_i(s1_valid_q), .s1_tested_i(s1_tested), .s1_children_i(s1_children),
    .visit_o(visit), .visit_base_o(visit_base), .visit_slot_o(visit_slot), .done_o(done),
    .again_o(again));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) again_q <= 1'b0;
    else         again_q <= again;
    if (again) again_ray_q    <= end_tested.ray;
    if (again) again_t_best_q <= end_tested.t_best;
  end

  // ---- Nodes to fetch. New rays wait for a gap.
  logic                        visit_valid, visit_ready, spawn_valid, spawn_ready, root_valid;
  logic                        root_ready;
  logic [RayBits+AddrBits-1:0] visit_data, root_data;
  logic [RayBits-1:0]          spawn_ray;

  rc_queue #(.Width(RayBits + AddrBits), .Depth(Contexts)) u_visit (
    .clk_i, .rst_ni, .push_i(visit),
    .data_i({end_tested.ray, visit_base + {{(AddrBits-SlotBits){1'b0}}, visit_slot}}),
    .valid_o(visit_valid), .pop_i(visit_valid && visit_ready), .data_o(visit_data));

  rc_fifo #(.Width(RayBits), .Depth(2)) u_spawn (
    .clk_i, .rst_ni, .valid_i(ray_valid_i), .ready_o(ray_ready_o), .data_i(ray_i.ray),
    .valid_o(spawn_valid), .ready_i(spawn_ready), .data_o(spawn_ray));

  if (rc_pkg::Levels == 1) begin : gen_new
    assign root_valid  = spawn_valid;
    assign spawn_ready = root_ready;
    assign root_data   = {spawn_ray, frame_i.root};
  end else begin : gen_changed   // roots of meshes first
    logic                        mesh_valid, mesh_ready;
    logic [RayBits+AddrBits-1:0] mesh_data;

    rc_queue #(.Width(RayBits + AddrBits), .Depth(Contexts)) u_mesh (
      .clk_i, .rst_ni, .push_i(change_fires_i), .data_i({change_i.ray, change_i.root}),
      .valid_o(mesh_valid), .pop_i(mesh_valid && mesh_ready), .data_o(mesh_data));

    rc_priority_merge #(.Width(RayBits + AddrBits)) u_root (
      .clk_i, .rst_ni,
      .first_valid_i(mesh_valid), .first_ready_o(mesh_ready), .first_i(mesh_data),
      .second_valid_i(spawn_valid), .second_ready_o(spawn_ready),
      .second_i({spawn_ray, frame_i.root}),
      .valid_o(root_valid), .ready_i(root_ready), .data_o(root_data));
  end

  rc_priority_merge #(.Width(RayBits + AddrBits)) u_node (
    .clk_i, .rst_ni,
    .first_valid_i(visit_valid), .first_ready_o(visit_ready), .first_i(visit_data),
    .second_valid_i(root_valid), .second_ready_o(root_ready), .second_i(root_data),
    .valid_o(node_req_valid_o), .ready_i(node_req_ready_i), .data_o(node_req_o));

  // ---- Rays that end. A fast chip reports them from a register, because list reads its results
  // with it.
  logic               done_place, ends;
  logic [RayBits-1:0] ends_ray;

  rc_pulse_register u_ends (.clk_i, .rst_ni, .fires_i(done), .fires_o(ends));
  rc_path_register #(.Width(RayBits)) u_ends_ray (
    .clk_i, .data_i(end_tested.ray), .data_o(ends_ray));

  rc_fifo_peek #(.Width(RayBits), .Depth(Contexts < 2 ? 2 : Contexts), .Second(1)) u_done (
    .clk_i, .rst_ni, .valid_i(ends), .ready_o(done_place), .data_i(ends_ray),
    .valid_o(done_valid_o), .ready_i(done_ready_i), .data_o(done_o),
    .next_fires_o(done_next_fires_o), .next_o(done_next_o));

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni && fields_valid && node_rsp_valid_i)
    a_ray_first: assert (fields_ray != node_rsp_i.ray)
    else $error("a ray's node is there before the ray");
  always_ff @(posedge clk_i) if (rst_ni && ends) a_done_never_full: assert (done_place)
    else $error("a queue that cannot overflow did");
`endif

  // Fields of a ray that only tri uses.
  logic [rc_pkg::RayW-1:0]    ray_flat;
  logic [rc_pkg::FrameW-1:0]  frame_flat;
  logic [rc_pkg::ChangeW-1:0] change_flat;
  logic                       unused;

  assign ray_flat    = ray_i;
  assign frame_flat  = frame_i;
  assign change_flat = change_i;
  assign unused      = ^{done_place, is_short, node_rsp, ray_flat, frame_flat, change_fires_i,
                         change_flat, rsp1_offset, end_tested, leaves_near, rsp1_within};
endmodule
`default_nettype wire
