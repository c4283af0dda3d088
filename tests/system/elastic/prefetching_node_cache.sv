// Right: a node cache that prefetches a line when it has been idle for 40 cycles, and drops it.
`default_nettype none
module rc_node_cache (
  input  logic               clk_i,
  input  logic               rst_ni,
  input  logic               req_valid_i,
  output logic               req_ready_o,
  input  rc_pkg::node_req_t  req_i,
  output logic               rsp_valid_o,
  input  logic               rsp_ready_i,
  output rc_pkg::node_rsp_t  rsp_o,
  output logic               next_fires_o,
  output logic [rc_pkg::RayBits-1:0] next_ray_o,
  output logic               miss_valid_o,
  input  logic               miss_ready_i,
  output rc_pkg::node_miss_t miss_o,
  input  logic               fill_fires_i,
  input  rc_pkg::node_fill_t fill_i,
  output logic               waits_o,
  output logic [rc_pkg::CauseBits-1:0] outcome_o
);
  localparam logic [5:0] Pause = 6'd40;

  rc_pkg::node_miss_t own_miss;
  logic       own_ready, own_miss_valid, offers_q, waits_q, is_idle;
  logic [5:0] idle_q, line_q;
  logic [7:0] in_flight_q;   // misses of the cache itself

  rc_node_cache_own u_own (
    .clk_i, .rst_ni, .req_valid_i(req_valid_i && !offers_q && !waits_q), .req_ready_o(own_ready),
    .req_i,
    .rsp_valid_o, .rsp_ready_i, .rsp_o, .next_fires_o, .next_ray_o, .miss_valid_o(own_miss_valid),
    .miss_ready_i(miss_ready_i && !offers_q), .miss_o(own_miss),
    .fill_fires_i(fill_fires_i && !waits_q),
    .fill_i, .waits_o, .outcome_o);

  assign req_ready_o  = own_ready && !offers_q && !waits_q;
  assign miss_valid_o = own_miss_valid || offers_q;
  assign miss_o       = offers_q ? rc_pkg::node_miss_t'(line_q) : own_miss;
  assign is_idle      = !req_valid_i && !own_miss_valid && in_flight_q == '0 && !rsp_valid_o &&
      !offers_q
                      && !waits_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      offers_q    <= 1'b0;
      waits_q     <= 1'b0;
      idle_q      <= '0;
      line_q      <= '0;
      in_flight_q <= '0;
    end else begin
      in_flight_q <= in_flight_q + 8'(own_miss_valid && miss_ready_i && !offers_q)
                   - 8'(fill_fires_i && !waits_q);
      idle_q      <= !is_idle ? '0 : idle_q == Pause ? idle_q : idle_q + 6'd1;
      if (is_idle && idle_q == Pause) offers_q <= 1'b1;
      if (offers_q && miss_ready_i) begin
        offers_q <= 1'b0;
        waits_q  <= 1'b1;
        line_q   <= line_q + 6'd7;
      end
      if (waits_q && fill_fires_i) waits_q <= 1'b0;
    end
  end
endmodule
`default_nettype wire
