// Product of two signed numbers, exact. Latency Stages: rc_pkg::MulStages, which is 0 in a relaxed
// chip, or 3 in a fast one: operands, products of 18-bit limbs, their sum. So a multiplier block's
// own registers hold operands and products, and no carry chain is as long as the product.
//
// An unsigned number has a zero above it. A limb is 18 bits: all but the highest are unsigned.
`default_nettype none
module rc_mul #(
  parameter  int unsigned AW     = 18,
  parameter  int unsigned BW     = 18,
  parameter  int unsigned Stages = rc_pkg::MulStages,
  localparam int unsigned PW     = AW + BW
) (
  input  logic                 clk_i,
  input  logic signed [AW-1:0] a_i,
  input  logic signed [BW-1:0] b_i,
  output logic signed [PW-1:0] p_o
);
  if (AW < 2 || BW < 2) begin : gen_refuse
    $error("rc_mul: AW and BW must be at least 2");
  end
  if (Stages != 0 && Stages != 3) begin : gen_refuse_2
    $error("rc_mul: Stages must be 0 or 3");
  end
  if (Stages == 0) begin : gen_now
    assign p_o = PW'(a_i) * PW'(b_i);
    logic unused;
    assign unused = clk_i;
  end else begin : gen_stages
    localparam int unsigned L  = 18;
    localparam int unsigned LA = (AW + L - 1) / L;   // limbs
    localparam int unsigned LB = (BW + L - 1) / L;
    logic signed [PW-1:0] sum, sum_q;
    for (genvar i = 0; i < LA; i++) begin : gen_a
      for (genvar j = 0; j < LB; j++) begin : gen_b
        logic signed [PW-1:0] placed, below;
        rc_mul_limb #(
          .AW(i == LA - 1 ? AW - i * L : L), .BW(j == LB - 1 ? BW - j * L : L),
          .ASigned(i == LA - 1), .BSigned(j == LB - 1), .PW(PW), .Place(L * (i + j))) u_limb (
          .clk_i, .a_i(a_i[AW-1 < i*L+L-1 ? AW-1 : i*L+L-1 : i*L]),
          .b_i(b_i[BW-1 < j*L+L-1 ? BW-1 : j*L+L-1 : j*L]), .p_o(placed));
        if (i == 0 && j == 0) begin : gen_first
          assign below = '0;
        end else if (j == 0) begin : gen_row
          assign below = gen_a[i-1].gen_b[LB-1].total;
        end else begin : gen_next
          assign below = gen_b[j-1].total;
        end
        logic signed [PW-1:0] total;
        assign total = below + placed;
      end
    end
    assign sum = gen_a[LA-1].gen_b[LB-1].total;
    always_ff @(posedge clk_i) sum_q <= sum;
    assign p_o = sum_q;
  end
endmodule
`default_nettype wire
