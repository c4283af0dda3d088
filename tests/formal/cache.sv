// Properties of the whole rc_cache, if ids in use are not given again and memory sends each
// requested word once, in any order and at any time:
// - every request is answered once, with the word at its address, however often lines are filled
//   and evicted;
// - no answer is lost in a full queue;
// - if memory owes no word and answers are accepted, no request stays open for long.
//
// The proof uses the smallest cache in which lines are evicted, requests merge into a line in
// flight, and ways and MSHRs run out: two ways, one set, two MSHRs, four ids, and a memory of four
// lines of one bit each with arbitrary content. It covers a number of cycles from reset. The parts
// are proven for all time in fifo.sv, credit_counter.sv, queue.sv, tags.sv and mshr.sv.
module cache #(
  parameter  int unsigned Words    = 1,   // of a line, 1 or 2
  parameter  int unsigned Soon     = 9,   // cycles
  localparam int unsigned IdBits   = 2,
  localparam int unsigned Ids      = 4,
  localparam int unsigned AddrBits = 1 + Words,
  localparam int unsigned Cells    = 1 << AddrBits,
  localparam int unsigned MissIdW  = Words
) (
  input  logic                clk_i,
  input  logic                rst_ni,
  input  logic [Cells-1:0]    memory_i,
  input  logic                req_valid_i,
  input  logic [IdBits-1:0]   req_id_i,
  input  logic [AddrBits-1:0] req_addr_i,
  input  logic                rsp_ready_i,
  input  logic                miss_ready_i,
  input  logic                fill_fires_i,
  input  logic [MissIdW-1:0]  fill_id_i
);
  logic                             req_ready_o, rsp_valid_o, miss_valid_o, waits_o, rsp_bit;
  logic [2:0]                       outcome_o;
  logic [IdBits-1:0]                rsp_id;
  logic [MissIdW-1:0]               miss_id;
  logic [AddrBits-1:0]              miss_addr;
  logic [(1<<MissIdW)*AddrBits-1:0] asked_addr_q;
  rc_cache #(.IdBits(IdBits), .AddrBits(AddrBits), .Parts(1), .PartW(1), .Sets(1), .Ways(2),
      .Words(Words), .Mshrs(2),
             .Queue(2)) u_dut (
    .clk_i(clk_i), .rst_ni(rst_ni), .req_valid_i(req_valid_i), .req_ready_o(req_ready_o),
    .req_i({req_id_i, req_addr_i}), .rsp_valid_o(rsp_valid_o), .rsp_ready_i(rsp_ready_i),
    .rsp_o({rsp_id, rsp_bit}),
    .miss_valid_o(miss_valid_o), .miss_ready_i(miss_ready_i), .miss_o({miss_id, miss_addr}),
    .fill_fires_i(fill_fires_i), .fill_id_i(fill_id_i),
    .fill_word_i(memory_i[asked_addr_q[AddrBits*fill_id_i +: AddrBits]]),
    .waits_o(waits_o), .outcome_o(outcome_o));

  logic [1:0]       begun_q = 2'd0;
  logic [Cells-1:0] memory_q;
  always @(posedge clk_i) begin
    if (begun_q != 2'd1) begun_q <= begun_q + 1'b1;
    memory_q <= memory_i;
  end
  always @* begin
    assume (rst_ni == (begun_q == 2'd1));
    assume (begun_q == 2'd0 || memory_i == memory_q);
  end

  logic [Ids-1:0]          open_q;     // between request and answer
  logic [Ids*AddrBits-1:0] wants_q;
  logic [(1<<MissIdW)-1:0] owed_q;     // requested words that have not arrived
  logic [4:0]              quiet_q;    // cycles without a stalled request or answer
  logic                    stalled_q, shown_q;
  logic [IdBits-1:0]       shown_id_q;
  always @(posedge clk_i) begin
    if (!rst_ni) begin
      open_q  <= '0;
      owed_q  <= '0;
      quiet_q <= '0;
    end else begin
      if (rsp_valid_o && rsp_ready_i) open_q[rsp_id] <= 1'b0;
      if (req_valid_i && req_ready_o) begin
        open_q[req_id_i] <= 1'b1;
        wants_q[AddrBits*req_id_i +: AddrBits] <= req_addr_i;
      end
      if (fill_fires_i) owed_q[fill_id_i] <= 1'b0;
      if (miss_valid_o && miss_ready_i) begin
        owed_q[miss_id] <= 1'b1;
        asked_addr_q[AddrBits*miss_id +: AddrBits] <= miss_addr;
      end
      quiet_q <= rsp_ready_i && !miss_valid_o && owed_q == '0 && !(req_valid_i && req_ready_o) &&
          open_q != '0
          ? quiet_q + 1'b1 : '0;
    end
    stalled_q  <= rst_ni && rsp_valid_o && !rsp_ready_i;
    shown_q    <= rsp_bit;
    shown_id_q <= rsp_id;
  end
  always @* if (rst_ni) begin
    assume (!req_valid_i || !open_q[req_id_i]);
    assume (!fill_fires_i || owed_q[fill_id_i]);
  end
  always @* if (rst_ni) begin
    a_asked:  assert (!rsp_valid_o || open_q[rsp_id]);
    a_right:  assert (!rsp_valid_o || rsp_bit == memory_i[wants_q[AddrBits*rsp_id +: AddrBits]]);
    a_stays:  assert (!stalled_q || (rsp_valid_o && rsp_id == shown_id_q && rsp_bit == shown_q));
    a_once:   assert (!miss_valid_o || !owed_q[miss_id]);
    a_soon:   assert (quiet_q < Soon);
  end
endmodule
