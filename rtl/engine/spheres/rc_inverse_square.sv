// K, a power of two over the square of a direction: 2^(49 + n) / |e|^2, rounded down. n, in 0..3,
// is the number of bits that the square has above 33. K comes from a table with linear
// interpolation.
//
// Part of rc_globe_moment. K comes 1 + MulStages + 2 Cut stages later; n comes in the same cycle
// as the square. Model: inverse_of() in model/engine/spheres/globe.cpp.
`default_nettype none
module rc_inverse_square #(
  localparam int unsigned TowardBits = rc_pkg::TowardBits
) (
  input  logic                    clk_i,
  input  logic                    last_enable_i,   // the last stage accepts its input
  input  logic [2*TowardBits-1:0] square_i,
  output logic [1:0]              n_o,
  output logic [16:0]             inverse_o
);
  localparam int unsigned Entries = 128;
  localparam int unsigned StepW   = 10;
  localparam int unsigned EntryW  = 17 + StepW;

  // n, and the 16 bits of the square below its highest bit.
  logic [15:0] z, z_q;

  always_comb begin
    n_o = 2'd0;
    if (square_i[33]) n_o = 2'd1;
    if (square_i[34]) n_o = 2'd2;
    if (square_i[35]) n_o = 2'd3;
    z = square_i[16 +: 16];
    if (n_o == 2'd1) z = square_i[17 +: 16];
    if (n_o == 2'd2) z = square_i[18 +: 16];
    if (n_o == 2'd3) z = square_i[19 +: 16];
  end
  rc_path_register #(.Width(16)) u_z (.clk_i, .data_i(z), .data_o(z_q));

  // Table entry and interpolation.
  logic [EntryW-1:0] inverse_mem [Entries];

  initial for (int i = 0; i < Entries; i++)
    inverse_mem[i] = rc_pkg::NearInverse[i*EntryW +: EntryW];

  logic [EntryW-1:0]  entry, entry_q;
  logic [8:0]         rest;
  logic [16:0]        value;
  logic [StepW+9-1:0] less;

  assign entry = inverse_mem[z_q[15:9]];
  rc_path_register #(.Width(EntryW)) u_entry (.clk_i, .data_i(entry), .data_o(entry_q));
  rc_path_register #(.Width(9)) u_rest (.clk_i, .data_i(z_q[8:0]), .data_o(rest));

  rc_mul #(.AW(StepW), .BW(9), .Signed(1'b0)) u_less (
    .clk_i, .a_i(entry_q[StepW-1:0]), .b_i(rest), .p_o(less));

  rc_path_register #(.Width(17), .Stages(rc_pkg::MulStages)) u_value (
    .clk_i, .data_i(entry_q[StepW +: 17]), .data_o(value));

  always_ff @(posedge clk_i) if (last_enable_i) inverse_o <= value - 17'(less[StepW+8:9]);

  logic unused;
  assign unused = ^{less[8:0], square_i[15:0]};
endmodule
`default_nettype wire
