// Properties of rc_sqrt, for every square: the root is the floor, and inexact_o is set if there is
// a remainder. A delay line follows one request through the stages. Requests before and after it
// are arbitrary, at least Every cycles away.
module sqrt #(
  parameter  int unsigned Stages  = 2,
  parameter  int unsigned Bits    = 2,
  parameter  int unsigned Every   = 1,
  localparam int unsigned RootW   = Bits * Stages,
  localparam int unsigned SquareW = 2 * RootW
) (
  input logic               clk_i,
  input logic               valid_i,
  input logic [SquareW-1:0] square_i
);
  logic [RootW-1:0] root_o;
  logic             inexact_o;
  rc_sqrt #(.Stages(Stages), .Bits(Bits), .Every(Every)) u_dut (
    .clk_i(clk_i), .valid_i(valid_i), .square_i(square_i), .root_o(root_o), .inexact_o(inexact_o));

  logic [Stages-1:0]         valid_q = '0;
  if (Every > 1) begin : gen_apart
    always @* assume (!valid_i || valid_q[Every-2:0] == '0);
  end
  logic [Stages*SquareW-1:0] square_q;
  always @(posedge clk_i) begin
    valid_q  <= {valid_q[Stages-2:0], valid_i};
    square_q <= {square_q[(Stages-1)*SquareW-1:0], square_i};
  end
  logic [SquareW-1:0] square;
  logic [SquareW+1:0] below, next;
  assign square = square_q[Stages*SquareW-1 -: SquareW];
  assign below  = {{(SquareW-RootW+2){1'b0}}, root_o} * {{(SquareW-RootW+2){1'b0}}, root_o};
  assign next   = below + {{(SquareW-RootW+1){1'b0}}, root_o, 1'b1};   // (root + 1)^2
  always @* if (valid_q[Stages-1]) begin
    a_floor:   assert (below <= {2'b00, square} && next > {2'b00, square});
    a_inexact: assert (inexact_o == (below != {2'b00, square}));
  end
endmodule
