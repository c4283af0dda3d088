// Property of rc_delay_ram: data that enters with valid_i leaves after exactly Stages cycles. Two
// bits of data represent any width. An induction over more than Stages cycles sees all data in the
// memory enter, so only the place needs an invariant.
module delay_ram #(
  parameter  int unsigned Stages = 3,
  localparam int unsigned IndexW = $clog2(Stages)
) (
  input logic       clk_i,
  input logic       rst_ni,
  input logic       valid_i,
  input logic [1:0] data_i
);
  logic [1:0] data_o;
  rc_delay_ram #(.Width(2), .Stages(Stages)) u_dut (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid_i), .data_i(data_i), .data_o(data_o));
  (* hierconn *) wire [IndexW-1:0] \u_dut.at_q ;

  logic begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* assume (rst_ni == begun_q);

  logic [Stages-1:0]   valid_q = '0;
  logic [2*Stages-1:0] data_q;
  always @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else         valid_q <= {valid_q[Stages-2:0], valid_i};
    data_q <= {data_q[2*Stages-3:0], data_i};
  end
  always @* if (rst_ni) begin
    a_place: assert ({1'b0, \u_dut.at_q } < Stages);
    if (valid_q[Stages-1]) begin
      a_comes_out: assert (data_o == data_q[2*Stages-1 -: 2]);
    end
  end
endmodule
