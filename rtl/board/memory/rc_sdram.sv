// Controller of one 16-bit SDR SDRAM. It reads and writes lines of 64 bytes: four bursts of eight
// beats, 32 clocks on the data bus. Rows stay open. Requests are served in order.
//
// Two requests are held: the current one, and the next. Until the first column command of the
// current line, row commands serve that line. After it they serve the next line, between the
// column commands. So the row of the next line is precharged and activated while the current line
// moves. A stream of lines in open rows or in different banks fills every clock of the bus.
// When a refresh is due, the line in progress is finished, all banks are precharged, and all rows
// wait until the refresh has ended.
//
// A line's number is {row, bank, line of the row}. Beat 2k is the lower half of word k.
//
// Timing. A command that is decided in cycle d is on the pins in cycle d + 1. Write data are taken
// in the cycle of the decision and in the seven that follow. Read data are captured at the end of
// cycle d + Cl + ReadDelay and are on rd_data_o one cycle later. The comparison of a request's row
// with the open row of its bank takes a cycle; a stream of requests hides it. The timings are in
// ps, and the module computes clocks from them, rounded up. model/board/sdram.hpp is the model.
//
// ReadDelay is the number of clocks by which read data reach the input registers late. It is 0 if
// the SDRAM's clock lags by a part of a period and its data arrive within the rest of the period.
// It is 1 if they need a period more, or if the SDRAM's clock is in phase.
`default_nettype none
module rc_sdram #(
  parameter  int unsigned ClkKhz     = 75_000,
  parameter  int unsigned RowBits    = 13,
  parameter  int unsigned ColumnBits = 10,
  parameter  int unsigned Cl         = 2,
  parameter  int unsigned RcdPs      = 21_000,
  parameter  int unsigned RpPs       = 21_000,
  parameter  int unsigned RasPs      = 42_000,
  parameter  int unsigned RcPs       = 63_000,
  parameter  int unsigned RrdPs      = 14_000,
  parameter  int unsigned WrPs       = 14_000,
  parameter  int unsigned WrClocks   = 2,          // and at least so many clocks
  parameter  int unsigned RfcPs      = 63_000,
  parameter  int unsigned RefiPs     = 7_800_000,
  parameter  int unsigned MrdClocks  = 2,
  parameter  int unsigned InitUs     = 200,
  parameter  int unsigned InitRefreshes = 8,
  parameter  int unsigned ReadDelay  = 0,
  parameter  int unsigned TagW       = 8,
  localparam int unsigned InRowW     = ColumnBits - 5,
  localparam int unsigned LineW      = RowBits + 2 + InRowW
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  output logic             init_done_o,
  input  logic             align_i,       // a refresh is due, and the next one an interval later
  // Requests
  input  logic             req_valid_i,
  output logic             req_ready_o,
  input  logic             req_write_i,
  input  logic [LineW-1:0] req_addr_i,
  input  logic [TagW-1:0]  req_tag_i,
  // Write data: taken in each cycle of wr_next_o
  output logic             wr_next_o,
  output logic [TagW-1:0]  wr_tag_o,
  input  logic [15:0]      wr_data_i,
  input  logic [1:0]       wr_mask_i,   // 1: the byte is not written
  // Read data
  output logic             rd_valid_o,
  output logic             rd_last_o,
  output logic [TagW-1:0]  rd_tag_o,
  output logic [15:0]      rd_data_o,
  // Pins
  output logic             sd_cke_o,
  output logic             sd_cs_no,
  output logic             sd_ras_no,
  output logic             sd_cas_no,
  output logic             sd_we_no,
  output logic [1:0]       sd_ba_o,
  output logic [12:0]      sd_a_o,
  output logic [1:0]       sd_dqm_o,
  output logic [15:0]      sd_dq_o,
  output logic             sd_dq_oe_o,
  output logic             sd_dq_oe_next_o,   // sd_dq_oe_o in the next cycle
  input  logic [15:0]      sd_dq_i
);
  // ---- Timings in clocks. The shorter bound of the period makes them longer, the longer bound
  // makes the interval of refreshes shorter.
  localparam int unsigned ShortPs   = 1_000_000_000 / ClkKhz;
  localparam int unsigned LongPs    = (1_000_000_000 + ClkKhz - 1) / ClkKhz;
  localparam int unsigned Rcd       = (RcdPs + ShortPs - 1) / ShortPs;
  localparam int unsigned Rp        = (RpPs + ShortPs - 1) / ShortPs;
  localparam int unsigned RasOnly   = (RasPs + ShortPs - 1) / ShortPs;
  localparam int unsigned Rc        = (RcPs + ShortPs - 1) / ShortPs;
  localparam int unsigned Ras       = RasOnly + Rp < Rc ? Rc - Rp : RasOnly;   // implies tRC
  localparam int unsigned Rrd       = (RrdPs + ShortPs - 1) / ShortPs;
  localparam int unsigned WrOnly    = (WrPs + ShortPs - 1) / ShortPs;
  localparam int unsigned Wr        = WrOnly < WrClocks ? WrClocks : WrOnly;
  localparam int unsigned Rfc       = (RfcPs + ShortPs - 1) / ShortPs;
  localparam int unsigned Refi      = RefiPs / LongPs;
  localparam int unsigned InitWait  = (InitUs * 1_000_000 + ShortPs - 1) / ShortPs;
  localparam int unsigned Burst     = 8;
  localparam int unsigned Turn      = Cl + Burst + 1;  // from a read to a write: one idle clock

  localparam int unsigned InitW     = $clog2(InitWait + 1);
  localparam int unsigned RefiW     = $clog2(Refi);
  localparam int unsigned LongWait  = Rfc > Rp ? (Rfc > Rcd ? Rfc : Rcd) : (Rp > Rcd ? Rp : Rcd);
  localparam int unsigned WaitW     = $clog2(LongWait + 1);
  localparam int unsigned LongPre   = Burst + Wr > Ras ? Burst + Wr : Ras;
  localparam int unsigned PreW      = $clog2(LongPre + 1);
  localparam int unsigned TurnW     = $clog2(Turn + 1);
  localparam int unsigned ReadDepth = 1 + Cl + ReadDelay;  // from the decision to the data

  if (Cl < 2 || Cl > 3) begin : gen_refuse_cl
    $error("rc_sdram: Cl must be 2 or 3");
  end
  if (RowBits > 13 || ColumnBits < 6 || ColumnBits > 10) begin : gen_refuse_size
    $error("rc_sdram: RowBits must be at most 13, and ColumnBits 6 to 10");
  end
  if (Rrd > Rcd + 1) begin : gen_refuse_rrd
    $error("rc_sdram: a column command must separate activations by tRRD");
  end
  if (Ras > Rcd + Burst) begin : gen_refuse_ras
    $error("rc_sdram: a burst must end after tRAS");
  end
  if (Refi < 2 * (32 + LongPre + Rp + Rfc + Turn)) begin : gen_refuse_refi
    $error("rc_sdram: tREFI must leave time for a line");
  end

  // Commands: {RAS, CAS, WE}, all active low.
  localparam logic [2:0] CmdMode      = 3'b000;
  localparam logic [2:0] CmdRefresh   = 3'b001;
  localparam logic [2:0] CmdPrecharge = 3'b010;
  localparam logic [2:0] CmdActivate  = 3'b011;
  localparam logic [2:0] CmdWrite     = 3'b100;
  localparam logic [2:0] CmdRead      = 3'b101;
  localparam logic [2:0] CmdNop       = 3'b111;

  localparam logic [2:0]  ClCode = 3'(Cl);
  localparam logic [12:0] Mode   = {6'd0, ClCode, 1'b0, 3'b011};  // burst of 8, sequential

  // ---- Initialisation: wait, precharge all, refreshes, mode register.
  localparam int unsigned StepW = $clog2(InitRefreshes + 3);
  logic             run_q;
  logic [InitW-1:0] init_q;   // clocks until the next step
  logic [StepW-1:0] step_q;
  logic             init_step, init_precharge, init_mode, init_ends;

  assign init_step      = !run_q && init_q == '0;
  assign init_precharge = step_q == '0;
  assign init_mode      = step_q == StepW'(InitRefreshes + 1);
  assign init_ends      = step_q == StepW'(InitRefreshes + 2);
  assign init_done_o    = run_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      run_q  <= 1'b0;
      init_q <= InitW'(InitWait);
      step_q <= '0;
    end else if (init_step) begin
      run_q  <= init_ends;
      step_q <= step_q + 1'b1;
      init_q <= InitW'(init_precharge ? Rp - 1 : init_mode ? MrdClocks - 1 : Rfc - 1);
    end else if (!run_q) begin
      init_q <= init_q - 1'b1;
    end
  end

  // ---- Requests: the current and the next.
  logic               cur_valid_q, cur_write_q, nxt_valid_q, nxt_write_q;
  logic [RowBits-1:0] cur_row_q, nxt_row_q;
  logic [1:0]         cur_bank_q, nxt_bank_q;
  logic [InRowW-1:0]  cur_line_q, nxt_line_q;
  logic [TagW-1:0]    cur_tag_q, nxt_tag_q;
  logic [1:0]         cur_burst_q;   // column commands given
  logic               take, cur_ends, col_fires;

  assign req_ready_o = run_q && !nxt_valid_q;
  assign take        = req_valid_i && req_ready_o;
  assign cur_ends    = col_fires && cur_burst_q == 2'd3;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      cur_valid_q <= 1'b0;
      nxt_valid_q <= 1'b0;
      cur_burst_q <= '0;
    end else begin
      cur_burst_q <= cur_burst_q + 2'(col_fires);
      if (!cur_valid_q || cur_ends) begin
        cur_valid_q <= nxt_valid_q || take;
        nxt_valid_q <= 1'b0;
      end else if (take) begin
        nxt_valid_q <= 1'b1;
      end
    end
    if (!cur_valid_q || cur_ends) begin
      {cur_row_q, cur_bank_q, cur_line_q} <= nxt_valid_q ? {nxt_row_q, nxt_bank_q, nxt_line_q}
                                                         : req_addr_i;
      cur_write_q <= nxt_valid_q ? nxt_write_q : req_write_i;
      cur_tag_q   <= nxt_valid_q ? nxt_tag_q : req_tag_i;
    end
    if (!nxt_valid_q) begin
      {nxt_row_q, nxt_bank_q, nxt_line_q} <= req_addr_i;
      nxt_write_q <= req_write_i;
      nxt_tag_q   <= req_tag_i;
    end
  end

  // ---- Refresh.
  logic             due_q, stops, refreshes, closes_all, first;
  logic [RefiW-1:0] refi_q;

  assign first = cur_burst_q == '0;   // the current line has given no column command
  assign stops = due_q && first;   // no line is in progress

  always_ff @(posedge clk_i) begin
    if (!rst_ni || !run_q) begin
      refi_q <= RefiW'(Refi - 1);
      due_q  <= 1'b0;
    end else begin
      refi_q <= align_i || refi_q == '0 ? RefiW'(Refi - 1) : refi_q - 1'b1;
      due_q  <= align_i || refi_q == '0 || (due_q && !refreshes);
    end
  end

  // ---- The request that row commands serve.
  logic               sel_valid;
  logic [RowBits-1:0] sel_row;
  logic [1:0]         sel_bank;
  logic               compared_q;  // the row of the selected request has been compared
  logic               equal_q;     // it is the row that its bank had open last

  assign sel_valid = first ? cur_valid_q : nxt_valid_q;
  assign sel_row   = first ? cur_row_q : nxt_row_q;
  assign sel_bank  = first ? cur_bank_q : nxt_bank_q;

  // ---- Banks. wait_q: clocks until a closed bank may be activated, or until an open one may be
  // read or written. pre_q: clocks until an open bank may be precharged. A flag marks each
  // counter that is 0.
  logic [3:0]         open_q, wait_ends_q, pre_ends_q, activates, precharges, columns;
  logic [RowBits-1:0] row_q [4];
  logic [RowBits-1:0] open_row;
  logic               activate, precharge;
  logic               activates_may, precharges_may;   // apart from the state of the bank

  for (genvar b = 0; b < 4; b++) begin : gen_bank
    logic [WaitW-1:0] wait_q, wait_next;
    logic [PreW-1:0]  pre_q, pre_next;

    assign activates[b]  = activates_may && sel_bank == 2'(b) && !open_q[b] && wait_ends_q[b];
    assign precharges[b] = precharges_may && sel_bank == 2'(b) && open_q[b] && pre_ends_q[b];
    assign columns[b]    = col_fires && cur_bank_q == 2'(b);

    assign wait_next = refreshes                     ? WaitW'(Rfc - 1)
                     : precharges[b] || closes_all   ? WaitW'(Rp - 1)
                     : activates[b]                  ? WaitW'(Rcd - 1)
                     : wait_ends_q[b]                ? '0
                     : wait_q - 1'b1;
    assign pre_next  = activates[b]  ? PreW'(Ras - 1)
                     : columns[b]    ? PreW'(cur_write_q ? Burst + Wr - 2 : Burst - 1)
                     : pre_ends_q[b] ? '0
                     : pre_q - 1'b1;

    always_ff @(posedge clk_i) begin
      wait_q         <= rst_ni ? wait_next : '0;
      wait_ends_q[b] <= !rst_ni || wait_next == '0;
      pre_q          <= rst_ni ? pre_next : '0;
      pre_ends_q[b]  <= !rst_ni || pre_next == '0;
      open_q[b]      <= rst_ni && (activates[b] || (open_q[b] && !precharges[b] && !closes_all));
    end
  end

  assign activate  = activates != '0;
  assign precharge = precharges != '0;
  assign open_row  = row_q[sel_bank];

  always_ff @(posedge clk_i) begin
    if (activate) row_q[sel_bank] <= sel_row;
    equal_q <= activate || open_row == sel_row;
    // When the first column command selects the next request, equal_q is 1 for a cycle, and no row
    // command depends on that.
    compared_q <= rst_ni && sel_valid;
  end

  // ---- Beats of the burst in progress, and the turn of the bus from reads to writes.
  logic [2:0]       beats_q;   // beats after this cycle's
  logic             beats_busy, beats_write_q, beats_last_q;
  logic [TagW-1:0]  beats_tag_q, beats_tag;
  logic [TurnW-1:0] turn_q;

  assign beats_busy = beats_q != '0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni)         beats_q <= '0;
    else if (col_fires)  beats_q <= 3'(Burst - 1);
    else if (beats_busy) beats_q <= beats_q - 1'b1;
    if (col_fires) begin
      beats_write_q <= cur_write_q;
      beats_last_q  <= cur_burst_q == 2'd3;
      beats_tag_q   <= cur_tag_q;
    end
    if (!rst_ni)                        turn_q <= '0;
    else if (col_fires && !cur_write_q) turn_q <= TurnW'(Turn - 1);
    else if (turn_q != '0)              turn_q <= turn_q - 1'b1;
  end

  // ---- Decision.
  logic cur_may, row_may;

  // The row of the current line is open, and its bank may be read or written.
  assign cur_may   = cur_valid_q && !due_q && compared_q && equal_q && open_q[cur_bank_q]
                  && wait_ends_q[cur_bank_q] && (!cur_write_q || turn_q == '0);
  assign col_fires = !beats_busy && (!first || cur_may);

  // During a burst the bank in use cannot be precharged: its pre_q is not 0.
  assign row_may        = sel_valid && !due_q && (first || beats_busy);
  assign activates_may  = row_may;
  assign precharges_may = row_may && compared_q && !equal_q;

  assign closes_all = stops && open_q != '0 && pre_ends_q == '1;
  assign refreshes  = stops && open_q == '0 && wait_ends_q == '1;

  // ---- Pins.
  logic [2:0] command, command_q;

  always_comb begin
    command = CmdNop;
    if (init_step && !init_ends)
      command = init_precharge ? CmdPrecharge : init_mode ? CmdMode : CmdRefresh;
    if (closes_all || precharge) command = CmdPrecharge;
    if (refreshes)               command = CmdRefresh;
    if (activate)                command = CmdActivate;
    if (col_fires)               command = cur_write_q ? CmdWrite : CmdRead;
  end

  always_ff @(posedge clk_i) begin
    command_q <= rst_ni ? command : CmdNop;
    sd_cke_o  <= 1'b1;   // also in a reset, so that a burst in flight ends
    sd_cs_no  <= !rst_ni;
    sd_ba_o   <= col_fires ? cur_bank_q : activate || precharge ? sel_bank : '0;
    // A10 is high in a precharge of all banks, and low in other precharges and column commands.
    sd_a_o    <= !run_q     ? (init_mode ? Mode : init_ends ? '0 : 13'h400)
               : col_fires  ? 13'({cur_line_q, cur_burst_q, 3'd0})
               : closes_all ? 13'h400
               : activate   ? 13'(sel_row)
               : '0;
  end
  assign {sd_ras_no, sd_cas_no, sd_we_no} = command_q;

  // Write data.
  assign beats_tag = beats_busy ? beats_tag_q : cur_tag_q;
  assign wr_next_o = beats_busy ? beats_write_q : col_fires && cur_write_q;
  assign wr_tag_o  = beats_tag;
  assign sd_dq_oe_next_o = rst_ni && wr_next_o;

  always_ff @(posedge clk_i) begin
    sd_dq_oe_o <= sd_dq_oe_next_o;
    sd_dq_o    <= wr_data_i;
    sd_dqm_o   <= !rst_ni || !run_q ? '1 : wr_next_o ? wr_mask_i : '0;
  end

  // Read data.
  localparam int unsigned ReadW = TagW + 2;
  logic [ReadDepth*ReadW-1:0] reads_q;
  logic [ReadW-1:0]           read;
  logic                       read_beat, read_last;
  logic [15:0]                dq_q;

  assign read_beat = beats_busy ? !beats_write_q : col_fires && !cur_write_q;
  assign read_last = beats_q == 3'd1 && beats_last_q;
  assign read      = {read_beat, read_last, beats_tag};

  always_ff @(posedge clk_i) begin
    dq_q    <= sd_dq_i;
    reads_q <= rst_ni ? {reads_q[0 +: (ReadDepth-1)*ReadW], read} : '0;
  end

  assign {rd_valid_o, rd_last_o, rd_tag_o} = reads_q[(ReadDepth-1)*ReadW +: ReadW];
  assign rd_data_o = dq_q;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && run_q)
      assert (!(due_q && refi_q == '0))
        else $error("rc_sdram: a refresh is due before the last one was given");
  end
`endif
endmodule
`default_nettype wire
