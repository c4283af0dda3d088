// Property of rc_addsub: it returns the sum or difference, for every pair of numbers, also in the
// device's carry cells.
module addsub #(
  parameter int unsigned Width = 5
) (
  input logic             clk_i,
  input logic             minus_i,
  input logic [Width-1:0] a_i,
  input logic [Width-1:0] b_i
);
  logic [Width-1:0] sum_o, sum;
  rc_addsub #(.Width(Width)) u_dut (
    .minus_i(minus_i), .a_i(a_i), .b_i(b_i), .sum_o(sum_o));
  assign sum = minus_i ? a_i + ~b_i + 1'b1 : a_i + b_i;
  always @(posedge clk_i) begin
    a_sum: assert (sum_o == sum);
  end
endmodule
