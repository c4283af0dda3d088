// Memory that writes and reads an entry in Parts parts, one part per cycle. Wide data that stays
// stable for Parts cycles then needs few block RAMs.
//
// A write stores part write_part_i of write_data_i one cycle later. read_data_o shows each part as
// it was last read, two cycles after its address. The user must not read and write the same part of
// an entry in one cycle, as in rc_ram_sync.
//
// Neighbouring bits belong to different parts. So a block RAM holds bits that belong together, and
// can be placed next to the logic that uses them.
`default_nettype none
module rc_ram_parts #(
  parameter  int unsigned Width  = 4,
  parameter  int unsigned Depth  = 2,
  parameter  int unsigned Parts  = 2,
  localparam int unsigned IndexW = Depth < 2 ? 1 : $clog2(Depth),
  localparam int unsigned PartB  = $clog2(Parts)
) (
  input  logic              clk_i,
  // Write port
  input  logic              write_i,
  input  logic [IndexW-1:0] write_addr_i,
  input  logic [PartB-1:0]  write_part_i,
  input  logic [Width-1:0]  write_data_i,
  // Read port
  input  logic [IndexW-1:0] read_addr_i,
  input  logic [PartB-1:0]  read_part_i,
  output logic [Width-1:0]  read_data_o
);
  localparam int unsigned PartW = (Width + Parts - 1) / Parts;
  localparam int unsigned AddrW = IndexW + PartB;

  if (Width < Parts || Parts < 2 || Parts != 1 << PartB) begin : gen_refuse
    $error("rc_ram_parts: Parts must be a power of two, and Width no less");
  end
  // Yosys 0.23 infers block RAM only if the attribute requests it.
  (* no_rw_check, ram_style = "block" *) logic [PartW-1:0] mem [1 << AddrW];

  logic [Parts*PartW-1:0] whole, held;
  logic [PartW-1:0]       part;
  logic                   write_q;
  logic [AddrW-1:0]       at_q;
  logic [PartW-1:0]       part_q, read_q;
  logic [PartB-1:0]       read_part_q;   // the part that read_q holds

  assign whole = (Parts * PartW)'(write_data_i);

  // Part to write. A variable index would become a shifter in Yosys 0.23.
  always_comb begin
    part = '0;
    for (int i = 0; i < PartW; i++)
      for (int p = 0; p < Parts; p++)
        if (write_part_i == PartB'(p)) part[i] = whole[i*Parts + p];
  end

  // Parts that were read: bit i of part p is bit i * Parts + p of the entry.
  for (genvar p = 0; p < Parts; p++) begin : gen_part
    logic [PartW-1:0] held_q;
    always_ff @(posedge clk_i) if (read_part_q == PartB'(p)) held_q <= read_q;
    for (genvar i = 0; i < PartW; i++) begin : gen_bit
      assign held[i*Parts + p] = held_q[i];
    end
  end

  // Memory.
  always_ff @(posedge clk_i) begin
    write_q     <= write_i;
    at_q        <= {write_addr_i, write_part_i};
    part_q      <= part;
    read_part_q <= read_part_i;
    read_q      <= mem[{read_addr_i, read_part_i}];
    if (write_q) mem[at_q] <= part_q;
  end

  assign read_data_o = held[Width-1:0];

  logic unused;
  assign unused = ^held;
endmodule
`default_nettype wire
