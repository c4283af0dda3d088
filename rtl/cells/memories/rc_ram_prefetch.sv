// Small memory that the ray at the head of a queue reads.
//
// A relaxed chip reads it in the same cycle (distributed RAM). A fast chip uses block RAM if
// distributed RAM would take many cells. Then the ray reads one cycle earlier, when rc_fifo_peek
// reports that it comes to the head. No cycle changes. From that read until the ray leaves the
// head, the user must not write the ray's entry.
`default_nettype none
module rc_ram_prefetch #(
  parameter  int unsigned Width  = 1,
  parameter  int unsigned Depth  = 2,
  localparam int unsigned IndexW = Depth < 2 ? 1 : $clog2(Depth),
  localparam bit          Block  = rc_pkg::PathCut != 0 && Depth > 16 && Width > 16
) (
  input  logic              clk_i,
  input  logic              rst_ni,      // for the assertion: during reset the ports are arbitrary
  // Write port
  input  logic              write_i,
  input  logic [IndexW-1:0] write_addr_i,
  input  logic [Width-1:0]  write_data_i,
  // Head of the queue
  input  logic [IndexW-1:0] head_addr_i,
  // From rc_fifo_peek: an entry comes to the head, and its address
  input  logic              next_fires_i,
  input  logic [IndexW-1:0] next_addr_i,
  // Entry of the head
  output logic [Width-1:0]  read_data_o
);
  if (Width < 1 || Depth < 1) begin : gen_refuse
    $error("rc_ram_prefetch: Width and Depth must be at least 1");
  end

  if (!Block) begin : gen_head
    rc_ram #(.Width(Width), .Depth(Depth)) u_ram (
      .clk_i, .write_i, .write_addr_i, .write_data_i, .read_addr_i(head_addr_i), .read_data_o);

    logic unused;
    assign unused = ^{rst_ni, next_fires_i, next_addr_i};
  end else begin : gen_next
    rc_ram_sync #(.Width(Width), .Depth(Depth)) u_ram (
      .clk_i, .write_i, .write_addr_i, .write_data_i, .read_i(next_fires_i),
      .read_addr_i(next_addr_i), .read_data_o);

`ifndef SYNTHESIS
    always_ff @(posedge clk_i) if (rst_ni)
      a_apart: assert (!(write_i && next_fires_i && write_addr_i == next_addr_i))
      else $error("rc_ram_prefetch: an entry is read while it is written");
`endif

    logic unused;
    assign unused = ^{rst_ni, head_addr_i};
  end
endmodule
`default_nettype wire
