// Tags of caches that replace the line that came first, whether it was used since or not: hits do
// not change the order of replacement.
`default_nettype none
module rc_tags #(
  parameter  int unsigned TagW = 18,
  parameter  int unsigned Sets = 64,
  parameter  int unsigned Ways = 4,
  parameter  int unsigned Cut  = 0,
  localparam int unsigned SetW = Sets < 2 ? 1 : $clog2(Sets),
  localparam int unsigned WayW = Ways < 2 ? 1 : $clog2(Ways)
) (
  input  logic            clk_i,
  input  logic            rst_ni,
  // Request ahead
  input  logic            next_load_i,
  input  logic [SetW-1:0] next_set_i,
  input  logic            load_i,
  input  logic [SetW-1:0] ahead_set_i,
  input  logic [TagW-1:0] ahead_tag_i,
  // Request in the look-up
  input  logic [SetW-1:0] set_i,
  input  logic [TagW-1:0] tag_i,
  input  logic [Ways-1:0] waiting_i,
  output logic [Ways-1:0] hits_o,
  output logic            hit_o,
  output logic            conflict_o,
  output logic [WayW-1:0] found_o,
  output logic [WayW-1:0] way_o,
  input  logic            touch_i,
  input  logic            take_i
);
  rc_tags_own #(.TagW(TagW), .Sets(Sets), .Ways(Ways), .Cut(Cut)) u_own (
    .clk_i, .rst_ni, .next_load_i, .next_set_i, .load_i, .ahead_set_i, .ahead_tag_i, .set_i, .tag_i,
    .waiting_i, .hits_o, .hit_o, .conflict_o, .found_o, .way_o,
    .touch_i(touch_i && take_i), .take_i);
endmodule
`default_nettype wire
