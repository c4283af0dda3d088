// Guarantees of rc_credit_counter, if requests come only while open_o is set and answers only to
// requests: at most Credits requests are in flight, never fewer than none, and open_o is set
// exactly while another one has a place.
module credit_counter #(
  parameter int unsigned Credits = 4,
  parameter int unsigned Cut     = 0    // 0 or 1
) (
  input logic clk_i,
  input logic rst_ni,
  input logic admit_i,
  input logic leave_i
);
  localparam int unsigned CountW = $clog2(Credits + 1);
  logic open_o;
  rc_credit_counter #(.Credits(Credits), .Cut(Cut)) u_dut (
    .clk_i(clk_i), .rst_ni(rst_ni), .admit_i(admit_i), .leave_i(leave_i), .open_o(open_o));
  (* hierconn *) wire [CountW-1:0] \u_dut.in_flight_q ;

  logic begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  // Requests and answers, counted apart, far beyond the cell's own count.
  logic [7:0] flying_q;
  always @(posedge clk_i) begin
    if (!rst_ni) flying_q <= '0;
    else flying_q <= flying_q + admit_i - leave_i;
  end
  always @* if (rst_ni) begin
    assume (!admit_i || open_o);
    assume (!leave_i || flying_q != '0);
  end
  always @* if (begun_q && rst_ni) begin
    a_most: assert (flying_q <= Credits);
    a_open: assert (open_o == (flying_q < Credits));
    a_same: assert (\u_dut.in_flight_q == flying_q);
  end
endmodule
