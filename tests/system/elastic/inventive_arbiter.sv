// Faulty: requests line 0 of its own accord when it has been idle for 50 cycles.
`default_nettype none
module rc_arbiter #(
  parameter  int unsigned Sources = 2,
  parameter  int unsigned Width   = 1,
  localparam int unsigned IndexW  = $clog2(Sources)
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic [Sources-1:0]       valid_i,
  output logic [Sources-1:0]       ready_o,
  input  logic [Sources*Width-1:0] data_i,
  output logic                     valid_o,
  input  logic                     ready_i,
  output logic [IndexW-1:0]        source_o,
  output logic [Width-1:0]         data_o
);
  localparam logic [5:0] Pause = 6'd50;

  logic              own_valid, invents;
  logic [IndexW-1:0] own_source;
  logic [Width-1:0]  own_data;
  logic [5:0]        idle_q;   // cycles

  rc_arbiter_own #(.Sources(Sources), .Width(Width)) u_own (
    .clk_i, .rst_ni, .valid_i, .ready_o, .data_i, .valid_o(own_valid),
    .ready_i(ready_i && !invents),
    .source_o(own_source), .data_o(own_data));

  assign invents  = !own_valid && idle_q == Pause;
  assign valid_o  = own_valid || invents;
  assign source_o = invents ? '0 : own_source;
  assign data_o   = invents ? '0 : own_data;

  always_ff @(posedge clk_i) begin
    if (!rst_ni || own_valid || (invents && ready_i)) idle_q <= '0;
    else if (idle_q != Pause)                         idle_q <= idle_q + 6'd1;
  end
endmodule
`default_nettype wire
