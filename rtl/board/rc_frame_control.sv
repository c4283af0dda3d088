// Starts the chip's frames for the host, and measures them.
//
// After arm_i the module waits for the beginning of the screen's vertical blank (takes_i), and
// then writes 1 to the chip's register `start`. 100 pixel clocks earlier the memory has begun a
// refresh, which closes all rows. So every frame begins with memory and beam in the same state,
// and takes the model's number of cycles. The host must not access the chip's bus while armed_o is
// high.
//
// When the chip is done and its last pixel has left the conversion, flush_o makes the pixel writer
// write its partial blocks. flushed_o is high from the end of these writes until the next frame is
// armed. cycles_o counts from the frame's cycle 0 to the last beat of the last pixel. Model:
// model/board/board_memory.hpp (BoardMemory::start).
`default_nettype none
module rc_frame_control (
  input  logic                           clk_i,
  input  logic                           rst_ni,
  // From the host
  input  logic                           arm_i,       // one cycle
  output logic                           armed_o,
  output logic                           flushed_o,
  output logic [47:0]                    cycles_o,
  // From the scan-out
  input  logic                           takes_i,
  // Bus of the host link
  input  logic                           wb_cyc_i,
  input  logic                           wb_stb_i,
  input  logic                           wb_we_i,
  input  logic [rc_pkg::RegAddrBits-1:0] wb_adr_i,
  input  logic [31:0]                    wb_dat_i,
  output logic                           wb_ack_o,
  output logic                           wb_err_o,
  // To the chip's bus
  output logic                           wb_cyc_o,
  output logic                           wb_stb_o,
  output logic                           wb_we_o,
  output logic [rc_pkg::RegAddrBits-1:0] wb_adr_o,
  output logic [31:0]                    wb_dat_o,
  input  logic                           wb_ack_i,
  input  logic                           wb_err_i,
  // From the chip
  input  logic                           running_i,
  input  logic                           done_i,
  // To and from the pixels
  input  logic                           pixels_empty_i,   // of conversion and writer
  input  logic                           colour_empty_i,   // of the conversion
  output logic                           flush_o
);
  logic        armed_q, starts_q, ends_q, flushed_q;
  logic [47:0] cycles_q;
  logic        begins, answered, is_written;

  assign begins     = armed_q && takes_i;
  assign answered   = starts_q && (wb_ack_i || wb_err_i);
  assign flush_o    = ends_q && done_i && colour_empty_i;
  assign is_written = ends_q && done_i && pixels_empty_i;

  // armed: waits for the vertical blank. starts: writes to `start`. ends: from cycle 0 on until all
  // pixels are in memory.
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      armed_q   <= 1'b0;
      starts_q  <= 1'b0;
      ends_q    <= 1'b0;
      flushed_q <= 1'b0;
      cycles_q  <= '0;
    end else begin
      if (arm_i)        armed_q <= 1'b1;
      else if (begins)  armed_q <= 1'b0;

      if (begins)        starts_q <= 1'b1;
      else if (answered) starts_q <= 1'b0;

      if (running_i)       ends_q <= 1'b1;
      else if (is_written) ends_q <= 1'b0;

      if (arm_i)           flushed_q <= 1'b0;
      else if (is_written) flushed_q <= 1'b1;

      if (arm_i)                    cycles_q <= '0;
      else if (running_i || ends_q) cycles_q <= cycles_q + 48'(!is_written);
    end
  end

  assign armed_o   = armed_q || starts_q;
  assign flushed_o = flushed_q;
  assign cycles_o  = cycles_q;

  // ---- Bus: the write to `start`, or the host link's access.
  assign wb_cyc_o = starts_q || wb_cyc_i;
  assign wb_stb_o = starts_q || wb_stb_i;
  assign wb_we_o  = starts_q || wb_we_i;
  assign wb_adr_o = starts_q ? rc_pkg::RegAddrBits'(rc_pkg::RegStart) : wb_adr_i;
  assign wb_dat_o = starts_q ? 32'd1 : wb_dat_i;
  assign wb_ack_o = wb_ack_i && !starts_q;
  assign wb_err_o = wb_err_i && !starts_q;
endmodule
`default_nettype wire
