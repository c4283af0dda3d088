// Where a ray that begins on a plane beyond the lattice enters the lattice. The entry is a point
// exactly on the ray, a whole number of steps of 2^ApproachShift directions away. It is the first
// such point that no slab of the lattice lies ahead of.
//
// Part of rc_pass, which has the valid bits. Each stage finds one bit of that number, the highest
// first. If a pass stays in a stage for four cycles or more, each cycle except one makes a step, so
// fewer stages are built. Their result waits for s28.
//
// Each axis stores the depth of a point in the lattice's slab, seen along the ray. The depth is
// negative before the slab, and above 2 End behind it. So a step is one addition, and the sign of
// the depth shows whether the slab lies ahead. Model: model/unit/shade/light/approach.hpp.
`default_nettype none
module rc_approach #(
  localparam int unsigned N           = rc_pkg::CoordBits,
  localparam int unsigned M           = rc_pkg::DirBits,
  localparam int unsigned OriginBits  = rc_pkg::OriginBits,
  localparam int unsigned OriginWidth = rc_pkg::OriginWidth,
  localparam int unsigned PointWidth  = rc_pkg::PointWidth
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic [12:0]              valid_i,        // of s15 to s27
  input  logic [3*PointWidth-1:0]  s15_p_i,
  input  logic [3*M-1:0]           s15_d_i,        // no component exceeds 2^(M-2)
  output logic                     s28_enters_o,   // 0: the ray passes by the lattice
  output logic [3*OriginWidth-1:0] s28_entry_o
);

  localparam int unsigned Steps = rc_pkg::ApproachSteps;   // 12
  localparam int unsigned Shift = rc_pkg::ApproachShift;
  localparam int unsigned Every = rc_pkg::ShadeInterval;

  // Width of a point on the ray: all steps together are 2^(Shift + Steps) directions.
  localparam int unsigned Reach  = Shift + Steps + M - 1;
  localparam int unsigned PlaceW = (Reach > PointWidth ? Reach : PointWidth) + 2;

  localparam logic signed [PlaceW-1:0] End = PlaceW'(((65'(1) << (N - 1)) - 65'd1) << OriginBits);

  localparam int unsigned TwiceW = Reach + 1;   // width of twice a way

  // State between steps: the depth of the point, twice the way of the next step, and whether the
  // ray runs downwards. After the last step it is the way of that step, not twice the way.
  logic [3*PlaceW-1:0] s15_depth, first_depth, last_depth;
  logic [3*TwiceW-1:0] s15_twice, first_twice, last_way;
  logic [2:0]          s15_down, first_down, last_down;

  for (genvar k = 0; k < 3; k++) begin : gen_first
    logic signed [PlaceW-1:0] p;
    logic [M-1:0]             d, size;

    assign p           = PlaceW'($signed(s15_p_i[k*PointWidth +: PointWidth]));
    assign d           = s15_d_i[k*M +: M];
    assign s15_down[k] = d[M-1];
    assign s15_depth[k*PlaceW +: PlaceW] = d[M-1] ? End - p : p + End;
    assign size        = d[M-1] ? -d : d;
    assign s15_twice[k*TwiceW +: TwiceW] = TwiceW'(size) << (Shift + Steps);
  end

  rc_path_register #(.Width(3 * (PlaceW + TwiceW + 1)), .Stages(rc_pkg::PassCut)) u_first (
    .clk_i, .data_i({s15_depth, s15_twice, s15_down}),
    .data_o({first_depth, first_twice, first_down}));

  // If a pass stays long, each stage accepts a point in one cycle and makes a step in each of the
  // next ones. began[i]: a pass came i cycles ago.
  localparam bit          InTurn = Every >= 4;
  localparam int unsigned Own    = InTurn ? Every - 1 : 1;   // steps of a stage
  localparam int unsigned Last   = (Steps + Own - 1) / Own - 1;
  localparam int unsigned Took   = InTurn ? Last * Every + Steps - Last * Own + 1 : 1;

  logic [Took-1:0] began_q;
  logic [Took:0]   began;
  logic            begins, done;   // done: a point comes to the last step

  rc_pulse_register #(.Stages(rc_pkg::PassCut)) u_begins (
    .clk_i, .rst_ni, .fires_i(valid_i[0]), .fires_o(begins));

  assign began = {began_q, begins};
  always_ff @(posedge clk_i) began_q <= rst_ni ? began[Took-1:0] : '0;
  assign done  = InTurn ? began[Took] : valid_i[Steps];

  // Steps: a step is made if, after it, a slab still lies ahead.
  for (genvar i = 0; i <= Last; i++) begin : gen_stage
    logic [3*PlaceW-1:0] depth, from, next, depth_q;
    logic [3*TwiceW-1:0] twice, now, twice_q;
    logic [2:0]          down, down_q, ahead;   // ahead: the slab of axis k lies ahead of `next`
    logic                comes;

    if (i == 0) begin : gen_begin
      assign {depth, twice, down} = {first_depth, first_twice, first_down};
    end else begin : gen_go_on
      assign {depth, twice, down} = {gen_stage[i-1].depth_q, gen_stage[i-1].twice_q,
                                     gen_stage[i-1].down_q};
    end

    assign from = InTurn ? depth_q : depth;
    assign now  = InTurn ? twice_q : twice;

    for (genvar k = 0; k < 3; k++) begin : gen_axis
      assign next[k*PlaceW +: PlaceW] = from[k*PlaceW +: PlaceW]
                                      + PlaceW'(now[k*TwiceW+1 +: TwiceW-1]);
      assign ahead[k]                 = next[k*PlaceW+PlaceW-1];

      always_ff @(posedge clk_i) begin
        if (InTurn)
          twice_q[k*TwiceW +: TwiceW] <= comes ? twice[k*TwiceW +: TwiceW]
                                               : now[k*TwiceW +: TwiceW] >> 1;
        else if (comes) twice_q[k*TwiceW +: TwiceW] <= now[k*TwiceW +: TwiceW] >> 1;
      end
    end

    always_ff @(posedge clk_i) begin
      if (comes) down_q <= down;
      if (InTurn) begin
        if (comes || ahead != '0) depth_q <= comes ? depth : next;
      end else begin
        if (comes) depth_q <= ahead != '0 ? next : depth;
      end
    end

    if (InTurn) begin : gen_in_turn
      assign comes = began[i*Every];
    end else begin : gen_in_stages
      assign comes = valid_i[i];
    end
  end

  assign {last_depth, last_way, last_down} = {gen_stage[Last].depth_q, gen_stage[Last].twice_q,
                                              gen_stage[Last].down_q};

  // The step that enters: the depth becomes non-negative on every axis.
  logic [2:0]               fits;
  logic                     enters;
  logic [3*OriginWidth-1:0] entry;

  for (genvar k = 0; k < 3; k++) begin : gen_last
    logic signed [PlaceW-1:0] depth, there;

    assign depth   = last_depth[k*PlaceW +: PlaceW] + PlaceW'(last_way[k*TwiceW +: TwiceW]);
    assign there   = last_down[k] ? End - depth : depth - End;
    assign fits[k] = !depth[PlaceW-1] && depth <= 2 * End;
    assign entry[k*OriginWidth +: OriginWidth] = there[OriginWidth-1:0];

    logic unused;
    assign unused = ^there;
  end

  assign enters = fits == 3'b111;

  if (!InTurn) begin : gen_end_now
    always_ff @(posedge clk_i)
      if (done) {s28_enters_o, s28_entry_o} <= {enters, entry};

    logic unused;
    assign unused = ^began;
  end else begin : gen_end_waits
    logic                     done_q, made_enters_q;
    logic [3*OriginWidth-1:0] made_entry_q;
    logic [3*OriginWidth:0]   waited;

    always_ff @(posedge clk_i) begin
      done_q <= rst_ni && done;
      if (done) {made_enters_q, made_entry_q} <= {enters, entry};
    end

    rc_stage_delay #(.Width(1 + 3 * OriginWidth), .Stages(Steps)) u_beside (
      .clk_i, .rst_ni, .enter_i(done_q), .leave_i(valid_i[Steps]),
      .data_i({made_enters_q, made_entry_q}), .data_o(waited));

    if (rc_pkg::PassCut == 0) begin : gen_register
      always_ff @(posedge clk_i) if (valid_i[Steps]) {s28_enters_o, s28_entry_o} <= waited;
    end else begin : gen_no_register   // the next result stays long before s27 accepts it
      assign {s28_enters_o, s28_entry_o} = waited;
    end
  end
endmodule
`default_nettype wire
