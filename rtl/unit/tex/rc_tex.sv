// Textures: reads the texture record of a hit and then the line of its texels, and filters them.
//
// A hit from shade requests its record at once. rc_texel_address computes the address of the texels
// from the record, and rc_texel_filter computes a colour from the texels. Requests for texels have
// priority over those for records. Lines are always accepted, and shade accepts every colour.
//
// Latency from a record to its request for texels TexAddressStages + 1, from texels to their
// colour TexFilterStages. Both take one hit per cycle. The unit exists only in a chip with
// textures. Model: model/unit/tex/tex.hpp (timing), model/unit/tex/texel.hpp (values).
`default_nettype none
module rc_tex (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  // From the host. The user holds it while rays are in flight.
  input  rc_pkg::frame_t        frame_i,
  // From shade
  input  logic                  req_valid_i,
  output logic                  req_ready_o,
  input  rc_pkg::tex_req_t      req_i,
  // To and from tex_cache
  output logic                  texel_req_valid_o,
  input  logic                  texel_req_ready_i,
  output rc_pkg::texel_req_t    texel_req_o,
  input  logic                  texel_rsp_valid_i,
  output logic                  texel_rsp_ready_o,
  input  rc_pkg::texel_rsp_t    texel_rsp_i,
  input  logic                  texels_wait_i,   // the cache waits for memory
  // To shade
  output logic                  rsp_fires_o,
  output rc_pkg::tex_rsp_t      rsp_o,
  // Activity: rc_pkg::tex_cause_e
  output logic [rc_pkg::CauseBits-1:0] cause_o
);
  localparam int unsigned RayBits  = rc_pkg::RayBits;
  localparam int unsigned AddrBits = rc_pkg::AddrBits;
  localparam int unsigned Contexts = rc_pkg::Contexts;
  localparam int unsigned HitW     = rc_pkg::TexReqW - RayBits - AddrBits;
  localparam int unsigned PlaceW   = rc_pkg::TexelPlaceW;

  assign texel_rsp_ready_o = 1'b1;

  // ---- Requests to the cache: texels first, then records.
  logic                        texels_valid, texels_ready;
  logic [RayBits+AddrBits-1:0] texels_next, request;
  logic                        req_fires, texels_fire;

  rc_priority_merge #(.Width(RayBits + AddrBits)) u_request (
    .clk_i, .rst_ni,
    .first_valid_i(texels_valid), .first_ready_o(texels_ready), .first_i(texels_next),
    .second_valid_i(req_valid_i), .second_ready_o(req_ready_o),
    .second_i({req_i.ray, req_i.record}),
    .valid_o(texel_req_valid_o), .ready_i(texel_req_ready_i), .data_o(request));

  assign texel_req_o = request;
  assign req_fires   = req_valid_i && req_ready_o;
  assign texels_fire = texels_valid && texels_ready;

  // ---- Answers: a record or texels, according to the context's last request.
  logic [Contexts-1:0] reads_texels_q;
  logic [RayBits-1:0]  rsp_ray;
  logic                record_comes, texels_come;
  logic [HitW-1:0]     hit;

  assign rsp_ray      = texel_rsp_i.ray;
  assign record_comes = texel_rsp_valid_i && !reads_texels_q[rsp_ray];
  assign texels_come  = texel_rsp_valid_i && reads_texels_q[rsp_ray];

  always_ff @(posedge clk_i) begin
    if (req_fires)   reads_texels_q[req_i.ray] <= 1'b0;
    if (texels_fire) reads_texels_q[texels_next[AddrBits +: RayBits]] <= 1'b1;
  end

  logic [rc_pkg::TexReqW-1:0] req_flat;   // the context's number and the record lie highest

  assign req_flat = req_i;

  logic unused;
  assign unused = ^req_flat;

  rc_ram #(.Width(HitW), .Depth(Contexts)) u_hit (
    .clk_i, .write_i(req_fires), .write_addr_i(req_i.ray),
    .write_data_i(req_flat[HitW-1:0]), .read_addr_i(rsp_ray),
    .read_data_o(hit));

  // ---- From a record to the address of the texels.
  logic                addressed;
  logic [RayBits-1:0]  addressed_ray;
  logic [AddrBits-1:0] addressed_line;
  logic [PlaceW-1:0]   addressed_place, place;

  rc_texel_address u_address (
    .clk_i, .rst_ni, .valid_i(record_comes), .ray_i(rsp_ray), .frame_i, .hit_i(hit),
    .line_i(texel_rsp_i.line), .valid_o(addressed), .ray_o(addressed_ray),
    .line_o(addressed_line), .place_o(addressed_place));

  rc_queue #(.Width(RayBits + AddrBits), .Depth(Contexts)) u_texels (
    .clk_i, .rst_ni, .push_i(addressed), .data_i({addressed_ray, addressed_line}),
    .valid_o(texels_valid), .pop_i(texels_fire), .data_o(texels_next));

  rc_ram #(.Width(PlaceW), .Depth(Contexts)) u_place (
    .clk_i, .write_i(addressed), .write_addr_i(addressed_ray), .write_data_i(addressed_place),
    .read_addr_i(rsp_ray), .read_data_o(place));

  // ---- From texels to a colour.
  rc_texel_filter u_filter (
    .clk_i, .rst_ni, .valid_i(texels_come), .ray_i(rsp_ray), .line_i(texel_rsp_i.line),
    .place_i(place), .valid_o(rsp_fires_o), .rsp_o);

  assign cause_o = texel_rsp_valid_i ? rc_pkg::TexBusyWork
                 : texels_wait_i     ? rc_pkg::TexStarvedMemory : rc_pkg::TexStarvedShade;
endmodule
`default_nettype wire
