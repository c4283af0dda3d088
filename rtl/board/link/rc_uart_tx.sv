// UART transmitter: 8 data bits, the lowest first, no parity, one stop bit (8N1).
//
// A byte is accepted when the line is idle, and its start bit begins in the next cycle. The
// transmitter accepts the next byte at the end of the stop bit, so bytes follow one another without
// a gap, except for one cycle. tx_o comes from a register.
`default_nettype none
module rc_uart_tx #(
  parameter int unsigned ClkKhz = 75000,     // clock, in kHz
  parameter int unsigned Baud   = 3000000    // bits per second
) (
  input  logic       clk_i,
  input  logic       rst_ni,
  // Bytes to send
  input  logic       valid_i,
  output logic       ready_o,
  input  logic [7:0] data_i,
  // To the line; idle is high
  output logic       tx_o
);
  logic       busy_q, tick, takes;
  logic [3:0] bits_q;   // bits that are still to come after the present one
  logic [8:0] rest_q;   // those bits, the next one lowest; the stop bit above the data

  assign ready_o = !busy_q;
  assign takes   = valid_i && ready_o;

  rc_baud #(.ClkKhz(ClkKhz), .Baud(Baud)) u_baud (
    .clk_i, .load_i(takes), .half_i(1'b0), .run_i(busy_q), .tick_o(tick));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      busy_q <= 1'b0;
      tx_o   <= 1'b1;
    end else if (takes) begin
      busy_q <= 1'b1;
      tx_o   <= 1'b0;
    end else if (tick) begin
      busy_q <= bits_q != '0;
      tx_o   <= rest_q[0];
    end
    if (takes) begin
      bits_q <= 4'd9;
      rest_q <= {1'b1, data_i};
    end else if (tick) begin
      bits_q <= bits_q - 1'b1;
      rest_q <= {1'b1, rest_q[8:1]};
    end
  end
endmodule
`default_nettype wire
