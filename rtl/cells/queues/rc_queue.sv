// Queue without back-pressure: the user proves that at most Depth entries exist (in the machine,
// one for each ray context). An assertion checks this.
//
// Latency 1. Depth may be 1. Model: model/core/ring.hpp (Ring). Proof: tests/formal/queue.sv.
`default_nettype none
module rc_queue #(
  parameter  int unsigned Width  = 1,
  parameter  int unsigned Depth  = 4,
  localparam int unsigned Places = Depth < 2 ? 2 : Depth
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  // Input
  input  logic             push_i,
  input  logic [Width-1:0] data_i,
  // Output
  output logic             valid_o,
  input  logic             pop_i,
  output logic [Width-1:0] data_o
);
  if (Width < 1 || Depth < 1) begin : gen_refuse
    $error("rc_queue: Width and Depth must be at least 1");
  end
  logic ready;

  rc_fifo #(.Width(Width), .Depth(Places)) u_fifo (
    .clk_i, .rst_ni, .valid_i(push_i), .ready_o(ready), .data_i,
    .valid_o, .ready_i(pop_i), .data_o);

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni && push_i) a_never_full: assert (ready)
    else $error("a queue that cannot overflow did");
  always_ff @(posedge clk_i) if (rst_ni && pop_i) a_pop_has_entry: assert (valid_o)
    else $error("nothing to pop");
`endif

  logic unused;
  assign unused = ready;
endmodule
`default_nettype wire
