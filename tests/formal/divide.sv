// Properties of rc_divide, for every dividend and divisor: the quotient is the floor, and inexact_o
// is set if there is a remainder. A delay line follows one request through the stages. Requests
// before and after it are arbitrary, at least Every cycles away.
module divide #(
  parameter  int unsigned Width  = 5,
  parameter  int unsigned Stages = 2,
  parameter  int unsigned Bits   = 2,
  parameter  int unsigned Every  = 1,
  parameter  int unsigned Lows   = Bits * Stages,
  localparam int unsigned QuoW   = Bits * Stages,
  localparam int unsigned AllW   = Width + QuoW
) (
  input logic             clk_i,
  input logic             valid_i,
  input logic [Width-1:0] rem_i,
  input logic [QuoW-1:0]  low_i,
  input logic [Width-1:0] den_i
);
  logic [QuoW-1:0] quo_o;
  logic            inexact_o;
  rc_divide #(.Width(Width), .Stages(Stages), .Bits(Bits), .Every(Every), .Lows(Lows)) u_dut (
    .clk_i(clk_i), .valid_i(valid_i), .rem_i(rem_i), .low_i(low_i), .den_i(den_i), .quo_o(quo_o),
    .inexact_o(inexact_o));

  logic [Stages-1:0]         valid_q = '0;
  always @* assume (!valid_i || rem_i < den_i);
  if (Lows < QuoW) begin : gen_zeros
    always @* assume (low_i[QuoW-Lows-1:0] == '0);
  end
  if (Every > 1) begin : gen_apart
    always @* assume (!valid_i || valid_q[Every-2:0] == '0);
  end

  logic [Stages*AllW-1:0]    dividend_q;
  logic [Stages*Width-1:0]   den_q;
  always @(posedge clk_i) begin
    valid_q    <= {valid_q[Stages-2:0], valid_i};
    dividend_q <= {dividend_q[(Stages-1)*AllW-1:0], rem_i, low_i};
    den_q      <= {den_q[(Stages-1)*Width-1:0], den_i};
  end
  logic [AllW-1:0]  dividend;
  logic [AllW:0]    product;
  logic [Width-1:0] den;
  assign dividend = dividend_q[Stages*AllW-1 -: AllW];
  assign den      = den_q[Stages*Width-1 -: Width];
  assign product  = {{(Width+1){1'b0}}, quo_o} * {{(QuoW+1){1'b0}}, den};
  always @* if (valid_q[Stages-1]) begin
    a_floor:   assert (product <= dividend && dividend - product < den);
    a_inexact: assert (inexact_o == (product != dividend));
  end
endmodule
