// Products of several pairs that come together. Each multiplier computes Share of them, one after
// the other.
//
// All products are ready together, rc_pkg::MulStages + Share - 1 cycles after the operands. No
// other operands may come in the Share - 1 cycles after operands. Multiplier i / Share computes
// product i, in its cycle i % Share. Proof: tests/formal/mul_shared.sv.
`default_nettype none
module rc_mul_shared #(
  parameter  int unsigned AW       = 18,
  parameter  int unsigned BW       = 18,
  parameter  bit          Signed   = 1'b1,
  parameter  int unsigned Sums     = 1,      // levels of sums, as in rc_mul
  parameter  int unsigned Products = 2,
  parameter  int unsigned Share    = 2,
  localparam int unsigned PW       = AW + BW
) (
  input  logic                   clk_i,
  input  logic                   valid_i,   // operands come
  input  logic [Products*AW-1:0] a_i,       // product 0 lowest
  input  logic [Products*BW-1:0] b_i,
  output logic [Products*PW-1:0] p_o
);
  if (Products < 1 || Share < 1) begin : gen_refuse
    $error("rc_mul_shared: Products and Share must be at least 1");
  end
  localparam int unsigned Multipliers = (Products + Share - 1) / Share;

  for (genvar m = 0; m < Multipliers; m++) begin : gen_multiplier
    localparam int unsigned First = m * Share;
    localparam int unsigned Own   = Products - First < Share ? Products - First : Share;

    logic [AW-1:0] a;
    logic [BW-1:0] b;
    logic [PW-1:0] p;

    // Operands. Those of later products wait, the next of them lowest.
    if (Own == 1) begin : gen_alone
      assign a = a_i[First*AW +: AW];
      assign b = b_i[First*BW +: BW];
    end else begin : gen_operands
      logic [(Own-1)*AW-1:0] a_q;
      logic [(Own-1)*BW-1:0] b_q;
      assign a = valid_i ? a_i[First*AW +: AW] : a_q[AW-1:0];
      assign b = valid_i ? b_i[First*BW +: BW] : b_q[BW-1:0];
      always_ff @(posedge clk_i) begin
        a_q <= valid_i ? a_i[(First+1)*AW +: (Own-1)*AW] : a_q >> AW;
        b_q <= valid_i ? b_i[(First+1)*BW +: (Own-1)*BW] : b_q >> BW;
      end
    end

    rc_mul #(.AW(AW), .BW(BW), .Signed(Signed), .Sums(Sums)) u_mul (
      .clk_i, .a_i(a), .b_i(b), .p_o(p));

    // Early products wait for the last one.
    for (genvar i = 0; i < Own; i++) begin : gen_product
      rc_path_register #(.Width(PW), .Stages(Share - 1 - i)) u_early (
        .clk_i, .data_i(p), .data_o(p_o[(First+i)*PW +: PW]));
    end
  end

  if (Products <= Multipliers) begin : gen_not_shared
    logic unused;
    assign unused = valid_i;
  end
endmodule
`default_nettype wire
