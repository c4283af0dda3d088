// Memory that writes and reads an entry in parts, one in a cycle: few block RAMs hold wide data if
// these stand still for as many cycles. Of write_data_i the part that is named is written in the
// cycle after. Every part of read_data_o is what was read for it last, and is there two cycles
// after it was named. Reading and writing one part of an entry at once is the user's error, as with
// rc_ram_sync. Bits that lie side by side are of different parts, so that a block RAM holds what
// belongs together, and can lie beside it.
`default_nettype none
module rc_ram_parts #(
  parameter  int unsigned Width  = 4,
  parameter  int unsigned Depth  = 2,
  parameter  int unsigned Parts  = 2,
  localparam int unsigned IndexW = Depth < 2 ? 1 : $clog2(Depth),
  localparam int unsigned PartB  = $clog2(Parts)
) (
  input  logic              clk_i,
  input  logic              write_i,
  input  logic [IndexW-1:0] write_addr_i,
  input  logic [PartB-1:0]  write_part_i,
  input  logic [Width-1:0]  write_data_i,
  input  logic [IndexW-1:0] read_addr_i,
  input  logic [PartB-1:0]  read_part_i,
  output logic [Width-1:0]  read_data_o
);
  localparam int unsigned PartW = (Width + Parts - 1) / Parts;
  localparam int unsigned AddrW = IndexW + PartB;
  if (Width < Parts || Parts < 2 || Parts != 1 << PartB) begin : gen_refuse
    $error("rc_ram_parts: Parts must be a power of two, and Width no less");
  end
  // Yosys 0.23 does not choose block RAM by itself.
  (* no_rw_check, ram_style = "block" *) logic [PartW-1:0] mem [1 << AddrW];
  logic [Parts*PartW-1:0] whole, kept;
  logic [PartW-1:0]       part;
  logic                   write_q;
  logic [AddrW-1:0]       at_q;
  logic [PartW-1:0]       part_q, read_q;
  logic [PartB-1:0]       came_q;   // the part that read_q is
  assign whole = (Parts * PartW)'(write_data_i);
  always_comb begin   // without an index that varies, of which Yosys 0.23 would make a shifter
    part = '0;
    for (int i = 0; i < PartW; i++)
      for (int p = 0; p < Parts; p++)
        if (write_part_i == PartB'(p)) part[i] = whole[i*Parts + p];
  end
  for (genvar p = 0; p < Parts; p++) begin : gen_part
    logic [PartW-1:0] kept_q;
    always_ff @(posedge clk_i) if (came_q == PartB'(p)) kept_q <= read_q;
    for (genvar i = 0; i < PartW; i++) begin : gen_bit
      assign kept[i*Parts + p] = kept_q[i];
    end
  end
  always_ff @(posedge clk_i) begin
    write_q <= write_i;
    at_q    <= {write_addr_i, write_part_i};
    part_q  <= part;
    came_q  <= read_part_i;
    read_q  <= mem[{read_addr_i, read_part_i}];
    if (write_q) mem[at_q] <= part_q;
  end
  assign read_data_o = kept[Width-1:0];
  logic unused;
  assign unused = ^kept;
endmodule
`default_nettype wire
