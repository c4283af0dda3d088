// Memory of what a pass reads of its context. Where a pass enters in every cycle, it answers in the
// same one (LUT RAM). Where passes come every few cycles, the answer to read_i comes in the next
// cycle and stays until then (block RAM): nobody reads and writes a context at once.
`default_nettype none
module rc_kept #(
  parameter  int unsigned Width  = 1,
  parameter  int unsigned Depth  = 2,
  localparam int unsigned IndexW = Depth < 2 ? 1 : $clog2(Depth)
) (
  input  logic              clk_i,
  input  logic              write_i,
  input  logic [IndexW-1:0] write_addr_i,
  input  logic [Width-1:0]  write_data_i,
  input  logic              read_i,
  input  logic [IndexW-1:0] read_addr_i,
  output logic [Width-1:0]  read_data_o
);
  if (rc_pkg::ShadeInterval == 1) begin : gen_now
    rc_ram #(.Width(Width), .Depth(Depth)) u_ram (
      .clk_i, .write_i, .write_addr_i, .write_data_i, .read_addr_i, .read_data_o);
    logic unused;
    assign unused = read_i;
  end else begin : gen_next
    rc_ram_sync #(.Width(Width), .Depth(Depth)) u_ram (
      .clk_i, .write_i, .write_addr_i, .write_data_i, .read_i, .read_addr_i, .read_data_o);
`ifndef SYNTHESIS
    a_apart: assert property (@(posedge clk_i)
        !(write_i && read_i && write_addr_i == read_addr_i))
      else $error("rc_kept: a context is read while it is written");
`endif
  end
endmodule
`default_nettype wire
