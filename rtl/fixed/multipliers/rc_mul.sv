// Exact product of two numbers. Latency Stages; a new product in every cycle.
//
// Stages is 0, or one stage for the operands, one for the products of 18-bit limbs, and one for
// each level of sums. So the multiplier block's own registers hold operands and products. Of two
// levels of sums the first adds at most three numbers. If Stages is less than 2 + Sums, the last
// level has no register after it.
//
// Limbs below the highest are unsigned. The highest limb is signed if Signed is set.
`default_nettype none
module rc_mul #(
  parameter  int unsigned AW     = 18,
  parameter  int unsigned BW     = 18,
  parameter  bit          Signed = 1'b1,
  parameter  int unsigned Stages = rc_pkg::MulStages,
  parameter  int unsigned Sums   = 1,                  // levels of sums: 1 or 2
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
  if (Stages == 1 || Sums < 1 || Sums > 2 || Stages > 2 + Sums) begin : gen_refuse_stages
    $error("rc_mul: Stages must be 0 or lie in 2..2 + Sums, and Sums be 1 or 2");
  end

`ifdef RC_ECP5
  localparam bit Spills = Stages == 0 && Signed && AW > 18 && BW > 18 && AW <= 20 && BW <= 20
                       && (AW == 20 || BW == 20);
`else
  localparam bit Spills = 1'b0;
`endif

  if (Spills) begin : gen_spill
    rc_mul_spill #(.AW(AW), .BW(BW)) u_spill (.a_i, .b_i, .p_o);

    logic unused;
    assign unused = clk_i;
  end else if (Stages == 0) begin : gen_now
    if (Signed) begin : gen_signed
`ifdef SYNTHESIS
      assign p_o = PW'(a_i) * PW'(b_i);
`else
      // The same product of unsigned words, which a simulation multiplies in one operation.
      localparam int unsigned Word = PW <= 32 ? 32 : PW <= 64 ? 64 : PW;
      assign p_o = PW'($unsigned(Word'(a_i)) * $unsigned(Word'(b_i)));
`endif
    end else begin : gen_unsigned
      assign p_o = {{BW{1'b0}}, a_i} * {{AW{1'b0}}, b_i};
    end

    logic unused;
    assign unused = clk_i;
  end else begin : gen_stages
    localparam int unsigned LimbW  = 18;   // as wide as the multipliers of an FPGA
    localparam int unsigned LimbsA = (AW + LimbW - 1) / LimbW;   // limbs
    localparam int unsigned LimbsB = (BW + LimbW - 1) / LimbW;

    // The products of one limb of a with every second limb of b do not overlap, and form one row.
    // If that limb of a is signed, each of its products is a row of its own.
    localparam int unsigned Side    = LimbsB < 2 ? LimbsB : 2;
    localparam int unsigned Rows    = Signed ? (LimbsA - 1) * Side + LimbsB : LimbsA * Side;
    localparam int unsigned Group   = Sums == 1 ? Rows : 3;   // rows that the first level adds
    localparam int unsigned Groups  = (Rows + Group - 1) / Group;

    logic [Rows*PW-1:0]   row;
    logic [Groups*PW-1:0] sum, last;

    // Products of limbs, and their rows.
    for (genvar i = 0; i < LimbsA; i++) begin : gen_a
      localparam bit ASigned = Signed && i == LimbsA - 1;
      for (genvar j = 0; j < LimbsB; j++) begin : gen_b
        logic signed [PW-1:0] placed, side;

        rc_mul_limb #(
          .AW(i == LimbsA - 1 ? AW - i * LimbW : LimbW),
          .BW(j == LimbsB - 1 ? BW - j * LimbW : LimbW),
          .ASigned(ASigned), .BSigned(Signed && j == LimbsB - 1), .PW(PW),
          .Place(LimbW * (i + j))) u_limb (
          .clk_i, .a_i(a_i[AW-1 < i*LimbW+LimbW-1 ? AW-1 : i*LimbW+LimbW-1 : i*LimbW]),
          .b_i(b_i[BW-1 < j*LimbW+LimbW-1 ? BW-1 : j*LimbW+LimbW-1 : j*LimbW]), .p_o(placed));

        if (ASigned || j < 2) begin : gen_alone
          assign side = placed;
        end else begin : gen_side
          assign side = placed | gen_b[j-2].side;
        end

        if (ASigned) begin : gen_row
          assign row[((LimbsA-1)*Side+j)*PW +: PW] = side;
        end else if (j + Side >= LimbsB) begin : gen_row_of_sides
          assign row[(i*Side+j+Side-LimbsB)*PW +: PW] = side;
        end
      end
    end

    // First level of sums: Group rows each.
    for (genvar i = 0; i < Rows; i++) begin : gen_sum
      logic [PW-1:0] total;

      if (i % Group == 0) begin : gen_first
        assign total = row[i*PW +: PW];
      end else begin : gen_next
        assign total = gen_sum[i-1].total + row[i*PW +: PW];
      end

      if (i % Group == Group - 1 || i == Rows - 1) begin : gen_last
        assign sum[i/Group*PW +: PW] = total;
      end
    end

    rc_path_register #(.Width(Groups * PW), .Stages(Stages < 3 ? 0 : 1)) u_sum (
      .clk_i, .data_i(sum), .data_o(last));

    // Second level of sums.
    for (genvar i = 0; i < Groups; i++) begin : gen_total
      logic [PW-1:0] total;

      if (i == 0) begin : gen_first
        assign total = last[PW-1:0];
      end else begin : gen_next
        assign total = gen_total[i-1].total + last[i*PW +: PW];
      end
    end

    rc_path_register #(.Width(PW), .Stages(Stages < 4 ? 0 : 1)) u_total (
      .clk_i, .data_i(gen_total[Groups-1].total), .data_o(p_o));
  end
endmodule
`default_nettype wire
