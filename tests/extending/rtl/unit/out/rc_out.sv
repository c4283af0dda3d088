// Holds a finished pixel for at least one cycle, until sched accepts it.
//
// Two places let a result come in every cycle. ready and valid come from registers, so no
// combinational path leads from list to the sink. Model: model/unit/out/out.hpp.
`default_nettype none
module rc_out (
  input  logic            clk_i,
  input  logic            rst_ni,
  // From list, or shade
  input  logic            result_valid_i,
  output logic            result_ready_o,
  input  rc_pkg::result_t result_i,
  // To sched
  output logic            pixel_valid_o,
  input  logic            pixel_ready_i,
  output rc_pkg::pixel_t  pixel_o,
  output logic [rc_pkg::CauseBits-1:0] cause_o
);
  rc_fifo #(.Width(rc_pkg::ResultW), .Depth(2)) u_fifo (
    .clk_i, .rst_ni, .valid_i(result_valid_i), .ready_o(result_ready_o), .data_i(result_i),
    .valid_o(pixel_valid_o), .ready_i(pixel_ready_i), .data_o(pixel_o));

  assign cause_o = !pixel_valid_o ? rc_pkg::OutStarvedList
                 : pixel_ready_i ? rc_pkg::OutBusyWork : rc_pkg::OutStalledSink;
endmodule
`default_nettype wire
