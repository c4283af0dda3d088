// Gathers items into lines of Records items, item 0 lowest.
//
// It accepts one item per cycle. A line is offered in the cycle after its last item. While a line
// is on offer, no item is accepted. start_i begins a sequence of total_i items, whose last line
// may be partly empty: unused places are 0. start_i may be set only when no item is in the line,
// and at most total_i items may be offered. While no line is offered, line_o shows the items so
// far. Proof: tests/formal/gather.sv.
`default_nettype none
module rc_gather #(
  parameter int unsigned Records   = 4,
  parameter int unsigned Width     = 1,
  parameter int unsigned TotalBits = 1
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic                     start_i,
  input  logic [TotalBits-1:0]     total_i,
  // Items
  input  logic                     valid_i,
  output logic                     ready_o,
  input  logic [Width-1:0]         data_i,
  // Lines
  output logic                     line_valid_o,
  input  logic                     line_ready_i,
  output logic [Records*Width-1:0] line_o,
  output logic [Records-1:0]       accepted_o   // one bit for each item, when a line is accepted
);
  localparam int unsigned CountW = $clog2(Records + 1);

  logic                 full_q;    // the line is on offer
  logic [CountW-1:0]    count_q;   // items in the line
  logic [TotalBits-1:0] left_q;    // items that have not come
  logic                 fires, empties;

  assign ready_o      = !full_q;
  assign line_valid_o = full_q;
  assign fires        = valid_i && ready_o;
  assign empties      = start_i || (full_q && line_ready_i);

  always_ff @(posedge clk_i) begin
    if (!rst_ni || empties) full_q <= 1'b0;
    else if (fires)         full_q <= count_q == CountW'(Records - 1) || left_q == TotalBits'(1);
    if (empties)            count_q <= '0;
    else if (fires)         count_q <= count_q + 1'b1;
    if (start_i)            left_q <= total_i;
    else if (fires)         left_q <= left_q - 1'b1;
  end

  for (genvar k = 0; k < Records; k++) begin : gen_item
    logic [Width-1:0] item_q;

    always_ff @(posedge clk_i) begin
      if (empties)                               item_q <= '0;
      else if (fires && count_q == CountW'(k)) item_q <= data_i;
    end
    assign line_o[k*Width +: Width] = item_q;
    assign accepted_o[k]            = full_q && line_ready_i && count_q > CountW'(k);
  end
endmodule
`default_nettype wire
