// The chip's host interface: registers on a Wishbone B4 bus (classic cycles, 32 bits, word
// addresses). docs/machine/chip.md describes the registers bit by bit; sim/run/gen/registers.hpp
// lists them.
//
// Every access is answered two cycles after it is seen: with ack, or with err. err means that the
// register does not exist or is not accessible now. An access that ends in err changes nothing.
//
// A start first clears the counters and computes the number of pixels, in sixteen cycles, as after
// a reset. start_o is high for one cycle; the next cycle is the frame's cycle 0. The frame ends
// with the cycle in which its last answer leaves the chip.
`default_nettype none
module rc_host #(
  parameter int unsigned Counters = 1
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  // Bus
  input  logic                         wb_cyc_i,
  input  logic                         wb_stb_i,
  input  logic                         wb_we_i,
  input  logic [rc_pkg::RegAddrBits-1:0] wb_adr_i,
  input  logic [31:0]                  wb_dat_i,
  output logic [31:0]                  wb_dat_o,
  output logic                         wb_ack_o,
  output logic                         wb_err_o,
  // To and from the machine
  output logic                         start_o,
  output rc_pkg::frame_t               frame_o,
  input  logic [rc_pkg::MostAnswers-1:0] hit_fires_i,   // one bit for each answer that leaves
  // To and from the counters
  output logic                         count_o,     // this cycle is counted
  output logic                         clear_o,     // clears the selected counter of all units
  output logic [rc_pkg::CounterNumberBits-1:0] counter_o,   // the selected counter
  input  logic                         counter_there_i,
  input  logic [rc_pkg::CounterBits-1:0] counter_i,
  // Status, for pins
  output logic                         running_o,   // this cycle belongs to a frame
  output logic                         done_o       // a frame has ended and none was started since
);
  localparam int unsigned CounterBits = rc_pkg::CounterBits;
  localparam int unsigned SideW       = rc_pkg::PixelBits + 1;  // side of a picture
  localparam int unsigned FrameWords  = rc_pkg::FrameWords;
  localparam int unsigned AddrW       = rc_pkg::RegAddrBits;
  localparam int unsigned CounterW    = rc_pkg::CounterNumberBits;

  // ---- Bus access: its registers hold the address and the data until the answer.
  logic        accepted_q, ack_q, err_q, we_q, req_valid, fires, writes, good;
  logic [AddrW-1:0] adr_q;
  logic [31:0] dat_q, read, read_q;

  assign req_valid = wb_cyc_i && wb_stb_i && !accepted_q && !ack_q && !err_q;
  assign fires     = accepted_q && wb_cyc_i && wb_stb_i;
  assign writes    = fires && we_q && good;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) {accepted_q, ack_q, err_q} <= '0;
    else         {accepted_q, ack_q, err_q} <= {req_valid, fires && good, fires && !good};
    if (req_valid) begin
      we_q  <= wb_we_i;
      adr_q <= wb_adr_i;
      dat_q <= wb_dat_i;
    end
    if (fires) read_q <= we_q ? '0 : read;
  end

  assign wb_ack_o = ack_q;
  assign wb_err_o = err_q;
  assign wb_dat_o = read_q;

  // ---- Frame.
  typedef enum logic [1:0] {StPrepare, StIdle, StStart, StRun} state_e;
  state_e       state_q;
  logic         start_pending_q, done_q, start_q, goes, ends, is_idle;
  logic [3:0]   step_q;
  logic [31:0]  left_q, left_less;   // pixels
  logic         some_q;              // there are pixels
  logic [3:0]   hits;
  logic [31:0]  prepared;            // left_q after a step of the preparation
  logic         has_some;

  assign is_idle = state_q == StIdle;
  assign goes    = writes && adr_q == AddrW'(rc_pkg::RegStart) && dat_q[0];
  assign start_o = start_q;   // in StStart, if there are pixels
  assign ends    = state_q == StStart ? !some_q : state_q == StRun && left_q == 32'(hits);

  always_comb begin
    hits = '0;
    for (int k = 0; k < rc_pkg::MostAnswers; k++) hits = hits + 4'(hit_fires_i[k]);
  end

  assign left_less = left_q - 32'(hits);

  // State machine. StPrepare computes width * height bit by bit, from the top bit of the height.
  // With a stream it loads ray_count instead.
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q         <= StPrepare;
      start_pending_q <= 1'b0;
      done_q          <= 1'b0;
      step_q          <= '0;
      left_q          <= '0;
    end else begin
      if (state_q == StPrepare) begin
        step_q <= step_q + 1'b1;
        if (start_pending_q) left_q <= prepared;
        if (step_q == '1) state_q <= start_pending_q ? StStart : StIdle;
      end else if (state_q == StIdle) begin
        start_pending_q <= goes;
        if (goes) begin
          state_q <= StPrepare;
          done_q  <= 1'b0;
        end
      end else begin
        if (state_q == StRun) left_q <= left_less;
        state_q <= ends ? StIdle : StRun;
        done_q  <= ends;
      end
    end
  end

  always_ff @(posedge clk_i)
    start_q <= rst_ni && state_q == StPrepare && step_q == '1 && start_pending_q && some_q;
  always_ff @(posedge clk_i) begin   // the frame does not change in StPrepare
    some_q <= has_some;
  end

  if (rc_pkg::IsStream) begin : gen_rays
    assign has_some = frame_o.ray_count != '0;
    assign prepared = 32'(frame_o.ray_count);
  end else begin : gen_picture
    logic [15:0] rest_q;   // remaining bits of the height, top bit first

    always_ff @(posedge clk_i)
      rest_q <= state_q == StPrepare ? rest_q << 1 : {{(16-SideW){1'b0}}, frame_o.height};

    assign has_some = frame_o.width != '0 && frame_o.height != '0;
    assign prepared = (left_q << 1) + (rest_q[15] ? 32'(frame_o.width) : '0);
  end

  assign running_o = state_q == StRun;
  assign done_o    = done_q;

  // Frame registers. In a simulation the words are clocked only during an access of the bus. On
  // silicon they are clocked in every cycle.
`ifdef SYNTHESIS
  localparam bit Chip = 1'b1;
`else
  localparam bit Chip = 1'b0;
`endif

  logic [rc_pkg::FrameW-1:0] frame_q;
  assign frame_o = frame_q;

  for (genvar w = 0; w < FrameWords; w++) begin : gen_word
    localparam int unsigned At   = 32'(rc_pkg::FrameAt[16*w +: 16]);
    localparam int unsigned Bits = 32'(rc_pkg::FrameBits[16*w +: 16]);

    // The word is written one cycle after the access, when dat_q still holds it. A start can come
    // only after that.
    logic write_q;
    always_ff @(posedge clk_i) begin
      if (Chip || fires || write_q) begin
        write_q <= fires && we_q && is_idle && adr_q == AddrW'(rc_pkg::RegFrame + w);
        if (write_q) frame_q[At +: Bits] <= dat_q[Bits-1:0];
      end
    end
  end

  // ---- Counters.
  logic                 counts_q;   // the host enables counting
  logic [CounterBits-1:0] cycles_q;
  logic [31:0]          high_q;  // upper word of cycles_q at the time of the read of its lower word

  assign count_o = Counters != 0 && running_o && counts_q;
  assign clear_o = Counters != 0 && state_q == StPrepare;

  // A counter's address ends in {group, number, code} and the bit that selects its upper word.
  logic                of_counter, upper_word;
  logic [CounterW-1:0] counter;

  assign of_counter            = adr_q >= AddrW'(rc_pkg::RegCounters);
  assign {counter, upper_word} = (CounterW + 1)'(adr_q);
  assign counter_o             = clear_o ? CounterW'(step_q[rc_pkg::CauseBits-1:0]) : counter;

  always_ff @(posedge clk_i) begin
    if (!rst_ni)                                             counts_q <= 1'b1;
    else if (writes && adr_q == AddrW'(rc_pkg::RegCount))    counts_q <= dat_q[0];
    if (state_q == StPrepare)                                cycles_q <= '0;
    else if (running_o && counts_q)                          cycles_q <= cycles_q + 1'b1;
    if (fires && !we_q && adr_q == AddrW'(rc_pkg::RegCycles)) high_q   <= 32'(cycles_q >> 32);
  end

  // ---- Read and write access.
  logic still;      // nothing is counted in this cycle or was in the last
  logic was_counting_q;

  always_ff @(posedge clk_i) was_counting_q <= count_o;
  assign still = !count_o && !was_counting_q && state_q != StPrepare;

  logic [AddrW-1:0] frame_word, parameter_word;

  assign frame_word     = adr_q - AddrW'(rc_pkg::RegFrame);
  assign parameter_word = adr_q - AddrW'(rc_pkg::RegParameters);

  always_comb begin
    read = '0;
    good = 1'b0;
    if (we_q) begin
      good = adr_q == AddrW'(rc_pkg::RegCount)
          || (is_idle && (adr_q == AddrW'(rc_pkg::RegStart) || frame_word < AddrW'(FrameWords)));
    end else if (of_counter) begin
      read = upper_word ? 32'(counter_i >> 32) : counter_i[31:0];
      good = Counters != 0 && still && counter_there_i;
    end else if (parameter_word < AddrW'(rc_pkg::Parameters)) begin
      read = rc_pkg::ParameterValues[32*parameter_word[4:0] +: 32];
      good = 1'b1;
    end else begin
      good = 1'b1;
      case (adr_q)
        AddrW'(rc_pkg::RegMagic):      read = rc_pkg::Magic;
        AddrW'(rc_pkg::RegVersion):    read = rc_pkg::Version;
        AddrW'(rc_pkg::RegStatus):     read = {30'd0, done_q, !is_idle};
        AddrW'(rc_pkg::RegCount):      read = {30'd0, Counters != 0, counts_q};
        AddrW'(rc_pkg::RegLeft):       read = left_q;
        AddrW'(rc_pkg::RegCycles):     read = cycles_q[31:0];
        AddrW'(rc_pkg::RegCycles + 1): read = high_q;
        default:                    good = 1'b0;
      endcase
    end
  end

  logic unused;
  assign unused = ^dat_q;   // the widest word of the frame may be narrower
endmodule
`default_nettype wire
