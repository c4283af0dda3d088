// The host link as the board uses it: UART, FIFO of received bytes, packets, board registers.
// docs/machine/board-link.md describes it. The host's end is sim/board/link.hpp.
`default_nettype none
module rc_host_link #(
  parameter int unsigned ClkKhz     = 75000,     // clock, in kHz
  parameter int unsigned Baud       = 3000000,   // bits per second
  parameter int unsigned LineBits   = 20,        // of a line's number in memory
  parameter int unsigned FifoDepth  = 1024,      // received bytes that may wait
  parameter int unsigned QuietUs    = 20000,     // silence that ends a partial packet, in us
  parameter logic [63:0] ConfigHash = '0         // of the configuration of the bitstream
) (
  input  logic                           clk_i,
  input  logic                           rst_ni,
  // UART, from and to the USB bridge; rx_i is asynchronous
  input  logic                           rx_i,
  output logic                           tx_o,
  // To the chip's bus
  output logic                           wb_cyc_o,
  output logic                           wb_stb_o,
  output logic                           wb_we_o,
  output logic [rc_pkg::RegAddrBits-1:0] wb_adr_o,
  output logic [31:0]                    wb_dat_o,
  input  logic [31:0]                    wb_dat_i,
  input  logic                           wb_ack_i,
  input  logic                           wb_err_i,
  // To memory: the client `host` of rc_board_memory
  output logic                           host_req_valid_o,
  input  logic                           host_req_ready_i,
  output logic                           host_req_write_o,
  output logic [LineBits-1:0]            host_req_addr_o,
  input  logic                           host_next_i,
  output logic [15:0]                    host_wr_data_o,
  input  logic                           host_rd_valid_i,
  input  logic [15:0]                    host_rd_data_i,
  // Registers of the board: control, status, frame buffer
  output logic                           chip_reset_o,   // active high
  output logic                           arm_o,
  input  logic                           init_done_i,
  input  logic                           flushed_i,
  input  logic                           armed_i,
  input  logic [31:0]                    underruns_i,
  input  logic [47:0]                    cycles_i,
  output logic [LineBits-1:0]            draw_base_o,
  output logic [LineBits-1:0]            base_o,
  output logic [15:0]                    width_o,
  output logic [15:0]                    height_o,
  output logic                           double_o
);
  localparam int unsigned QuietCycles = 32'(64'(ClkKhz) * 64'(QuietUs) / 1000);

  logic       rx_valid, rx_fault, rx_lost;
  logic [7:0] rx_data;
  logic       in_valid, in_ready, out_valid, out_ready, bad_packet;
  logic [7:0] in_data, out_data;

  rc_uart_rx #(.ClkKhz(ClkKhz), .Baud(Baud)) u_rx (
    .clk_i, .rst_ni, .rx_i, .valid_o(rx_valid), .data_o(rx_data), .fault_o(rx_fault));

  rc_byte_fifo #(.Depth(FifoDepth)) u_fifo (
    .clk_i, .rst_ni, .push_i(rx_valid), .data_i(rx_data), .lost_o(rx_lost),
    .valid_o(in_valid), .ready_i(in_ready), .data_o(in_data));

  rc_uart_tx #(.ClkKhz(ClkKhz), .Baud(Baud)) u_tx (
    .clk_i, .rst_ni, .valid_i(out_valid), .ready_o(out_ready), .data_i(out_data), .tx_o);

  logic        reg_valid, reg_write, reg_good;
  logic [7:0]  reg_addr;
  logic [31:0] reg_in, reg_out;

  rc_link #(.LineBits(LineBits), .QuietCycles(QuietCycles)) u_link (
    .clk_i, .rst_ni,
    .rx_valid_i(in_valid), .rx_ready_o(in_ready), .rx_data_i(in_data),
    .tx_valid_o(out_valid), .tx_ready_i(out_ready), .tx_data_o(out_data),
    .wb_cyc_o, .wb_stb_o, .wb_we_o, .wb_adr_o, .wb_dat_o, .wb_dat_i, .wb_ack_i, .wb_err_i,
    .reg_valid_o(reg_valid), .reg_write_o(reg_write), .reg_addr_o(reg_addr), .reg_data_o(reg_in),
    .reg_data_i(reg_out), .reg_good_i(reg_good),
    .host_req_valid_o, .host_req_ready_i, .host_req_write_o, .host_req_addr_o, .host_next_i,
    .host_wr_data_o, .host_rd_valid_i, .host_rd_data_i, .bad_o(bad_packet));

  rc_board_registers #(.LineBits(LineBits), .ConfigHash(ConfigHash)) u_registers (
    .clk_i, .rst_ni,
    .valid_i(reg_valid), .write_i(reg_write), .addr_i(reg_addr), .data_i(reg_in),
    .data_o(reg_out), .good_o(reg_good),
    .chip_reset_o, .arm_o, .init_done_i, .flushed_i, .armed_i, .underruns_i, .cycles_i,
    .draw_base_o, .base_o, .width_o, .height_o, .double_o,
    .bad_packet_i(bad_packet), .bad_byte_i(rx_fault || rx_lost));
endmodule
`default_nettype wire
