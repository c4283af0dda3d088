// Data that waits beside a pipeline for Stages cycles, as rc_shift_register, of work that comes at least
// Every cycles apart. If that is more than one cycle it lies still in a small memory until the last
// of the cycles, and a few bits are moved, not all of them.
`default_nettype none
module rc_interval_delay #(
  parameter int unsigned Width  = 1,
  parameter int unsigned Stages = 4,
  parameter int unsigned Every  = 1
) (
  input  logic              clk_i,
  input  logic              rst_ni,
  input  logic [Stages-1:0] valid_i,   // as of rc_shift_register
  input  logic [Stages-1:0] there_i,   // the pipeline's stage i holds work, and no more than that
  input  logic [Width-1:0]  data_i,
  output logic [Width-1:0]  data_o
);
  if (Every == 1 || Stages < 4) begin : gen_delay
    rc_shift_register #(.Width(Width), .Stages(Stages)) u_delay (.clk_i, .valid_i, .data_i, .data_o);
    logic unused;
    assign unused = ^{rst_ni, there_i};
  end else begin : gen_memory
    logic [Width-1:0] last;
    rc_stage_delay #(.Width(Width), .Stages((Stages + Every - 2) / Every), .Every(Every)) u_beside (
      .clk_i, .rst_ni, .come_i(there_i[0]), .leave_i(there_i[Stages-1]), .data_i, .data_o(last));
    rc_path_register #(.Width(Width), .Stages(1)) u_last (.clk_i, .data_i(last), .data_o);
    logic unused;
    assign unused = ^{valid_i, there_i};
  end
endmodule
`default_nettype wire
