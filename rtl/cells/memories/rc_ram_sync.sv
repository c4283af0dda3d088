// Memory with one write port and one read port with a registered answer (block RAM). An address
// with read_i gives its data in the next cycle.
//
// The user must not read and write one address in the same cycle. Without that promise
// (no_rw_check) Yosys adds registers and multiplexers that preserve the old word.
`default_nettype none
module rc_ram_sync #(
  parameter  int unsigned Width  = 1,
  parameter  int unsigned Depth  = 2,
  localparam int unsigned IndexW = Depth < 2 ? 1 : $clog2(Depth)
) (
  input  logic              clk_i,
  // Write port
  input  logic              write_i,
  input  logic [IndexW-1:0] write_addr_i,
  input  logic [Width-1:0]  write_data_i,
  // Read port
  input  logic              read_i,
  input  logic [IndexW-1:0] read_addr_i,
  output logic [Width-1:0]  read_data_o
);
  if (Width < 1 || Depth < 1) begin : gen_refuse
    $error("rc_ram_sync: Width and Depth must be at least 1");
  end

  (* no_rw_check *) logic [Width-1:0] mem [Depth < 2 ? 2 : Depth];
  logic [Width-1:0] read_q;

  assign read_data_o = read_q;
  always_ff @(posedge clk_i) begin
    if (write_i) mem[write_addr_i] <= write_data_i;
    if (read_i) read_q <= mem[read_addr_i];
  end
endmodule
`default_nettype wire
