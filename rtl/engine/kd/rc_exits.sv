// Which exits a ray meets, and from when on: of each, the latest entry and the earliest end on its
// way and of the box. Part of rc_treelet and rc_slant. What planes say comes with the stage that
// valid_i is of, what rc_bounds says 1 + Cut later, and the answer is there 1 + 2 Cut later.
`default_nettype none
module rc_exits #(
  localparam int unsigned W = rc_pkg::NodeWidth,
  localparam int unsigned Q = rc_pkg::NodePlanes,
  localparam int unsigned T = rc_pkg::TBits
) (
  input  logic           clk_i,
  input  logic           valid_i,    // the stage before the ways' last register holds a treelet
  // Of each plane: which sides there are, and when the ray changes from one to the other
  input  logic [Q-1:0]   turned_i,
  input  logic [Q-1:0]   near_i,
  input  logic [Q-1:0]   far_i,
  input  logic [Q*T-1:0] near_to_i,
  input  logic [Q*T-1:0] far_from_i,
  // Of the box
  input  logic [T-1:0]   enter_i,
  input  logic [T-1:0]   leave_i,
  input  logic           met_i,
  output logic [W-1:0]   met_o,
  output logic [W*T-1:0] near_o
);
  localparam int unsigned Levels = $clog2(W);

  // On a plane's upper side the ray is first if it is turned.
  for (genvar i = 0; i < W; i++) begin : gen_exit
    logic [3*T-1:0] from, to;
    logic [2:0]     there;
    for (genvar l = 0; l < 3; l++) begin : gen_level
      if (l < Levels) begin : gen_plane_there
        // Plane of level l on the way to exit i, and the exit's side of it.
        localparam int unsigned At    = (1 << l) - 1 + (i >> (Levels - l));
        localparam int unsigned Upper = (i >> (Levels - 1 - l)) & 1;
        logic first;
        assign first = turned_i[At] == (Upper != 0);
        assign from[l*T +: T] = first ? '0 : far_from_i[At*T +: T];
        assign to[l*T +: T]   = first ? near_to_i[At*T +: T] : '1;
        assign there[l]       = first ? near_i[At] : far_i[At];
      end else begin : gen_no_plane
        assign from[l*T +: T] = '0;
        assign to[l*T +: T]   = '1;
        assign there[l]       = 1'b1;
      end
    end
    logic [T-1:0] way_enter, way_leave, first, last, enter, leave;
    logic         way_met, may_meet;
    rc_span u_way (
      .clk_i, .valid_i, .from_i(from), .to_i(to), .there_i(there),
      .from_o(way_enter), .to_o(way_leave), .there_o(way_met));
    assign first = way_enter > enter_i ? way_enter : enter_i;
    assign last  = way_leave < leave_i ? way_leave : leave_i;
    rc_path_register #(.Width(2 * T + 1)) u_both (
      .clk_i, .data_i({first, last, way_met && met_i}), .data_o({enter, leave, may_meet}));
    assign met_o[i]         = enter <= leave && may_meet;
    assign near_o[i*T +: T] = enter;
  end
endmodule
`default_nettype wire
