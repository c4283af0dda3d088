// Small memory with one write port and one read port that answers in the same cycle (distributed
// RAM). A read returns what earlier cycles wrote.
`default_nettype none
module rc_ram #(
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
  input  logic [IndexW-1:0] read_addr_i,
  output logic [Width-1:0]  read_data_o
);
  if (Width < 1 || Depth < 1) begin : gen_refuse
    $error("rc_ram: Width and Depth must be at least 1");
  end
  logic [Width-1:0] mem [Depth < 2 ? 2 : Depth];

  assign read_data_o = mem[read_addr_i];
  always_ff @(posedge clk_i) if (write_i) mem[write_addr_i] <= write_data_i;
endmodule
`default_nettype wire
