// The engine without a structure: gives every ray the list of all primitives, page by page. It has
// the interface of every engine (rtl/README.md), but requests no nodes.
//
// A page is NodeWidth leaves of four primitives, all of them from t = 0 on. A ray begins with the
// first page. When list has tested a page, the next page follows two cycles later, unless the page
// was the last or list requests a stop. Pages of rays in flight go before new rays.
//
// Model: model/engine/none/page.hpp, and Trav (model/unit/trav/trav.hpp) for the timing.
`default_nettype none
module rc_none (
  input  logic            clk_i,
  input  logic            rst_ni,
  input  rc_pkg::frame_t  frame_i,
  // From raygen
  input  logic            ray_valid_i,
  output logic            ray_ready_o,
  input  rc_pkg::ray_t    ray_i,
  // To and from list
  output logic            leaves_fires_o,
  output rc_pkg::leaves_t leaves_o,
  input  logic            tested_valid_i,
  output logic            tested_ready_o,
  input  rc_pkg::tested_t tested_i,
  // A finished ray, to list
  output logic            done_valid_o,
  input  logic            done_ready_i,
  output rc_pkg::done_t   done_o,
  output logic            done_next_fires_o,   // in a fast chip: the next one comes, and its ray
  output rc_pkg::done_t   done_next_o,
  // What it did: rc_pkg::trav_cause_e
  output logic [rc_pkg::CauseBits-1:0] trav_cause_o
);
  localparam int unsigned RayBits    = rc_pkg::RayBits;
  localparam int unsigned AddrBits   = rc_pkg::AddrBits;
  localparam int unsigned Contexts   = rc_pkg::Contexts;
  localparam int unsigned GroupBits  = rc_pkg::GroupBits;
  localparam int unsigned NodeWidth  = rc_pkg::NodeWidth;
  localparam int unsigned TBits      = rc_pkg::TBits;
  localparam int unsigned OffsetBits = rc_pkg::OffsetBits;
  localparam int unsigned CountBits  = rc_pkg::CountBits;
  localparam int unsigned Leaf = 4;                  // primitives of a leaf: page_leaf
  localparam int unsigned Page = Leaf * NodeWidth;   // primitives of a page

  // Number of primitives. Only this engine has that register.
  logic [AddrBits:0] listed;
  if (rc_pkg::Structure == rc_pkg::StructureNone) begin : gen_listed
    assign listed = frame_i.listed;
  end else begin : gen_no_list
    assign listed = '0;
  end

  // s1: a page was tested. Is there another? Primitives are counted from the list's first one.
  logic                s1_valid_q, s1_stop_q, more;
  logic [RayBits-1:0]  s1_ray_q;
  logic [AddrBits:0]   kept;
  logic [AddrBits+1:0] next;

  assign tested_ready_o = 1'b1;
  assign trav_cause_o   = tested_valid_i ? rc_pkg::TravBusyWork : rc_pkg::TravStarvedList;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) s1_valid_q <= 1'b0;
    else         s1_valid_q <= tested_valid_i;
    if (tested_valid_i) s1_ray_q <= tested_i.ray;
  end

  if (rc_pkg::Shading) begin : gen_stop
    always_ff @(posedge clk_i) if (tested_valid_i) s1_stop_q <= tested_i.stop;
  end else begin : gen_go_on
    assign s1_stop_q = 1'b0;
  end

  assign next = {1'b0, kept} + (AddrBits+2)'(Page);
  assign more = next < {1'b0, listed} && !s1_stop_q;

  // Pages to send. New rays wait for a gap.
  logic                        page_valid, page_ready, spawn_valid, spawn_ready, ready;
  logic [RayBits+AddrBits:0]   page_data;
  logic [RayBits-1:0]          spawn_ray, ray;
  logic [AddrBits:0]           first;   // first primitive of the page

  assign ready = 1'b1;

  rc_queue #(.Width(RayBits + AddrBits + 1), .Depth(Contexts)) u_page (
    .clk_i, .rst_ni, .push_i(s1_valid_q && more), .data_i({s1_ray_q, next[AddrBits:0]}),
    .valid_o(page_valid), .pop_i(page_valid && page_ready), .data_o(page_data));

  rc_fifo #(.Width(RayBits), .Depth(2)) u_spawn (
    .clk_i, .rst_ni, .valid_i(ray_valid_i), .ready_o(ray_ready_o), .data_i(ray_i.ray),
    .valid_o(spawn_valid), .ready_i(spawn_ready), .data_o(spawn_ray));

  rc_priority_merge #(.Width(RayBits + AddrBits + 1)) u_leaves (
    .clk_i, .rst_ni,
    .first_valid_i(page_valid), .first_ready_o(page_ready), .first_i(page_data),
    .second_valid_i(spawn_valid), .second_ready_o(spawn_ready),
    .second_i({spawn_ray, {(AddrBits+1){1'b0}}}),
    .valid_o(leaves_fires_o), .ready_i(ready), .data_o({ray, first}));

  rc_ram #(.Width(AddrBits + 1), .Depth(Contexts)) u_first (
    .clk_i, .write_i(leaves_fires_o), .write_addr_i(ray), .write_data_i(first),
    .read_addr_i(s1_ray_q), .read_data_o(kept));

  // Leaves of the page: four primitives each, fewer in the last leaf.
  logic [AddrBits:0]               left;
  logic [GroupBits-1:0]            leaves;
  logic [AddrBits-1:0]             base;
  logic [NodeWidth*OffsetBits-1:0] offset;
  logic [NodeWidth*CountBits-1:0]  count;

  assign left = listed - first;
  assign base = frame_i.root + first[AddrBits:1];

  always_comb begin
    leaves = '0;
    offset = '0;
    count  = '0;
    for (int i = 0; i < NodeWidth; i++) begin
      if (left > (AddrBits+1)'(Leaf * i)) begin
        leaves                             = GroupBits'(i + 1);
        offset[i*OffsetBits +: OffsetBits] = OffsetBits'(Leaf * i);
        count[i*CountBits +: CountBits]    = left >= (AddrBits+1)'(Leaf * (i + 1))
                                           ? CountBits'(Leaf) : {{(CountBits-2){1'b0}}, left[1:0]};
      end
    end
  end

  assign leaves_o = {ray, base, leaves, {(NodeWidth*TBits){1'b0}}, offset, count};

  // Rays whose last page was tested.
  logic done_place;
  rc_fifo_peek #(.Width(RayBits), .Depth(Contexts < 2 ? 2 : Contexts), .Second(1)) u_done (
    .clk_i, .rst_ni, .valid_i(s1_valid_q && !more), .ready_o(done_place), .data_i(s1_ray_q),
    .valid_o(done_valid_o), .ready_i(done_ready_i), .data_o(done_o),
    .next_fires_o(done_next_fires_o), .next_o(done_next_o));

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni && s1_valid_q && !more)
    a_done_never_full: assert (done_place)
    else $error("a queue that cannot overflow did");
`endif

  logic [rc_pkg::RayW-1:0]    ray_flat;   // fields that only other units use
  logic [rc_pkg::FrameW-1:0]  frame_flat;
  logic [rc_pkg::TestedW-1:0] tested_flat;
  logic                       unused;
  assign ray_flat    = ray_i;
  assign frame_flat  = frame_i;
  assign tested_flat = tested_i;
  assign unused      = ^{done_place, ray_flat, frame_flat, tested_flat, next[AddrBits+1], first[0],
                         left};
endmodule
`default_nettype wire
