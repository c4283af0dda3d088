// Delays data by Stages cycles to match a pipeline that accepts work at most once every Every
// cycles. Same result as rc_shift_register.
//
// If Every is above 1, the data stays in place in a small memory until the last cycle. Only a few
// bits move then, instead of all of them.
`default_nettype none
module rc_interval_delay #(
  parameter int unsigned Width  = 1,
  parameter int unsigned Stages = 4,
  parameter int unsigned Every  = 1
) (
  input  logic              clk_i,
  input  logic              rst_ni,
  input  logic [Stages-1:0] enable_i,   // as in rc_shift_register
  input  logic [Stages-1:0] valid_i,    // stage i of the pipeline holds work: the valid bit alone
  input  logic [Width-1:0]  data_i,
  output logic [Width-1:0]  data_o
);
  if (Every == 1 || Stages < 4) begin : gen_delay
    rc_shift_register #(.Width(Width), .Stages(Stages)) u_delay (
      .clk_i, .enable_i, .data_i, .data_o);

    logic unused;
    assign unused = ^{rst_ni, valid_i};
  end else begin : gen_memory
    logic [Width-1:0] last;

    // All cycles except the last lie in the memory. The last one is a register.
    rc_stage_delay #(.Width(Width), .Stages((Stages + Every - 2) / Every), .Every(Every)) u_beside (
      .clk_i, .rst_ni, .enter_i(valid_i[0]), .leave_i(valid_i[Stages-1]), .data_i, .data_o(last));
    rc_path_register #(.Width(Width), .Stages(1)) u_last (.clk_i, .data_i(last), .data_o);

    logic unused;
    assign unused = ^{enable_i, valid_i};
  end
endmodule
`default_nettype wire
