// Delays data by Stages cycles to match a pipeline: data_o is the data_i of Stages cycles ago if
// valid_i was set then, and arbitrary otherwise.
//
// Like rc_shift_register, but the data stays in place in a small memory (rc_ram) and only the
// address moves. Proof: tests/formal/delay_ram.sv.
`default_nettype none
module rc_delay_ram #(
  parameter  int unsigned Width  = 1,
  parameter  int unsigned Stages = 2,
  localparam int unsigned IndexW = Stages < 2 ? 1 : $clog2(Stages)
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             valid_i,
  input  logic [Width-1:0] data_i,
  output logic [Width-1:0] data_o
);
  if (Width < 1 || Stages < 1) begin : gen_refuse
    $error("rc_delay_ram: Width and Stages must be at least 1");
  end

  // Address: counts modulo Stages. Each cycle reads the word of Stages cycles ago, then replaces
  // it.
  logic [IndexW-1:0] at_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || at_q == IndexW'(Stages - 1)) at_q <= '0;
    else                                        at_q <= at_q + 1'b1;
  end

  rc_ram #(.Width(Width), .Depth(Stages)) u_ram (
    .clk_i, .write_i(valid_i), .write_addr_i(at_q), .write_data_i(data_i), .read_addr_i(at_q),
    .read_data_o(data_o));
endmodule
`default_nettype wire
