// Square root by non-restoring digit recurrence, one or two bits per step.
//
// Returns floor(sqrt(square)), and inexact_o if a remainder is left. Latency: Stages steps of Held
// cycles; no stall.
//
// A square may come every Every cycles, with valid_i. Each stage of the pipeline makes Every steps,
// one after the other. If Every is 1, a stage works only if valid_i came with its operand, and a
// square may stay longer: Held cycles in each stage except the first. Its step is made in the last
// of them. Proof: tests/formal/sqrt.sv.
`default_nettype none
module rc_sqrt #(
  parameter  int unsigned Stages  = 4,   // steps
  parameter  int unsigned Bits    = 2,   // of the root, per step
  parameter  int unsigned Every   = 1,
  parameter  int unsigned Held    = 1,
  localparam int unsigned RootW   = Bits * Stages,
  localparam int unsigned SquareW = 2 * RootW
) (
  input  logic               clk_i,
  input  logic               valid_i,
  input  logic [SquareW-1:0] square_i,
  output logic [RootW-1:0]   root_o,
  output logic               inexact_o
);
  if (Stages * Bits * Every * Held < 1 || Bits > 2 || (Every > 1 && Held > 1)) begin : gen_refuse
    $error("rc_sqrt: Stages must be at least 1, Bits 1 or 2, and Every or Held 1");
  end

  localparam int unsigned Last  =   // index of the last stage
    Stages < 1 || Every < 1 ? 0 : (Stages + Every - 1) / Every - 1;
  localparam int unsigned Chunk = Bits * Every;   // bits of the root that a stage makes

  // valid[i]: step i is next.
  logic [Stages:0] valid;

  assign valid[0] = valid_i;
  for (genvar i = 0; i < Stages; i++) begin : gen_valid
    rc_path_register #(.Width(1), .Stages(Held)) u_step (
      .clk_i, .data_i(valid[i]), .data_o(valid[i+1]));
  end

  // The square leaves its register at the top, two bits for each bit of the root. The remainder,
  // which is the square so far minus the root's square, lies between -2 root - 1 and 2 root. A step
  // takes 4 times the remainder plus the next two bits. It subtracts 4 root + 1 if the remainder is
  // not negative, and otherwise adds 4 root + 3. The bit of the root is set if the result is not
  // negative. In each stage the root has the bits found so far, and the remainder has two more.
  for (genvar i = 0; i <= Last; i++) begin : gen_stage
    localparam int unsigned Steps    = Stages - i * Every < Every ? Stages - i * Every : Every;
    // Bits of the root after this stage.
    localparam int unsigned DoneBits = Chunk * i + Bits * Steps;
    localparam int unsigned Left     = SquareW - 2 * Chunk * i;    // bits of the square before it
    localparam bit          Again    = Steps > 1;
    logic                here, comes;
    logic [DoneBits+1:0] rem_q, rem_new, rem_d, between, rem_next;
    logic [DoneBits-1:0] root_q, root_new, root_d, root_next;
    logic [Left-1:0]     square_q, square_new, square_d;

    assign comes = valid[i*Every];
    assign here  = Again || comes;

    // Inputs of the stage.
    if (i == 0) begin : gen_first
      assign rem_new    = '0;
      assign root_new   = '0;
      assign square_new = square_i;
    end else begin : gen_next
      localparam int unsigned From = Chunk * i;   // bits of the root so far
      assign rem_new    = {{(DoneBits-From){gen_stage[i-1].rem_q[From+1]}}, gen_stage[i-1].rem_q};
      assign root_new   = DoneBits'(gen_stage[i-1].root_q);
      assign square_new = gen_stage[i-1].square_q[Left+2*Chunk-1 -: Left];
    end

    assign rem_d    = !Again || comes ? rem_new : rem_q;
    assign root_d   = !Again || comes ? root_new : root_q;
    assign square_d = !Again || comes ? square_new : square_q;

    // Steps.
    rc_addsub #(.Width(DoneBits + 2)) u_first (
      .minus_i(!rem_d[DoneBits+1]),
      .a_i({rem_d[DoneBits-1:0], square_d[Left-1 -: 2]}),
      .b_i({root_d, rem_d[DoneBits+1], 1'b1}), .sum_o(between));
    if (Bits == 1) begin : gen_one
      assign rem_next  = between;
      assign root_next = DoneBits'({root_d, !between[DoneBits+1]});
    end else begin : gen_two
      rc_addsub #(.Width(DoneBits + 2)) u_second (
        .minus_i(!between[DoneBits+1]),
        .a_i({between[DoneBits-1:0], square_d[Left-3 -: 2]}),
        .b_i({root_d[DoneBits-2:0], !between[DoneBits+1], between[DoneBits+1], 1'b1}),
        .sum_o(rem_next));
      assign root_next = DoneBits'({root_d, !between[DoneBits+1], !rem_next[DoneBits+1]});
    end

    always_ff @(posedge clk_i) begin
      if (here) begin
        rem_q    <= rem_next;
        root_q   <= root_next;
        square_q <= square_d << (2 * Bits);
      end
    end

    logic unused;
    assign unused = ^{rem_d[DoneBits], between[DoneBits], root_d[DoneBits-1]};
  end

  // The remainder is 0 if the result is 0 or -2 root - 1, tested as in rc_divide.
  logic [RootW+1:0] end_rem, end_step;

  assign end_rem   = gen_stage[Last].rem_q;
  assign end_step  = {1'b0, gen_stage[Last].root_q, 1'b1};
  assign inexact_o = end_rem[RootW+1] ? (end_rem ^ end_step) != (end_rem | end_step) << 1
                                      : end_rem != '0;
  assign root_o    = gen_stage[Last].root_q;

  logic unused;
  assign unused = ^{valid[Stages], gen_stage[Last].square_q};
endmodule
`default_nettype wire
