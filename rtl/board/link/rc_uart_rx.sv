// UART receiver: 8 data bits, the lowest first, no parity, one stop bit (8N1).
//
// A falling edge starts a byte. The receiver samples each bit once, in its middle, and the start
// bit too: if the line is high again there, the edge was a glitch. valid_o is high for one cycle
// in the middle of the stop bit. If the stop bit is low, the byte is discarded, fault_o is high
// for that cycle, and the receiver waits until the line is high. After the middle of the stop bit
// the next byte may start, so a sender may be faster by almost half a bit in ten.
//
// Latency: two cycles of synchronisation, then 9.5 bits from the edge. No back-pressure.
`default_nettype none
module rc_uart_rx #(
  parameter int unsigned ClkKhz = 75000,     // clock, in kHz
  parameter int unsigned Baud   = 3000000    // bits per second
) (
  input  logic       clk_i,
  input  logic       rst_ni,
  // From the line, asynchronous; idle is high
  input  logic       rx_i,
  // Received bytes
  output logic       valid_o,
  output logic [7:0] data_o,
  output logic       fault_o
);
  typedef enum logic [1:0] {StIdle, StStart, StData, StBreak} state_e;

  state_e     state_q;
  logic       meta_q, line_q, tick, is_idle;
  logic [3:0] bits_q;   // bits sampled after the start bit
  logic [7:0] data_q;
  logic       ends;

  // Synchroniser. After a reset the receiver first waits until the line is high: a line that is low
  // then is not a start bit.
  always_ff @(posedge clk_i) begin
    if (!rst_ni) {line_q, meta_q} <= 2'b00;
    else         {line_q, meta_q} <= {meta_q, rx_i};
  end

  assign is_idle = state_q == StIdle;

  rc_baud #(.ClkKhz(ClkKhz), .Baud(Baud)) u_baud (
    .clk_i, .load_i(is_idle), .half_i(1'b1), .run_i(!is_idle), .tick_o(tick));

  assign ends    = state_q == StData && tick && bits_q == 4'd8;
  assign valid_o = ends && line_q;
  assign fault_o = ends && !line_q;
  assign data_o  = data_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q <= StBreak;
    end else begin
      case (state_q)
        StIdle:  if (!line_q) state_q <= StStart;
        StStart: if (tick) state_q <= line_q ? StIdle : StData;
        StData:  if (ends) state_q <= line_q ? StIdle : StBreak;
        default: if (line_q) state_q <= StIdle;
      endcase
    end
    if (state_q == StStart) bits_q <= '0;
    else if (tick)          bits_q <= bits_q + 1'b1;
    if (state_q == StData && tick && !ends) data_q <= {line_q, data_q[7:1]};
  end
endmodule
`default_nettype wire
