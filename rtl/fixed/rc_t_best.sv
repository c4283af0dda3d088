// Holds t_best, the distance to beat, of each ray. A hit beyond t_best does not count.
//
// When a ray starts, t_best is t_max, the end of the ray's interval. t_max is all ones, but for a
// shadow ray 2^(N+F), which is the distance of the surface (docs/proofs/origins.md). Each write
// replaces t_best.
//
// A read answers in the same cycle. In a fast chip it answers in the next cycle. near_i comes in
// the cycle of the answer. It is compared with both candidates before one of them is selected. A
// read sees the changes of earlier cycles only. trav and list have one instance each. Model:
// t_max_of() in model/core/frame.hpp, BestHit in model/unit/list/ray_tests.hpp.
`default_nettype none
module rc_t_best #(
  parameter int unsigned Nears = 1
) (
  input  logic                       clk_i,
  input  logic                       rst_ni,
  // A ray starts
  input  logic                       start_fires_i,
  input  rc_pkg::start_t             start_i,
  // Write port
  input  logic                       write_i,
  input  logic [rc_pkg::RayBits-1:0] write_ray_i,
  input  logic [rc_pkg::TBits-1:0]   write_t_best_i,
  // Read port
  input  logic [rc_pkg::RayBits-1:0] read_ray_i,
  output logic [rc_pkg::TBits-1:0]   read_t_best_o,
  // Distances to compare, when read_t_best_o is valid; within_o: not beyond the distance to beat
  input  logic [Nears*rc_pkg::TBits-1:0] near_i,
  output logic [Nears-1:0]           within_o
);
  localparam int unsigned Contexts = rc_pkg::Contexts;
  localparam int unsigned TBits    = rc_pkg::TBits;
  localparam logic [TBits-1:0] SurfaceTMax = TBits'(1) << (rc_pkg::CoordBits + rc_pkg::TFracBits);

  // written: the memory holds the ray's value. shadow: the ray ends at the surface.
  logic [Contexts-1:0]        written, shadow;
  logic [TBits-1:0]           stored, s1_stored;
  logic                       was_written, was_shadow;
  logic [rc_pkg::RayBits-1:0] start_ray;

  assign start_ray = start_i.ray;

  // Not block RAM, even for many rays: its data would come too late for the comparison.
  (* ram_style = "distributed" *) logic [TBits-1:0] t_mem [Contexts < 2 ? 2 : Contexts];

  assign stored = t_mem[read_ray_i];

  always_ff @(posedge clk_i) if (write_i) t_mem[write_ray_i] <= write_t_best_i;

  rc_flags #(.Flags(Contexts)) u_written (
    .clk_i, .rst_ni, .clear_i(start_fires_i), .clear_at_i(start_ray),
    .set_i(write_i), .set_at_i(write_ray_i), .flags_o(written));

  if (rc_pkg::Shading) begin : gen_kinds
    logic is_shadow;

    assign is_shadow = start_i.kind == rc_pkg::RayShadow;
    rc_bit_array #(.Marks(Contexts)) u_shadow (
      .clk_i, .rst_ni, .write_i(start_fires_i), .write_at_i(start_ray), .mark_i(is_shadow),
      .marks_o(shadow));
    rc_bit_select #(.Flags(Contexts)) u_was_shadow (
      .clk_i, .flags_i(shadow), .index_i(read_ray_i), .flag_o(was_shadow));
  end else begin : gen_camera
    assign shadow   = '0;
    assign was_shadow = 1'b0;

    logic unused;
    assign unused = ^shadow;
  end

  rc_bit_select #(.Flags(Contexts)) u_was_written (
    .clk_i, .flags_i(written), .index_i(read_ray_i), .flag_o(was_written));

  rc_path_register #(.Width(TBits)) u_s1_stored (.clk_i, .data_i(stored), .data_o(s1_stored));

  assign read_t_best_o = was_written ? s1_stored : was_shadow ? SurfaceTMax : '1;

  // Comparisons with both candidates, then the selection.
  for (genvar i = 0; i < Nears; i++) begin : gen_near
    logic [TBits-1:0] near;
    assign near        = near_i[i*TBits +: TBits];
    assign within_o[i] = was_written ? near <= s1_stored : !was_shadow || near <= SurfaceTMax;
  end

  logic unused;
  assign unused = ^start_i;
endmodule
`default_nettype wire
