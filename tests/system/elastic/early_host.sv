// Faulty: says that the frame is done after its first 100 pixels.
`default_nettype none
module rc_host #(
  parameter int unsigned Counters = 1
) (
  input  logic                           clk_i,
  input  logic                           rst_ni,
  input  logic                           wb_cyc_i,
  input  logic                           wb_stb_i,
  input  logic                           wb_we_i,
  input  logic [rc_pkg::RegAddrBits-1:0] wb_adr_i,
  input  logic [31:0]                    wb_dat_i,
  output logic [31:0]                    wb_dat_o,
  output logic                           wb_ack_o,
  output logic                           wb_err_o,
  output logic                           start_o,
  output rc_pkg::frame_t                 frame_o,
  input  logic [rc_pkg::Pipelines-1:0]   hit_fires_i,
  output logic                           count_o,
  output logic                           clear_o,
  output logic [rc_pkg::CounterNumberBits-1:0] counter_o,
  input  logic                           counter_there_i,
  input  logic [rc_pkg::CounterBits-1:0]   counter_i,
  output logic                           running_o,
  output logic                           done_o
);
  localparam logic [6:0] Enough = 7'd100;

  logic       own_running, own_done, early;
  logic [6:0] hits_q;

  rc_host_own #(.Counters(Counters)) u_own (
    .clk_i, .rst_ni, .wb_cyc_i, .wb_stb_i, .wb_we_i, .wb_adr_i, .wb_dat_i, .wb_dat_o, .wb_ack_o,
    .wb_err_o,
    .start_o, .frame_o, .hit_fires_i, .count_o, .clear_o, .counter_o, .counter_there_i, .counter_i,
    .running_o(own_running), .done_o(own_done));

  assign early     = own_running && hits_q == Enough;
  assign running_o = own_running && !early;
  assign done_o    = own_done || early;

  always_ff @(posedge clk_i) begin
    if (!rst_ni || start_o)                       hits_q <= '0;
    else if (|hit_fires_i && hits_q != Enough) hits_q <= hits_q + 7'd1;
  end
endmodule
`default_nettype wire
