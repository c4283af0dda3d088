// Data that wait beside a pass of shade for so many of its stages: data_o is what came with
// come_i, until leave_i says that the pass goes on from the stage that needs it. As rc_wait, of
// which there is one if a pass stays one cycle in a stage.
`default_nettype none
module rc_beside #(
  parameter  int unsigned Width  = 1,
  parameter  int unsigned Stages = 2,
  localparam int unsigned IndexW = Stages < 2 ? 1 : $clog2(Stages)
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             come_i,    // a pass goes on from the stage that has the data
  input  logic             leave_i,   // the same pass, Stages later
  input  logic [Width-1:0] data_i,
  output logic [Width-1:0] data_o
);
  if (rc_pkg::ShadeInterval == 1) begin : gen_wait
    rc_wait #(.Width(Width), .Stages(Stages)) u_wait (
      .clk_i, .rst_ni, .valid_i(come_i), .data_i, .data_o);
    logic unused;
    assign unused = leave_i;
  end else begin : gen_ring   // Stages passes at most lie in it
    localparam logic [IndexW-1:0] Last = IndexW'(Stages - 1);
    logic [IndexW-1:0] in_q, out_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni)      in_q <= '0;
      else if (come_i)  in_q <= in_q == Last ? '0 : in_q + 1'b1;
      if (!rst_ni)      out_q <= '0;
      else if (leave_i) out_q <= out_q == Last ? '0 : out_q + 1'b1;
    end
    rc_ram #(.Width(Width), .Depth(Stages)) u_ram (
      .clk_i, .write_i(come_i), .write_addr_i(in_q), .write_data_i(data_i), .read_addr_i(out_q),
      .read_data_o(data_o));
  end
endmodule
`default_nettype wire
