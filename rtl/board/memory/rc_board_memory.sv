// The board's memory: rc_sdram and the arbiter of its four clients.
//   chip:   reads; an answer is a whole line with its id
//   scan:   reads of the scan-out; beats in the order of the requests
//   pixels: writes of the pixel writer
//   host:   reads and writes of the host link
//
// Priority: scan if it is urgent; then chip and pixels in turn; then scan; then host. After
// HostCap granted requests of other clients, a waiting request of host goes first. No cycle is
// reserved: a client without competitors is served whenever the controller is free. A request
// passes to rc_sdram in the cycle in which it is granted.
//
// No combinational path leads through the arbiter, because its clients lie far apart in the
// device. A request of chip first enters a register here, and chip's ready is high while this
// register is free. The other clients hold their request in a register of their own. Their ready
// is high for one cycle, the one after the grant.
//
// The answer to chip is valid for one cycle, the one after the line's last beat. A client of
// writes presents the data of its oldest request and shifts them with `next`. The module
// has the parameters of rc_sdram. model/board/memory_clients.hpp is the model.
`default_nettype none
module rc_board_memory #(
  parameter  int unsigned ClkKhz     = 75_000,
  parameter  int unsigned RowBits    = 13,
  parameter  int unsigned ColumnBits = 10,
  parameter  int unsigned Cl         = 2,
  parameter  int unsigned RcdPs      = 21_000,
  parameter  int unsigned RpPs       = 21_000,
  parameter  int unsigned RasPs      = 42_000,
  parameter  int unsigned RcPs       = 63_000,
  parameter  int unsigned RrdPs      = 14_000,
  parameter  int unsigned WrPs       = 14_000,
  parameter  int unsigned WrClocks   = 2,
  parameter  int unsigned RfcPs      = 63_000,
  parameter  int unsigned RefiPs     = 7_800_000,
  parameter  int unsigned MrdClocks  = 2,
  parameter  int unsigned InitUs     = 200,
  parameter  int unsigned InitRefreshes = 8,
  parameter  int unsigned ReadDelay  = 0,
  localparam int unsigned LineW      = RowBits + 2 + ColumnBits - 5
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  output logic             init_done_o,
  input  logic             align_i,   // begins a refresh, and gives the chip the next turn
  // Chip
  input  logic             mem_req_valid_i,
  output logic             mem_req_ready_o,
  input  rc_pkg::mem_req_t mem_req_i,
  output logic             mem_rsp_fires_o,
  output rc_pkg::mem_rsp_t mem_rsp_o,
  // Scan-out
  input  logic             scan_req_valid_i,
  output logic             scan_req_ready_o,
  input  logic [LineW-1:0] scan_req_addr_i,
  input  logic             scan_urgent_i,
  output logic             scan_rd_valid_o,
  output logic [15:0]      scan_rd_data_o,
  // Pixel writer
  input  logic             pix_req_valid_i,
  output logic             pix_req_ready_o,
  input  logic [LineW-1:0] pix_req_addr_i,
  output logic             pix_next_o,
  input  logic [15:0]      pix_data_i,
  input  logic [1:0]       pix_mask_i,
  // Host
  input  logic             host_req_valid_i,
  output logic             host_req_ready_o,
  input  logic             host_req_write_i,
  input  logic [LineW-1:0] host_req_addr_i,
  output logic             host_next_o,
  input  logic [15:0]      host_wr_data_i,
  output logic             host_rd_valid_o,
  output logic [15:0]      host_rd_data_o,
  // Pins
  output logic             sd_cke_o,
  output logic             sd_cs_no,
  output logic             sd_ras_no,
  output logic             sd_cas_no,
  output logic             sd_we_no,
  output logic [1:0]       sd_ba_o,
  output logic [12:0]      sd_a_o,
  output logic [1:0]       sd_dqm_o,
  output logic [15:0]      sd_dq_o,
  output logic             sd_dq_oe_o,
  output logic             sd_dq_oe_next_o,
  input  logic [15:0]      sd_dq_i
);
  localparam int unsigned LineBits = 512;
  localparam int unsigned IdW      = rc_pkg::MemRspW - LineBits;
  localparam int unsigned AddrW    = rc_pkg::MemReqW - IdW;
  localparam int unsigned TagW     = IdW + 2;
  localparam int unsigned HostCap  = 15;

  // The client in the upper two bits of a tag.
  localparam logic [1:0] OfChip = 2'd0;
  localparam logic [1:0] OfScan = 2'd1;
  localparam logic [1:0] OfPix  = 2'd2;
  localparam logic [1:0] OfHost = 2'd3;

  // ---- The request of chip.
  logic             chip_held_q, chip_fires;
  logic [IdW-1:0]   chip_id_q;
  logic [AddrW-1:0] chip_addr_q;

  assign mem_req_ready_o = !chip_held_q;

  always_ff @(posedge clk_i) begin
    chip_held_q <= rst_ni && (chip_held_q ? !chip_fires : mem_req_valid_i);
    if (!chip_held_q) {chip_id_q, chip_addr_q} <= mem_req_i;
  end

  // ---- Arbiter. A client that was granted in the last cycle still offers the same request.
  logic             free, scan_offers, pix_offers, host_offers, any_offers;
  logic             host_is_due, host_first, scan_first;
  logic             chip_grant, scan_grant, pix_grant, host_grant;   // at most one
  logic             scan_fires, pix_fires, host_fires;
  logic             scan_ready_q, pix_ready_q, host_ready_q;
  logic             pix_turn_q;      // of chip and pixels, pixels has the turn
  logic [3:0]       overtaken_q;     // requests granted while host waits
  logic             req_write;
  logic [1:0]       req_client;
  logic [LineW-1:0] req_addr;

  assign scan_offers = scan_req_valid_i && !scan_ready_q;
  assign pix_offers  = pix_req_valid_i && !pix_ready_q;
  assign host_offers = host_req_valid_i && !host_ready_q;
  assign any_offers  = chip_held_q || scan_offers || pix_offers || host_offers;

  assign host_is_due = overtaken_q == 4'(HostCap);
  assign host_first  = host_offers && host_is_due;
  assign scan_first  = scan_offers && scan_urgent_i;

  assign chip_grant = chip_held_q && !host_first && !scan_first && !(pix_offers && pix_turn_q);
  assign pix_grant  = pix_offers && !host_first && !scan_first && !(chip_held_q && !pix_turn_q);
  assign scan_grant = scan_offers && !host_first
                   && (scan_urgent_i || (!chip_held_q && !pix_offers));
  assign host_grant = host_offers && (host_is_due || (!chip_held_q && !pix_offers && !scan_offers));

  assign chip_fires = free && chip_grant;
  assign scan_fires = free && scan_grant;
  assign pix_fires  = free && pix_grant;
  assign host_fires = free && host_grant;

  assign req_client = chip_grant ? OfChip : scan_grant ? OfScan : pix_grant ? OfPix : OfHost;
  assign req_write  = pix_grant || (host_grant && host_req_write_i);
  assign req_addr   = chip_grant ? LineW'(chip_addr_q) : scan_grant ? scan_req_addr_i
                    : pix_grant ? pix_req_addr_i : host_req_addr_i;

  always_ff @(posedge clk_i) begin
    scan_ready_q <= rst_ni && scan_fires;
    pix_ready_q  <= rst_ni && pix_fires;
    host_ready_q <= rst_ni && host_fires;
    if (!rst_ni) begin
      pix_turn_q  <= 1'b0;
      overtaken_q <= '0;
    end else begin
      if (align_i)                      pix_turn_q <= 1'b0;
      else if (chip_fires || pix_fires) pix_turn_q <= chip_fires;
      if (!host_offers || host_fires) overtaken_q <= '0;
      else if (free && any_offers)    overtaken_q <= overtaken_q + 4'd1;
    end
  end

  assign scan_req_ready_o = scan_ready_q;
  assign pix_req_ready_o  = pix_ready_q;
  assign host_req_ready_o = host_ready_q;

  // ---- Controller.
  logic            wr_next, rd_valid, rd_last;
  logic [TagW-1:0] wr_tag, rd_tag;
  logic [1:0]      wr_client, rd_client, wr_mask;
  logic [15:0]     wr_data, rd_data;

  rc_sdram #(
    .ClkKhz(ClkKhz), .RowBits(RowBits), .ColumnBits(ColumnBits), .Cl(Cl), .RcdPs(RcdPs),
    .RpPs(RpPs), .RasPs(RasPs), .RcPs(RcPs), .RrdPs(RrdPs), .WrPs(WrPs), .WrClocks(WrClocks),
    .RfcPs(RfcPs), .RefiPs(RefiPs), .MrdClocks(MrdClocks), .InitUs(InitUs),
    .InitRefreshes(InitRefreshes), .ReadDelay(ReadDelay), .TagW(TagW)
  ) u_sdram (
    .clk_i, .rst_ni, .init_done_o, .align_i,
    .req_valid_i(any_offers), .req_ready_o(free), .req_write_i(req_write), .req_addr_i(req_addr),
    .req_tag_i({req_client, chip_id_q}),
    .wr_next_o(wr_next), .wr_tag_o(wr_tag), .wr_data_i(wr_data), .wr_mask_i(wr_mask),
    .rd_valid_o(rd_valid), .rd_last_o(rd_last), .rd_tag_o(rd_tag), .rd_data_o(rd_data),
    .sd_cke_o, .sd_cs_no, .sd_ras_no, .sd_cas_no, .sd_we_no, .sd_ba_o, .sd_a_o, .sd_dqm_o,
    .sd_dq_o, .sd_dq_oe_o, .sd_dq_oe_next_o, .sd_dq_i);

  assign wr_client   = wr_tag[TagW-1 -: 2];
  assign pix_next_o  = wr_next && wr_client == OfPix;
  assign host_next_o = wr_next && wr_client == OfHost;
  assign wr_data     = wr_client == OfPix ? pix_data_i : host_wr_data_i;
  assign wr_mask     = wr_client == OfPix ? pix_mask_i : 2'b00;

  assign rd_client       = rd_tag[TagW-1 -: 2];
  assign scan_rd_valid_o = rd_valid && rd_client == OfScan;
  assign host_rd_valid_o = rd_valid && rd_client == OfHost;
  assign scan_rd_data_o  = rd_data;
  assign host_rd_data_o  = rd_data;

  // ---- Lines for the chip: the first beat ends in the lowest bits.
  logic                chip_beat, rsp_fires_q;
  logic [IdW-1:0]      rsp_id_q;
  logic [LineBits-1:0] line_q;

  assign chip_beat = rd_valid && rd_client == OfChip;

  always_ff @(posedge clk_i) begin
    rsp_fires_q <= rst_ni && chip_beat && rd_last;
    if (chip_beat) begin
      rsp_id_q <= rd_tag[IdW-1:0];
      line_q   <= {rd_data, line_q[LineBits-1:16]};
    end
  end

  assign mem_rsp_fires_o = rsp_fires_q;
  assign mem_rsp_o       = {rsp_id_q, line_q};

  logic unused;
  assign unused = ^{wr_tag, chip_addr_q};
endmodule
`default_nettype wire
