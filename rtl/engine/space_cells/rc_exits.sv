// Finds the exits that a ray meets, and the time from which it may be in each. For each exit it
// compares the latest entry with the earliest end of the planes on its path and of the box. Part of
// rc_cell_answer.
//
// The planes' results come in the cycle of valid_i, the box's (rc_bounds) 1 + Cut cycles later. The
// answer comes 1 + 2 Cut cycles later.
`default_nettype none
module rc_exits #(
  localparam int unsigned NodeWidth  = rc_pkg::NodeWidth,
  localparam int unsigned NodePlanes = rc_pkg::NodePlanes,
  localparam int unsigned TBits      = rc_pkg::TBits
) (
  input  logic                        clk_i,
  // The stage before the paths' last register holds a node.
  input  logic                        valid_i,
  // From each plane: the sides that the ray may be on, and when it changes sides
  input  logic [NodePlanes-1:0]       turned_i,
  input  logic [NodePlanes-1:0]       near_i,
  input  logic [NodePlanes-1:0]       far_i,
  input  logic [NodePlanes*TBits-1:0] near_to_i,
  input  logic [NodePlanes*TBits-1:0] far_from_i,
  // From the box
  input  logic [TBits-1:0]            enter_i,
  input  logic [TBits-1:0]            leave_i,
  input  logic                        met_i,
  // Result
  output logic [NodeWidth-1:0]        met_o,
  output logic [NodeWidth*TBits-1:0]  near_o
);
  localparam int unsigned Levels = $clog2(NodeWidth);

  // The intervals on an exit's path. The ray meets the upper side of a plane first if it is turned.
  for (genvar i = 0; i < NodeWidth; i++) begin : gen_exit
    logic [3*TBits-1:0] from, to;
    logic [2:0]         there;
    for (genvar l = 0; l < 3; l++) begin : gen_level
      if (l < Levels) begin : gen_plane_there
        // Plane of level l on the path to exit i, and the exit's side of that plane.
        localparam int unsigned At    = (1 << l) - 1 + (i >> (Levels - l));
        localparam int unsigned Upper = (i >> (Levels - 1 - l)) & 1;

        logic first;
        assign first = turned_i[At] == (Upper != 0);
        assign from[l*TBits +: TBits] = first ? '0 : far_from_i[At*TBits +: TBits];
        assign to[l*TBits +: TBits]   = first ? near_to_i[At*TBits +: TBits] : '1;
        assign there[l]               = first ? near_i[At] : far_i[At];
      end else begin : gen_no_plane
        assign from[l*TBits +: TBits] = '0;
        assign to[l*TBits +: TBits]   = '1;
        assign there[l]               = 1'b1;
      end
    end

    logic [TBits-1:0] way_enter, way_leave, first, last, enter, leave;
    logic             way_met, may_meet;

    rc_span u_way (
      .clk_i, .valid_i, .from_i(from), .to_i(to), .there_i(there),
      .from_o(way_enter), .to_o(way_leave), .there_o(way_met));

    // Intersection with the box.
    assign first = way_enter > enter_i ? way_enter : enter_i;
    assign last  = way_leave < leave_i ? way_leave : leave_i;
    rc_path_register #(.Width(2 * TBits + 1)) u_both (
      .clk_i, .data_i({first, last, way_met && met_i}), .data_o({enter, leave, may_meet}));

    assign met_o[i]                 = enter <= leave && may_meet;
    assign near_o[i*TBits +: TBits] = enter;
  end
endmodule
`default_nettype wire
