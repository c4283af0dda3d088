// TMDS encoder of one channel, as in the DVI 1.0 specification, figure 3-5. Latency 2, one symbol
// per pixel clock.
//
// The first stage reduces the transitions of a byte (bit 8 of a symbol: XOR, not XNOR). The
// second inverts the byte (bit 9) so that ones and zeros balance. disparity_q is half of the ones
// minus the zeros sent since the last control symbol. It stays from -4 to 4. In the blank the
// channel sends one of four control symbols, and the disparity returns to 0.
`default_nettype none
module rc_tmds (
  input  logic       clk_i,       // the pixel clock
  input  logic       de_i,        // 1: a byte, 0: a control symbol
  input  logic [7:0] data_i,
  input  logic [1:0] control_i,
  output logic [9:0] symbol_o     // bit 0 is sent first
);
  // ---- Stage 1: fewer transitions.
  logic [3:0] data_ones;
  logic       with_xnor;
  logic [7:0] reduced, reduced_q;
  logic       xor_q, de_q;
  logic [1:0] control_q;

  always_comb begin
    data_ones = '0;
    for (int i = 0; i < 8; i++) data_ones = data_ones + 4'(data_i[i]);
  end
  assign with_xnor = data_ones > 4'd4 || (data_ones == 4'd4 && !data_i[0]);

  // Bit i is the parity of bits 0 to i of the byte. XNOR inverts it i times.
  for (genvar i = 0; i < 8; i++) begin : gen_reduced
    assign reduced[i] = ^data_i[i:0] ^ (with_xnor && i % 2 == 1);
  end

  always_ff @(posedge clk_i) begin
    reduced_q <= reduced;
    xor_q     <= !with_xnor;
    de_q      <= de_i;
    control_q <= control_i;
  end

  // ---- Stage 2: balance. excess is half of the ones minus the zeros of the reduced byte.
  logic signed [3:0] excess, disparity_q, disparity;
  logic              inverts;
  logic [9:0]        symbol_q, symbol;

  always_comb begin
    excess = -4'sd4;
    for (int i = 0; i < 8; i++) excess = excess + $signed({3'd0, reduced_q[i]});
  end

  always_comb begin
    inverts = (disparity_q > 4'sd0) == (excess > 4'sd0);
    if (disparity_q == 4'sd0 || excess == 4'sd0) inverts = !xor_q;
    // Bits 9 and 8 add to the balance of the byte: 1 if both are set, -1 if both are clear.
    disparity = inverts ? disparity_q - excess : disparity_q + excess;
    if (inverts && xor_q)        disparity = disparity + 4'sd1;
    else if (!inverts && !xor_q) disparity = disparity - 4'sd1;
    symbol = {inverts, xor_q, inverts ? ~reduced_q : reduced_q};
    if (!de_q) begin
      disparity = 4'sd0;
      case (control_q)
        2'b00:   symbol = 10'b1101010100;
        2'b01:   symbol = 10'b0010101011;
        2'b10:   symbol = 10'b0101010100;
        default: symbol = 10'b1010101011;
      endcase
    end
  end

  always_ff @(posedge clk_i) begin
    disparity_q <= disparity;
    symbol_q    <= symbol;
  end

  assign symbol_o = symbol_q;
endmodule
`default_nettype wire
