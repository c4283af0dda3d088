// How far each ray still looks: its distance to beat. When a ray starts, this is what its
// kind gives: 2^(N+F) for a shadow ray, which ends at t = 2^-B, and all ones for the others.
// Afterwards it is what was written last.
//
// A read sees what happened in earlier cycles only. It is answered in the same cycle; in a fast
// chip in the next, because to find one of many flags and to choose by it would be one long
// path. trav and list have one each. Model: reach_of() in model/core/frame.hpp.
`default_nettype none
module rc_reach (
  input  logic                       clk_i,
  input  logic                       rst_ni,
  input  logic                       start_fires_i,
  input  rc_pkg::start_t             start_i,
  input  logic                       write_i,
  input  logic [rc_pkg::RayBits-1:0] write_ray_i,
  input  logic [rc_pkg::TBits-1:0]   write_t_i,
  input  logic [rc_pkg::RayBits-1:0] read_ray_i,
  output logic [rc_pkg::TBits-1:0]   read_t_o
);
  localparam int unsigned T  = rc_pkg::Contexts;
  localparam int unsigned TB = rc_pkg::TBits;
  localparam logic [TB-1:0] SurfaceT = TB'(1) << (rc_pkg::CoordBits + rc_pkg::TFracBits);

  // written says whether the memory holds a ray's; shadow_q, which rays end at the surface.
  logic [T-1:0]               written, shadow_q;
  logic [TB-1:0]              kept, end_kept;
  logic                       end_written, end_shadow;
  logic [rc_pkg::RayBits-1:0] start_ray;
  assign start_ray = start_i.ray;
  rc_ram #(.Width(TB), .Depth(T)) u_t (
    .clk_i, .write_i, .write_addr_i(write_ray_i), .write_data_i(write_t_i),
    .read_addr_i(read_ray_i), .read_data_o(kept));
  rc_flags #(.Flags(T)) u_written (
    .clk_i, .rst_ni, .clear_i(start_fires_i), .clear_at_i(start_ray),
    .set_i(write_i), .set_at_i(write_ray_i), .flags_o(written));
  if (rc_pkg::Shading != 0) begin : gen_kinds
    logic is_shadow;
    assign is_shadow = start_i.kind == rc_pkg::RayShadow;
    always_ff @(posedge clk_i) if (start_fires_i) shadow_q[start_ray] <= is_shadow;
  end else begin : gen_camera
    assign shadow_q = '0;
  end
  rc_cut #(.Width(TB)) u_end (.clk_i, .data_i(kept), .data_o(end_kept));
  rc_cut #(.Width(1)) u_end_written (
    .clk_i, .data_i(written[read_ray_i]), .data_o(end_written));
  rc_cut #(.Width(1)) u_end_shadow (
    .clk_i, .data_i(shadow_q[read_ray_i]), .data_o(end_shadow));
  assign read_t_o = end_written ? end_kept : end_shadow ? SurfaceT : '1;
endmodule
`default_nettype wire
