// The board's end of the host link: packets of bytes in, accesses to the chip's Wishbone bus, to
// the board's registers and to lines of memory, and one answer for each packet.
// docs/machine/board-link.md describes the packets; sim/board/protocol.hpp mirrors the constants.
//
// The module executes a packet after checking its checksum, and before it reads the next one:
// - A packet with a wrong checksum is dropped without an answer. So is a partial packet when no
//   byte comes for QuietCycles cycles.
// - A write of no line or of more than sixteen lines is dropped after its head, without an answer:
//   its payload may not fit the buffer.
// - bad_o is high for one cycle each time that a packet is dropped.
// - A packet with the expected sequence number is executed, once. Its result is kept.
// - A packet with one of the sixteen numbers before it was executed earlier. Its kept result is
//   sent again. Lines of memory are read again, which changes nothing.
// - Any other number is refused with the reason "gap" and the expected number.
// - "hello" is executed with any number, and sets the expected number. Before the first "hello"
//   all other packets are refused.
//
// One state machine receives, executes and answers, so the bytes of the next packet wait in a FIFO
// meanwhile (rc_byte_fifo). The memory must take or give 32 beats for every request that it
// accepts, the first one not before the cycle of its acceptance.
`default_nettype none
module rc_link #(
  parameter  int unsigned LineBits    = 20,        // of a line's number in memory
  parameter  int unsigned QuietCycles = 1500000,   // silence that ends a partial packet: 20 ms
  parameter  int unsigned BusCycles   = 256,       // limit for an answer on the chip's bus
  localparam int unsigned RegBits     = 8          // of a board register's number
) (
  input  logic                            clk_i,
  input  logic                            rst_ni,
  // Received bytes
  input  logic                            rx_valid_i,
  output logic                            rx_ready_o,
  input  logic [7:0]                      rx_data_i,
  // Bytes to send
  output logic                            tx_valid_o,
  input  logic                            tx_ready_i,
  output logic [7:0]                      tx_data_o,
  // To the chip's bus: a Wishbone master, classic cycles
  output logic                            wb_cyc_o,
  output logic                            wb_stb_o,
  output logic                            wb_we_o,
  output logic [rc_pkg::RegAddrBits-1:0]  wb_adr_o,
  output logic [31:0]                     wb_dat_o,
  input  logic [31:0]                     wb_dat_i,
  input  logic                            wb_ack_i,
  input  logic                            wb_err_i,
  // To the board's registers: answered in the same cycle
  output logic                            reg_valid_o,
  output logic                            reg_write_o,
  output logic [RegBits-1:0]              reg_addr_o,
  output logic [31:0]                     reg_data_o,
  input  logic [31:0]                     reg_data_i,
  input  logic                            reg_good_i,    // the register allows the access
  // To memory: the client `host` of rc_board_memory
  output logic                            host_req_valid_o,
  input  logic                            host_req_ready_i,
  output logic                            host_req_write_o,
  output logic [LineBits-1:0]             host_req_addr_o,
  input  logic                            host_next_i,       // a beat of a write is taken
  output logic [15:0]                     host_wr_data_o,
  input  logic                            host_rd_valid_i,
  input  logic [15:0]                     host_rd_data_i,
  // Statistics
  output logic                            bad_o              // a packet was dropped
);
  if (LineBits < 1 || LineBits > 31) begin : gen_refuse
    $error("rc_link: LineBits must be 1 to 31");
  end
  if (QuietCycles < 2 || BusCycles < 4) begin : gen_refuse_cycles
    $error("rc_link: QuietCycles and BusCycles are too short");
  end

  // Marks: the first two bytes of a packet. Kinds of packets; an answer adds 0x80, a refusal 0xc0.
  localparam logic [7:0] Mark0      = 8'hc5, Mark1 = 8'h3a;
  localparam logic [7:0] Hello      = 8'd1, WriteRegister = 8'd2, ReadRegister = 8'd3;
  localparam logic [7:0] WriteLines = 8'd4, ReadLines     = 8'd5, CheckLines   = 8'd6;

  // Results: 0, or the reason of a refusal.
  localparam logic [2:0] Done       = 3'd0, NoSession  = 3'd1, Gap      = 3'd2;
  localparam logic [2:0] BadKind    = 3'd3, BadAddress = 3'd4, BusError = 3'd5;
  localparam logic [2:0] BusSilence = 3'd6;

  localparam int unsigned LinesMost = 16;                  // in a packet
  localparam int unsigned BeatsB    = 5;                   // log2 of the beats of a line
  localparam int unsigned WordW     = $clog2(LinesMost) + BeatsB;
  localparam int unsigned ByteW     = WordW + 1;
  localparam int unsigned History   = 16;                  // results that are kept
  localparam int unsigned HistoryW  = $clog2(History);
  localparam int unsigned QuietW    = $clog2(QuietCycles + 1);
  localparam int unsigned BusW      = $clog2(BusCycles + 1);

  typedef enum logic [4:0] {
    StMark0, StMark1, StHead, StLength, StPayload, StCrc, StVerify,        // receive
    StJudge, StBus, StRegister, StMemory, StBeats, StLoad, StSum, StStore,  // execute
    StAnswer, StSendMark0, StSendMark1, StSendHead, StSendLines, StSendCrc
  } state_e;

  state_e              state_q;
  logic [ByteW:0]      left_q;       // bytes of this part of the packet that are still to come
  logic [63:0]         head_q;       // head of the packet, complete from StLength on
  logic [31:0]         data_q;       // the last four bytes of the payload, the first one lowest
  logic [2:0]          result_q;     // of the answer
  logic [31:0]         value_q;      // of the answer
  logic                session_q;    // there was a hello since the reset
  logic [7:0]          expected_q;   // sequence number of the next new packet
  logic                replay_q;     // this packet was executed before
  logic [LineBits-1:0] line_q;       // line of memory that is read or written
  logic [15:0]         lines_q;      // lines that follow it
  logic                requested_q;  // the memory has accepted the request for this line
  logic [WordW-1:0]    word_q;       // place in the buffer of the next beat from or to memory
  logic [ByteW-1:0]    at_q;         // place in the buffer of the next byte of the packet
  logic [QuietW-1:0]   quiet_q;      // cycles since the last byte
  logic [BusW-1:0]     bus_q;        // cycles since the bus access began
  logic [63:0]         out_q;        // head of the answer, the next byte lowest

  // ---- Fields of the head.
  logic [7:0]  kind, sequence_number;
  logic [31:0] address;
  logic [15:0] count;
  logic        is_write, gives_lines;

  assign {count, address, sequence_number, kind} = head_q;
  assign is_write    = kind == WriteLines;
  assign gives_lines = kind == ReadLines && result_q == Done;

  // ---- Bytes in and out.
  logic takes, sends, last, is_quiet;

  assign rx_ready_o = state_q == StMark0 || state_q == StMark1 || state_q == StHead
                   || state_q == StPayload || state_q == StCrc;
  assign tx_valid_o = state_q == StSendMark0 || state_q == StSendMark1 || state_q == StSendHead
                   || state_q == StSendLines || state_q == StSendCrc;
  assign takes      = rx_valid_i && rx_ready_o;
  assign sends      = tx_valid_o && tx_ready_i;
  assign last       = left_q == (ByteW + 1)'(1);

  // Silence within a packet.
  assign is_quiet = quiet_q == QuietW'(QuietCycles) && state_q != StMark0 && !rx_valid_i;

  always_ff @(posedge clk_i) begin
    if (state_q == StMark0 || !rx_ready_o || rx_valid_i) quiet_q <= '0;
    else                                                 quiet_q <= quiet_q + 1'b1;
  end

  // ---- Checksum of the packet that is received, of the answer, or of lines of memory.
  logic        crc_clear, crc_valid, crc_sound;
  logic [7:0]  crc_byte, buffer_byte;
  logic [31:0] crc;

  rc_crc32 u_crc (
    .clk_i, .clear_i(crc_clear), .valid_i(crc_valid), .byte_i(crc_byte), .crc_o(crc),
    .sound_o(crc_sound));

  assign crc_clear = state_q == StMark1 || state_q == StJudge || state_q == StAnswer;

  always_comb begin
    crc_valid = takes && state_q != StMark0;
    crc_byte  = rx_data_i;
    if (state_q == StSendHead || state_q == StSendLines) begin
      crc_valid = sends;
      crc_byte  = tx_data_o;
    end
    if (state_q == StSum) begin
      crc_valid = 1'b1;
      crc_byte  = buffer_byte;
    end
  end

  // ---- Buffer of sixteen lines, in beats: the payload of a write, or lines that were read. A read
  // address belongs to the next cycle's beat or byte, because the RAM answers a cycle later.
  logic             buffer_writes, beat_moves, byte_moves, line_ends;
  logic [WordW-1:0] buffer_at, word_next;
  logic [ByteW-1:0] at_next;
  logic [15:0]      buffer_in, buffer_word;

  assign beat_moves = state_q == StBeats && (is_write ? host_next_i : host_rd_valid_i);
  assign byte_moves = state_q == StSum || (state_q == StSendLines && sends)
                   || (state_q == StPayload && takes);
  assign word_next  = word_q + WordW'(beat_moves);
  assign at_next    = at_q + ByteW'(byte_moves);
  assign line_ends  = beat_moves && word_q[BeatsB-1:0] == {BeatsB{1'b1}};

  always_comb begin
    buffer_writes = state_q == StPayload && takes && at_q[0];
    buffer_at     = at_q[ByteW-1:1];
    buffer_in     = {rx_data_i, data_q[31:24]};
    if (state_q == StBeats) begin
      buffer_writes = !is_write && host_rd_valid_i;
      buffer_at     = word_q;
      buffer_in     = host_rd_data_i;
    end
  end

  rc_ram_sync #(.Width(16), .Depth(1 << WordW)) u_buffer (
    .clk_i, .write_i(buffer_writes), .write_addr_i(buffer_at), .write_data_i(buffer_in),
    .read_i(!buffer_writes), .read_addr_i(is_write ? word_next : at_next[ByteW-1:1]),
    .read_data_o(buffer_word));

  assign buffer_byte = at_q[0] ? buffer_word[15:8] : buffer_word[7:0];

  always_ff @(posedge clk_i) begin
    if (state_q == StLength || state_q == StBeats || state_q == StAnswer) at_q <= '0;
    else                                                                  at_q <= at_next;
    if (state_q == StJudge || state_q == StLoad) word_q <= '0;
    else                                         word_q <= word_next;
  end

  // ---- Results of the last sixteen packets. The sum of lines is complete in StStore.
  logic        stores_result;
  logic [2:0]  stored_result;
  logic [31:0] stored_value, value;

  assign stores_result = state_q == StStore && !replay_q;
  assign value         = kind == CheckLines && result_q == Done ? crc : value_q;

  rc_ram #(.Width(3 + 32), .Depth(History)) u_history (
    .clk_i, .write_i(stores_result), .write_addr_i(sequence_number[HistoryW-1:0]),
    .write_data_i({result_q, value}),
    .read_addr_i(sequence_number[HistoryW-1:0]), .read_data_o({stored_result, stored_value}));

  // ---- Judgement of a packet. The head and the expected number do not change for the cycles of
  // the checksum, so registers take the comparisons. StJudge uses them.
  logic [7:0]  ahead;         // sequence number less the expected one
  logic [31:0] beyond;        // the line after the last one
  logic        for_board;     // a register of the board, not of the chip
  logic        next_q, old_q, hello_q, kind_valid_q, for_register_q, register_q, lines_there_q;

  assign ahead     = sequence_number - expected_q;
  assign beyond    = address + 32'(count);
  assign for_board = address[31];

  always_ff @(posedge clk_i) begin
    next_q         <= ahead == '0;
    old_q          <= ahead >= 8'(256 - History);
    hello_q        <= kind == Hello;
    kind_valid_q   <= kind >= Hello && kind <= CheckLines;
    for_register_q <= kind == WriteRegister || kind == ReadRegister;
    register_q     <= for_board ? address[30:RegBits] == '0
                                : address[30:rc_pkg::RegAddrBits] == '0;
    lines_there_q  <= count != '0 && !address[31] && beyond <= 32'(1 << LineBits)
                   && (kind == CheckLines || count <= 16'(LinesMost));
  end

  logic        executes, reads_again, bad_count;
  logic [2:0]  judged_result;
  logic [31:0] judged_value;

  assign executes    = judged_result == Done && !hello_q && !old_q;
  assign reads_again = judged_result == Done && old_q && session_q && kind == ReadLines;

  always_comb begin
    judged_result = Done;
    judged_value  = '0;
    if (hello_q) begin
      judged_value = address;
    end else if (!session_q) begin
      judged_result = NoSession;
    end else if (old_q) begin
      judged_result = stored_result;
      judged_value  = stored_value;
      if (kind == ReadLines && !lines_there_q) judged_result = BadAddress;
    end else if (!next_q) begin
      judged_result = Gap;
      judged_value  = 32'(expected_q);
    end else if (!kind_valid_q) begin
      judged_result = BadKind;
    end else if (for_register_q ? !register_q : !lines_there_q) begin
      judged_result = BadAddress;
    end
  end

  // ---- State machine.
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q   <= StMark0;
      session_q <= 1'b0;
    end else begin
      case (state_q)
        // Receive. After the first mark a byte of the same value may be the first mark instead.
        StMark0: if (takes && rx_data_i == Mark0) state_q <= StMark1;
        StMark1: if (takes && rx_data_i != Mark0) state_q <= rx_data_i == Mark1 ? StHead : StMark0;
        StHead:  if (takes && last) state_q <= StLength;
        StLength: begin
          state_q <= kind == WriteRegister || is_write ? StPayload : StCrc;
          if (bad_count) state_q <= StMark0;
        end
        StPayload: if (takes && last) state_q <= StCrc;
        StCrc:     if (takes && last) state_q <= StVerify;
        StVerify:  state_q <= crc_sound ? StJudge : StMark0;

        // Execute. A refused packet with the expected number has a result too, which is kept.
        StJudge: begin
          if (hello_q) session_q <= 1'b1;
          if (reads_again)         state_q <= StMemory;
          else if (executes)       state_q <= !for_register_q ? StMemory
                                            : for_board       ? StRegister : StBus;
          else if (session_q && next_q && !hello_q) state_q <= StStore;
          else                     state_q <= StAnswer;
        end
        StRegister: state_q <= StStore;
        StBus:      if (wb_ack_i || wb_err_i || bus_q == BusW'(BusCycles)) state_q <= StStore;
        StMemory:   state_q <= StBeats;
        StBeats:
          if (line_ends) state_q <= kind == CheckLines ? StLoad
                                  : lines_q == '0      ? StStore : StMemory;
        StLoad:     state_q <= StSum;
        StSum:      if (last) state_q <= lines_q == '0 ? StStore : StMemory;
        StStore:    state_q <= StAnswer;

        // Answer.
        StAnswer:    state_q <= StSendMark0;
        StSendMark0: if (sends) state_q <= StSendMark1;
        StSendMark1: if (sends) state_q <= StSendHead;
        StSendHead:  if (sends && last) state_q <= gives_lines ? StSendLines : StSendCrc;
        StSendLines: if (sends && last) state_q <= StSendCrc;
        StSendCrc:   if (sends && last) state_q <= StMark0;
        default:     state_q <= StMark0;
      endcase
      if (is_quiet) state_q <= StMark0;
    end
  end

  assign bad_count = is_write && (count == '0 || count > 16'(LinesMost));
  assign bad_o     = is_quiet || (state_q == StVerify && !crc_sound)
                  || (state_q == StLength && bad_count);

  // Expected sequence number: the next one, when the packet has a result.
  always_ff @(posedge clk_i) begin
    if ((state_q == StJudge && hello_q) || stores_result) expected_q <= sequence_number + 1'b1;
  end

  // Bytes of the part of the packet that comes next, and of a line's sum.
  logic [ByteW:0] payload;
  assign payload = (ByteW + 1)'({count, 6'd0});

  always_ff @(posedge clk_i) begin
    case (state_q)
      StMark1, StSendMark1: left_q <= (ByteW + 1)'(8);
      StLength:             left_q <= is_write ? payload : (ByteW + 1)'(4);
      StLoad:               left_q <= (ByteW + 1)'(64);
      default:
        if (takes || sends || state_q == StSum) begin
          if (!last)                                     left_q <= left_q - 1'b1;
          else if (state_q == StSendHead && gives_lines) left_q <= payload;
          else                                           left_q <= (ByteW + 1)'(4);
        end
    endcase
  end

  // Head and data of the packet, and its result.
  always_ff @(posedge clk_i) begin
    if (state_q == StHead && takes)    head_q <= {rx_data_i, head_q[63:8]};
    if (state_q == StPayload && takes) data_q <= {rx_data_i, data_q[31:8]};
    case (state_q)
      StJudge: begin
        replay_q <= old_q;
        result_q <= judged_result;
        value_q  <= judged_value;
      end
      StRegister: begin
        result_q <= reg_good_i ? Done : BadAddress;
        value_q  <= reg_good_i && !reg_write_o ? reg_data_i : '0;
      end
      StBus: begin
        result_q <= wb_ack_i ? Done : wb_err_i ? BusError : BusSilence;
        value_q  <= wb_ack_i && !wb_we_o ? wb_dat_i : '0;
      end
      StStore:  value_q <= replay_q ? value_q : value;
      default: ;
    endcase
  end

  // ---- Answer.
  logic [7:0] crc_part;

  always_ff @(posedge clk_i) begin
    if (state_q == StAnswer)
      out_q <= {result_q == Done ? count : 16'(result_q), value_q, sequence_number,
                1'b1, result_q != Done, kind[5:0]};
    else if (state_q == StSendHead && sends) out_q <= out_q >> 8;
  end

  always_comb begin
    case (left_q[1:0])   // four bytes to come down to one
      2'd0:    crc_part = crc[7:0];
      2'd3:    crc_part = crc[15:8];
      2'd2:    crc_part = crc[23:16];
      default: crc_part = crc[31:24];
    endcase
    case (state_q)
      StSendMark0: tx_data_o = Mark0;
      StSendMark1: tx_data_o = Mark1;
      StSendHead:  tx_data_o = out_q[7:0];
      StSendLines: tx_data_o = buffer_byte;
      default:     tx_data_o = crc_part;
    endcase
  end

  // ---- The chip's bus.
  assign wb_cyc_o = state_q == StBus;
  assign wb_stb_o = wb_cyc_o;
  assign wb_we_o  = kind == WriteRegister;
  assign wb_adr_o = address[rc_pkg::RegAddrBits-1:0];
  assign wb_dat_o = data_q;

  always_ff @(posedge clk_i) bus_q <= wb_cyc_o ? bus_q + 1'b1 : '0;

  // ---- The board's registers.
  assign reg_valid_o = state_q == StRegister;
  assign reg_write_o = kind == WriteRegister;
  assign reg_addr_o  = address[RegBits-1:0];
  assign reg_data_o  = data_q;

  // ---- Memory, line by line.
  assign host_req_valid_o = state_q == StBeats && !requested_q;
  assign host_req_write_o = is_write;
  assign host_req_addr_o  = line_q;
  assign host_wr_data_o   = buffer_word;

  always_ff @(posedge clk_i) begin
    requested_q <= state_q == StBeats && (requested_q || host_req_ready_i);
    if (state_q == StJudge) begin
      line_q  <= address[LineBits-1:0];
      lines_q <= count - 1'b1;
    end else if (state_q == StSum ? last : line_ends && kind != CheckLines) begin
      line_q  <= line_q + 1'b1;
      lines_q <= lines_q - 1'b1;
    end
  end
endmodule
`default_nettype wire
