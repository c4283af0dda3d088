// The offsets of a node's children in its block, in half lines, computed only from their kinds:
// inner children first, two half lines each, then the triangles of leaves, one each. Part of
// rc_node_answer.
//
// Two stages, in parallel with the test of the planes. The first adds the inner children's lines,
// and the triangles of the first four children. The second adds the sizes before each child. Model:
// place_child() in model/engine/bvh/box.cpp.
`default_nettype none
module rc_child_offsets #(
  parameter  bit          Exits      = 1'b0,   // cells: only existing exits have lines
  localparam int unsigned NodeWidth  = rc_pkg::NodeWidth,
  localparam int unsigned CountBits  = rc_pkg::CountBits,
  localparam int unsigned OffsetBits = rc_pkg::OffsetBits
) (
  input  logic                            clk_i,
  input  logic [1:0]                      enable_i,    // enable_i[i]: stage i accepts a node
  // 0: no child, 1: an inner one, else a leaf of kind - 1.
  input  logic [NodeWidth*CountBits-1:0]  kind_i,
  // One stage later
  output logic [NodeWidth-1:0]            there_o,
  // Two stages later
  output logic [NodeWidth-1:0]            leaf_o,
  // Lines of inner children, triangles after them.
  output logic [NodeWidth*OffsetBits-1:0] offset_o,
  output logic [NodeWidth*CountBits-1:0]  count_o     // triangles of a leaf
);

  // In a simulation of a relaxed chip, invalid nodes cost no work. Silicon has no such condition.
  logic [1:0] computes;

`ifdef SYNTHESIS
  assign computes = '1;
`else
  assign computes = enable_i;
`endif

  // s1: kinds, lines of inner children, triangles of the first four children.
  logic [NodeWidth-1:0]           is_inner, is_leaf, inner_q, leaf_q;
  logic [NodeWidth*CountBits-1:0] count, count_q;
  logic [OffsetBits-1:0]          lines, lines_q;   // of all inner children
  logic [OffsetBits-1:0]          half, half_q;     // triangles of the first four children

  always_comb begin
    is_inner = '0;
    is_leaf  = '0;
    count    = '0;
    lines    = '0;
    half     = '0;
    if (computes[0]) begin
      for (int i = 0; i < NodeWidth; i++) begin
        is_inner[i] = kind_i[i*CountBits +: CountBits] == CountBits'(1);
        is_leaf[i]  = kind_i[i*CountBits +: CountBits] > CountBits'(1);
        if (is_leaf[i])
          count[i*CountBits +: CountBits] = kind_i[i*CountBits +: CountBits] - CountBits'(1);
        lines = lines + {{(OffsetBits-2){1'b0}}, is_inner[i], 1'b0};
        if (i < 4) half = half + {{(OffsetBits-CountBits){1'b0}}, count[i*CountBits +: CountBits]};
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (enable_i[0]) begin
      inner_q <= is_inner;
      leaf_q  <= is_leaf;
      count_q <= count;
      lines_q <= lines;
      half_q  <= half;
    end
  end

  assign there_o = inner_q | leaf_q;

  // s2: offsets. The triangles before a child are those of the first four children, plus those of
  // up to three children in the same group of four.
  logic [NodeWidth*OffsetBits-1:0] offset;
  logic [OffsetBits-1:0]           start, beside, exits;

  always_comb begin
    offset = '0;
    start  = '0;
    beside = '0;
    exits  = '0;
    if (computes[1]) begin
      for (int i = 0; i < NodeWidth; i++) begin
        if (i % 4 == 0) beside = '0;
        start = i < 4 ? lines_q : lines_q + half_q;
        offset[i*OffsetBits +: OffsetBits] = leaf_q[i] ? start + beside
                                           : Exits ? exits : OffsetBits'(2 * i);
        beside = beside + {{(OffsetBits-CountBits){1'b0}}, count_q[i*CountBits +: CountBits]};
        exits  = exits + {{(OffsetBits-2){1'b0}}, inner_q[i], 1'b0};
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (enable_i[1]) begin
      leaf_o   <= leaf_q;
      count_o  <= count_q;
      offset_o <= offset;
    end
  end
endmodule
`default_nettype wire
