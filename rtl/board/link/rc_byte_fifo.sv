// FIFO of bytes in block RAM, between a receiver that cannot wait and rc_link.
//
// A byte that meets a full FIFO is lost, and lost_o is high for that cycle; the packet's checksum
// then fails, and the host sends it again. Latency 2, one byte per cycle. The FIFO holds Depth
// bytes in RAM and one more at its output.
`default_nettype none
module rc_byte_fifo #(
  parameter  int unsigned Depth = 1024,   // bytes, a power of two
  localparam int unsigned PlaceW = $clog2(Depth)
) (
  input  logic       clk_i,
  input  logic       rst_ni,
  // Input
  input  logic       push_i,
  input  logic [7:0] data_i,
  output logic       lost_o,
  // Output
  output logic       valid_o,
  input  logic       ready_i,
  output logic [7:0] data_o
);
  if (Depth < 2 || Depth != (1 << PlaceW)) begin : gen_refuse
    $error("rc_byte_fifo: Depth must be a power of two, 2 or more");
  end

  logic [PlaceW:0] write_q, read_q;   // one bit more than a place: full and empty differ
  logic            valid_q, is_full, is_empty, writes, reads;

  assign is_empty = write_q == read_q;
  assign is_full  = write_q == (read_q ^ {1'b1, {PlaceW{1'b0}}});
  assign writes   = push_i && !is_full;
  assign lost_o   = push_i && is_full;
  assign reads    = !is_empty && (!valid_q || ready_i);
  assign valid_o  = valid_q;

  // A place that is read was written in an earlier cycle, so no address is read and written at
  // once.
  rc_ram_sync #(.Width(8), .Depth(Depth)) u_bytes (
    .clk_i, .write_i(writes), .write_addr_i(write_q[PlaceW-1:0]), .write_data_i(data_i),
    .read_i(reads), .read_addr_i(read_q[PlaceW-1:0]), .read_data_o(data_o));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      write_q <= '0;
      read_q  <= '0;
      valid_q <= 1'b0;
    end else begin
      if (writes) write_q <= write_q + 1'b1;
      if (reads)  read_q  <= read_q + 1'b1;
      valid_q <= reads || (valid_q && !ready_i);
    end
  end
endmodule
`default_nettype wire
