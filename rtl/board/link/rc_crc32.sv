// CRC-32 of IEEE 802.3 (polynomial 0x04c11db7, reflected), one byte per cycle.
//
// crc_o is the checksum of the bytes since clear_i, valid one cycle after the last of them.
// sound_o is high if the last four bytes were the checksum of the bytes before them, the low byte
// first: the register then holds the residue of the code. The host computes the same with zlib's
// crc32().
`default_nettype none
module rc_crc32 (
  input  logic        clk_i,
  input  logic        clear_i,   // forget all bytes; wins over valid_i
  input  logic        valid_i,
  input  logic [7:0]  byte_i,
  output logic [31:0] crc_o,
  output logic        sound_o
);
  localparam logic [31:0] Polynomial = 32'hedb88320;   // reflected: bit 0 is the highest power
  localparam logic [31:0] Residue    = 32'hdebb20e3;

  logic [31:0] crc_q, crc_d;

  always_comb begin
    crc_d = crc_q ^ {24'd0, byte_i};
    for (int i = 0; i < 8; i++) crc_d = {1'b0, crc_d[31:1]} ^ (crc_d[0] ? Polynomial : 32'd0);
  end

  always_ff @(posedge clk_i) begin
    if (clear_i)      crc_q <= {32{1'b1}};
    else if (valid_i) crc_q <= crc_d;
  end

  assign crc_o   = ~crc_q;
  assign sound_o = crc_q == Residue;
endmodule
`default_nettype wire
