// Video output: takes the pixels of scan-out to the pixel clock, encodes them as TMDS, and
// serialises them to two bits per shift clock and channel.
//
// The shift clock has five times the pixel clock's frequency and a constant phase. tmds_o holds a
// pair of bits for each of blue, green, red and the clock, blue in the lowest two bits. The lower
// bit of a pair is sent first. rtl/ecp5/rc_ulx3s.v connects them to output cells. All three
// resets must be active together. While the queue starts, the screen is in the blank with
// inactive syncs.
`default_nettype none
module rc_video (
  // Chip's clock
  input  logic        clk_i,
  input  logic        rst_ni,
  input  logic        pixel_valid_i,
  input  logic [23:0] pixel_colour_i,   // red in bits 7:0, green in 15:8, blue in 23:16
  input  logic        pixel_de_i,
  input  logic        pixel_hsync_i,
  input  logic        pixel_vsync_i,
  output logic        overflow_o,       // see rc_video_fifo
  // Pixel clock
  input  logic        pixel_clk_i,
  input  logic        pixel_rst_ni,
  output logic        underflow_o,
  // Shift clock
  input  logic        shift_clk_i,
  input  logic        shift_rst_ni,
  output logic [7:0]  tmds_o
);
  logic        valid, of_fifo_de, of_fifo_hsync, of_fifo_vsync, de, hsync, vsync;
  logic [23:0] colour;

  rc_video_fifo #(.Width(27), .Depth(16)) u_fifo (
    .clk_i, .rst_ni,
    .valid_i(pixel_valid_i),
    .data_i({pixel_de_i, pixel_hsync_i, pixel_vsync_i, pixel_colour_i}),
    .overflow_o,
    .pixel_clk_i, .pixel_rst_ni,
    .valid_o(valid),
    .data_o({of_fifo_de, of_fifo_hsync, of_fifo_vsync, colour}),
    .underflow_o);

  assign de    = valid && of_fifo_de;
  assign hsync = !valid || of_fifo_hsync;
  assign vsync = !valid || of_fifo_vsync;

  logic toggle_q;
  always_ff @(posedge pixel_clk_i) begin
    if (!pixel_rst_ni) toggle_q <= 1'b0;
    else               toggle_q <= !toggle_q;
  end

  // Channels: blue with the syncs, green, red, and the pixel clock as a fourth.
  logic [39:0] symbols;

  rc_tmds u_blue (
    .clk_i(pixel_clk_i), .de_i(de), .data_i(colour[23:16]), .control_i({vsync, hsync}),
    .symbol_o(symbols[9:0]));
  rc_tmds u_green (
    .clk_i(pixel_clk_i), .de_i(de), .data_i(colour[15:8]), .control_i(2'b00),
    .symbol_o(symbols[19:10]));
  rc_tmds u_red (
    .clk_i(pixel_clk_i), .de_i(de), .data_i(colour[7:0]), .control_i(2'b00),
    .symbol_o(symbols[29:20]));
  assign symbols[39:30] = 10'b0000011111;

  for (genvar i = 0; i < 4; i++) begin : gen_channel
    rc_serialiser u_serialiser (
      .shift_clk_i, .shift_rst_ni, .pixel_toggle_i(toggle_q),
      .symbol_i(symbols[10*i +: 10]), .pair_o(tmds_o[2*i +: 2]));
  end
endmodule
`default_nettype wire
