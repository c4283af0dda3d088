// Where a ray that begins on a plane beyond the lattice comes into it: at a point exactly on
// it, a whole number of steps of 2^ApproachShift directions away, the first before which no
// slab of the lattice still lies ahead. Part of rc_pass, which has the valid bits; a stage
// finds a bit of that number, the highest first. Model: model/shade/approach.hpp.
`default_nettype none
module rc_approach #(
  localparam int unsigned N  = rc_pkg::CoordBits,
  localparam int unsigned M  = rc_pkg::DirBits,
  localparam int unsigned B  = rc_pkg::OriginBits,
  localparam int unsigned P  = rc_pkg::OriginWidth,
  localparam int unsigned PW = rc_pkg::PointWidth
) (
  input  logic            clk_i,
  input  logic [12:0]     valid_i,        // of s15 to s27
  input  logic [3*PW-1:0] s15_p_i,
  input  logic [3*M-1:0]  s15_d_i,        // no component exceeds 2^(M-2)
  output logic            s28_enters_o,   // and does not pass by the lattice
  output logic [3*P-1:0]  s28_entry_o
);
  localparam int unsigned Steps = rc_pkg::ApproachSteps;   // 12
  localparam int unsigned Shift = rc_pkg::ApproachShift;
  // A point on the way: all steps together are 2^(Shift + Steps) directions.
  localparam int unsigned Reach = Shift + Steps + M - 1;
  localparam int unsigned Q     = (Reach > PW ? Reach : PW) + 2;
  localparam logic signed [Q-1:0] End = Q'(((65'(1) << (N - 1)) - 65'd1) << B);

  // Where stages s15 + i begin.
  logic [(Steps+1)*3*Q-1:0] at;
  logic [(Steps+1)*3*M-1:0] d;
  for (genvar k = 0; k < 3; k++) begin : gen_first
    assign at[k*Q +: Q] = Q'($signed(s15_p_i[k*PW +: PW]));
    assign d[k*M +: M]  = s15_d_i[k*M +: M];
  end
  for (genvar i = 0; i < Steps; i++) begin : gen_step
    logic [3*Q-1:0] next, at_q;
    logic [3*M-1:0] d_q;
    logic [2:0]     ahead;   // the slab of axis k lies ahead of `next`
    for (genvar k = 0; k < 3; k++) begin : gen_axis
      logic signed [Q-1:0] way, there;
      assign way   = Q'($signed(d[(3*i+k)*M +: M])) <<< (Shift + Steps - 1 - i);
      assign there = $signed(at[(3*i+k)*Q +: Q]) + way;
      assign ahead[k]      = way < 0 ? there > End : there < -End;
      assign next[k*Q +: Q] = there;
    end
    always_ff @(posedge clk_i) begin
      if (valid_i[i]) begin
        at_q <= ahead != '0 ? next : at[3*i*Q +: 3*Q];
        d_q  <= d[3*i*M +: 3*M];
      end
    end
    assign at[3*(i+1)*Q +: 3*Q] = at_q;
    assign d[3*(i+1)*M +: 3*M]  = d_q;
  end

  // The step that comes in.
  logic [2:0]     fits;
  logic [3*P-1:0] entry;
  for (genvar k = 0; k < 3; k++) begin : gen_last
    logic signed [Q-1:0] there;
    assign there = $signed(at[(3*Steps+k)*Q +: Q])
                 + (Q'($signed(d[(3*Steps+k)*M +: M])) <<< Shift);
    assign fits[k]       = there <= End && there >= -End;
    assign entry[k*P +: P] = there[P-1:0];
  end
  always_ff @(posedge clk_i) begin
    if (valid_i[Steps]) begin
      s28_enters_o <= fits == 3'b111;
      s28_entry_o  <= entry;
    end
  end
endmodule
`default_nettype wire
