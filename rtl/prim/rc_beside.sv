// Data that wait beside a pipeline into which work comes every Every cycles and stays as long in
// each stage, for Stages of these: data_o is what came with come_i, until leave_i says that the
// same work goes on to the stage that needs it. As rc_wait, which it is if Every is 1.
//
// If work stays long, and a cell of LUT RAM (16 words) does not hold the data, they lie in block
// RAM, which Yosys 0.23 does not choose by itself. What is next is read in the cycle in which work
// leaves: it is there in the next one, as from LUT RAM; or if it may come Late, in the one after.
`default_nettype none
module rc_beside #(
  parameter  int unsigned Width  = 1,
  parameter  int unsigned Stages = 2,
  parameter  int unsigned Every  = rc_pkg::ShadeInterval,
  parameter  bit          Late   = 1'b0,
  localparam int unsigned IndexW = Stages < 2 ? 1 : $clog2(Stages),
  localparam bit          Block  = Every >= 4 && Stages > 16 && Width > 16
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             come_i,    // work goes on from the stage that has the data
  input  logic             leave_i,   // the same work, Stages later
  input  logic [Width-1:0] data_i,
  output logic [Width-1:0] data_o
);
  if (Every == 1) begin : gen_wait
    rc_wait #(.Width(Width), .Stages(Stages)) u_wait (
      .clk_i, .rst_ni, .valid_i(come_i), .data_i, .data_o);
    logic unused;
    assign unused = leave_i;
  end else if (Stages == 1) begin : gen_register
    logic [Width-1:0] data_q;
    assign data_o = data_q;
    always_ff @(posedge clk_i) if (come_i) data_q <= data_i;
    logic unused;
    assign unused = ^{rst_ni, leave_i};
  end else begin : gen_ring   // Stages pieces of work at most lie in it
    localparam logic [IndexW-1:0] Last = IndexW'(Stages - 1);
    logic [IndexW-1:0] in_q, out_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni)      in_q <= '0;
      else if (come_i)  in_q <= in_q == Last ? '0 : in_q + 1'b1;
      if (!rst_ni)      out_q <= '0;
      else if (leave_i) out_q <= out_q == Last ? '0 : out_q + 1'b1;
    end
    if (Block) begin : gen_block
      (* no_rw_check, ram_style = "block" *) logic [Width-1:0] mem [Stages];
      logic [Width-1:0]  read_q;
      logic [IndexW-1:0] out_d;
      assign out_d  = !leave_i || Late ? out_q : out_q == Last ? '0 : out_q + 1'b1;
      assign data_o = read_q;
      always_ff @(posedge clk_i) begin
        if (come_i) mem[in_q] <= data_i;
        if (!come_i || in_q != out_d) read_q <= mem[out_d];
      end
    end else begin : gen_luts
      rc_ram #(.Width(Width), .Depth(Stages)) u_ram (
        .clk_i, .write_i(come_i), .write_addr_i(in_q), .write_data_i(data_i), .read_addr_i(out_q),
        .read_data_o(data_o));
    end
  end
endmodule
`default_nettype wire
