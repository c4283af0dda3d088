// The board's own registers, which the host reaches through rc_link. docs/machine/board-link.md
// lists them; sim/board/protocol.hpp mirrors their numbers.
//
// An access is answered in its cycle, and a write has its effect in the next one. good_o is low if
// there is no such register, or if it cannot be written. Reading the lower word of the frame's
// cycles keeps the upper word for the next read.
`default_nettype none
module rc_board_registers #(
  parameter int unsigned LineBits   = 20,   // of a line's number in memory
  parameter int unsigned Version    = 1,    // version of these registers and of the packets
  parameter logic [63:0] ConfigHash = '0    // of the configuration of the bitstream
) (
  input  logic                clk_i,
  input  logic                rst_ni,
  // Access
  input  logic                valid_i,
  input  logic                write_i,
  input  logic [7:0]          addr_i,
  input  logic [31:0]         data_i,
  output logic [31:0]         data_o,
  output logic                good_o,
  // Control
  output logic                chip_reset_o,   // reset of the chip, active high
  output logic                arm_o,          // starts a frame at the next blank; one cycle
  // Status
  input  logic                init_done_i,    // the memory works
  input  logic                flushed_i,      // the frame has ended, and its pixels are in memory
  input  logic                armed_i,        // a frame waits for the vertical blank
  input  logic [31:0]         underruns_i,    // pixels that came too late for the screen
  input  logic [47:0]         cycles_i,       // of the last frame, with its flush
  // Frame buffer
  output logic [LineBits-1:0] draw_base_o,    // first block of the picture that is drawn
  output logic [LineBits-1:0] base_o,         // first block of the picture that is shown
  output logic [15:0]         width_o,        // pixels
  output logic [15:0]         height_o,
  output logic                double_o,       // each pixel is shown as 2x2
  // Faults of the link: one cycle each
  input  logic                bad_packet_i,
  input  logic                bad_byte_i
);
  localparam logic [31:0] Magic = "RCBD";

  // Numbers of the registers.
  localparam logic [7:0] RegMagic    = 8'd0,  RegVersion   = 8'd1,  RegHashLow = 8'd2;
  localparam logic [7:0] RegHashHigh = 8'd3,  RegLines     = 8'd4,  RegControl = 8'd5;
  localparam logic [7:0] RegStatus   = 8'd6,  RegUnderruns = 8'd7,  RegCycles  = 8'd8;
  localparam logic [7:0] RegCycles2  = 8'd9,  RegBase      = 8'd10, RegWidth   = 8'd11;
  localparam logic [7:0] RegHeight   = 8'd12, RegDouble    = 8'd13, RegFaults  = 8'd14;
  localparam logic [7:0] RegDrawBase  = 8'd15;

  logic        writes;
  logic [15:0] high_q, bad_packets_q, bad_bytes_q;

  always_comb begin
    good_o = 1'b1;
    data_o = '0;
    case (addr_i)
      RegMagic:     data_o = Magic;
      RegVersion:   data_o = Version;
      RegHashLow:   data_o = ConfigHash[31:0];
      RegHashHigh:  data_o = ConfigHash[63:32];
      RegLines:     data_o = 32'(1 << LineBits);
      RegControl:   data_o = {31'd0, chip_reset_o};
      RegStatus:    data_o = {29'd0, armed_i, flushed_i, init_done_i};
      RegUnderruns: data_o = underruns_i;
      RegCycles:    data_o = cycles_i[31:0];
      RegCycles2:   data_o = {16'd0, high_q};
      RegBase:      data_o = 32'(base_o);
      RegWidth:     data_o = {16'd0, width_o};
      RegHeight:    data_o = {16'd0, height_o};
      RegDouble:    data_o = {31'd0, double_o};
      RegFaults:    data_o = {bad_bytes_q, bad_packets_q};
      RegDrawBase:  data_o = 32'(draw_base_o);
      default:      good_o = 1'b0;
    endcase
    if (write_i)
      good_o = addr_i == RegControl || addr_i == RegDrawBase
            || (addr_i >= RegBase && addr_i <= RegDouble);
  end

  assign writes = valid_i && write_i;
  assign arm_o  = writes && addr_i == RegControl && data_i[1];

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      chip_reset_o  <= 1'b0;
      draw_base_o   <= '0;
      base_o        <= '0;
      width_o       <= '0;
      height_o      <= '0;
      double_o      <= 1'b0;
      bad_packets_q <= '0;
      bad_bytes_q   <= '0;
    end else begin
      if (writes) begin
        case (addr_i)
          RegControl:  chip_reset_o <= data_i[0];
          RegDrawBase: draw_base_o  <= data_i[LineBits-1:0];
          RegBase:    base_o   <= data_i[LineBits-1:0];
          RegWidth:   width_o  <= data_i[15:0];
          RegHeight:  height_o <= data_i[15:0];
          RegDouble:  double_o <= data_i[0];
          default: ;
        endcase
      end
      // The counts of faults stop at their ends.
      if (bad_packet_i && bad_packets_q != '1) bad_packets_q <= bad_packets_q + 1'b1;
      if (bad_byte_i && bad_bytes_q != '1)     bad_bytes_q   <= bad_bytes_q + 1'b1;
    end
    if (valid_i && !write_i && addr_i == RegCycles) high_q <= cycles_i[47:32];
  end

  logic unused;
  assign unused = ^data_i;   // no register has all 32 bits
endmodule
`default_nettype wire
