// The node unit of a structure. A new engine adds a line here. Part of rc_tree.
//
// Only box may be occupied for a few cycles after each node. The answer comes Pad cycles later than
// the unit's own, and must be accepted in that cycle.
`default_nettype none
module rc_node_unit #(
  parameter int unsigned Structure = rc_pkg::Structure,
  parameter int unsigned ReqW      = rc_pkg::NodeReqBits,
  parameter int unsigned Pad       = 0
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  // From trav
  input  logic             req_valid_i,
  output logic             req_ready_o,
  input  logic [ReqW-1:0]  req_i,
  input  logic             open_i,       // the credit counter that two units share is open
  // To trav
  output logic             rsp_valid_o,
  output rc_pkg::node_answer_t rsp_o,
  // In: its cache waits for memory. Out: what it did, rc_pkg::node_unit_cause_e.
  input  logic             node_waits_i,
  output logic [rc_pkg::CauseBits-1:0] cause_o
);
  logic                       req_valid, ready, occupied, valid;
  rc_pkg::node_answer_t       own;
  logic [rc_pkg::NodeAnswerW-1:0] own_flat, rsp_flat;

  // A unit that accepts a node in every cycle.
`define RC_NODE_UNIT(STRUCTURE, UNIT) \
  if (Structure == rc_pkg::STRUCTURE) begin : gen_``UNIT \
    rc_``UNIT u_``UNIT ( \
      .clk_i, .rst_ni, .req_valid_i(req_valid), .req_ready_o(ready), .req_i, .rsp_valid_o(valid), \
      .rsp_ready_i(1'b1), .rsp_o(own)); \
  end

  `RC_NODE_UNIT(StructureKd, treelet)
  `RC_NODE_UNIT(StructureSpheres, globe)
  `RC_NODE_UNIT(StructureBsp, slant)
  `RC_NODE_UNIT(StructureBih, bih)
`undef RC_NODE_UNIT

  if (Structure == rc_pkg::StructureBvh) begin : gen_box
    rc_box u_box (
      .clk_i, .rst_ni, .req_valid_i(req_valid), .req_ready_o(ready), .req_i, .occupied_o(occupied),
      .rsp_valid_o(valid), .rsp_ready_i(1'b1), .rsp_o(own));
  end else begin : gen_never_occupied
    assign occupied = 1'b0;
  end

  assign req_valid   = req_valid_i && open_i;
  assign req_ready_o = ready && open_i;

  // Padding of the answer.
  assign own_flat = own;

  rc_pulse_register #(.Stages(Pad)) u_waits (
    .clk_i, .rst_ni, .fires_i(valid), .fires_o(rsp_valid_o));
  rc_path_register #(.Width(rc_pkg::NodeAnswerW), .Stages(Pad)) u_answer (
    .clk_i, .data_i(own_flat), .data_o(rsp_flat));

  assign rsp_o = rsp_flat;

  always_comb begin
    if (occupied) cause_o = rc_pkg::NodeUnitBusyWork;
    else if (req_valid_i)
      cause_o = req_ready_o ? rc_pkg::NodeUnitBusyWork : rc_pkg::NodeUnitStalledTrav;
    else
      cause_o = node_waits_i ? rc_pkg::NodeUnitStarvedMemory : rc_pkg::NodeUnitStarvedTrav;
  end
endmodule
`default_nettype wire
