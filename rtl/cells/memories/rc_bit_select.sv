// Selects one of Flags flags by its index. Latency Cut: in the same cycle, or one cycle later.
//
// With Cut each group of eight flags selects its bit into a register, and the next cycle selects
// the group. Selecting one of 64 flags in one cycle takes five levels of LUTs and long wires.
`default_nettype none
module rc_bit_select #(
  parameter  int unsigned Flags  = 2,
  parameter  int unsigned Cut    = rc_pkg::PathCut,
  localparam int unsigned IndexW = Flags < 2 ? 1 : $clog2(Flags)
) (
  input  logic              clk_i,
  input  logic [Flags-1:0]  flags_i,
  input  logic [IndexW-1:0] index_i,
  output logic              flag_o
);
  if (Flags < 1) begin : gen_refuse
    $error("rc_bit_select: Flags must be at least 1");
  end

  if (Cut == 0) begin : gen_now
    assign flag_o = flags_i[index_i];

    logic unused;
    assign unused = clk_i;
  end else begin : gen_later
    localparam int unsigned Parts = (Flags + 7) / 8;
    localparam int unsigned PartW = Parts < 2 ? 1 : $clog2(Parts);

    logic [8*Parts-1:0]    all;
    logic [IndexW+PartW+2:0] index;
    logic [Parts-1:0]      part_q;
    logic [PartW-1:0]      which_q;

    assign all   = {{(8*Parts-Flags){1'b0}}, flags_i};
    assign index = {{(PartW+3){1'b0}}, index_i};

    // First cycle: one flag of each group of eight.
    for (genvar p = 0; p < Parts; p++) begin : gen_part
      logic [7:0] part;
      assign part = all[8*p +: 8];
      always_ff @(posedge clk_i) part_q[p] <= part[index[2:0]];
    end

    // Second cycle: the group.
    always_ff @(posedge clk_i) which_q <= index[3 +: PartW];
    assign flag_o = part_q[which_q];

    logic unused;
    assign unused = ^index;
  end
endmodule
`default_nettype wire
