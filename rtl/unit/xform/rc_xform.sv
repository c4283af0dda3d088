// Transforms a ray from the scene's space into the space of an instance's mesh, with its
// reciprocals.
//
// o' = round(A o + b), d' = round(A d), with MapFrac fraction bits, halves up. It happens once for
// each ray and instance, so all primitives of the instance see the same integers. d' is not
// normalised: a point of the ray has the same t in both spaces.
//
// The scene's compiler ensures that the magnitudes of a row of A sum to at most 1, and that each
// component of |A o + b| is below 2^(CoordBits-1). So o' and d' need no more bits than o and d.
//
// If the chip shades, o and o' have OriginBits of fraction. A shadow ray's o' is rounded to a
// lattice point. For the instance that a ray leaves, or at which a shadow ray ends, o' and d' come
// with the request.
//
// Latency rc_pkg::XformLatency, one ray every XformInterval cycles: its 18 products share
// multipliers, and its reciprocals share dividers. Its answers must always be accepted. Model:
// model/unit/xform/xform.hpp.
`default_nettype none
module rc_xform (
  input  logic               clk_i,
  input  logic               rst_ni,
  // From node_cache, with the original ray
  input  logic               req_valid_i,
  output logic               req_ready_o,
  input  rc_pkg::xform_req_t req_i,
  output logic               occupied_o,     // products of the last ray are being made
  // To trav and list
  output logic               change_fires_o,
  output rc_pkg::change_t    change_o
);
  localparam int unsigned OriginWidth = rc_pkg::OriginWidth;
  localparam int unsigned RayDirBits  = rc_pkg::RayDirBits;
  localparam int unsigned FactorW     = OriginWidth > RayDirBits ? OriginWidth : RayDirBits;
  localparam int unsigned MapBits     = rc_pkg::MapBits;
  localparam int unsigned MapFrac     = rc_pkg::MapFrac;
  localparam int unsigned OriginBits  = rc_pkg::OriginBits;
  localparam int unsigned TranslateW  = OriginWidth - OriginBits + MapFrac;
  localparam int unsigned ProductW    = MapBits + FactorW;               // width of a product
  localparam int unsigned SumW        = FactorW + MapFrac + 1;           // width of a sum
  localparam int unsigned R1          = rc_pkg::RecipBits + 1;
  localparam int unsigned ExpBits     = rc_pkg::ExpBits;
  localparam int unsigned Latency     = rc_pkg::XformLatency;
  localparam int unsigned Share       = rc_pkg::RecipShare;

  // Stages in which a ray has arrived, its products are ready, and it is transformed.
  localparam int unsigned In    = rc_pkg::PathCut;
  localparam int unsigned Moved = rc_pkg::MapStages;
  localparam int unsigned Made  = Moved - 2;

  // ---- Admission: occupied while the products are made.
  logic admit;

  assign admit = req_valid_i && req_ready_o;

  if (rc_pkg::XformInterval == 1) begin : gen_never_occupied
    assign occupied_o = 1'b0;
  end else begin : gen_occupied
    localparam int unsigned LeftW = $clog2(rc_pkg::XformInterval);
    logic [LeftW-1:0] left_q;

    assign occupied_o = left_q != '0;

    always_ff @(posedge clk_i) begin
      if (!rst_ni)      left_q <= '0;
      else if (admit)   left_q <= LeftW'(rc_pkg::XformInterval - 1);
      else if (occupied_o) left_q <= left_q - 1'b1;
    end
  end

  assign req_ready_o = !occupied_o;

  // valid[i]: stage i holds a ray.
  logic [Latency-1:0] valid_q;
  logic [Latency:0]   valid;

  assign valid = {valid_q, admit};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else         valid_q <= valid[Latency-1:0];
  end

  // The request.
  rc_pkg::xform_req_t           in;
  logic [rc_pkg::XformReqW-1:0] in_flat;

  rc_path_register #(.Width(rc_pkg::XformReqW)) u_in (.clk_i, .data_i(req_i), .data_o(in_flat));

  assign in = in_flat;

  // ---- Products: of o, then of d, each row by row.
  logic [3*OriginWidth-1:0] in_o;
  logic [3*RayDirBits-1:0]  in_d;
  logic [9*MapBits-1:0]     in_a;
  logic [3*TranslateW-1:0]  in_b;
  logic [18*MapBits-1:0]    factor_a;
  logic [18*FactorW-1:0]    factor_v;
  logic [18*ProductW-1:0]   product;

  assign in_o     = in.o;
  assign in_d     = in.d;
  assign in_a     = in.a;
  assign in_b     = in.b;
  assign factor_a = {in_a, in_a};

  for (genvar i = 0; i < 9; i++) begin : gen_factor
    assign factor_v[i*FactorW +: FactorW] =
        FactorW'($signed(in_o[(i%3)*OriginWidth +: OriginWidth]));
    assign factor_v[(9+i)*FactorW +: FactorW] =
        FactorW'($signed(in_d[(i%3)*RayDirBits +: RayDirBits]));
  end

  rc_mul_shared #(.AW(MapBits), .BW(FactorW), .Products(18), .Share(rc_pkg::MapShare)) u_products (
    .clk_i, .valid_i(valid[In]), .a_i(factor_a), .b_i(factor_v), .p_o(product));

  // ---- Sums. Half a step, for the rounding, is added to b or, for d, in its place.
  localparam logic [SumW-1:0] Half = SumW'(1) << (MapFrac - 1);

  logic [3*SumW-1:0]        begin_b, made_b;
  logic                     in_shadow, moved_shadow, at_home, sum_shadow;
  logic [3*OriginWidth-1:0] home_o;
  logic [3*RayDirBits-1:0]  home_d;

  for (genvar i = 0; i < 3; i++) begin : gen_b
    assign begin_b[i*SumW +: SumW] = (SumW'($signed(in_b[i*TranslateW +: TranslateW]))
                                      <<< OriginBits)
                                   + (in_shadow ? Half << OriginBits : Half);
  end

  rc_path_register #(.Width(3 * SumW), .Stages(Made - In)) u_b (
    .clk_i, .data_i(begin_b), .data_o(made_b));

  logic [3*FactorW-1:0] moved_o, moved_d;   // as wide as the wider of the two
  for (genvar i = 0; i < 6; i++) begin : gen_sum
    logic [SumW-1:0]    addend, first_q, second_q;
    logic [SumW-1:0]    total;
    logic [FactorW-1:0] moved_q, home, rounded;

    if (i < 3) begin : gen_point
      assign addend = made_b[i*SumW +: SumW];
      assign moved_o[i*FactorW +: FactorW] = moved_q;
      assign home = FactorW'($signed(home_o[i*OriginWidth +: OriginWidth]));
      assign rounded = sum_shadow ? total[MapFrac +: FactorW] >> OriginBits << OriginBits
                     : total[MapFrac +: FactorW];
    end else begin : gen_direction
      assign addend = Half;
      assign moved_d[(i-3)*FactorW +: FactorW] = moved_q;
      assign home = FactorW'($signed(home_d[(i-3)*RayDirBits +: RayDirBits]));
      assign rounded = total[MapFrac +: FactorW];
    end

    assign total = first_q + second_q;

    always_ff @(posedge clk_i) begin
      if (valid[Made]) begin
        first_q  <= SumW'($signed(product[3*i*ProductW +: ProductW]))
                  + SumW'($signed(product[(3*i+1)*ProductW +: ProductW]));
        second_q <= SumW'($signed(product[(3*i+2)*ProductW +: ProductW])) + addend;
      end
      if (valid[Made+1]) moved_q <= at_home ? home : rounded;
    end

`ifndef SYNTHESIS
    localparam int unsigned Width = i < 3 ? OriginWidth : RayDirBits;
    always_ff @(posedge clk_i) if (rst_ni && valid[Made+1])
      a_fits: assert (total[SumW-1:MapFrac+Width-1] == {(SumW-MapFrac-Width+1){total[SumW-1]}})
      else $error("an instance moves a ray beyond its lattice");
`endif

    logic unused;
    assign unused = ^total;
  end

  logic [3*OriginWidth-1:0] o;
  logic [3*RayDirBits-1:0]  d;

  for (genvar k = 0; k < 3; k++) begin : gen_narrow
    assign o[k*OriginWidth +: OriginWidth] = moved_o[k*FactorW +: OriginWidth];
    assign d[k*RayDirBits +: RayDirBits] = moved_d[k*FactorW +: RayDirBits];
  end

  // ---- Home: a ray that starts from this instance, or a shadow ray that ends there.
  if (rc_pkg::HasHomes) begin : gen_homes
    logic in_home;

    assign in_shadow = in.kind == rc_pkg::RayShadow;
    assign in_home   = in.kind != rc_pkg::RayCamera && in.home == in.here;

    rc_path_register #(.Width(2 + 3 * (OriginWidth + RayDirBits)), .Stages(Made + 1 - In)) u_home (
      .clk_i, .data_i({in_home, in_shadow, in.home_o, in.home_d}),
      .data_o({at_home, sum_shadow, home_o, home_d}));

    rc_path_register #(.Width(1), .Stages(1)) u_shadow (
      .clk_i, .data_i(sum_shadow), .data_o(moved_shadow));
  end else begin : gen_no_homes
    assign {in_shadow, moved_shadow, at_home, sum_shadow} = '0;
    assign {home_o, home_d} = '0;
  end

  // ---- Reciprocals: a divider makes those of Share axes, one after the other.
  localparam int unsigned Dividers = (3 + Share - 1) / Share;

  logic [3*R1-1:0]      recip;
  logic [3*ExpBits-1:0] len;

  for (genvar m = 0; m < Dividers; m++) begin : gen_divider
    localparam int unsigned First = m * Share;
    localparam int unsigned Own   = 3 - First < Share ? 3 - First : Share;
    logic signed [RayDirBits-1:0] axis;
    logic [R1+ExpBits-1:0]        made;
    logic                         is_short;

    if (Own == 1) begin : gen_alone
      assign axis     = d[First*RayDirBits +: RayDirBits];
      assign is_short = !moved_shadow;
    end else begin : gen_axes   // the next axis is lowest
      logic [(Own-1)*RayDirBits-1:0] wait_q;
      logic               short_q;

      assign axis     = valid[Moved] ? d[First*RayDirBits +: RayDirBits] : wait_q[RayDirBits-1:0];
      assign is_short = valid[Moved] ? !moved_shadow : short_q;

      always_ff @(posedge clk_i) begin
        short_q <= is_short;
        wait_q <= valid[Moved] ? d[(First+1)*RayDirBits +: (Own-1)*RayDirBits]
                : wait_q >> RayDirBits;
      end
    end

    rc_recip u_recip (
      .clk_i, .rst_ni, .valid_i(valid[Moved +: Own] != '0), .short_i(is_short), .d_i(axis),
      .recip_o(made[R1-1:0]), .len_o(made[R1+ExpBits-1:R1]));

    for (genvar i = 0; i < Own; i++) begin : gen_axis   // the first wait for the last
      rc_path_register #(.Width(R1 + ExpBits), .Stages(Share - 1 - i)) u_early (
        .clk_i, .data_i(made),
        .data_o({len[(First+i)*ExpBits +: ExpBits], recip[(First+i)*R1 +: R1]}));
    end
  end

  // ---- Delays. Ray, first and root; if the chip shades, the ray's kind and the instance's line as
  // well.
  localparam int unsigned TagW = rc_pkg::ChangeTagW;
  rc_pkg::change_tag_t      in_tag, end_tag;
  logic [TagW-1:0]          end_tag_flat;
  logic [3*OriginWidth-1:0] end_o;
  logic [3*RayDirBits-1:0]  end_d;

  assign in_tag.ray   = in.ray;
  assign in_tag.first = in.first;
  assign in_tag.root  = in.root;

  rc_delay_ram #(.Width(TagW), .Stages(Latency - In)) u_tag (
    .clk_i, .rst_ni, .valid_i(valid[In]), .data_i(in_tag), .data_o(end_tag_flat));

  assign end_tag = end_tag_flat;

  rc_delay_ram #(.Width(3 * (OriginWidth + RayDirBits)), .Stages(Latency - Moved)) u_moved (
    .clk_i, .rst_ni, .valid_i(valid[Moved]), .data_i({o, d}), .data_o({end_o, end_d}));

  assign change_fires_o = valid[Latency];
  assign change_o.ray   = end_tag.ray;
  assign change_o.first = end_tag.first;
  assign change_o.root  = end_tag.root;
  assign change_o.o     = end_o;
  assign change_o.d     = end_d;
  assign change_o.recip = recip;
  assign change_o.len   = len;

  if (rc_pkg::HasHomes) begin : gen_tag_of_home
    assign in_tag.kind   = in.kind;
    assign in_tag.here   = in.here;
    assign change_o.kind = end_tag.kind;
    assign change_o.here = end_tag.here;
  end

  logic unused;
  assign unused = ^{moved_o, moved_d, in};
endmodule
`default_nettype wire
