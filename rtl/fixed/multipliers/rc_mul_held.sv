// Products of several pairs that stay stable for Every cycles, as a pass of shade does in each
// stage (rtl/unit/shade/pass/rc_pass.sv). As few multipliers as possible compute them, one after
// the other.
//
// phase_i[p] is high in cycle p of the Every cycles. All products are ready in the last cycle. If
// Every is 1, each product has a multiplier without latency.
//
// In a fast chip a multiplier has registers at its operands and its products if the cycles suffice.
// Operands may come Late cycles after the first; phase_i is then late by the same amount. Proof:
// tests/formal/mul_held.sv.
`default_nettype none
module rc_mul_held #(
  parameter  int unsigned AW       = 18,
  parameter  int unsigned BW       = 18,
  parameter  bit          Signed   = 1'b1,
  parameter  int unsigned Products = 1,
  parameter  int unsigned Every    = rc_pkg::ShadeInterval,
  parameter  int unsigned Late     = 0,
  localparam int unsigned PW       = AW + BW
) (
  input  logic                   clk_i,
  input  logic [Every-1:0]       phase_i,
  input  logic [Products*AW-1:0] a_i,      // product 0 lowest
  input  logic [Products*BW-1:0] b_i,
  output logic [Products*PW-1:0] p_o
);
  if (Products < 1 || Every < 1 || Late >= Every) begin : gen_refuse
    $error("rc_mul_held: Products and Every must be at least 1, Late less than Every");
  end

  // Inside: registers within a multiplier. Most: products that one multiplier can make. Share:
  // products that it makes.
  localparam int unsigned Inside      = rc_pkg::MulStages > 1 && Every > 2 + Late ? 2 : 0;
  localparam int unsigned Most        = Every - Inside - Late;
  localparam int unsigned Multipliers = (Products + Most - 1) / Most;
  localparam int unsigned Share       = (Products + Multipliers - 1) / Multipliers;

  for (genvar m = 0; m < Multipliers; m++) begin : gen_multiplier
    localparam int unsigned First = m * Share;
    localparam int unsigned Own   = Products - First < Share ? Products - First : Share;
    localparam int          Early = Own - 1;   // products that are not the last

    logic [AW-1:0] a;
    logic [BW-1:0] b;
    logic [PW-1:0] p;

    // Operands of the product that is made in this cycle.
    always_comb begin
      a = a_i[(First+Own-1)*AW +: AW];
      b = b_i[(First+Own-1)*BW +: BW];
      for (int i = 0; i < Early; i++)
        if (phase_i[i]) begin
          a = a_i[(First+i)*AW +: AW];
          b = b_i[(First+i)*BW +: BW];
        end
    end

    rc_mul #(.AW(AW), .BW(BW), .Signed(Signed), .Stages(Inside)) u_mul (
      .clk_i, .a_i(a), .b_i(b), .p_o(p));

    // All products except the last one wait for it.
    for (genvar i = 0; i < Own; i++) begin : gen_product
      if (i == Own - 1) begin : gen_last
        assign p_o[(First+i)*PW +: PW] = p;
      end else begin : gen_early
        logic [PW-1:0] p_q;
        always_ff @(posedge clk_i) if (phase_i[i+Inside]) p_q <= p;
        assign p_o[(First+i)*PW +: PW] = p_q;
      end
    end
  end

  logic unused;
  assign unused = ^phase_i;
endmodule
`default_nettype wire
