// a - b if minus_i is set, else a + b, modulo 2^Width, with one carry cell per two bits. No
// latency.
//
// With RC_ECP5 defined it instantiates the ECP5's carry cells, because Yosys 0.23 would put the
// selection into as many LUTs in front of them. Otherwise the same function is inferred. Proof of
// equality: tests/formal/addsub.sv.
`default_nettype none
module rc_addsub #(
  parameter int unsigned Width = 8
) (
  input  logic             minus_i,
  input  logic [Width-1:0] a_i,
  input  logic [Width-1:0] b_i,
  output logic [Width-1:0] sum_o
);
  if (Width < 1) begin : gen_refuse
    $error("rc_addsub: Width must be at least 1");
  end

`ifdef RC_ECP5
  localparam int unsigned Cells = (Width + 1) / 2;
  // The cell's table for D = 1: A ^ B, or A ^ ~B if C. Where the result is 0, A is the carry.
  localparam logic [15:0] AddSub = 16'b1001_0110_1010_1010;

  logic [2*Cells-1:0] a, b, sum;
  logic [Cells:0]     carry;

  assign a        = (2*Cells)'(a_i);
  assign b        = (2*Cells)'(b_i);
  assign carry[0] = minus_i;

  for (genvar i = 0; i < Cells; i++) begin : gen_cell
    CCU2C #(.INIT0(AddSub), .INIT1(AddSub), .INJECT1_0("NO"), .INJECT1_1("NO")) u_carry (
      .CIN(carry[i]), .COUT(carry[i+1]),
      .A0(a[2*i]), .B0(b[2*i]), .C0(minus_i), .D0(1'b1), .S0(sum[2*i]),
      .A1(a[2*i+1]), .B1(b[2*i+1]), .C1(minus_i), .D1(1'b1), .S1(sum[2*i+1]));
  end

  assign sum_o = sum[Width-1:0];

  logic unused;
  assign unused = ^{carry[Cells], sum};
`else
  // A selection between sum and difference would be a branch in a simulation, mostly mispredicted.
  assign sum_o = a_i + (b_i ^ {Width{minus_i}}) + Width'(minus_i);
`endif
endmodule
`default_nettype wire
