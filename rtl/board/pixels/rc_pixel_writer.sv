// Pixel writer: gathers finished pixels, which come in any order, into blocks of 4x4 pixels and
// writes the blocks to memory. A block is a line of 64 bytes. Word 4 * (y % 4) + x % 4 holds a
// pixel: red in byte 0, green in byte 1, blue in byte 2 and 0 in byte 3. Block (x / 4, y / 4) is
// line base_i + (y / 4) * ceil(width_i / 4) + x / 4.
//
// Four buffers hold a block each. A pixel enters the buffer of its block, or a free one. Buffers
// are written one at a time. The oldest full buffer goes first. If none is full, the oldest buffer
// is written in two cases: a pixel needs a buffer and none is free, or flush_i is high. Words
// without a pixel are masked. A pixel enters every other cycle, until it needs a buffer that is not
// free. A write takes four cycles, the time until the request is accepted, and its 32 beats. This
// is longer than 16 pixels need to enter.
//
// base_i and width_i may change only while empty_o is high. Raise flush_i after the last pixel:
// each pixel that comes while it is high may cost a write of its own. empty_o is high when no
// pixel is inside, so the last beat of the last write has been taken.
// Model: model/board/pixel_writer.hpp (PixelWriter).
`default_nettype none
module rc_pixel_writer #(
  parameter int unsigned LineW = 20,         // bits of a line number
  parameter int unsigned SideW = 10          // bits of a coordinate
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  // Picture
  input  logic [LineW-1:0] base_i,
  input  logic [SideW:0]   width_i,
  input  logic             flush_i,
  output logic             empty_o,
  // Finished pixels
  input  logic             pixel_valid_i,
  output logic             pixel_ready_o,
  input  logic [SideW-1:0] pixel_x_i,
  input  logic [SideW-1:0] pixel_y_i,
  input  logic [23:0]      pixel_colour_i,   // red in bits 7:0, green in 15:8, blue in 23:16
  // To the memory: a line, then 32 beats of 16 bits, low byte first
  output logic             req_valid_o,
  input  logic             req_ready_i,
  output logic [LineW-1:0] req_addr_o,
  input  logic             next_i,           // the beat is taken at the end of this cycle
  output logic [15:0]      data_o,
  output logic [1:0]       mask_o            // 1: the byte is not written
);
  localparam int unsigned Buffers = 4;
  localparam int unsigned BlockW  = SideW - 2;   // bits of a block's coordinate
  localparam int unsigned PixelW  = 2 * SideW + 24;

  if (SideW < 3 || SideW > 16 || LineW < 2) begin : gen_refuse
    $error("rc_pixel_writer: SideW must be from 3 to 16, and LineW at least 2");
  end

  // ---- Input queue: pixel_ready_o depends on registers only.
  logic             head_valid, head_fires;
  logic [SideW-1:0] head_x, head_y;
  logic [23:0]      head_colour;

  rc_fifo #(.Width(PixelW), .Depth(2), .Cut(1)) u_input (
    .clk_i, .rst_ni,
    .valid_i(pixel_valid_i), .ready_o(pixel_ready_o),
    .data_i({pixel_x_i, pixel_y_i, pixel_colour_i}),
    .valid_o(head_valid), .ready_i(head_fires), .data_o({head_x, head_y, head_colour}));

  // ---- Buffers: used, and open for pixels of their block. older_q[4 * i + j]: i is older than j.
  logic [Buffers-1:0]         used_q, open_q, same, lowest_free, found, full;
  logic [Buffers*Buffers-1:0] older_q;
  logic [16*Buffers-1:0]      there_q;                // words with a pixel
  logic [BlockW*Buffers-1:0]  block_x_q, block_y_q;
  logic [1:0]                 entered_index;
  logic [3:0]                 head_word;

  // A cycle finds the buffer of the head, the next lets it enter.
  logic               head_pending, enters_q, begins_q;
  logic [Buffers-1:0] found_q;

  assign head_word    = {head_y[1:0], head_x[1:0]};
  assign lowest_free  = ~used_q & (used_q + 1'b1);
  assign found        = same != '0 ? same : lowest_free;
  assign head_pending = head_valid && !enters_q;
  assign head_fires   = enters_q;

  always_ff @(posedge clk_i) begin
    enters_q <= rst_ni && head_pending && found != '0;
    found_q  <= found;
    begins_q <= same == '0;
  end

  for (genvar i = 0; i < Buffers; i++) begin : gen_match
    assign same[i] = open_q[i] && block_x_q[BlockW*i +: BlockW] == head_x[SideW-1:2]
                     && block_y_q[BlockW*i +: BlockW] == head_y[SideW-1:2];
    assign full[i]    = open_q[i] && there_q[16*i +: 16] == '1;
  end

  always_comb begin
    entered_index = '0;
    for (int i = 0; i < Buffers; i++) if (found_q[i]) entered_index = 2'(i);
  end

  // ---- The buffer to write next: the oldest of the full ones, or of all. Its inputs are
  // registers: a buffer has been full, and a pixel has waited, for a cycle.
  typedef enum logic [2:0] {StIdle, StRead, StMultiply, StAdd, StRequest, StBeats} state_e;
  state_e             state_q;
  logic [Buffers-1:0] full_q, candidates, oldest;
  logic               waits_q;

  always_ff @(posedge clk_i) begin
    full_q  <= full;
    // While no write is under way, no buffer becomes free.
    waits_q <= head_pending && found == '0 && state_q == StIdle;
  end

  always_comb begin
    candidates = '0;
    if ((full_q & open_q) != '0) candidates = full_q & open_q;
    else if (waits_q || flush_i) candidates = open_q;
    for (int i = 0; i < Buffers; i++) begin
      oldest[i] = candidates[i];
      for (int j = 0; j < Buffers; j++)
        if (candidates[j] && older_q[Buffers*j+i]) oldest[i] = 1'b0;
    end
  end

  // ---- Writing: choose a buffer, read its block, multiply, add, request, 32 beats.
  logic [1:0]         sent_q;            // the buffer that is written
  logic [BlockW-1:0]  sent_x_q, sent_y_q;
  logic [15:0]        sent_there_q;
  logic [SideW-2:0]   stride_q;          // blocks in a row of the picture
  logic [LineW-1:0]   product_q, addr_q;
  logic [4:0]         beat_q;            // of the beat after the one in data_q
  logic               req_valid_q, ends, loads, chooses;
  logic [23:0]        word;
  logic [15:0]        data_q;
  logic [1:0]         mask_q;

  // A buffer that the head may have found does not close before the head has entered it.
  assign chooses = state_q == StIdle && oldest != '0 && (!head_pending || waits_q);
  assign loads   = state_q == StAdd || next_i;
  assign ends    = state_q == StBeats && next_i && beat_q == '0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q     <= StIdle;
      req_valid_q <= 1'b0;
    end else begin
      case (state_q)
        StIdle:     if (chooses) state_q <= StRead;
        StRead:     state_q <= StMultiply;
        StMultiply: state_q <= StAdd;
        StAdd:      state_q <= StRequest;
        StRequest:  if (req_ready_i) state_q <= StBeats;
        default:    if (ends) state_q <= StIdle;
      endcase
      req_valid_q <= state_q == StAdd || (req_valid_q && !req_ready_i);
    end

    if (state_q == StIdle)
      for (int i = 0; i < Buffers; i++) if (oldest[i]) sent_q <= 2'(i);
    sent_x_q     <= block_x_q[BlockW*sent_q +: BlockW];
    sent_y_q     <= block_y_q[BlockW*sent_q +: BlockW];
    sent_there_q <= there_q[16*sent_q +: 16];
    stride_q     <= (SideW-1)'(({1'b0, width_i} + (SideW+2)'(3)) >> 2);
    product_q    <= LineW'(sent_y_q) * LineW'(stride_q);
    if (state_q == StAdd) addr_q <= base_i + product_q + LineW'(sent_x_q);

    // Beats: the next one is read while data_q holds the current one.
    if (state_q == StIdle) beat_q <= '0;
    else if (loads)        beat_q <= beat_q + 1'b1;
    if (loads) begin
      data_q <= beat_q[0] ? {8'd0, word[23:16]} : word[15:0];
      mask_q <= {2{!sent_there_q[beat_q[4:1]]}};
    end
  end

  assign req_valid_o = req_valid_q;
  assign req_addr_o  = addr_q;
  assign data_o      = data_q;
  assign mask_o      = mask_q;

  rc_ram #(.Width(24), .Depth(16 * Buffers)) u_words (
    .clk_i,
    .write_i(head_fires), .write_addr_i({entered_index, head_word}), .write_data_i(head_colour),
    .read_addr_i({sent_q, beat_q[4:1]}), .read_data_o(word));

  // ---- State of the buffers.
  for (genvar i = 0; i < Buffers; i++) begin : gen_buffer
    logic enters, begins;
    assign enters = enters_q && found_q[i];
    assign begins = enters && begins_q;

    always_ff @(posedge clk_i) begin
      if (!rst_ni) begin
        used_q[i] <= 1'b0;
        open_q[i] <= 1'b0;
      end else begin
        if (begins)                         used_q[i] <= 1'b1;
        else if (ends && sent_q == 2'(i))   used_q[i] <= 1'b0;
        if (begins)                         open_q[i] <= 1'b1;
        else if (chooses && oldest[i])      open_q[i] <= 1'b0;
      end
      if (begins) begin
        block_x_q[BlockW*i +: BlockW] <= head_x[SideW-1:2];
        block_y_q[BlockW*i +: BlockW] <= head_y[SideW-1:2];
      end
      if (enters)
        there_q[16*i +: 16] <= (begins ? 16'd0 : there_q[16*i +: 16]) | (16'd1 << head_word);
    end

    // A new block is younger than all others.
    for (genvar j = 0; j < Buffers; j++) begin : gen_older
      logic other_begins;
      assign other_begins = enters_q && found_q[j] && begins_q;
      always_ff @(posedge clk_i) begin
        if (begins)            older_q[Buffers*i+j] <= 1'b0;
        else if (other_begins) older_q[Buffers*i+j] <= i != j;
      end
    end
  end

  // A queued pixel keeps the writer from being empty.
  assign empty_o = !head_valid && used_q == '0;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i)
    if (rst_ni && next_i) a_beat_of_a_write: assert (state_q == StBeats || state_q == StRequest)
      else $error("a beat is taken that belongs to no write");
`endif
endmodule
`default_nettype wire
