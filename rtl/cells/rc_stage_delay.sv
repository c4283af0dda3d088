// Data that wait beside a pipeline into which work comes every Every cycles and stays as long in
// each stage, for Stages of these: data_o is what came with come_i, until leave_i says that the
// same work goes on to the stage that needs it. As rc_delay_ram, which it is if Every is 1.
//
// If work stays long, and a cell of LUT RAM (16 words) does not hold the data, they lie in block
// RAM, which Yosys 0.23 does not choose by itself. What is next is read in the cycle in which work
// leaves: it is there in the next one, as from LUT RAM.
// With more than one of Parts, wide data lie in a block RAM as narrow as a part (rc_ram_parts).
// They are written in the last Parts cycles up to that of come_i, in which they stand still, and
// what is next is there, in registers, Parts + 2 cycles after work has left. Data in block RAM that
// are not so wide are in a register one cycle after they would be there.
`default_nettype none
module rc_stage_delay #(
  parameter  int unsigned Width   = 1,
  parameter  int unsigned Stages  = 2,
  parameter  int unsigned Every   = rc_pkg::ShadeInterval,
  parameter  int unsigned Parts   = 1,
  localparam bit          Block   = Every >= 4 && Stages > 16 && Width > 16,
  localparam bit          InParts = Block && Parts > 1 && Width > 36,   // of a block RAM
  localparam int unsigned Slots   = InParts ? Stages + 1 : Stages,   // one is being written
  localparam int unsigned IndexW  = Slots < 2 ? 1 : $clog2(Slots)
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             come_i,    // work goes on from the stage that has the data
  input  logic             leave_i,   // the same work, Stages later
  input  logic [Width-1:0] data_i,
  output logic [Width-1:0] data_o
);
  if (Every == 1) begin : gen_wait
    rc_delay_ram #(.Width(Width), .Stages(Stages)) u_wait (
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
    localparam logic [IndexW-1:0] Last = IndexW'(Slots - 1);
    logic [IndexW-1:0] in_q, out_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni)      in_q <= '0;
      else if (come_i)  in_q <= in_q == Last ? '0 : in_q + 1'b1;
      if (!rst_ni)      out_q <= '0;
      else if (leave_i) out_q <= out_q == Last ? '0 : out_q + 1'b1;
    end
    if (InParts) begin : gen_parts
      logic [$clog2(Parts)-1:0] part_q;
      always_ff @(posedge clk_i) part_q <= rst_ni ? part_q + 1'b1 : '0;
      rc_ram_parts #(.Width(Width), .Depth(Slots), .Parts(Parts)) u_ram (
        .clk_i, .write_i(1'b1), .write_addr_i(in_q), .write_part_i(part_q), .write_data_i(data_i),
        .read_addr_i(out_q), .read_part_i(part_q), .read_data_o(data_o));
`ifndef SYNTHESIS
      logic [Width-1:0]         last_q;
      logic [$clog2(Parts)-1:0] still, still_q;   // cycles that they have stood still, at most
      assign still = data_i != last_q ? '0 : still_q == '1 ? '1 : still_q + 1'b1;
      always_ff @(posedge clk_i) begin
        last_q  <= data_i;
        still_q <= still;
      end
      always_ff @(posedge clk_i) if (rst_ni && come_i) a_still: assert (still == '1)
        else $error("rc_stage_delay: data have moved while their parts were written");
`endif
    end else if (Block) begin : gen_block
      (* no_rw_check, ram_style = "block" *) logic [Width-1:0] mem [Stages];
      logic [Width-1:0]  read_q;
      logic [IndexW-1:0] out_d;
      assign out_d  = !leave_i ? out_q : out_q == Last ? '0 : out_q + 1'b1;
      rc_path_register #(.Width(Width), .Stages(Parts > 1 ? 1 : 0)) u_read (
        .clk_i, .data_i(read_q), .data_o(data_o));
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
