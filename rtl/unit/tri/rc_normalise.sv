// Shortens a number to its Kept highest bits, by the smallest sufficient even shift. Returns the
// shortened number, half of the shift, and whether a set bit was lost. So a root of few bits,
// shifted back, can replace a root of many bits. Part of rc_sphere.
//
// It has Levels stages. Each of them shifts by a power of two of bit pairs if necessary. Latency
// Levels * rc_pkg::PathCut cycles.
`default_nettype none
module rc_normalise #(
  parameter  int unsigned Width  = 8,
  parameter  int unsigned Levels = 2,
  parameter  int unsigned Kept   = 4,
  localparam int unsigned RightW = Levels > 0 ? Levels : 1
) (
  input  logic              clk_i,
  input  logic [Width-1:0]  all_i,
  output logic [Kept-1:0]   cut_o,
  output logic [RightW-1:0] right_o,   // pairs of bits
  output logic              lost_o
);
  if (Kept < 1 || Kept > Width) begin : gen_refuse
    $error("rc_normalise: Kept must lie in 1..Width");
  end

  logic [Width-1:0] cut;

  if (Levels == 0) begin : gen_whole
    assign cut               = all_i;
    assign {right_o, lost_o} = '0;

    logic unused;
    assign unused = clk_i;
  end

  for (genvar k = 0; k < Levels; k++) begin : gen_level
    // Highest power of two first. A level shifts by its pairs if one pair less leaves too many
    // bits.
    localparam int unsigned Pairs = 1 << (Levels - 1 - k);
    logic [Width-1:0]  all, left;
    logic [Levels-1:0] right;   // of the levels so far, at the bottom
    logic              goes, lost, out_lost;
    logic [Levels-1:0] out_right;

    if (k == 0) begin : gen_first
      assign all   = all_i;
      assign lost  = 1'b0;
      assign right = '0;
    end else begin : gen_next
      assign all   = gen_level[k-1].left;
      assign lost  = gen_level[k-1].out_lost;
      assign right = gen_level[k-1].out_right;
    end

    assign goes = (all >> (Kept + 2 * (Pairs - 1))) != '0;

    rc_path_register #(.Width(Width + Levels + 1)) u_level (
      .clk_i,
      .data_i({goes ? all >> (2 * Pairs) : all, Levels'({right, goes}),
               lost || (goes && all[2*Pairs-1:0] != '0)}),
      .data_o({left, out_right, out_lost}));

    if (k == Levels - 1) begin : gen_last
      assign cut               = left;
      assign {right_o, lost_o} = {out_right, out_lost};
    end
  end

  assign cut_o = cut[Kept-1:0];

  logic unused;
  assign unused = ^cut;
endmodule
`default_nettype wire
