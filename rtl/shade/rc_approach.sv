// Where a ray that begins on a plane beyond the lattice comes into it: at a point exactly on
// it, a whole number of steps of 2^ApproachShift directions away, the first before which no
// slab of the lattice still lies ahead. Part of rc_pass, which has the valid bits; a stage
// finds a bit of that number, the highest first. Where a pass stays in a stage for several
// cycles it takes a step in each, so that fewer stages are built; what they find waits for s28.
// Model: model/shade/approach.hpp.
`default_nettype none
module rc_approach #(
  localparam int unsigned N  = rc_pkg::CoordBits,
  localparam int unsigned M  = rc_pkg::DirBits,
  localparam int unsigned B  = rc_pkg::OriginBits,
  localparam int unsigned P  = rc_pkg::OriginWidth,
  localparam int unsigned PW = rc_pkg::PointWidth
) (
  input  logic            clk_i,
  input  logic            rst_ni,
  input  logic [12:0]     valid_i,        // of s15 to s27
  input  logic [3*PW-1:0] s15_p_i,
  input  logic [3*M-1:0]  s15_d_i,        // no component exceeds 2^(M-2)
  output logic            s28_enters_o,   // and does not pass by the lattice
  output logic [3*P-1:0]  s28_entry_o
);
  localparam int unsigned Steps = rc_pkg::ApproachSteps;   // 12
  localparam int unsigned Shift = rc_pkg::ApproachShift;
  localparam int unsigned Every = rc_pkg::ShadeInterval;
  // A point on the way: all steps together are 2^(Shift + Steps) directions.
  localparam int unsigned Reach = Shift + Steps + M - 1;
  localparam int unsigned Q     = (Reach > PW ? Reach : PW) + 2;
  localparam logic signed [Q-1:0] End = Q'(((65'(1) << (N - 1)) - 65'd1) << B);

  // Where the last step begins, with the way that it is.
  logic [3*Q-1:0] last_at, last_way;
  if (Every == 1) begin : gen_at_once
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
    for (genvar k = 0; k < 3; k++) begin : gen_way
      assign last_way[k*Q +: Q] = Q'($signed(d[(3*Steps+k)*M +: M])) <<< Shift;
    end
    assign last_at = at[3*Steps*Q +: 3*Q];
  end else begin : gen_in_turn
    // began[i]: a pass came to s15 i cycles ago, and takes step i.
    localparam int unsigned Last = (Steps + Every - 1) / Every - 1;
    logic [Steps-1:0] began_q;
    logic [Steps:0]   began;
    assign began = {began_q, valid_i[0]};
    always_ff @(posedge clk_i) began_q <= rst_ni ? began[Steps-1:0] : '0;
    for (genvar i = 0; i <= Last; i++) begin : gen_steps
      logic [3*Q-1:0] at, at_q, way, way_q, next;
      logic [2:0]     ahead;   // the slab of axis k lies ahead of `next`
      logic           comes;
      assign comes = began[i*Every];
      for (genvar k = 0; k < 3; k++) begin : gen_axis
        logic signed [Q-1:0] at_new, way_new, go, there;
        if (i == 0) begin : gen_first
          assign at_new  = Q'($signed(s15_p_i[k*PW +: PW]));
          assign way_new = Q'($signed(s15_d_i[k*M +: M])) <<< (Shift + Steps - 1);
        end else begin : gen_next
          assign at_new  = $signed(gen_steps[i-1].at_q[k*Q +: Q]);
          assign way_new = $signed(gen_steps[i-1].way_q[k*Q +: Q]) >>> 1;
        end
        assign go    = comes ? way_new : $signed(way_q[k*Q +: Q]) >>> 1;
        assign there = $signed(at[k*Q +: Q]) + go;
        assign at[k*Q +: Q]   = comes ? at_new : at_q[k*Q +: Q];
        assign way[k*Q +: Q]  = go;
        assign next[k*Q +: Q] = there;
        assign ahead[k]       = go < 0 ? there > End : there < -End;
      end
      always_ff @(posedge clk_i) begin
        at_q  <= ahead != '0 ? next : at;
        way_q <= way;
      end
    end
    assign last_at = gen_steps[Last].at_q;
    assign last_way = gen_steps[Last].way_q;
  end

  // The step that comes in.
  logic [2:0]     fits;
  logic           enters;
  logic [3*P-1:0] entry;
  for (genvar k = 0; k < 3; k++) begin : gen_last
    logic signed [Q-1:0] there;
    assign there = $signed(last_at[k*Q +: Q]) + $signed(last_way[k*Q +: Q]);
    assign fits[k]       = there <= End && there >= -End;
    assign entry[k*P +: P] = there[P-1:0];
  end
  assign enters = fits == 3'b111;
  if (Every == 1) begin : gen_end_now
    always_ff @(posedge clk_i)
      if (valid_i[Steps]) {s28_enters_o, s28_entry_o} <= {enters, entry};
    logic unused;
    assign unused = rst_ni;
  end else begin : gen_end_waits
    logic             done_q, made_enters_q, enters_waited;
    logic [3*P-1:0]   made_entry_q, entry_waited;
    always_ff @(posedge clk_i) begin
      done_q <= rst_ni && gen_in_turn.began[Steps];
      {made_enters_q, made_entry_q} <= {enters, entry};
      if (valid_i[Steps]) {s28_enters_o, s28_entry_o} <= {enters_waited, entry_waited};
    end
    rc_beside #(.Width(1 + 3 * P), .Stages(Steps)) u_beside (
      .clk_i, .rst_ni, .come_i(done_q), .leave_i(valid_i[Steps]),
      .data_i({made_enters_q, made_entry_q}), .data_o({enters_waited, entry_waited}));
  end
endmodule
`default_nettype wire
