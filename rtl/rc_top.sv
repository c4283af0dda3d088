// The machine: wires the pipelines that share the picture's tiles and the memory.
//
// A frame begins in the cycle after start_i. start_i may be set only when all answers of the last
// frame have left the chip, and not before the second cycle after a reset. The user holds frame_i
// until the last hit. Each pipeline returns the hits of its tiles.
//
// Memory is read 64 bytes at a time, and written if the chip writes hits. Answers to reads may
// come in any order, are matched by id, and are always accepted. Reset must be held for four
// cycles more than the largest cache has sets. Model: model/machine/machine.hpp.
`default_nettype none
module rc_top #(
  localparam int unsigned Units = rc_pkg::Pipelines * rc_pkg::PipelineUnits + rc_pkg::SharedUnits
) (
  input  logic                                      clk_i,
  input  logic                                      rst_ni,
  // From the host
  input  logic                                      start_i,
  input  rc_pkg::frame_t                            frame_i,
  // To and from memory
  output logic                                      mem_req_valid_o,
  input  logic                                      mem_req_ready_i,
  output rc_pkg::mem_req_t                          mem_req_o,
  input  logic                                      mem_rsp_fires_i,
  input  rc_pkg::mem_rsp_t                          mem_rsp_i,
  // Picture, one stream per pipeline; idle in a chip that writes hits
  output logic [rc_pkg::Pipelines-1:0]              hit_valid_o,
  input  logic [rc_pkg::Pipelines-1:0]              hit_ready_i,
  output logic [rc_pkg::Pipelines*rc_pkg::HitW-1:0] hit_o,
  // To the host: one bit for each answer that leaves the chip
  output logic [rc_pkg::MostAnswers-1:0]            hit_fires_o,
  // What each unit did in this cycle: shared units lowest, then pipeline by pipeline
  output logic [Units*rc_pkg::CauseBits-1:0] causes_o
);
  localparam int unsigned Pipelines      = rc_pkg::Pipelines;
  localparam int unsigned ClientBits     = rc_pkg::ClientBits;
  localparam int unsigned CacheIdW       = rc_pkg::ClientIdBits - ClientBits;  // a cache's own id
  localparam int unsigned AddrBits       = rc_pkg::AddrBits;
  // Bits of the ids of each kind of cache.
  localparam int unsigned NodeIdW        = rc_pkg::NodeMissW - AddrBits;
  localparam int unsigned PrimIdW        = rc_pkg::PrimMissW - AddrBits;
  localparam int unsigned SurfIdW        = rc_pkg::SurfMissW - AddrBits;
  localparam int unsigned RecordIdW      = rc_pkg::StreamMissW - AddrBits;
  localparam int unsigned TexelIdW       = rc_pkg::TexMissW - AddrBits;
  localparam int unsigned Clients        = rc_pkg::Clients;
  // Causes of the shared units and of a pipeline's units.
  localparam int unsigned SharedCauseW   = rc_pkg::SharedUnits * rc_pkg::CauseBits;
  localparam int unsigned PipelineCauseW = rc_pkg::PipelineUnits * rc_pkg::CauseBits;

  // The shared units have their own reset register, as has each unit of a pipeline.
  logic shared_rst_n;
  rc_reset_register u_reset (.clk_i, .rst_ni, .rst_no(shared_rst_n));

  // ---- Tiles.
  logic [Pipelines-1:0]  tile_ready, tile_fires;
  rc_pkg::tile_t tile;
  logic [rc_pkg::CauseBits-1:0] dispatch_cause;

  rc_dispatch u_dispatch (
    .clk_i, .rst_ni(shared_rst_n), .start_i, .frame_i,
    .tile_ready_i(tile_ready), .tile_fires_o(tile_fires), .tile_o(tile), .cause_o(dispatch_cause));

  // ---- Pipelines. Their caches are clients of memory: client Clients p reads nodes, the
  // next one primitives, the next one surfaces if the chip shades, or records of a stream. The
  // fourth client reads textures, if the chip has them.
  logic [Clients*Pipelines-1:0]                     miss_valid, miss_ready, fill_fires;
  logic [Clients*Pipelines*(CacheIdW+AddrBits)-1:0] miss;
  logic [Pipelines-1:0]                             hit_valid, hit_ready;
  logic [Pipelines*rc_pkg::HitW-1:0]                hit;
  logic                                             fill_valid;
  rc_pkg::l2_rsp_t                                  fill;
  logic [ClientBits-1:0]                            fill_client;
  logic [CacheIdW-1:0]                              fill_id;      // the client's own id

  assign {fill_client, fill_id} = fill.id;

  for (genvar p = 0; p < Pipelines; p++) begin : gen_pipeline
    logic [NodeIdW-1:0]   node_id;
    logic [PrimIdW-1:0]   prim_id;
    logic [SurfIdW-1:0]   surf_id;
    logic [AddrBits-1:0]  node_addr, prim_addr, surf_addr;
    logic                 surf_valid, surf_ready, surf_fires;
    logic [RecordIdW-1:0] record_id;
    logic [AddrBits-1:0]  record_addr;
    logic                 record_valid, record_ready, record_fires;
    logic [TexelIdW-1:0]  texel_id;
    logic [AddrBits-1:0]  texel_addr;
    logic                 texel_valid, texel_ready, texel_fires;

    rc_pipeline u_pipeline (
      .clk_i, .rst_ni, .start_i, .frame_i,
      .tile_ready_o(tile_ready[p]), .tile_fires_i(tile_fires[p]), .tile_i(tile),
      .node_miss_valid_o(miss_valid[Clients*p]), .node_miss_ready_i(miss_ready[Clients*p]),
      .node_miss_o({node_id, node_addr}), .node_fill_fires_i(fill_fires[Clients*p]),
      .node_fill_i({fill_id[NodeIdW-1:0], fill.line}),
      .prim_miss_valid_o(miss_valid[Clients*p+1]), .prim_miss_ready_i(miss_ready[Clients*p+1]),
      .prim_miss_o({prim_id, prim_addr}), .prim_fill_fires_i(fill_fires[Clients*p+1]),
      .prim_fill_i({fill_id[PrimIdW-1:0], fill.line}),
      .surf_miss_valid_o(surf_valid), .surf_miss_ready_i(surf_ready),
      .surf_miss_o({surf_id, surf_addr}), .surf_fill_fires_i(surf_fires),
      .surf_fill_i({fill_id[SurfIdW-1:0], fill.line}),
      .tex_miss_valid_o(texel_valid), .tex_miss_ready_i(texel_ready),
      .tex_miss_o({texel_id, texel_addr}), .tex_fill_fires_i(texel_fires),
      .tex_fill_i({fill_id[TexelIdW-1:0], fill.line}),
      .stream_miss_valid_o(record_valid), .stream_miss_ready_i(record_ready),
      .stream_miss_o({record_id, record_addr}), .stream_fill_fires_i(record_fires),
      .stream_fill_i({fill_id[RecordIdW-1:0], fill.line}),
      .hit_valid_o(hit_valid[p]), .hit_ready_i(hit_ready[p]),
      .hit_o(hit[p*rc_pkg::HitW +: rc_pkg::HitW]),
      .causes_o(causes_o[SharedCauseW+p*PipelineCauseW +: PipelineCauseW]));

    assign miss[Clients*p*(CacheIdW+AddrBits) +: CacheIdW+AddrBits] =
        {CacheIdW'(node_id), node_addr};
    assign miss[(Clients*p+1)*(CacheIdW+AddrBits) +: CacheIdW+AddrBits] =
        {CacheIdW'(prim_id), prim_addr};

    if (Clients == 2) begin : gen_plain
      assign {surf_ready, surf_fires, record_ready, record_fires} = '0;
      assign {texel_ready, texel_fires} = '0;

      logic unused;
      assign unused = ^{surf_valid, surf_id, surf_addr, record_valid, record_id, record_addr,
                        texel_valid, texel_id, texel_addr};
    end else begin : gen_third
      logic                         third_valid, third_ready, third_fires;
      logic [CacheIdW+AddrBits-1:0] third;

      if (rc_pkg::IsStream) begin : gen_stream
        assign {third_valid, third}         = {record_valid, CacheIdW'(record_id), record_addr};
        assign {record_ready, record_fires} = {third_ready, third_fires};
        assign {surf_ready, surf_fires}     = '0;

        logic unused;
        assign unused = ^{surf_valid, surf_id, surf_addr};
      end else begin : gen_shaded
        assign {third_valid, third}         = {surf_valid, CacheIdW'(surf_id), surf_addr};
        assign {surf_ready, surf_fires}     = {third_ready, third_fires};
        assign {record_ready, record_fires} = '0;

        logic unused;
        assign unused = ^{record_valid, record_id, record_addr};
      end

      assign {third_ready, third_fires}   = {miss_ready[Clients*p+2], fill_fires[Clients*p+2]};
      assign {texel_ready, texel_fires}   = {miss_ready[Clients*p+3], fill_fires[Clients*p+3]};
      assign miss_valid[Clients*p+2 +: 2] = {texel_valid, third_valid};
      assign miss[(Clients*p+2)*(CacheIdW+AddrBits) +: 2*(CacheIdW+AddrBits)] =
          {CacheIdW'(texel_id), texel_addr, third};
    end
  end

  // ---- Memory port.
  logic                  client_valid, client_ready;
  logic [ClientBits-1:0] client;
  logic [CacheIdW+AddrBits-1:0] client_miss;

  rc_arbiter #(.Sources(Clients * Pipelines), .Width(CacheIdW + AddrBits)) u_arbiter (
    .clk_i, .rst_ni(shared_rst_n), .valid_i(miss_valid), .ready_o(miss_ready), .data_i(miss),
    .valid_o(client_valid), .ready_i(client_ready), .source_o(client), .data_o(client_miss));

  // Compared, not shifted: in a simulation a shift of 0 by an unknown number is unknown.
  for (genvar k = 0; k < Clients * Pipelines; k++) begin : gen_client
    assign fill_fires[k] = fill_valid && fill_client == ClientBits'(k);
  end

  logic [rc_pkg::CauseBits-1:0] memport_cause, l2_cause, hits_cause;

  assign memport_cause = !client_valid ? rc_pkg::MemportStarvedCaches
                       : client_ready ? rc_pkg::MemportBusyWork : rc_pkg::MemportStalledMemory;
  assign causes_o[SharedCauseW-1:0] = {hits_cause, l2_cause, memport_cause, dispatch_cause};

  // Memory directly, or through the shared cache.
  logic             read_valid, read_ready;
  rc_pkg::l2_miss_t read;

  if (rc_pkg::L2Sets == 0) begin : gen_direct
    assign read_valid   = client_valid;
    assign client_ready = read_ready;
    assign read         = {client, client_miss};
    assign fill_valid   = mem_rsp_fires_i;
    assign fill         = mem_rsp_i;
    assign l2_cause     = '0;
  end else begin : gen_shared
    logic unused;
    rc_l2 u_l2 (
      .clk_i, .rst_ni(shared_rst_n),
      .req_valid_i(client_valid), .req_ready_o(client_ready), .req_i({client, client_miss}),
      .rsp_valid_o(fill_valid), .rsp_ready_i(1'b1), .rsp_o(fill),
      .miss_valid_o(read_valid), .miss_ready_i(read_ready), .miss_o(read),
      .fill_fires_i(mem_rsp_fires_i), .fill_i(mem_rsp_i), .waits_o(unused), .outcome_o(l2_cause));
  end

  // Answers leave through the pixel port. In a chip that writes hits they share the memory's port
  // with the reads, as lines.
  if (!rc_pkg::WritesHits) begin : gen_reads
    assign mem_req_valid_o = read_valid;
    assign read_ready      = mem_req_ready_i;
    assign mem_req_o       = read;
    assign hit_valid_o     = hit_valid;
    assign hit_ready       = hit_ready_i;
    assign hit_o           = hit;
    assign hit_fires_o     = hit_valid & hit_ready_i;
    assign hits_cause      = '0;
  end else begin : gen_hits
    logic                        line_valid, line_ready, is_write;
    logic [AddrBits-1:0]         line_addr;
    logic [rc_pkg::LineBits-1:0] line;
    logic [rc_pkg::L2MissW-1:0]  request;

    rc_hits u_hits (
      .clk_i, .rst_ni(shared_rst_n), .start_i, .frame_i,
      .hit_valid_i(hit_valid), .hit_ready_o(hit_ready), .hit_i(hit),
      .line_valid_o(line_valid), .line_ready_i(line_ready), .line_addr_o(line_addr),
      .line_o(line), .written_o(hit_fires_o), .cause_o(hits_cause));

    rc_arbiter #(.Sources(2), .Width(rc_pkg::L2MissW)) u_port (
      .clk_i, .rst_ni(shared_rst_n), .valid_i({line_valid, read_valid}),
      .ready_o({line_ready, read_ready}), .data_i({rc_pkg::L2MissW'(line_addr), read}),
      .valid_o(mem_req_valid_o), .ready_i(mem_req_ready_i), .source_o(is_write),
      .data_o(request));

    assign mem_req_o            = {line, is_write, request};
    assign {hit_valid_o, hit_o} = '0;

    logic unused;
    assign unused = ^hit_ready_i;
  end
endmodule
`default_nettype wire
