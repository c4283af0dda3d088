// The top of a ULX3S board (LFE5U-85F): clocks, resets and input-output cells around rc_board. It
// is for synthesis only; ulx3s.lpf has its pins. Ports carry the names of the board's schematic.
//
// One PLL makes all clocks from 25 MHz: the chip's clock, 125 MHz and 25 MHz for the screen, and
// the SDRAM's clock, which lags the chip's by three quarters of a period. CLK_KHZ is 75000 (VCO 750
// MHz) or 62500 (625 MHz). ReadDelay of rc_board is 1: the input registers capture data 1 1/4
// periods after the edge of the SDRAM's clock. docs/machine/board.md has the margins at the pins.
`default_nettype none
module rc_ulx3s #(
  parameter integer CLK_KHZ     = 75000,
  parameter integer BAUD        = 3000000,
  parameter integer COLUMN_BITS = 10,          // 10: AS4C32M16SB (64 MB), 9: IS42S16160G (32 MB)
  parameter integer COUNTERS    = 1,
  parameter [63:0]  CONFIG_HASH = 64'd0
) (
  input  wire        clk_25mhz,
  input  wire        btn_pwr_n,                // pressed: reset
  // USB bridge
  output wire        ftdi_rxd,
  input  wire        ftdi_txd,
  // SDRAM
  output wire        sdram_clk,
  output wire        sdram_cke,
  output wire        sdram_csn,
  output wire        sdram_rasn,
  output wire        sdram_casn,
  output wire        sdram_wen,
  output wire [1:0]  sdram_ba,
  output wire [12:0] sdram_a,
  output wire [1:0]  sdram_dqm,
  inout  wire [15:0] sdram_d,
  // Screen: blue, green, red, clock
  output wire [3:0]  gpdi_dp,
  // Others
  output wire [7:0]  led,
  output wire        wifi_gpio0                // high, so that the ESP32 leaves the FPGA alone
);
  localparam integer IS_75    = CLK_KHZ == 75000;
  localparam integer CLKI_DIV = IS_75 ? 1 : 2;
  localparam integer FB_DIV   = IS_75 ? 3 : 5;
  localparam integer CHIP_DIV = 10;
  localparam integer BIT_DIV  = IS_75 ? 6 : 5;
  localparam integer DOT_DIV  = IS_75 ? 30 : 25;

  // ---- Clocks.
  wire clk, shift_clk, pixel_clk, memory_clk, locked;

  (* FREQUENCY_PIN_CLKI = "25" *)
  (* ICP_CURRENT = "12" *) (* LPF_RESISTOR = "8" *)
  (* MFG_ENABLE_FILTEROPAMP = "1" *) (* MFG_GMCREF_SEL = "2" *)
  EHXPLLL #(
    .PLLRST_ENA("DISABLED"), .INTFB_WAKE("DISABLED"), .STDBY_ENABLE("DISABLED"),
    .DPHASE_SOURCE("DISABLED"), .OUTDIVIDER_MUXA("DIVA"), .OUTDIVIDER_MUXB("DIVB"),
    .OUTDIVIDER_MUXC("DIVC"), .OUTDIVIDER_MUXD("DIVD"),
    .CLKI_DIV(CLKI_DIV), .CLKFB_DIV(FB_DIV), .FEEDBK_PATH("CLKOP"),
    .CLKOP_ENABLE("ENABLED"), .CLKOP_DIV(CHIP_DIV), .CLKOP_CPHASE(5), .CLKOP_FPHASE(0),
    .CLKOS_ENABLE("ENABLED"), .CLKOS_DIV(BIT_DIV), .CLKOS_CPHASE(5), .CLKOS_FPHASE(0),
    .CLKOS2_ENABLE("ENABLED"), .CLKOS2_DIV(DOT_DIV), .CLKOS2_CPHASE(5), .CLKOS2_FPHASE(0),
    // Later than CLKOP by 7 4/8 of the 10 VCO periods in a period of the chip's clock.
    .CLKOS3_ENABLE("ENABLED"), .CLKOS3_DIV(CHIP_DIV), .CLKOS3_CPHASE(12), .CLKOS3_FPHASE(4)
  ) u_pll (
    .RST(1'b0), .STDBY(1'b0), .CLKI(clk_25mhz), .CLKFB(clk),
    .CLKOP(clk), .CLKOS(shift_clk), .CLKOS2(pixel_clk), .CLKOS3(memory_clk), .LOCK(locked),
    .PHASESEL0(1'b0), .PHASESEL1(1'b0), .PHASEDIR(1'b1), .PHASESTEP(1'b1), .PHASELOADREG(1'b1),
    .PLLWAKESYNC(1'b0), .ENCLKOP(1'b0));

  // ---- Resets end 65,536 cycles after the PLL locks or the button is released. A cache clears its
  // tags in less time. The other domains leave the reset after the chip's.
  reg [16:0] wait_q = 17'd0;
  reg [1:0]  button_q = 2'd0;
  reg [1:0]  pixel_reset_q = 2'd0, shift_reset_q = 2'd0;
  wire       rst_n = wait_q[16];

  always @(posedge clk or negedge locked) begin
    if (!locked) begin
      wait_q   <= 17'd0;
      button_q <= 2'd0;
    end else begin
      button_q <= {button_q[0], btn_pwr_n};
      if (!button_q[1])     wait_q <= 17'd0;
      else if (!wait_q[16]) wait_q <= wait_q + 17'd1;
    end
  end

  always @(posedge pixel_clk) pixel_reset_q <= {pixel_reset_q[0], rst_n};
  always @(posedge shift_clk) shift_reset_q <= {shift_reset_q[0], rst_n};

  // ---- The board.
  wire [15:0] dq_out, dq_in;
  wire        dq_oe_next;
  wire [15:0] dq_off;
  wire [7:0]  tmds;

  rc_board #(
    .ClkKhz(CLK_KHZ), .Baud(BAUD), .ColumnBits(COLUMN_BITS), .Counters(COUNTERS),
    .ConfigHash(CONFIG_HASH)
  ) u_board (
    .clk_i(clk), .rst_ni(rst_n), .pixel_clk_i(pixel_clk), .pixel_rst_ni(pixel_reset_q[1]),
    .shift_clk_i(shift_clk), .shift_rst_ni(shift_reset_q[1]),
    .rx_i(ftdi_txd), .tx_o(ftdi_rxd),
    .sd_cke_o(sdram_cke), .sd_cs_no(sdram_csn), .sd_ras_no(sdram_rasn), .sd_cas_no(sdram_casn),
    .sd_we_no(sdram_wen), .sd_ba_o(sdram_ba), .sd_a_o(sdram_a), .sd_dqm_o(sdram_dqm),
    .sd_dq_o(dq_out), .sd_dq_oe_o(), .sd_dq_oe_next_o(dq_oe_next),
    .sd_dq_i(dq_in),
    .tmds_o(tmds), .led_o(led));

  assign wifi_gpio0 = 1'b1;

  // ---- Cells at the pins. Each data pin has a register of its own that disables its output.
  // `rayclock chip` moves the other registers at the SDRAM's pins into the cells of the pins.
  genvar i;
  generate
    for (i = 0; i < 16; i = i + 1) begin : gen_dq
      (* syn_useioff, ioff_dir = "output" *)
      TRELLIS_FF #(
        .GSR("DISABLED"), .CEMUX("1"), .CLKMUX("CLK"), .LSRMUX("LSR"), .REGSET("SET")
      ) u_off (.CLK(clk), .LSR(1'b0), .DI(!dq_oe_next), .Q(dq_off[i]));
      BB u_dq (.I(dq_out[i]), .T(dq_off[i]), .O(dq_in[i]), .B(sdram_d[i]));
    end
    for (i = 0; i < 4; i = i + 1) begin : gen_tmds
      ODDRX1F u_ddr (.D0(tmds[2*i]), .D1(tmds[2*i+1]), .SCLK(shift_clk), .RST(1'b0), .Q(gpdi_dp[i]));
    end
  endgenerate

  ODDRX1F u_memory_clk (.D0(1'b1), .D1(1'b0), .SCLK(memory_clk), .RST(1'b0), .Q(sdram_clk));
endmodule
`default_nettype wire
