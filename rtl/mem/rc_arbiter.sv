// Round-robin arbiter: merges Sources valid/ready sources into one link. It serves the first source
// that offers, counted from the one after the last that was served. An offer that was not accepted
// stays.
//
// No latency: valid_o follows the sources in the same cycle, and ready goes to the source on offer.
// Model: model/mem/arbiter.hpp. Proof: tests/formal/arbiter.sv.
`default_nettype none
module rc_arbiter #(
  parameter  int unsigned Sources = 2,
  parameter  int unsigned Width   = 1,
  localparam int unsigned IndexW  = $clog2(Sources)
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  // Sources
  input  logic [Sources-1:0]       valid_i,
  output logic [Sources-1:0]       ready_o,
  input  logic [Sources*Width-1:0] data_i,
  // Merged link
  output logic                     valid_o,
  input  logic                     ready_i,
  output logic [IndexW-1:0]        source_o,
  output logic [Width-1:0]         data_o
);
  if (Sources < 2 || Width < 1) begin : gen_refuse
    $error("rc_arbiter: there must be two Sources, and Width must be at least 1");
  end

  logic              held_q;
  logic [IndexW-1:0] last_q, held_source_q, turn;

  // Next source in turn. The last assignment wins, so the nearest source is tested last.
  always_comb begin
    turn = last_q;
    for (int i = Sources - 1; i >= 1; i--) begin
      if (valid_i[IndexW'(last_q + IndexW'(i))]) turn = IndexW'(last_q + IndexW'(i));
    end
  end

  assign source_o = held_q ? held_source_q : turn;
  assign valid_o  = valid_i != '0;
  assign ready_o  = {{(Sources-1){1'b0}}, valid_o && ready_i} << source_o;
  assign data_o   = data_i[source_o*Width +: Width];

  // An offer that stalls holds its source.
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      held_q <= 1'b0;
      last_q <= '0;
    end else begin
      held_q <= valid_o && !ready_i;
      if (valid_o && ready_i) last_q <= source_o;
    end
    held_source_q <= source_o;
  end
endmodule
`default_nettype wire
