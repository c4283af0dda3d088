// Scan-out: reads the shown picture from memory and produces the pixels of a screen with 640x480
// pixels at 60 Hz.
//
// A frame has 800x525 pixel clocks (640+16+96+48 by 480+10+2+33, both syncs active low). A phase
// accumulator gives one tick for every pixel clock: PixelKhz ticks in ChipKhz cycles, evenly
// spread. Only the ratio of the two parameters matters, and it must be the ratio of the clocks. A
// tick's pixel leaves four cycles later, without back-pressure.
//
// The picture lies in memory in blocks of 4x4 pixels, one line of 64 bytes each. So its lines are
// read in ascending order from base_i. Two row buffers hold four rows of pixels each. While the
// beam shows a row of blocks, the next one is fetched. A row buffer is opened for fetching when
// the beam leaves its last pixel.
//
// Blocks fall due at an even pace: all blocks of a row within the time in which a row is shown.
// urgent_o is high from the cycle after the offered block falls due until the block is accepted.
// Underruns are impossible if the memory keeps this pace while urgent_o is high (conditions:
// worst_line_cycles() in model/board/scan_out.hpp).
//
// base_i, width_i, height_i and double_i are taken over at the start of the vertical blank
// (takes_o). Lines of the last picture that still arrive are discarded. A picture that does not
// fit the screen, or has no pixels, is not fetched: the screen is black. double_i shows each
// pixel as 2x2. The picture is centred; an odd margin is smaller at the left and at the top.
//
// A pixel that is shown before its block has arrived is black and counted (underruns_o,
// saturating).
// Model: model/board/scan_out.hpp (ScanOut).
`default_nettype none
module rc_scan_out #(
  parameter int unsigned ChipKhz  = 75000,
  parameter int unsigned PixelKhz = 25000,
  parameter int unsigned LineW    = 20,     // bits of a line number
  parameter int unsigned InFlight = 4       // lines offered or requested that have not arrived
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  // Picture
  input  logic [LineW-1:0] base_i,
  input  logic [15:0]      width_i,
  input  logic [15:0]      height_i,
  input  logic             double_i,
  output logic             takes_o,         // the picture is taken over at the end of this cycle
  output logic             nears_o,         // 100 pixel clocks before: no line is in flight
  output logic [15:0]      underruns_o,
  // To and from the memory: lines in the order of requests, 32 beats each
  output logic             req_valid_o,
  input  logic             req_ready_i,
  output logic [LineW-1:0] req_addr_o,
  output logic             urgent_o,        // the offered line is due
  input  logic             rd_valid_i,
  input  logic [15:0]      rd_data_i,
  // To the screen
  output logic             pixel_valid_o,
  output logic [23:0]      pixel_colour_o,  // red in bits 7:0, green in 15:8, blue in 23:16
  output logic             pixel_de_o,
  output logic             pixel_hsync_o,
  output logic             pixel_vsync_o
);
  localparam int unsigned ShownW = 640, HSyncAt = 656, HBackAt = 752, TotalW = 800;
  localparam int unsigned ShownH = 480, VSyncAt = 490, VBackAt = 492, TotalH = 525;
  localparam int unsigned Blocks    = ShownW / 4;              // of a row buffer
  localparam int unsigned PhaseW    = $clog2(ChipKhz + PixelKhz);
  localparam int unsigned PendingW  = InFlight < 1 ? 1 : $clog2(InFlight + 1);
  localparam int unsigned RowClocks = 4 * TotalW;              // pixel clocks of four lines
  localparam int unsigned CountW    = 15;                      // blocks of a picture: at most 19200

  if (PixelKhz < 1 || ChipKhz < PixelKhz) begin : gen_refuse
    $error("rc_scan_out: PixelKhz must be at least 1, and ChipKhz at least PixelKhz");
  end
  if (InFlight < 1) begin : gen_refuse_in_flight
    $error("rc_scan_out: InFlight must be at least 1");
  end

  // ---- Beam: one tick for each pixel clock. A reset begins at the vertical blank.
  logic [PhaseW-1:0] phase_q, phase_sum;
  logic              phase_wraps, tick_q, line_ends, takes;
  logic [9:0]        h_q, v_q;

  assign phase_sum   = phase_q + PhaseW'(PixelKhz);
  assign phase_wraps = phase_sum >= PhaseW'(ChipKhz);
  assign line_ends   = h_q == 10'(TotalW - 1);
  assign takes       = tick_q && h_q == '0 && v_q == 10'(ShownH);
  assign takes_o     = takes;
  assign nears_o     = tick_q && h_q == 10'(TotalW - 100) && v_q == 10'(ShownH - 1);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      phase_q <= '0;
      tick_q  <= 1'b0;
      h_q     <= '0;
      v_q     <= 10'(ShownH);
    end else begin
      phase_q <= phase_wraps ? phase_sum - PhaseW'(ChipKhz) : phase_sum;
      tick_q  <= phase_wraps;
      if (tick_q) h_q <= line_ends ? '0 : h_q + 1'b1;
      if (tick_q && line_ends) v_q <= v_q == 10'(TotalH - 1) ? '0 : v_q + 1'b1;
    end
  end

  // ---- Shown picture, and what follows from its size: valid when start_q is high.
  logic [LineW-1:0] base_q;
  logic [15:0]      width_q, height_q;
  logic             double_q, taken_q, start_q, shows_q;
  logic [10:0]      shown_w, shown_h;
  logic [9:0]       shown_w_q, shown_h_q, left_q, top_q;   // screen pixels
  logic [7:0]       blocks_q, rows_q;                      // of the picture, in blocks
  logic             fits;

  assign shown_w = double_q ? {width_q[9:0], 1'b0} : {1'b0, width_q[9:0]};
  assign shown_h = double_q ? {height_q[9:0], 1'b0} : {1'b0, height_q[9:0]};
  assign fits    = width_q[15:10] == '0 && height_q[15:10] == '0
                && shown_w <= 11'(ShownW) && shown_h <= 11'(ShownH);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      taken_q <= 1'b0;
      start_q <= 1'b0;
    end else begin
      taken_q <= takes;
      start_q <= taken_q;
    end
    if (takes) begin
      base_q   <= base_i;
      width_q  <= width_i;
      height_q <= height_i;
      double_q <= double_i;
    end
    shows_q   <= fits && width_q != '0 && height_q != '0;
    shown_w_q <= shown_w[9:0];
    shown_h_q <= shown_h[9:0];
    left_q    <= 10'((11'(ShownW) - shown_w) >> 1);
    top_q     <= 10'((11'(ShownH) - shown_h) >> 1);
    blocks_q  <= 8'((width_q[9:0] + 10'd3) >> 2);
    rows_q    <= 8'((height_q[9:0] + 10'd3) >> 2);
  end

  // ---- Row buffers: opened is the number of rows of blocks that may have been requested.
  // The beam leaves the last pixel of a row of blocks when the blank begins; opens_q is one cycle
  // later.
  logic [9:0] s1_y_q;      // lines of the screen below the picture's top, constant from h_q = 1 on
  logic       opens_q, last_line_q;
  logic [7:0] opened_q;

  always_ff @(posedge clk_i) begin
    last_line_q <= s1_y_q < shown_h_q && (double_q ? s1_y_q[2:0] == '1 : s1_y_q[1:0] == '1)
                && opened_q < rows_q;
    opens_q     <= rst_ni && tick_q && h_q == 10'(ShownW) && last_line_q;
  end

  // ---- Requests. to_request_q counts the blocks of opened rows that are not yet offered,
  // to_fall_q those that are not yet due.
  logic [CountW-1:0]   to_request_q, to_fall_q, added;
  logic [12:0]         pace_q, pace_sum, pace_limit;
  logic                falls, issues, line_done;
  logic                req_valid_q, urgent_q;
  logic [LineW-1:0]    addr_q, next_addr_q;
  logic [PendingW-1:0] pending_q, drop_q;

  assign pace_limit = double_q ? 13'(2 * RowClocks) : 13'(RowClocks);
  assign pace_sum   = pace_q + 13'(blocks_q);
  assign falls      = tick_q && to_fall_q != '0 && pace_sum >= pace_limit;
  assign issues     = to_request_q != '0 && pending_q != PendingW'(InFlight)
                   && (!req_valid_q || req_ready_i) && !takes;

  always_comb begin
    added = '0;
    if (start_q && shows_q) added = rows_q == 8'd1 ? CountW'(blocks_q) : CountW'({blocks_q, 1'b0});
    else if (opens_q)         added = CountW'(blocks_q);
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      req_valid_q  <= 1'b0;
      to_request_q <= '0;
      to_fall_q    <= '0;
      pending_q    <= '0;
      drop_q       <= '0;
      opened_q     <= '0;
    end else begin
      req_valid_q <= issues || (req_valid_q && !req_ready_i);
      pending_q   <= pending_q + PendingW'(issues) - PendingW'(line_done);
      if (takes)                             drop_q <= pending_q - PendingW'(line_done);
      else if (line_done && drop_q != '0)    drop_q <= drop_q - 1'b1;

      if (takes) begin
        to_request_q <= '0;
        to_fall_q    <= '0;
      end else begin
        to_request_q <= to_request_q + added - CountW'(issues);
        to_fall_q    <= to_fall_q + added - CountW'(falls);
      end

      if (takes)                   opened_q <= '1;   // opens nothing until the start
      else if (start_q && shows_q) opened_q <= 8'd2;
      else if (opens_q)              opened_q <= opened_q + 1'b1;
    end

    if (takes)                        pace_q <= '0;
    else if (tick_q && to_fall_q != '0) pace_q <= falls ? pace_sum - pace_limit : pace_sum;

    urgent_q <= rst_ni && req_valid_q && !req_ready_i && to_request_q >= to_fall_q;

    if (issues) addr_q <= next_addr_q;
    if (start_q)     next_addr_q <= base_q;
    else if (issues) next_addr_q <= next_addr_q + 1'b1;
  end

  assign req_valid_o = req_valid_q;
  assign req_addr_o  = addr_q;
  assign urgent_o    = urgent_q;

  // ---- Arrival: two beats make a pixel. All blocks before block arrived_q of row arrived_row_q
  // are in the row buffers.
  logic [4:0]  beat_q;
  logic [15:0] low_q;
  logic        keeps;
  logic [7:0]  arrived_q, arrived_row_q;
  logic [8:0]  write_block;

  assign line_done   = rd_valid_i && beat_q == '1;
  assign keeps       = drop_q == '0;
  assign write_block = arrived_row_q[0] ? 9'(arrived_q) + 9'(Blocks) : 9'(arrived_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni)         beat_q <= '0;
    else if (rd_valid_i) beat_q <= beat_q + 1'b1;
    if (rd_valid_i) low_q <= rd_data_i;

    if (!rst_ni || takes) begin
      arrived_q     <= '0;
      arrived_row_q <= '0;
    end else if (line_done && keeps) begin
      arrived_q <= arrived_q + 1'b1;
      if (arrived_q + 1'b1 == blocks_q) begin
        arrived_q     <= '0;
        arrived_row_q <= arrived_row_q + 1'b1;
      end
    end
  end

  // ---- Stage 1: position of the beam in the picture. A position outside wraps to a number above
  // the picture's size.
  logic       s1_valid_q, s1_de_q, s1_hsync_q, s1_vsync_q;
  logic [9:0] s1_x_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) s1_valid_q <= 1'b0;
    else         s1_valid_q <= tick_q;
    s1_de_q    <= h_q < 10'(ShownW) && v_q < 10'(ShownH);
    s1_hsync_q <= !(h_q >= 10'(HSyncAt) && h_q < 10'(HBackAt));
    s1_x_q     <= h_q - left_q;
    s1_y_q     <= v_q - top_q;
  end

  // The vertical sync changes with the leading edge of the horizontal sync.
  always_ff @(posedge clk_i) begin
    if (!rst_ni) s1_vsync_q <= 1'b1;
    else if (tick_q && h_q == 10'(HSyncAt))
      s1_vsync_q <= !(v_q >= 10'(VSyncAt - 1) && v_q < 10'(VBackAt - 1));
  end

  // ---- Stage 2: the block and its place in the row buffers.
  logic       s2_valid_q, s2_de_q, s2_hsync_q, s2_vsync_q, s2_in_q;
  logic [9:0] s1_x, s1_y;             // pixels of the picture
  logic [7:0] s2_block_q, s2_row_q;
  logic [8:0] s2_read_block_q;
  logic [3:0] s2_word_q;

  assign s1_x = double_q ? s1_x_q >> 1 : s1_x_q;
  assign s1_y = double_q ? s1_y_q >> 1 : s1_y_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) s2_valid_q <= 1'b0;
    else         s2_valid_q <= s1_valid_q;
    s2_de_q         <= s1_de_q;
    s2_hsync_q      <= s1_hsync_q;
    s2_vsync_q      <= s1_vsync_q;
    s2_in_q         <= s1_de_q && shows_q && s1_x_q < shown_w_q && s1_y_q < shown_h_q;
    s2_block_q      <= s1_x[9:2];
    s2_row_q        <= s1_y[9:2];
    s2_read_block_q <= s1_y[2] ? 9'(s1_x[9:2]) + 9'(Blocks) : 9'(s1_x[9:2]);
    s2_word_q       <= {s1_y[1:0], s1_x[1:0]};
  end

  // ---- Stage 3: the pixel from the row buffers.
  logic        s3_valid_q, s3_de_q, s3_hsync_q, s3_vsync_q, s3_in_q, s3_arrived_q;
  logic [23:0] s3_pixel;

  rc_ram_sync #(.Width(24), .Depth(2 * Blocks * 16)) u_rows (
    .clk_i,
    .write_i(rd_valid_i && beat_q[0] && keeps),
    .write_addr_i({write_block, beat_q[4:1]}),
    .write_data_i({rd_data_i[7:0], low_q}),
    .read_i(s2_valid_q && s2_in_q),
    .read_addr_i({s2_read_block_q, s2_word_q}),
    .read_data_o(s3_pixel));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) s3_valid_q <= 1'b0;
    else         s3_valid_q <= s2_valid_q;
    s3_de_q      <= s2_de_q;
    s3_hsync_q   <= s2_hsync_q;
    s3_vsync_q   <= s2_vsync_q;
    s3_in_q      <= s2_in_q;
    s3_arrived_q <= s2_row_q < arrived_row_q
                 || (s2_row_q == arrived_row_q && s2_block_q < arrived_q);
  end

  // ---- Stage 4: output.
  logic [15:0] underruns_q;
  logic        out_valid_q, out_de_q, out_hsync_q, out_vsync_q;
  logic [23:0] out_colour_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      out_valid_q <= 1'b0;
      underruns_q <= '0;
    end else begin
      out_valid_q <= s3_valid_q;
      if (s3_valid_q && s3_in_q && !s3_arrived_q && underruns_q != '1)
        underruns_q <= underruns_q + 1'b1;
    end
    out_de_q     <= s3_de_q;
    out_hsync_q  <= s3_hsync_q;
    out_vsync_q  <= s3_vsync_q;
    out_colour_q <= s3_in_q && s3_arrived_q ? s3_pixel : '0;
  end

  assign underruns_o    = underruns_q;
  assign pixel_valid_o  = out_valid_q;
  assign pixel_colour_o = out_colour_q;
  assign pixel_de_o     = out_de_q;
  assign pixel_hsync_o  = out_hsync_q;
  assign pixel_vsync_o  = out_vsync_q;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i)
    if (rst_ni && rd_valid_i) a_line_was_requested: assert (pending_q != '0)
      else $error("a beat arrives that was not requested");
`endif
endmodule
`default_nettype wire
