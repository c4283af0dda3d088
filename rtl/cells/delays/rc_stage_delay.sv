// Delays data to match a pipeline in which each piece of work stays Every cycles in each stage, for
// Stages stages. data_o holds what came with enter_i until leave_i: then the same work enters the
// stage that needs it. If Every is 1, this is rc_delay_ram.
//
// The data lies in a ring of LUT RAM. It lies in block RAM if work stays long and a cell of LUT RAM
// (16 words) cannot hold the ring. Block RAM reads the next entry in the cycle in which work
// leaves. So the entry is ready in the next cycle, as with LUT RAM.
//
// With Parts above 1, data wider than a block RAM lies in a block RAM of a part's width
// (rc_ram_parts). It is written in the last Parts cycles up to the cycle of enter_i; data_i must
// stay stable in these cycles. The next entry is in registers Parts + 2 cycles after work leaves.
// Narrower data in block RAM reaches its register one cycle later than with Parts 1.
`default_nettype none
module rc_stage_delay #(
  parameter  int unsigned Width   = 1,
  parameter  int unsigned Stages  = 2,
  parameter  int unsigned Every   = rc_pkg::ShadeInterval,
  parameter  int unsigned Parts   = 1,
  localparam bit          Block   = Every >= 4 && Stages > 16 && Width > 16,
  localparam bit          InParts = Block && Parts > 1 && Width > 36,   // of a block RAM
  localparam int unsigned Slots   = InParts ? Stages + 1 : Stages,   // one slot is being written
  localparam int unsigned IndexW  = Slots < 2 ? 1 : $clog2(Slots)
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             enter_i,   // work leaves the stage that has the data
  input  logic             leave_i,   // the same work, Stages stages later
  input  logic [Width-1:0] data_i,
  output logic [Width-1:0] data_o
);
  if (Every == 1) begin : gen_wait
    rc_delay_ram #(.Width(Width), .Stages(Stages)) u_wait (
      .clk_i, .rst_ni, .valid_i(enter_i), .data_i, .data_o);

    logic unused;
    assign unused = leave_i;
  end else if (Stages == 1) begin : gen_register
    logic [Width-1:0] data_q;
    assign data_o = data_q;
    always_ff @(posedge clk_i) if (enter_i) data_q <= data_i;

    logic unused;
    assign unused = ^{rst_ni, leave_i};
  end else begin : gen_ring   // holds at most Stages pieces of work
    localparam logic [IndexW-1:0] Last = IndexW'(Slots - 1);
    logic [IndexW-1:0] in_q, out_q;

    // Write and read index of the ring.
    always_ff @(posedge clk_i) begin
      if (!rst_ni)      in_q <= '0;
      else if (enter_i)  in_q <= in_q == Last ? '0 : in_q + 1'b1;
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
      logic [$clog2(Parts)-1:0] still, still_q;   // cycles for which data_i was stable, saturated
      assign still = data_i != last_q ? '0 : still_q == '1 ? '1 : still_q + 1'b1;
      always_ff @(posedge clk_i) begin
        last_q  <= data_i;
        still_q <= still;
      end
      always_ff @(posedge clk_i) if (rst_ni && enter_i) a_still: assert (still == '1)
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
        if (enter_i) mem[in_q] <= data_i;
        if (!enter_i || in_q != out_d) read_q <= mem[out_d];
      end
    end else begin : gen_luts
      rc_ram #(.Width(Width), .Depth(Stages)) u_ram (
        .clk_i, .write_i(enter_i), .write_addr_i(in_q), .write_data_i(data_i), .read_addr_i(out_q),
        .read_data_o(data_o));
    end
  end
endmodule
`default_nettype wire
