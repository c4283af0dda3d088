// A stand-alone test bench of the chip rc_chip: a memory, a host on the bus, and a judge.
//
// It writes the frame's settings from registers.hex, starts the frame, and compares every pixel
// with pixels.hex. Then it reads the registers of the frame's account and compares them with
// counters.hex.
//
// The memory answers a request after MemLatency cycles and accepts one every MemInterval cycles.
// The sink accepts every pixel at once. The account holds for this timing. With +seed=N, N above 0,
// three times are random: the latency of each request, and so the order of the answers; the cycles
// in which the memory accepts a request; and the cycles in which the sink accepts a pixel of each
// pipeline. The pixels stay the same, and the bench skips the account. +nocounters also skips it,
// for another memory or for a chip without counters.
`default_nettype none
module rc_bench;
  // @settings@
  localparam int HitW  = rc_pkg::HitW;
  localparam int Ids   = 1 << rc_pkg::MemIdBits;
  localparam int Tries = 100;   // cycles before the bus must answer

  logic [511:0]     image    [0:Lines-1];       // memory.hex: one line of 64 bytes per word
  logic [47:0]      settings [0:Settings-1];    // registers.hex: address, value
  logic [HitW-1:0]  expected [0:Pixels-1];      // pixels.hex: hit_t with its context 0, row by row
  logic [63:0]      account  [0:Accounts-1];    // counters.hex: address, value

  logic clk, rst_n;
  initial clk = 1'b0;
  always #5 clk = !clk;

  // ---- The chip.
  logic                             cyc, we, ack, err;
  logic [rc_pkg::RegAddrBits-1:0]   adr;
  logic [31:0]                      dat_to_chip, dat_from_chip;
  logic                             req_valid, req_ready, rsp_fires, running, done;
  logic [rc_pkg::MemReqW-1:0]       req;
  logic [rc_pkg::MemRspW-1:0]       rsp;
  logic [rc_pkg::Pipelines-1:0]     hit_valid, hit_ready;
  logic [rc_pkg::Pipelines*HitW-1:0] hits;
  rc_chip u_chip (
    .clk_i(clk), .rst_ni(rst_n),
    .wb_cyc_i(cyc), .wb_stb_i(cyc), .wb_we_i(we), .wb_adr_i(adr), .wb_dat_i(dat_to_chip),
    .wb_dat_o(dat_from_chip), .wb_ack_o(ack), .wb_err_o(err),
    .mem_req_valid_o(req_valid), .mem_req_ready_i(req_ready), .mem_req_o(req),
    .mem_rsp_fires_i(rsp_fires), .mem_rsp_i(rsp),
    .hit_valid_o(hit_valid), .hit_ready_i(hit_ready), .hit_o(hits),
    .running_o(running), .done_o(done));

  // ---- Random numbers from a seed, equal in every simulator (xorshift, 32 bits).
  int          seed;
  logic        random;
  logic [31:0] chance;
  function automatic logic [31:0] next_chance(input logic [31:0] old);
    logic [31:0] a, b;
    a           = old ^ (old << 13);
    b           = a ^ (a >> 17);
    next_chance = b ^ (b << 5);
  endfunction
  initial begin
    if (!$value$plusargs("seed=%d", seed)) seed = 0;
    random = seed != 0;
    chance = 32'h9e3779b9 ^ seed;
    if (chance == 0) chance = 1;
  end
  always @(posedge clk) chance <= next_chance(chance);

  // ---- The memory: for each id the pending request, and the first cycle in which it may be
  // answered.
  localparam int AddrW = rc_pkg::AddrBits;
  localparam int IdW   = rc_pkg::MemIdBits;
  logic             waits [0:Ids-1];
  logic [AddrW-1:0] asked [0:Ids-1];
  logic [31:0]      due   [0:Ids-1];
  logic [31:0]      now, next_free, latency;
  logic [IdW-1:0]   id;
  logic             chosen;
  int               again, k;   // requests whose id is still pending
  always @(posedge clk) begin
    if (!rst_n) begin
      now       = 0;
      next_free = 0;
      again     = 0;
      req_ready <= 1'b1;
      rsp_fires <= 1'b0;
      rsp       <= '0;
      hit_ready <= '1;
      for (int i = 0; i < Ids; i++) waits[i] = 1'b0;
    end else begin
      if (req_valid && req_ready) begin
        id        = req[rc_pkg::MemReqW-1 -: IdW];
        latency   = MemLatency;
        // Usually adds up to 15 cycles, sometimes up to 255.
        if (random) latency = latency + (chance[10:8] == 0 ? 32'(chance[31:24]) : 32'(chance[3:0]));
        if (waits[id]) again = again + 1;
        waits[id] = 1'b1;
        asked[id] = req[AddrW-1:0];
        due[id]   = now + latency;
        next_free = now + MemInterval;
      end
      // Prepare the next cycle.
      now       = now + 1;
      req_ready <= random ? chance[12:11] != 0 : now >= next_free;
      for (int p = 0; p < rc_pkg::Pipelines; p++)
        hit_ready[p] <= !random || chance[(p + 4) % 32] != chance[(p + 20) % 32];
      rsp_fires <= 1'b0;
      chosen    = 1'b0;
      for (int i = 0; i < Ids; i++) begin
        k = (i + (random ? int'(chance[23:16]) : 0)) % Ids;
        if (!chosen && waits[k] && due[k] <= now) begin
          chosen    = 1'b1;
          waits[k]  = 1'b0;
          rsp_fires <= 1'b1;
          rsp       <= {IdW'(k), 32'(asked[k]) < Lines ? image[32'(asked[k])] : 512'd0};
        end
      end
    end
  end

  // ---- The judge of pixels.
  int          cycles, seen, wrong;
  logic [0:0]  given [0:Pixels-1];
  rc_pkg::hit_t hit;
  int          at;
  logic [rc_pkg::Pipelines-1:0]      held;
  logic [rc_pkg::Pipelines*HitW-1:0] held_hits;
  initial for (int i = 0; i < Pixels; i++) given[i] = 1'b0;
  always @(posedge clk) begin
    if (!rst_n) begin
      cycles = 0;
      seen   = 0;
      wrong  = 0;
      held   = '0;
    end else begin
      if (running) cycles = cycles + 1;
      // A pixel that was not accepted must not change.
      for (int p = 0; p < rc_pkg::Pipelines; p++)
        if (held[p] && (!hit_valid[p] || hits[p*HitW +: HitW] !== held_hits[p*HitW +: HitW])) begin
          if (wrong < 10) $display("pipeline %0d changes a pixel that it offers", p);
          wrong = wrong + 1;
        end
      held      = hit_valid & ~hit_ready;
      held_hits = hits;
      for (int p = 0; p < rc_pkg::Pipelines; p++) if (hit_valid[p] && hit_ready[p]) begin
        hit     = hits[p*HitW +: HitW];
        hit.ray = '0;   // the context number depends on memory timing
        at      = int'(hit.y) * Width + int'(hit.x);
        seen    = seen + 1;
        if (int'(hit.x) >= Width || int'(hit.y) >= Height) begin
          $display("pixel (%0d, %0d) lies outside the picture", hit.x, hit.y);
          wrong = wrong + 1;
        end else begin
          if (given[at]) begin
            $display("pixel (%0d, %0d) came for the second time", hit.x, hit.y);
            wrong = wrong + 1;
          end else if (hit !== expected[at]) begin
            if (wrong < 10) $display("pixel (%0d, %0d) is %h and should be %h", hit.x, hit.y, hit, expected[at]);
            wrong = wrong + 1;
          end
          given[at] = 1'b1;
        end
      end
    end
  end

  // ---- The host.
  logic [31:0] answer;
  logic        refused;
  task automatic access(input logic writes, input logic [rc_pkg::RegAddrBits-1:0] address,
                        input logic [31:0] value);
    int tries;
    @(negedge clk);
    cyc         = 1'b1;
    we          = writes;
    adr         = address;
    dat_to_chip = value;
    tries       = 0;
    @(negedge clk);
    while (!ack && !err && tries < Tries) begin
      tries = tries + 1;
      @(negedge clk);
    end
    answer  = dat_from_chip;
    refused = ack !== 1'b1;
    @(negedge clk);
    cyc = 1'b0;
    if (refused) begin
      $display("the bus refuses to %s register %h", writes ? "write" : "read", address);
      wrong = wrong + 1;
    end
  endtask

  task automatic read_account;
    logic [31:0] low;
    logic [rc_pkg::RegAddrBits-1:0] address;
    for (int i = 0; i < Accounts; i++) begin
      address = account[i][40 +: rc_pkg::RegAddrBits];
      access(1'b0, address, '0);
      low = answer;
      access(1'b0, address + 1'b1, '0);
      if ({answer[7:0], low} !== account[i][39:0]) begin
        $display("counter %h is %0d and should be %0d", address, {answer[7:0], low}, account[i][39:0]);
        wrong = wrong + 1;
      end
    end
  endtask

  task automatic check(input logic good, input string what);
    if (!good) begin
      $display("%s", what);
      wrong = wrong + 1;
    end
  endtask

  initial begin
    $readmemh("memory.hex", image);
    $readmemh("registers.hex", settings);
    $readmemh("pixels.hex", expected);
    $readmemh("counters.hex", account);
    cyc         = 1'b0;
    we          = 1'b0;
    adr         = '0;
    dat_to_chip = '0;
    rst_n       = 1'b0;
    repeat (ResetCycles) @(negedge clk);
    rst_n = 1'b1;
    repeat (32) @(negedge clk);   // the chip initialises itself for sixteen cycles

    access(1'b0, rc_pkg::RegAddrBits'(rc_pkg::RegMagic), '0);
    check(answer === rc_pkg::Magic, "the register magic does not say RCLK");
    for (int i = 0; i < Settings; i++) begin
      access(1'b1, settings[i][32 +: rc_pkg::RegAddrBits], settings[i][31:0]);
    end
    while (done !== 1'b1 && cycles < MostCycles && wrong < 100) @(negedge clk);
    check(done === 1'b1, "the frame does not end");
    repeat (4) @(negedge clk);
    check(seen == Pixels, "not every pixel came");
    check(again == 0, "a request has the id of one that is not answered yet");
    if (!random && !$test$plusargs("nocounters")) begin
      check(cycles == Cycles, "the frame took another number of cycles");
      read_account();
    end
    if (wrong == 0) begin
      $display("PASS: %0d pixels, %0d cycles", seen, cycles);
      $finish;
    end else begin
      $display("FAIL: %0d differences; %0d pixels, %0d cycles, %0d expected", wrong, seen, cycles, Cycles);
      $fatal(1);
    end
  end
endmodule
`default_nettype wire
