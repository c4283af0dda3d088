// Gives pixels, row by row, to free contexts, and puts the pixel to the hit when its
// ray is done. A fresh machine uses contexts 0..Contexts-1 first; after that the one
// that has been free longest.
//
// A slot is offered from the cycle after reset until the last pixel of frame_i is
// given. A hit passes through in the same cycle and frees its context. Model:
// model/sched/sched.hpp.
`default_nettype none
module rc_sched (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  rc_pkg::frame_t   frame_i,
  output logic             slot_valid_o,
  input  logic             slot_ready_i,
  output rc_pkg::slot_t    slot_o,
  input  logic             closest_valid_i,
  output logic             closest_ready_o,
  input  rc_pkg::closest_t closest_i,
  output logic             hit_valid_o,
  input  logic             hit_ready_i,
  output rc_pkg::hit_t     hit_o
);
  localparam int unsigned I = rc_pkg::RayBits;
  localparam int unsigned P = rc_pkg::PixelBits;
  localparam int unsigned T = rc_pkg::Contexts;

  logic [P-1:0] x_q, y_q;
  logic         more_q;
  logic [I:0]   started_q;  // contexts used so far, 0..Contexts
  logic         fresh, give, freed, free_valid;
  logic [I-1:0] free_ray, slot_ray;
  assign fresh        = started_q != (I+1)'(T);
  assign slot_valid_o = more_q && (fresh || free_valid);
  assign slot_ray     = fresh ? started_q[I-1:0] : free_ray;
  assign slot_o       = {slot_ray, x_q, y_q};
  assign give         = slot_valid_o && slot_ready_i;
  assign freed        = hit_valid_o && hit_ready_i;

  logic last_x, last_y;
  assign last_x = {1'b0, x_q} + 1'b1 == frame_i.width;
  assign last_y = {1'b0, y_q} + 1'b1 == frame_i.height;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      x_q       <= '0;
      y_q       <= '0;
      more_q    <= 1'b1;
      started_q <= '0;
    end else if (give) begin
      if (fresh) started_q <= started_q + 1'b1;
      x_q <= last_x ? '0 : x_q + 1'b1;
      if (last_x) begin
        y_q    <= y_q + 1'b1;
        more_q <= !last_y;
      end
    end
  end

  rc_queue #(.Width(I), .Depth(T)) u_free (
    .clk_i, .rst_ni, .push_i(freed), .data_i(closest_i.ray),
    .valid_o(free_valid), .pop_i(give && !fresh), .data_o(free_ray));

  logic [2*P-1:0] pixel;
  rc_ram #(.Width(2 * P), .Depth(T)) u_pixel (
    .clk_i, .write_i(give), .write_addr_i(slot_ray), .write_data_i({x_q, y_q}),
    .read_addr_i(closest_i.ray), .read_data_o(pixel));

  assign hit_valid_o     = closest_valid_i;
  assign closest_ready_o = hit_ready_i;
  assign hit_o           = {pixel, closest_i};

  logic unused;
  assign unused = ^{frame_i.root, frame_i.eye, frame_i.corner, frame_i.right, frame_i.down};
endmodule
`default_nettype wire
