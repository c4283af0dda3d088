// Serialiser of one TMDS channel: a symbol of 10 bits per pixel clock becomes two bits per shift
// clock, bit 0 first, for an output cell with double data rate.
//
// The shift clock has five times the pixel clock's frequency and a constant phase. pixel_toggle_i
// changes with every pixel clock. Its change is seen one shift clock later, and the symbol is
// loaded at the end of the next one. So symbol_i is read in the middle of its time.
`default_nettype none
module rc_serialiser (
  input  logic       shift_clk_i,
  input  logic       shift_rst_ni,
  input  logic       pixel_toggle_i,
  input  logic [9:0] symbol_i,
  output logic [1:0] pair_o          // bit 0 is sent first
);
  logic       toggle_q, last_toggle_q;
  logic [9:0] shift_q;

  always_ff @(posedge shift_clk_i) begin
    if (!shift_rst_ni) begin
      toggle_q      <= 1'b0;
      last_toggle_q <= 1'b0;
      shift_q       <= '0;
    end else begin
      toggle_q      <= pixel_toggle_i;
      last_toggle_q <= toggle_q;
      shift_q       <= toggle_q != last_toggle_q ? symbol_i : {2'b00, shift_q[9:2]};
    end
  end

  assign pair_o = shift_q[1:0];
endmodule
`default_nettype wire
