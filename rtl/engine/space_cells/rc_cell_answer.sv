// The common end of the units whose nodes consist of cells: the box of the node's contents, the
// exits that the ray meets, their order, and the result queue. Part of rc_treelet, rc_slant and
// rc_bih, which have the valid bits and decide the planes.
//
// The node comes at stage In, its planes' results at stage Meet. The box's results wait for planes
// that take longer. Model: exits_met() in model/engine/space_cells/decide.hpp.
`default_nettype none
module rc_cell_answer #(
  parameter  int unsigned Latency = rc_pkg::TreeletLatency,   // the unit's, without its queue
  parameter  int unsigned Meet    = rc_pkg::PathCut + rc_pkg::PlaneStages,
  localparam int unsigned NodeWidth   = rc_pkg::NodeWidth,
  localparam int unsigned NodePlanes  = rc_pkg::NodePlanes,
  localparam int unsigned RayBits     = rc_pkg::RayBits,
  localparam int unsigned AddrBits    = rc_pkg::AddrBits,
  localparam int unsigned CountBits   = rc_pkg::CountBits,
  localparam int unsigned N           = rc_pkg::CoordBits,
  localparam int unsigned OriginWidth = rc_pkg::OriginWidth,
  localparam int unsigned R1          = rc_pkg::RecipBits + 1,
  localparam int unsigned ExpBits     = rc_pkg::ExpBits,
  localparam int unsigned TBits       = rc_pkg::TBits
) (
  input  logic            clk_i,
  input  logic            rst_ni,
  input  logic [Latency:0] valid_i,   // valid_i[i]: stage i holds a node
  // Ray: origin, signs, reciprocals and lengths of its direction
  input  logic [RayBits-1:0]             ray_i,
  input  logic [3*OriginWidth-1:0]       o_i,
  input  logic [2:0]                     neg_i,
  input  logic [3*R1-1:0]                recip_i,
  input  logic [3*ExpBits-1:0]           len_i,
  // Node: the box of its contents, and its exits
  input  logic                           open_i,    // there is no box
  input  logic [3*N-1:0]                 lo_i,
  input  logic [3*N-1:0]                 hi_i,
  input  logic [AddrBits-1:0]            base_i,
  input  logic [NodeWidth*CountBits-1:0] kind_i,
  // From each plane: the sides that the ray may be on, and when it changes sides
  input  logic [NodePlanes-1:0]          turned_i,
  input  logic [NodePlanes-1:0]          near_i,
  input  logic [NodePlanes-1:0]          far_i,
  input  logic [NodePlanes*TBits-1:0]    near_to_i,
  input  logic [NodePlanes*TBits-1:0]    far_from_i,
  // To trav
  output logic                       rsp_valid_o,
  input  logic                       rsp_ready_i,
  output logic [rc_pkg::NodeAnswerW-1:0] rsp_o
);
  // The stage in which the box's times are ready, and the cycles that they wait.
  localparam int unsigned In   = rc_pkg::PathCut;
  localparam int unsigned Box  = In + rc_pkg::PlaneStages + 1 + rc_pkg::PathCut;
  localparam int unsigned Wait = Meet + 1 + In - Box;

  if (Meet + 1 + In < Box) begin : gen_refuse
    $error("rc_cell_answer: planes must not be faster than the box");
  end

  // The times at which the ray enters and leaves the box.
  logic [TBits-1:0] enter, leave, box_enter, box_leave;
  logic             there, box_met;

  rc_bounds u_bounds (
    .clk_i, .valid_i(valid_i[Box-1:In]), .s0_o_i(o_i), .s0_neg_i(neg_i), .s0_recip_i(recip_i),
    .s0_len_i(len_i), .s0_open_i(open_i), .s0_lo_i(lo_i), .s0_hi_i(hi_i),
    .enter_o(enter), .leave_o(leave), .met_o(there));

  if (Wait == 0) begin : gen_in_time
    assign {box_enter, box_leave, box_met} = {enter, leave, there};
  end else begin : gen_early
    rc_shift_register #(.Width(2 * TBits + 1), .Stages(Wait)) u_wait (
      .clk_i, .enable_i(valid_i[Box+Wait-1:Box]), .data_i({enter, leave, there}),
      .data_o({box_enter, box_leave, box_met}));
  end

  // The exits that are met.
  logic [NodeWidth-1:0]       met;
  logic [NodeWidth*TBits-1:0] near;

  rc_exits u_exits (
    .clk_i, .valid_i(valid_i[Meet+In]), .turned_i, .near_i, .far_i, .near_to_i, .far_from_i,
    .enter_i(box_enter), .leave_i(box_leave), .met_i(box_met), .met_o(met), .near_o(near));

  // Their order, and the result queue.
  rc_node_answer #(.Latency(Latency), .Exits(1'b1)) u_answer (
    .clk_i, .rst_ni, .enable_i(valid_i[Latency-1:0]), .ray_i, .base_i, .kind_i,
    .met_i(met), .near_i(near), .end_valid_i(valid_i[Latency]), .rsp_valid_o, .rsp_ready_i, .rsp_o);
endmodule
`default_nettype wire
