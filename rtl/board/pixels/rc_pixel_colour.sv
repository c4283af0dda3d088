// Converts finished pixels to 8 bits per channel, for the screen.
//
// A chip that shades gives linear colours with UnitBits of fraction. Their sRGB bytes equal the
// bytes that the host writes to a PNG (sim/files/image/srgb.hpp): a byte is the number of entries
// of `Thresholds` that do not exceed the channel. Eight stages find it by binary search. The three
// channels enter one after the other, so the module accepts a pixel every three cycles. A pixel
// can leave Stages + 3 = 11 cycles after it was accepted.
//
// A chip that does not shade gives hits. The screen shows the number of the primitive, plus 1, as
// a colour. Bits 0, 3, 6, ... of the number become red, bits 1, 4, 7, ... green, and bits 2, 5, 8,
// ... blue; the lowest of them becomes a channel's highest bit. This is the colour map of labels
// in the PASCAL VOC development kit. A pixel without a hit is black. The module then accepts a
// pixel in every cycle, and the pixel can leave in the next one.
//
// Model: model/board/pixel_colour.hpp.
`default_nettype none
module rc_pixel_colour (
  input  logic                           clk_i,
  input  logic                           rst_ni,
  // From the chip
  input  logic                           hit_valid_i,
  output logic                           hit_ready_o,
  input  rc_pkg::hit_t                   hit_i,
  // To the pixel writer
  output logic                           pixel_valid_o,
  input  logic                           pixel_ready_i,
  output logic [rc_pkg::PixelBits-1:0]   x_o,
  output logic [rc_pkg::PixelBits-1:0]   y_o,
  output logic [23:0]                    colour_o,   // red in the lowest byte, blue in the highest
  // Status
  output logic                           empty_o     // no pixel is inside
);
  localparam int unsigned PlaceW = 2 * rc_pkg::PixelBits;
  localparam int unsigned Pixels = 4;   // in the module at the same time

  logic              fires, leaves, is_open;
  logic [PlaceW-1:0] place;
  logic              colour_valid;
  logic [23:0]       colour;

  assign fires  = hit_valid_i && hit_ready_o;
  assign leaves = pixel_valid_o && pixel_ready_i;

  rc_credit_counter #(.Credits(Pixels)) u_credits (
    .clk_i, .rst_ni, .admit_i(fires), .leave_i(leaves), .open_o(is_open));

  // The pixels' places, and their colours once they are known, both in order.
  logic place_valid, place_ready, colour_ready;

  rc_fifo #(.Width(PlaceW), .Depth(Pixels)) u_places (
    .clk_i, .rst_ni, .valid_i(fires), .ready_o(place_ready), .data_i({hit_i.y, hit_i.x}),
    .valid_o(place_valid), .ready_i(leaves), .data_o(place));
  rc_fifo #(.Width(24), .Depth(Pixels)) u_colours (
    .clk_i, .rst_ni, .valid_i(colour_valid), .ready_o(colour_ready), .data_i(colour),
    .valid_o(pixel_valid_o), .ready_i(leaves), .data_o(colour_o));

  assign {y_o, x_o} = place;
  assign empty_o    = !place_valid;

  if (rc_pkg::Shading) begin : gen_shaded
    localparam int unsigned Stages = 8;
    localparam int unsigned ValueW = rc_pkg::UnitBits + 1;
    localparam int unsigned Bytes  = 255;
    // Entry b is the least value whose byte is greater than b; the last entry comes first.
    localparam logic [Bytes*ValueW-1:0] Thresholds = {
    17'd65245, 17'd64663, 17'd64084, 17'd63509, 17'd62936, 17'd62367, 17'd61800, 17'd61237,
    17'd60676, 17'd60119, 17'd59564, 17'd59013, 17'd58465, 17'd57919, 17'd57377, 17'd56837,
    17'd56300, 17'd55767, 17'd55236, 17'd54709, 17'd54184, 17'd53662, 17'd53143, 17'd52627,
    17'd52114, 17'd51604, 17'd51097, 17'd50593, 17'd50092, 17'd49593, 17'd49098, 17'd48605,
    17'd48116, 17'd47629, 17'd47145, 17'd46664, 17'd46186, 17'd45711, 17'd45238, 17'd44769,
    17'd44302, 17'd43838, 17'd43377, 17'd42919, 17'd42464, 17'd42011, 17'd41562, 17'd41115,
    17'd40671, 17'd40229, 17'd39791, 17'd39355, 17'd38923, 17'd38493, 17'd38065, 17'd37641,
    17'd37219, 17'd36800, 17'd36384, 17'd35971, 17'd35560, 17'd35152, 17'd34747, 17'd34345,
    17'd33945, 17'd33548, 17'd33154, 17'd32762, 17'd32373, 17'd31987, 17'd31604, 17'd31223,
    17'd30845, 17'd30470, 17'd30097, 17'd29727, 17'd29360, 17'd28995, 17'd28633, 17'd28274,
    17'd27917, 17'd27563, 17'd27212, 17'd26863, 17'd26517, 17'd26173, 17'd25832, 17'd25494,
    17'd25158, 17'd24825, 17'd24494, 17'd24166, 17'd23841, 17'd23518, 17'd23198, 17'd22880,
    17'd22565, 17'd22252, 17'd21942, 17'd21635, 17'd21330, 17'd21027, 17'd20727, 17'd20430,
    17'd20135, 17'd19842, 17'd19552, 17'd19265, 17'd18980, 17'd18697, 17'd18417, 17'd18140,
    17'd17864, 17'd17592, 17'd17322, 17'd17054, 17'd16788, 17'd16525, 17'd16265, 17'd16007,
    17'd15751, 17'd15498, 17'd15247, 17'd14998, 17'd14752, 17'd14508, 17'd14267, 17'd14028,
    17'd13791, 17'd13557, 17'd13325, 17'd13095, 17'd12868, 17'd12643, 17'd12420, 17'd12200,
    17'd11981, 17'd11766, 17'd11552, 17'd11341, 17'd11132, 17'd10925, 17'd10721, 17'd10518,
    17'd10318, 17'd10121, 17'd9925, 17'd9732, 17'd9541, 17'd9352, 17'd9165, 17'd8981,
    17'd8798, 17'd8618, 17'd8440, 17'd8265, 17'd8091, 17'd7920, 17'd7750, 17'd7583,
    17'd7418, 17'd7255, 17'd7094, 17'd6935, 17'd6779, 17'd6624, 17'd6471, 17'd6321,
    17'd6173, 17'd6026, 17'd5882, 17'd5740, 17'd5600, 17'd5461, 17'd5325, 17'd5191,
    17'd5059, 17'd4929, 17'd4800, 17'd4674, 17'd4550, 17'd4427, 17'd4307, 17'd4188,
    17'd4072, 17'd3957, 17'd3844, 17'd3734, 17'd3625, 17'd3518, 17'd3412, 17'd3309,
    17'd3208, 17'd3108, 17'd3010, 17'd2914, 17'd2820, 17'd2727, 17'd2637, 17'd2548,
    17'd2461, 17'd2376, 17'd2292, 17'd2210, 17'd2130, 17'd2052, 17'd1975, 17'd1900,
    17'd1827, 17'd1755, 17'd1685, 17'd1617, 17'd1551, 17'd1486, 17'd1422, 17'd1360,
    17'd1300, 17'd1242, 17'd1185, 17'd1129, 17'd1075, 17'd1023, 17'd972, 17'd923,
    17'd875, 17'd828, 17'd783, 17'd740, 17'd698, 17'd657, 17'd618, 17'd580,
    17'd544, 17'd509, 17'd475, 17'd443, 17'd412, 17'd382, 17'd354, 17'd327,
    17'd301, 17'd276, 17'd253, 17'd230, 17'd209, 17'd189, 17'd170, 17'd150,
    17'd130, 17'd110, 17'd90, 17'd70, 17'd50, 17'd30, 17'd10};

    if (rc_pkg::UnitBits != 16) begin : gen_refuse
      $error("rc_pixel_colour: the thresholds need 16 bits of fraction");
    end

    // ---- The pixel that enters: its channels, from the next one on, and how many are left.
    logic [2*ValueW-1:0] rest_q;
    logic [1:0]          left_q;
    logic                enters;
    logic [3*ValueW-1:0] channels;   // the last member of a shaded hit

    assign channels    = hit_i[3*ValueW-1:0];
    assign hit_ready_o = is_open && left_q == 2'd0;
    assign enters      = fires || left_q != 2'd0;

    always_ff @(posedge clk_i) begin
      if (!rst_ni)              left_q <= '0;
      else if (fires)           left_q <= 2'd2;
      else if (left_q != 2'd0)  left_q <= left_q - 2'd1;

      rest_q <= fires ? channels[3*ValueW-1:ValueW] : {ValueW'(0), rest_q[2*ValueW-1:ValueW]};
    end

    // ---- Binary search: stage s has found the s highest bits of the byte.
    logic [Stages:0]   valid;
    logic [Stages:0]   is_last;             // the channel is blue
    logic [(Stages+1)*ValueW-1:0] value;
    logic [(Stages+1)*Stages-1:0] found;  // bits that are not yet found are 0

    assign valid[0]   = enters;
    assign is_last[0] = left_q == 2'd1;
    assign value[ValueW-1:0] = fires ? channels[ValueW-1:0] : rest_q[ValueW-1:0];
    assign found[Stages-1:0] = '0;

    for (genvar s = 0; s < Stages; s++) begin : gen_stage
      localparam int unsigned Step = 1 << (Stages - 1 - s);   // weight of the stage's bit
      logic [ValueW-1:0] threshold;
      logic              valid_q, is_last_q;
      logic [ValueW-1:0] value_q;
      logic [Stages-1:0] found_q;

      always_comb begin
        threshold = '0;
        for (int b = 0; b < Bytes; b += 2 * Step)
          if (found[s*Stages +: Stages] == Stages'(b))
            threshold = Thresholds[(b+Step-1)*ValueW +: ValueW];
      end

      always_ff @(posedge clk_i) begin
        if (!rst_ni) valid_q <= 1'b0;
        else         valid_q <= valid[s];
        is_last_q <= is_last[s];
        value_q   <= value[s*ValueW +: ValueW];
        found_q   <= found[s*Stages +: Stages]
                   | (value[s*ValueW +: ValueW] >= threshold ? Stages'(Step) : Stages'(0));
      end

      assign valid[s+1]   = valid_q;
      assign is_last[s+1] = is_last_q;
      assign value[(s+1)*ValueW +: ValueW] = value_q;
      assign found[(s+1)*Stages +: Stages] = found_q;
    end

    // ---- Red and green wait for blue.
    logic [15:0] bytes_q;

    always_ff @(posedge clk_i)
      if (valid[Stages]) bytes_q <= {found[Stages*Stages +: Stages], bytes_q[15:8]};

    assign colour_valid = valid[Stages] && is_last[Stages];
    assign colour       = {found[Stages*Stages +: Stages], bytes_q};

    logic unused;
    assign unused = ^{value[Stages*ValueW +: ValueW], hit_i};
  end else begin : gen_labels
    logic [31:0] label;

    assign hit_ready_o  = is_open;
    assign colour_valid = fires;
    assign label        = hit_i.prim + 32'd1;

    for (genvar i = 0; i < 8; i++) begin : gen_bit
      assign colour[7-i]  = hit_i.found && label[3*i];
      assign colour[15-i] = hit_i.found && label[3*i+1];
      assign colour[23-i] = hit_i.found && label[3*i+2];
    end

    logic unused;
    assign unused = ^{label[31:24], hit_i};
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni && fires) a_place_fits: assert (place_ready)
    else $error("rc_pixel_colour: no room for a place");
  always_ff @(posedge clk_i) if (rst_ni && colour_valid) a_colour_fits: assert (colour_ready)
    else $error("rc_pixel_colour: no room for a colour");
  always_ff @(posedge clk_i) if (rst_ni && pixel_valid_o) a_has_place: assert (place_valid)
    else $error("rc_pixel_colour: a colour without a place");
`endif

  logic unused_ready;
  assign unused_ready = ^{place_ready, colour_ready};
endmodule
`default_nettype wire
