// The fields of a ray that the node unit needs:
// - boxes, treelets and pairs of planes (signs_ray_t): origin, signs and reciprocals;
// - globes (toward_ray_t): the direction that rc_globe_ray makes;
// - slants (along_ray_t): origin, reciprocals and the direction, shifted up to RayDirBits.
//
// Part of rc_trav, which stores them until the ray's nodes come. Latency 3 for globes in a fast
// chip, otherwise 0.
`default_nettype none
module rc_node_ray #(
  parameter  int unsigned Structure   = rc_pkg::Structure,
  parameter  int unsigned FieldsW     = rc_pkg::NodeReqBits - rc_pkg::NodeBits - rc_pkg::RayBits,
  localparam int unsigned RayBits     = rc_pkg::RayBits,
  localparam int unsigned OriginWidth = rc_pkg::OriginWidth,
  localparam int unsigned RayDirBits  = rc_pkg::RayDirBits,
  localparam int unsigned R1          = rc_pkg::RecipBits + 1,
  localparam int unsigned ExpBits     = rc_pkg::ExpBits
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  // Ray
  input  logic                     valid_i,
  input  logic [RayBits-1:0]       ray_i,
  input  logic [3*OriginWidth-1:0] o_i,
  input  logic [3*RayDirBits-1:0]  d_i,
  input  logic [3*R1-1:0]          recip_i,
  input  logic [3*ExpBits-1:0]     len_i,
  input  logic                     short_i,  // d has DirBits only: shadow rays fill RayDirBits
  // Result
  output logic                     valid_o,
  output logic [RayBits-1:0]       ray_o,
  output logic [FieldsW-1:0]       fields_o  // the origin is highest
);
  rc_pkg::signs_ray_t signs_ray;
  rc_pkg::along_ray_t along_ray;

  assign signs_ray.o     = o_i;
  assign signs_ray.neg   = {d_i[3*RayDirBits-1], d_i[2*RayDirBits-1], d_i[RayDirBits-1]};
  assign signs_ray.recip = recip_i;
  assign signs_ray.len   = len_i;

  // The direction in the upper bits of RayDirBits.
  logic [3*RayDirBits-1:0] along;

  for (genvar k = 0; k < 3; k++) begin : gen_axis
    assign along[k*RayDirBits +: RayDirBits] = d_i[k*RayDirBits +: RayDirBits]
                                             << (short_i ? RayDirBits - rc_pkg::DirBits : 0);
  end

  assign along_ray.o     = o_i;
  assign along_ray.recip = recip_i;
  assign along_ray.len   = len_i;
  assign along_ray.along = along;

  if (Structure == rc_pkg::StructureSpheres) begin : gen_toward
    rc_globe_ray u_globe_ray (
      .clk_i, .rst_ni, .valid_i, .ray_i, .o_i, .d_i, .short_i, .valid_o, .ray_o, .fields_o);
  end else begin : gen_now
    assign valid_o = valid_i;
    assign ray_o   = ray_i;

    if (Structure == rc_pkg::StructureBsp) begin : gen_along
      assign fields_o = along_ray;
    end else begin : gen_signs
      assign fields_o = signs_ray;
    end
  end

  logic unused;
  assign unused = ^{clk_i, rst_ni, signs_ray, along_ray};
endmodule
`default_nettype wire
