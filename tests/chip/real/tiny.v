// A stand-in for a unit, small enough that all that nextpnr writes of it can be kept: two registers, a sum between.
module rc_dispatch (input wire clk_i, input wire [7:0] in_i, output wire [4:0] out_o);
  reg [7:0] s0_q;
  reg [4:0] s1_q;
  always @(posedge clk_i) begin
    s0_q <= in_i;
    s1_q <= s0_q[3:0] + s0_q[7:4];
  end
  assign out_o = s1_q;
endmodule
module rc_harness (input wire clk_i, input wire serial_i, output wire serial_o);
  reg  [7:0] in_q;
  wire [4:0] out;
  reg  [4:0] out_q;
  always @(posedge clk_i) begin
    in_q  <= {in_q, serial_i};
    out_q <= out;
  end
  assign serial_o = ^out_q;
  rc_dispatch u_dispatch (.clk_i(clk_i), .in_i(in_q), .out_o(out));
endmodule
