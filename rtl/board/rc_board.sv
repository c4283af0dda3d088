// The board without its vendor's cells: chip, memory, screen and host link, from pin to pin.
//
//   host link --- frame control --- chip --- conversion --- pixel writer
//       |                            |                          |
//       +-------------- board memory (arbiter, SDRAM controller) ------- scan-out --- video
//
// clk_i drives everything except the end of the video. pixel_clk_i must have PixelKhz, and
// shift_clk_i five times its frequency, both from the same source as clk_i. Two pictures lie at
// the memory's end. The host selects the one to draw (draw_base) and the one to show (base).
//
// The SDRAM's clock is clk_i, three quarters of a period later. Read data do not reach the input
// registers within the last quarter, so ReadDelay is 1.
//
// docs/machine/board.md describes the board, model/board/board_memory.hpp is the model of its
// timing, sim/board/simulated_board.hpp simulates it, and rtl/ecp5/rc_ulx3s.v adds PLL and pins.
`default_nettype none
module rc_board #(
  parameter  int unsigned ClkKhz     = 75_000,
  parameter  int unsigned PixelKhz   = 25_000,
  parameter  int unsigned Baud       = 3_000_000,
  parameter  int unsigned ColumnBits = 10,          // 10: AS4C32M16SB, 9: IS42S16160G
  parameter  int unsigned InitUs     = 200,         // wait of the SDRAM after power-on
  parameter  int unsigned ReadDelay  = 1,           // of rc_sdram; see above
  parameter  int unsigned Counters   = 1,           // the chip's unit counters
  parameter  int unsigned GateClock  = 0,           // the chip's clock stands still while idle
  parameter  logic [63:0] ConfigHash = '0,          // of the configuration that rc_pkg belongs to
  localparam int unsigned RowBits    = 13
) (
  // Clocks and resets
  input  logic        clk_i,
  input  logic        rst_ni,
  input  logic        pixel_clk_i,
  input  logic        pixel_rst_ni,
  input  logic        shift_clk_i,
  input  logic        shift_rst_ni,
  // UART
  input  logic        rx_i,
  output logic        tx_o,
  // SDRAM
  output logic        sd_cke_o,
  output logic        sd_cs_no,
  output logic        sd_ras_no,
  output logic        sd_cas_no,
  output logic        sd_we_no,
  output logic [1:0]  sd_ba_o,
  output logic [12:0] sd_a_o,
  output logic [1:0]  sd_dqm_o,
  output logic [15:0] sd_dq_o,
  output logic        sd_dq_oe_o,
  output logic        sd_dq_oe_next_o,              // in the next cycle, for registers at the pins
  input  logic [15:0] sd_dq_i,
  // Screen: pairs of bits for blue, green, red and clock, blue lowest
  output logic [7:0]  tmds_o,
  // LEDs
  output logic [7:0]  led_o
);
  localparam int unsigned LineW = RowBits + 2 + ColumnBits - 5;
  localparam int unsigned SideW = 10;
  localparam int unsigned Cl    = ClkKhz > 100_000 ? 3 : 2;   // CAS latency of the SDRAM

  if (rc_pkg::Pipelines != 1) begin : gen_refuse
    $error("rc_board: the chip must have one pipeline");
  end

  // ---- Host link.
  logic                           link_cyc, link_stb, link_we, link_ack, link_err;
  logic [rc_pkg::RegAddrBits-1:0] link_adr;
  logic [31:0]                    link_dat;
  logic                           host_req_valid, host_req_ready, host_req_write;
  logic [LineW-1:0]               host_req_addr;
  logic                           host_next, host_rd_valid;
  logic [15:0]                    host_wr_data, host_rd_data;
  logic                           chip_reset, arm, armed, flushed, init_done, shows_twice;
  logic [47:0]                    frame_cycles;
  logic [15:0]                    underruns, shown_width, shown_height;
  logic [LineW-1:0]               shown_base, drawn_base;
  logic [31:0]                    chip_dat;

  rc_host_link #(
    .ClkKhz(ClkKhz), .Baud(Baud), .LineBits(LineW), .ConfigHash(ConfigHash)
  ) u_link (
    .clk_i, .rst_ni, .rx_i, .tx_o,
    .wb_cyc_o(link_cyc), .wb_stb_o(link_stb), .wb_we_o(link_we), .wb_adr_o(link_adr),
    .wb_dat_o(link_dat), .wb_dat_i(chip_dat), .wb_ack_i(link_ack), .wb_err_i(link_err),
    .host_req_valid_o(host_req_valid), .host_req_ready_i(host_req_ready),
    .host_req_write_o(host_req_write), .host_req_addr_o(host_req_addr), .host_next_i(host_next),
    .host_wr_data_o(host_wr_data), .host_rd_valid_i(host_rd_valid), .host_rd_data_i(host_rd_data),
    .chip_reset_o(chip_reset), .arm_o(arm),
    .init_done_i(init_done), .flushed_i(flushed), .armed_i(armed), .underruns_i(32'(underruns)),
    .cycles_i(frame_cycles),
    .draw_base_o(drawn_base), .base_o(shown_base), .width_o(shown_width), .height_o(shown_height),
    .double_o(shows_twice));

  // ---- Frame control: between the host link and the chip's bus.
  logic                           takes, nears, flush, running, done;
  logic                           chip_cyc, chip_stb, chip_we, chip_ack, chip_err;
  logic [rc_pkg::RegAddrBits-1:0] chip_adr;
  logic [31:0]                    chip_wr_dat;
  logic                           colour_empty, writer_empty, chip_rst_n_q;

  // While the host holds the chip in reset, frame control and the conversion are reset too. The
  // pixel writer writes its partial blocks. At power-on all three are in reset before the first
  // edge: chip, frame control and conversion.
  initial chip_rst_n_q = 1'b0;
  always_ff @(posedge clk_i) chip_rst_n_q <= rst_ni && !chip_reset;

  rc_frame_control u_frame (
    .clk_i, .rst_ni(chip_rst_n_q), .arm_i(arm), .armed_o(armed), .flushed_o(flushed),
    .cycles_o(frame_cycles), .takes_i(takes),
    .wb_cyc_i(link_cyc), .wb_stb_i(link_stb), .wb_we_i(link_we), .wb_adr_i(link_adr),
    .wb_dat_i(link_dat), .wb_ack_o(link_ack), .wb_err_o(link_err),
    .wb_cyc_o(chip_cyc), .wb_stb_o(chip_stb), .wb_we_o(chip_we), .wb_adr_o(chip_adr),
    .wb_dat_o(chip_wr_dat), .wb_ack_i(chip_ack), .wb_err_i(chip_err),
    .running_i(running), .done_i(done), .pixels_empty_i(colour_empty && writer_empty),
    .colour_empty_i(colour_empty), .flush_o(flush));

  // ---- Chip.
  logic             mem_req_valid, mem_req_ready, mem_rsp_fires;
  rc_pkg::mem_req_t mem_req;
  rc_pkg::mem_rsp_t mem_rsp;
  logic             hit_valid, hit_ready;
  rc_pkg::hit_t     hit;

  logic chip_clk;

  rc_chip_clock #(.Gates(GateClock)) u_chip_clock (
    .clk_i, .rst_ni, .chip_rst_ni(chip_rst_n_q), .bus_i(chip_cyc), .running_i(running),
    .chip_clk_o(chip_clk));

  rc_chip #(.Counters(Counters)) u_chip (
    .clk_i(chip_clk), .rst_ni(chip_rst_n_q),
    .wb_cyc_i(chip_cyc), .wb_stb_i(chip_stb), .wb_we_i(chip_we), .wb_adr_i(chip_adr),
    .wb_dat_i(chip_wr_dat), .wb_dat_o(chip_dat), .wb_ack_o(chip_ack), .wb_err_o(chip_err),
    .mem_req_valid_o(mem_req_valid), .mem_req_ready_i(mem_req_ready), .mem_req_o(mem_req),
    .mem_rsp_fires_i(mem_rsp_fires), .mem_rsp_i(mem_rsp),
    .hit_valid_o(hit_valid), .hit_ready_i(hit_ready), .hit_o(hit),
    .running_o(running), .done_o(done));

  // ---- Pixels to memory.
  logic                         pixel_valid, pixel_ready;
  logic [rc_pkg::PixelBits-1:0] pixel_x, pixel_y;
  logic [23:0]                  pixel_colour;
  logic                         pix_req_valid, pix_req_ready, pix_next;
  logic [LineW-1:0]             pix_req_addr;
  logic [15:0]                  pix_data;
  logic [1:0]                   pix_mask;

  rc_pixel_colour u_colour (
    .clk_i, .rst_ni(chip_rst_n_q), .hit_valid_i(hit_valid), .hit_ready_o(hit_ready), .hit_i(hit),
    .pixel_valid_o(pixel_valid), .pixel_ready_i(pixel_ready), .x_o(pixel_x), .y_o(pixel_y),
    .colour_o(pixel_colour), .empty_o(colour_empty));

  rc_pixel_writer #(.LineW(LineW), .SideW(SideW)) u_writer (
    .clk_i, .rst_ni(rst_ni), .base_i(drawn_base), .width_i(shown_width[SideW:0]),
    .flush_i(flush || !chip_rst_n_q),
    .empty_o(writer_empty),
    .pixel_valid_i(pixel_valid), .pixel_ready_o(pixel_ready), .pixel_x_i(pixel_x[SideW-1:0]),
    .pixel_y_i(pixel_y[SideW-1:0]), .pixel_colour_i(pixel_colour),
    .req_valid_o(pix_req_valid), .req_ready_i(pix_req_ready), .req_addr_o(pix_req_addr),
    .next_i(pix_next), .data_o(pix_data), .mask_o(pix_mask));

  // ---- Screen.
  logic             scan_req_valid, scan_req_ready, scan_urgent, scan_rd_valid;
  logic [LineW-1:0] scan_req_addr;
  logic [15:0]      scan_rd_data;
  logic             shown_valid, shown_de, shown_hsync, shown_vsync, overflow, underflow;
  logic [23:0]      shown_colour;

  rc_scan_out #(.ChipKhz(ClkKhz), .PixelKhz(PixelKhz), .LineW(LineW)) u_scan (
    .clk_i, .rst_ni, .base_i(shown_base), .width_i(shown_width), .height_i(shown_height),
    .double_i(shows_twice), .takes_o(takes), .nears_o(nears), .underruns_o(underruns),
    .req_valid_o(scan_req_valid), .req_ready_i(scan_req_ready), .req_addr_o(scan_req_addr),
    .urgent_o(scan_urgent), .rd_valid_i(scan_rd_valid), .rd_data_i(scan_rd_data),
    .pixel_valid_o(shown_valid), .pixel_colour_o(shown_colour), .pixel_de_o(shown_de),
    .pixel_hsync_o(shown_hsync), .pixel_vsync_o(shown_vsync));

  rc_video u_video (
    .clk_i, .rst_ni, .pixel_valid_i(shown_valid), .pixel_colour_i(shown_colour),
    .pixel_de_i(shown_de), .pixel_hsync_i(shown_hsync), .pixel_vsync_i(shown_vsync),
    .overflow_o(overflow), .pixel_clk_i, .pixel_rst_ni, .underflow_o(underflow),
    .shift_clk_i, .shift_rst_ni, .tmds_o);

  // ---- Memory.
  rc_board_memory #(
    .ClkKhz(ClkKhz), .RowBits(RowBits), .ColumnBits(ColumnBits), .Cl(Cl), .InitUs(InitUs),
    .ReadDelay(ReadDelay)
  ) u_memory (
    .clk_i, .rst_ni, .init_done_o(init_done), .align_i(nears),
    .mem_req_valid_i(mem_req_valid), .mem_req_ready_o(mem_req_ready), .mem_req_i(mem_req),
    .mem_rsp_fires_o(mem_rsp_fires), .mem_rsp_o(mem_rsp),
    .scan_req_valid_i(scan_req_valid), .scan_req_ready_o(scan_req_ready),
    .scan_req_addr_i(scan_req_addr), .scan_urgent_i(scan_urgent), .scan_rd_valid_o(scan_rd_valid),
    .scan_rd_data_o(scan_rd_data),
    .pix_req_valid_i(pix_req_valid), .pix_req_ready_o(pix_req_ready), .pix_req_addr_i(pix_req_addr),
    .pix_next_o(pix_next), .pix_data_i(pix_data), .pix_mask_i(pix_mask),
    .host_req_valid_i(host_req_valid), .host_req_ready_o(host_req_ready),
    .host_req_write_i(host_req_write), .host_req_addr_i(host_req_addr), .host_next_o(host_next),
    .host_wr_data_i(host_wr_data), .host_rd_valid_o(host_rd_valid), .host_rd_data_o(host_rd_data),
    .sd_cke_o, .sd_cs_no, .sd_ras_no, .sd_cas_no, .sd_we_no, .sd_ba_o, .sd_a_o, .sd_dqm_o, .sd_dq_o,
    .sd_dq_oe_o, .sd_dq_oe_next_o, .sd_dq_i);

  // ---- LEDs: memory ready, armed, frame runs, frame done, underruns, queue of the video failed,
  // RX, TX.
  logic queue_failed_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) queue_failed_q <= 1'b0;
    else         queue_failed_q <= queue_failed_q || overflow;
  end

  assign led_o = {!tx_o, !rx_i, queue_failed_q, underruns != '0, done, running, armed, init_done};

  logic unused;
  assign unused = ^{underflow, pixel_x, pixel_y, shown_width};
endmodule
`default_nettype wire
