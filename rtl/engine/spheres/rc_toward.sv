// A ray in the form in which globes are tested with it. The direction is shifted by a power of two
// until its longest component fills TowardBits, and rounded to nearest, halves up. A component that
// would become 2^17 is one less.
//
// Part of rc_trav, which stores the result until the ray's nodes come. Latency 3 in a fast chip, 0
// in a relaxed one. Model: globe_ray() in model/engine/spheres/globe.cpp.
`default_nettype none
module rc_toward #(
  localparam int unsigned I  = rc_pkg::RayBits,
  localparam int unsigned OW = rc_pkg::OriginWidth,
  localparam int unsigned H  = rc_pkg::RayDirBits,
  localparam int unsigned G  = rc_pkg::TowardBits,
  localparam int unsigned E  = rc_pkg::ExpBits,
  localparam int unsigned KeptW = 3 * OW + 3 * G + E
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             valid_i,
  input  logic [I-1:0]     ray_i,
  input  logic [3*OW-1:0]  o_i,
  input  logic [3*H-1:0]   d_i,
  input  logic             short_i,  // of DirBits only: len counts as for full width
  output logic             valid_o,
  output logic [I-1:0]     ray_o,
  output logic [KeptW-1:0] kept_o    // {o, direction, len}
);
  localparam int unsigned Cut   = rc_pkg::Cut;
  localparam int unsigned Waits = 3 * Cut;

  // Bit length of the longest component, and the free bits above it. full_len counts a short
  // direction (DirBits) as if it had H bits.
  logic [H-2:0]   used;
  logic [E-1:0]   len, full_len, free, free_q;
  logic [3*H-1:0] dir_q;

  always_comb begin
    used = '0;
    for (int k = 0; k < 3; k++) used = used | (d_i[k*H +: H-1] ^ {(H-1){d_i[k*H+H-1]}});
    len  = '0;
    free = E'(H - 1);
    for (int i = 0; i < H - 1; i++) begin
      if (used[i]) begin
        len  = E'(i + 1);
        free = E'(H - 2 - i);
      end
    end
  end

  assign full_len = short_i ? len + E'(H - rc_pkg::DirBits) : len;

  rc_path_register #(.Width(3 * H)) u_dir (.clk_i, .data_i(d_i), .data_o(dir_q));
  rc_path_register #(.Width(E)) u_free (.clk_i, .data_i(free), .data_o(free_q));

  // The shift, then the rounding.
  logic [3*G-1:0] toward, toward_q;

  for (genvar k = 0; k < 3; k++) begin : gen_axis
    logic [H-1:0] moved, moved_q;
    logic [G-1:0] whole, rounded;

    assign moved = dir_q[k*H +: H] << free_q;
    rc_path_register #(.Width(H)) u_moved (.clk_i, .data_i(moved), .data_o(moved_q));

    if (H > G) begin : gen_round
      logic unused;
      assign whole   = moved_q[H-1 -: G];
      assign rounded = whole + {{(G-1){1'b0}}, moved_q[H-G-1]};
      assign unused  = ^moved_q;
    end else begin : gen_exact
      assign whole   = G'(moved_q) << (G - H);
      assign rounded = whole;
    end

    assign toward[k*G +: G] = !whole[G-1] && rounded[G-1] ? whole : rounded;
  end

  rc_path_register #(.Width(3 * G)) u_toward (.clk_i, .data_i(toward), .data_o(toward_q));

  // Delays of the other fields, and of the valid bit.
  logic [3*OW-1:0] o_q;
  logic [E-1:0]    len_q;

  rc_path_register #(.Width(I), .Stages(Waits)) u_ray (.clk_i, .data_i(ray_i), .data_o(ray_o));
  rc_path_register #(.Width(3 * OW), .Stages(Waits)) u_o (.clk_i, .data_i(o_i), .data_o(o_q));
  rc_path_register #(.Width(E), .Stages(Waits)) u_len (.clk_i, .data_i(full_len), .data_o(len_q));

  assign kept_o = {o_q, toward_q, len_q};

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
