// Queue from the chip's clock to the pixel clock for a stream with the same average rate on both
// sides. Depth is a power of two, at least 8.
//
// The input has no back-pressure: the writer is a tick generator with the pixel clock's average
// frequency. The output starts when half of the queue is filled, and from then on takes an
// entry every pixel clock. An entry is visible to the reader after two to three pixel clocks. If
// an entry is missing, the output stops until half of the queue is filled again.
//
// A full queue drops an entry. overflow_o (at clk_i) and underflow_o (at pixel_clk_i) stay high
// once this or a missing entry has happened, until a reset. Both resets must be active together.
// The pointers cross in Gray code.
`default_nettype none
module rc_video_fifo #(
  parameter  int unsigned Width  = 1,
  parameter  int unsigned Depth  = 16,
  localparam int unsigned IndexW = $clog2(Depth)
) (
  // Writer
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             valid_i,
  input  logic [Width-1:0] data_i,
  output logic             overflow_o,
  // Reader
  input  logic             pixel_clk_i,
  input  logic             pixel_rst_ni,
  output logic             valid_o,
  output logic [Width-1:0] data_o,
  output logic             underflow_o
);
  if (Width < 1 || Depth < 8 || (Depth & (Depth - 1)) != 0) begin : gen_refuse
    $error("rc_video_fifo: Width must be at least 1, and Depth a power of two, at least 8");
  end

  logic [Width-1:0] mem [Depth];

  // ---- Writer. Pointers have a wrap bit above the index.
  logic [IndexW:0] tail_q, tail_gray_q, tail_next;
  logic [IndexW:0] head_gray_q, head_gray_w1_q, head_gray_w2_q;
  logic            full, writes, overflow_q;

  // Full: the tail is one round ahead. In Gray code the upper two bits differ and the rest agrees.
  assign full      = tail_gray_q == (head_gray_w2_q ^ ((IndexW+1)'(3) << (IndexW - 1)));
  assign writes    = valid_i && !full;
  assign tail_next = tail_q + 1'b1;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      tail_q         <= '0;
      tail_gray_q    <= '0;
      head_gray_w1_q <= '0;
      head_gray_w2_q <= '0;
      overflow_q     <= 1'b0;
    end else begin
      if (writes) begin
        tail_q      <= tail_next;
        tail_gray_q <= tail_next ^ (tail_next >> 1);
      end
      head_gray_w1_q <= head_gray_q;
      head_gray_w2_q <= head_gray_w1_q;
      if (valid_i && full) overflow_q <= 1'b1;
    end
    if (writes) mem[tail_q[IndexW-1:0]] <= data_i;
  end

  assign overflow_o = overflow_q;

  // ---- Reader.
  logic [IndexW:0]  head_q, head_next, tail_gray_r1_q, tail_gray_r2_q, tail, level;
  logic             runs_q, reads, valid_q, underflow_q;
  logic [Width-1:0] data_q;

  for (genvar i = 0; i <= IndexW; i++) begin : gen_binary   // from Gray code
    assign tail[i] = ^tail_gray_r2_q[IndexW:i];
  end

  assign level     = tail - head_q;
  assign reads     = runs_q && level != '0;
  assign head_next = head_q + 1'b1;

  always_ff @(posedge pixel_clk_i) begin
    if (!pixel_rst_ni) begin
      head_q         <= '0;
      head_gray_q    <= '0;
      tail_gray_r1_q <= '0;
      tail_gray_r2_q <= '0;
      runs_q         <= 1'b0;
      valid_q        <= 1'b0;
      underflow_q    <= 1'b0;
    end else begin
      tail_gray_r1_q <= tail_gray_q;
      tail_gray_r2_q <= tail_gray_r1_q;
      runs_q         <= runs_q ? level != '0 : level >= (IndexW+1)'(Depth / 2);
      valid_q        <= reads;
      if (reads) begin
        head_q      <= head_next;
        head_gray_q <= head_next ^ (head_next >> 1);
      end
      if (runs_q && level == '0) underflow_q <= 1'b1;
    end
    if (reads) data_q <= mem[head_q[IndexW-1:0]];
  end

  assign valid_o     = valid_q;
  assign data_o      = data_q;
  assign underflow_o = underflow_q;
endmodule
`default_nettype wire
