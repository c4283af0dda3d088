// A ray in the form in which globes are tested with it. The direction is shifted by a power of two
// until its longest component fills TowardBits, and rounded to nearest, halves up. A component that
// would become 2^17 is one less.
//
// Part of rc_trav, which stores the result until the ray's nodes come. Latency 3 in a fast chip, 0
// in a relaxed one. Model: globe_ray() in model/engine/spheres/globe.cpp.
`default_nettype none
module rc_globe_ray #(
  localparam int unsigned RayBits     = rc_pkg::RayBits,
  localparam int unsigned OriginWidth = rc_pkg::OriginWidth,
  localparam int unsigned RayDirBits  = rc_pkg::RayDirBits,
  localparam int unsigned TowardBits  = rc_pkg::TowardBits,
  localparam int unsigned ExpBits     = rc_pkg::ExpBits,
  localparam int unsigned KeptW = 3 * OriginWidth + 3 * TowardBits + ExpBits
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic                     valid_i,
  input  logic [RayBits-1:0]       ray_i,
  input  logic [3*OriginWidth-1:0] o_i,
  input  logic [3*RayDirBits-1:0]  d_i,
  input  logic                     short_i,  // of DirBits only: len counts as for full width
  output logic                     valid_o,
  output logic [RayBits-1:0]       ray_o,
  output logic [KeptW-1:0]         fields_o    // {o, direction, len}
);
  localparam int unsigned Cut   = rc_pkg::PathCut;
  localparam int unsigned Waits = 3 * Cut;

  // Bit length of the longest component, and the free bits above it. full_len counts a short
  // direction (DirBits) as if it had RayDirBits bits.
  logic [RayDirBits-2:0]   used;
  logic [ExpBits-1:0]      len, full_len, free, free_q;
  logic [3*RayDirBits-1:0] dir_q;

  always_comb begin
    used = '0;
    for (int k = 0; k < 3; k++) used = used | (d_i[k*RayDirBits +: RayDirBits-1]
                                               ^ {(RayDirBits-1){d_i[k*RayDirBits+RayDirBits-1]}});
    len  = '0;
    free = ExpBits'(RayDirBits - 1);
    for (int i = 0; i < RayDirBits - 1; i++) begin
      if (used[i]) begin
        len  = ExpBits'(i + 1);
        free = ExpBits'(RayDirBits - 2 - i);
      end
    end
  end

  assign full_len = short_i ? len + ExpBits'(RayDirBits - rc_pkg::DirBits) : len;

  rc_path_register #(.Width(3 * RayDirBits)) u_dir (.clk_i, .data_i(d_i), .data_o(dir_q));
  rc_path_register #(.Width(ExpBits)) u_free (.clk_i, .data_i(free), .data_o(free_q));

  // The shift, then the rounding.
  logic [3*TowardBits-1:0] toward, toward_q;

  for (genvar k = 0; k < 3; k++) begin : gen_axis
    logic [RayDirBits-1:0] moved, moved_q;
    logic [TowardBits-1:0] whole, rounded;

    assign moved = dir_q[k*RayDirBits +: RayDirBits] << free_q;
    rc_path_register #(.Width(RayDirBits)) u_moved (.clk_i, .data_i(moved), .data_o(moved_q));

    if (RayDirBits > TowardBits) begin : gen_round
      logic unused;
      assign whole   = moved_q[RayDirBits-1 -: TowardBits];
      assign rounded = whole + {{(TowardBits-1){1'b0}}, moved_q[RayDirBits-TowardBits-1]};
      assign unused  = ^moved_q;
    end else begin : gen_exact
      assign whole   = TowardBits'(moved_q) << (TowardBits - RayDirBits);
      assign rounded = whole;
    end

    assign toward[k*TowardBits +: TowardBits] = !whole[TowardBits-1] && rounded[TowardBits-1]
                                              ? whole : rounded;
  end

  rc_path_register #(.Width(3 * TowardBits)) u_toward (.clk_i, .data_i(toward), .data_o(toward_q));

  // Delays of the other fields, and of the valid bit.
  logic [3*OriginWidth-1:0] o_q;
  logic [ExpBits-1:0]       len_q;

  rc_path_register #(.Width(RayBits), .Stages(Waits)) u_ray (
    .clk_i, .data_i(ray_i), .data_o(ray_o));
  rc_path_register #(.Width(3 * OriginWidth), .Stages(Waits)) u_o (
    .clk_i, .data_i(o_i), .data_o(o_q));
  rc_path_register #(.Width(ExpBits), .Stages(Waits)) u_len (
    .clk_i, .data_i(full_len), .data_o(len_q));

  rc_pkg::toward_ray_t fields;

  assign fields.o      = o_q;
  assign fields.toward = toward_q;
  assign fields.len    = len_q;
  assign fields_o      = fields;

  if (Cut == 0) begin : gen_now
    assign valid_o = valid_i;
    logic unused;
    assign unused = rst_ni;
  end else begin : gen_late
    logic [2:0] valid_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni) valid_q <= '0;
      else         valid_q <= {valid_q[1:0], valid_i};
    end
    assign valid_o = valid_q[2];
  end
endmodule
`default_nettype wire
