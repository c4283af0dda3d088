// Cells of the ECP5 that Yosys has no models of: block memory and multiplier, as far as netlists of
// this project use them. What is not modelled is refused when a simulation is built, or stops it.
//
// Only netlists are simulated with them (sim/run/rtl/gates.hpp); the models of the other cells are Yosys'
// own. A cell does here what Yosys' maps mean by it: techlibs/ecp5, brams.txt, brams_map.v, dsp_map.v.
`default_nettype none

// 18 Kbit, written through port A and read through port B, with one clock; both ports are 36, 18 or 9
// bits wide. The lowest bits of the writer's address enable its bytes of nine bits, if it has more
// than one. With 36 bits the ports share their pins for data; otherwise port A returns the previous
// content. A word that port B reads in the cycle in which it is written must not be used: the model
// inverts its bits.
module DP16KD (
  input  wire CLKA, CEA, OCEA, WEA, RSTA, CSA2, CSA1, CSA0,
  input  wire CLKB, CEB, OCEB, WEB, RSTB, CSB2, CSB1, CSB0,
  input  wire ADA13, ADA12, ADA11, ADA10, ADA9, ADA8, ADA7, ADA6, ADA5,
              ADA4, ADA3, ADA2, ADA1, ADA0,
  input  wire ADB13, ADB12, ADB11, ADB10, ADB9, ADB8, ADB7, ADB6, ADB5,
              ADB4, ADB3, ADB2, ADB1, ADB0,
  input  wire DIA17, DIA16, DIA15, DIA14, DIA13, DIA12, DIA11, DIA10, DIA9,
              DIA8, DIA7, DIA6, DIA5, DIA4, DIA3, DIA2, DIA1, DIA0,
  input  wire DIB17, DIB16, DIB15, DIB14, DIB13, DIB12, DIB11, DIB10, DIB9,
              DIB8, DIB7, DIB6, DIB5, DIB4, DIB3, DIB2, DIB1, DIB0,
  output wire DOA17, DOA16, DOA15, DOA14, DOA13, DOA12, DOA11, DOA10, DOA9,
              DOA8, DOA7, DOA6, DOA5, DOA4, DOA3, DOA2, DOA1, DOA0,
  output wire DOB17, DOB16, DOB15, DOB14, DOB13, DOB12, DOB11, DOB10, DOB9,
              DOB8, DOB7, DOB6, DOB5, DOB4, DOB3, DOB2, DOB1, DOB0
);
  parameter DATA_WIDTH_A = 18, DATA_WIDTH_B = 18;
  parameter REGMODE_A = "NOREG", REGMODE_B = "NOREG", RESETMODE = "SYNC";
  parameter WRITEMODE_A = "NORMAL", WRITEMODE_B = "NORMAL";
  parameter ASYNC_RESET_RELEASE = "SYNC", CSDECODE_A = "0b000", CSDECODE_B = "0b000";
  parameter CLKAMUX = "CLKA", CLKBMUX = "CLKB", GSR = "ENABLED";
  parameter [319:0] INITVAL_00 = 0, INITVAL_01 = 0, INITVAL_02 = 0, INITVAL_03 = 0;
  parameter [319:0] INITVAL_04 = 0, INITVAL_05 = 0, INITVAL_06 = 0, INITVAL_07 = 0;
  parameter [319:0] INITVAL_08 = 0, INITVAL_09 = 0, INITVAL_0A = 0, INITVAL_0B = 0;
  parameter [319:0] INITVAL_0C = 0, INITVAL_0D = 0, INITVAL_0E = 0, INITVAL_0F = 0;
  parameter [319:0] INITVAL_10 = 0, INITVAL_11 = 0, INITVAL_12 = 0, INITVAL_13 = 0;
  parameter [319:0] INITVAL_14 = 0, INITVAL_15 = 0, INITVAL_16 = 0, INITVAL_17 = 0;
  parameter [319:0] INITVAL_18 = 0, INITVAL_19 = 0, INITVAL_1A = 0, INITVAL_1B = 0;
  parameter [319:0] INITVAL_1C = 0, INITVAL_1D = 0, INITVAL_1E = 0, INITVAL_1F = 0;
  parameter [319:0] INITVAL_20 = 0, INITVAL_21 = 0, INITVAL_22 = 0, INITVAL_23 = 0;
  parameter [319:0] INITVAL_24 = 0, INITVAL_25 = 0, INITVAL_26 = 0, INITVAL_27 = 0;
  parameter [319:0] INITVAL_28 = 0, INITVAL_29 = 0, INITVAL_2A = 0, INITVAL_2B = 0;
  parameter [319:0] INITVAL_2C = 0, INITVAL_2D = 0, INITVAL_2E = 0, INITVAL_2F = 0;
  parameter [319:0] INITVAL_30 = 0, INITVAL_31 = 0, INITVAL_32 = 0, INITVAL_33 = 0;
  parameter [319:0] INITVAL_34 = 0, INITVAL_35 = 0, INITVAL_36 = 0, INITVAL_37 = 0;
  parameter [319:0] INITVAL_38 = 0, INITVAL_39 = 0, INITVAL_3A = 0, INITVAL_3B = 0;
  parameter [319:0] INITVAL_3C = 0, INITVAL_3D = 0, INITVAL_3E = 0, INITVAL_3F = 0;
  localparam [64*320-1:0] Begin = {
    INITVAL_3F, INITVAL_3E, INITVAL_3D, INITVAL_3C, INITVAL_3B, INITVAL_3A, INITVAL_39,
    INITVAL_38, INITVAL_37, INITVAL_36, INITVAL_35, INITVAL_34, INITVAL_33, INITVAL_32,
    INITVAL_31, INITVAL_30, INITVAL_2F, INITVAL_2E, INITVAL_2D, INITVAL_2C, INITVAL_2B,
    INITVAL_2A, INITVAL_29, INITVAL_28, INITVAL_27, INITVAL_26, INITVAL_25, INITVAL_24,
    INITVAL_23, INITVAL_22, INITVAL_21, INITVAL_20, INITVAL_1F, INITVAL_1E, INITVAL_1D,
    INITVAL_1C, INITVAL_1B, INITVAL_1A, INITVAL_19, INITVAL_18, INITVAL_17, INITVAL_16,
    INITVAL_15, INITVAL_14, INITVAL_13, INITVAL_12, INITVAL_11, INITVAL_10, INITVAL_0F,
    INITVAL_0E, INITVAL_0D, INITVAL_0C, INITVAL_0B, INITVAL_0A, INITVAL_09, INITVAL_08,
    INITVAL_07, INITVAL_06, INITVAL_05, INITVAL_04, INITVAL_03, INITVAL_02, INITVAL_01,
    INITVAL_00};
  localparam Bytes = DATA_WIDTH_A / 9;
  if (DATA_WIDTH_A != DATA_WIDTH_B || (Bytes != 4 && Bytes != 2 && Bytes != 1) ||
      DATA_WIDTH_A != 9 * Bytes) begin : gen_refuse_width
    $error("DP16KD: only ports that are both of 36, 18 or 9 bits are modelled");
  end
  if (Bytes != 4 && WRITEMODE_A != "READBEFOREWRITE") begin : gen_refuse_mode
    $error("DP16KD: a port A that tells anything but what was there before is not modelled");
  end
  if (REGMODE_A != "NOREG" || REGMODE_B != "NOREG") begin : gen_refuse_register
    $error("DP16KD: no register behind the memory is modelled");
  end
  if (CLKAMUX != "CLKA" || CLKBMUX != "CLKB" || CSDECODE_A != "0b000" || CSDECODE_B != "0b000")
  begin : gen_refuse_mux
    $error("DP16KD: only plain clocks and block selects are modelled");
  end

  wire [13:0] write_at = {ADA13, ADA12, ADA11, ADA10, ADA9, ADA8, ADA7, ADA6, ADA5,
                          ADA4, ADA3, ADA2, ADA1, ADA0};
  wire [13:0] read_at  = {ADB13, ADB12, ADB11, ADB10, ADB9, ADB8, ADB7, ADB6, ADB5,
                          ADB4, ADB3, ADB2, ADB1, ADB0};
  wire [35:0] in       = {
    DIB17, DIB16, DIB15, DIB14, DIB13, DIB12, DIB11, DIB10, DIB9,
    DIB8, DIB7, DIB6, DIB5, DIB4, DIB3, DIB2, DIB1, DIB0,
    DIA17, DIA16, DIA15, DIA14, DIA13, DIA12, DIA11, DIA10, DIA9,
    DIA8, DIA7, DIA6, DIA5, DIA4, DIA3, DIA2, DIA1, DIA0};
  wire        selected = {CSA2, CSA1, CSA0, CSB2, CSB1, CSB0} == 0;
  wire        writes   = CEA && WEA && selected;
  wire [3:0]  enabled  = Bytes == 1 ? 4'b0001 : write_at[3:0];
  wire [10:0] first_in = write_at[13:3] & ~(Bytes - 1);
  wire [10:0] first    = read_at[13:3] & ~(Bytes - 1);
  reg  [8:0]  mem [0:2047];
  reg  [35:0] out_q;      // of port B, and of port A
  reg  [17:0] before_q;
  initial begin   // each pair of bytes has 20 bits
    for (integer i = 0; i < 1024; i = i + 1) {mem[2*i+1], mem[2*i]} = Begin[20*i +: 18];
  end
  always @(posedge CLKA) begin
    for (integer i = 0; i < Bytes; i = i + 1) begin
      if (writes && enabled[i]) mem[first_in+i] <= in[9*i +: 9];
      if (CEA && i < 2) before_q[9*i +: 9] <= mem[first_in+i];
    end
  end
  always @(posedge CLKB) begin   // a table has no clock at port A
    for (integer i = 0; i < Bytes; i = i + 1) begin
      if (RSTB)
        out_q[9*i +: 9] <= 0;
      else if (CEB && selected)
        out_q[9*i +: 9] <= mem[first+i] ^ {9{writes && enabled[i] && first_in == first}};
    end
    if (WEB || RSTA || !OCEB || (RSTB && RESETMODE != "SYNC"))
      $fatal(1, "DP16KD: what its port B or its reset does is not modelled");
  end
  assign {
    DOB17, DOB16, DOB15, DOB14, DOB13, DOB12, DOB11, DOB10, DOB9,
    DOB8, DOB7, DOB6, DOB5, DOB4, DOB3, DOB2, DOB1, DOB0}
    = Bytes == 4 ? out_q[35:18] : out_q[17:0];
  assign {
    DOA17, DOA16, DOA15, DOA14, DOA13, DOA12, DOA11, DOA10, DOA9,
    DOA8, DOA7, DOA6, DOA5, DOA4, DOA3, DOA2, DOA1, DOA0}
    = Bytes == 4 ? out_q[17:0] : before_q;
endmodule

// Product of two operands of 18 bits, each signed or not, with registers at operands and product, or
// with none.
module MULT18X18D (
  input  wire A17, A16, A15, A14, A13, A12, A11, A10, A9,
              A8, A7, A6, A5, A4, A3, A2, A1, A0,
  input  wire B17, B16, B15, B14, B13, B12, B11, B10, B9,
              B8, B7, B6, B5, B4, B3, B2, B1, B0,
  input  wire C17, C16, C15, C14, C13, C12, C11, C10, C9,
              C8, C7, C6, C5, C4, C3, C2, C1, C0,
  input  wire SIGNEDA, SIGNEDB, SOURCEA, SOURCEB, CLK0, CE0, RST0,
  output wire P35, P34, P33, P32, P31, P30, P29, P28, P27,
              P26, P25, P24, P23, P22, P21, P20, P19, P18,
              P17, P16, P15, P14, P13, P12, P11, P10, P9,
              P8, P7, P6, P5, P4, P3, P2, P1, P0
);
  parameter REG_INPUTA_CLK = "NONE", REG_INPUTB_CLK = "NONE", REG_INPUTC_CLK = "NONE";
  parameter REG_PIPELINE_CLK = "NONE", REG_OUTPUT_CLK = "NONE";
  parameter [127:0] GSR = "ENABLED";
  localparam Registered = REG_INPUTA_CLK == "CLK0";
  if ((REG_INPUTA_CLK != "CLK0" && REG_INPUTA_CLK != "NONE") || REG_INPUTB_CLK != REG_INPUTA_CLK ||
      REG_OUTPUT_CLK != REG_INPUTA_CLK) begin : gen_refuse_registers
    $error("MULT18X18D: registers are modelled at both operands and the product, or nowhere");
  end
  if (REG_INPUTC_CLK != "NONE" || REG_PIPELINE_CLK != "NONE") begin : gen_refuse_pipeline
    $error("MULT18X18D: neither operand C nor the register within is modelled");
  end

  wire [17:0] a = {A17, A16, A15, A14, A13, A12, A11, A10, A9,
                   A8, A7, A6, A5, A4, A3, A2, A1, A0};
  wire [17:0] b = {B17, B16, B15, B14, B13, B12, B11, B10, B9,
                   B8, B7, B6, B5, B4, B3, B2, B1, B0};
  reg  [18:0] a_q, b_q;
  reg  [35:0] p_q;
  wire [18:0] a_now = Registered ? a_q : {SIGNEDA & a[17], a};
  wire [18:0] b_now = Registered ? b_q : {SIGNEDB & b[17], b};
  wire [35:0] p_now = $signed(a_now) * $signed(b_now);
  if (Registered) begin : gen_registers
    always @(posedge CLK0) begin
      if (CE0) begin
        a_q <= {SIGNEDA & a[17], a};
        b_q <= {SIGNEDB & b[17], b};
        p_q <= p_now;
      end
      if (RST0 || SOURCEA || SOURCEB)
        $fatal(1, "MULT18X18D: neither reset nor cascades are modelled");
    end
  end
  assign {
    P35, P34, P33, P32, P31, P30, P29, P28, P27,
    P26, P25, P24, P23, P22, P21, P20, P19, P18,
    P17, P16, P15, P14, P13, P12, P11, P10, P9,
    P8, P7, P6, P5, P4, P3, P2, P1, P0} = Registered ? p_q : p_now;
endmodule
`default_nettype wire
