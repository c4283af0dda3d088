// A stand-alone test bench of the chip rc_chip: a memory, a host on the bus, and a judge.
//
// It programs the frame as registers.hex says, starts it, and compares every pixel with
// pixels.hex. Then it reads the registers of the frame's account, and compares them with
// counters.hex. The memory answers a request after MemLatency cycles, and takes one every
// MemInterval cycles: the account is for that memory. +nocounters leaves the account out,
// for another memory, or for a chip without counters.
`default_nettype none
module rc_bench;
  // @settings@
  localparam int HitW  = rc_pkg::HitW;
  localparam int Ids   = 1 << rc_pkg::MemIdBits;
  localparam int Tries = 100;   // cycles until the bus must have answered

  logic [511:0]     image    [0:Lines-1];       // memory.hex: a line of 64 bytes each
  logic [47:0]      settings [0:Settings-1];    // registers.hex: address, value
  logic [HitW-1:0]  expected [0:Pixels-1];      // pixels.hex: hit_t with its context 0, row by row
  logic [63:0]      account  [0:Accounts-1];    // counters.hex: address, value

  logic clk, rst_n;
  initial clk = 1'b0;
  always #5 clk = !clk;

  // ---- The chip.
  logic                             cyc, we, ack, err;
  logic [12:0]                      adr;
  logic [31:0]                      dat_to_chip, dat_from_chip;
  logic                             req_valid, req_ready, rsp_fires, running, done;
  logic [rc_pkg::MemReqW-1:0]       req;
  logic [rc_pkg::MemRspW-1:0]       rsp;
  logic [rc_pkg::Pipelines-1:0]     hit_valid;
  logic [rc_pkg::Pipelines*HitW-1:0] hits;
  rc_chip u_chip (
    .clk_i(clk), .rst_ni(rst_n),
    .wb_cyc_i(cyc), .wb_stb_i(cyc), .wb_we_i(we), .wb_adr_i(adr), .wb_dat_i(dat_to_chip),
    .wb_dat_o(dat_from_chip), .wb_ack_o(ack), .wb_err_o(err),
    .mem_req_valid_o(req_valid), .mem_req_ready_i(req_ready), .mem_req_o(req),
    .mem_rsp_fires_i(rsp_fires), .mem_rsp_i(rsp),
    .hit_valid_o(hit_valid), .hit_ready_i({rc_pkg::Pipelines{1'b1}}), .hit_o(hits),
    .running_o(running), .done_o(done));

  // ---- The memory: requests in a ring, each with the cycle in which it is answered.
  localparam int AddrW = rc_pkg::AddrBits;
  logic [rc_pkg::MemReqW-1:0] asked [0:Ids-1];
  logic [31:0]                due   [0:Ids-1];
  logic [31:0]                now, next_free, head, tail, from;
  assign req_ready = now >= next_free;
  assign rsp_fires = head != tail && due[head % Ids] <= now;
  assign from      = 32'(asked[head % Ids][AddrW-1:0]);
  assign rsp       = {asked[head % Ids][rc_pkg::MemReqW-1:AddrW], from < Lines ? image[from] : 512'd0};
  always @(posedge clk) begin
    if (!rst_n) begin
      now       <= 0;
      next_free <= 0;
      head      <= 0;
      tail      <= 0;
    end else begin
      now <= now + 1;
      if (rsp_fires) head <= head + 1;
      if (req_valid && req_ready) begin
        asked[tail % Ids] <= req;
        due[tail % Ids]   <= now + MemLatency;
        tail              <= tail + 1;
        next_free         <= now + MemInterval;
      end
    end
  end

  // ---- The judge of pixels.
  int          cycles, seen, wrong;
  logic [0:0]  given [0:Pixels-1];
  rc_pkg::hit_t hit;
  int          at;
  initial for (int i = 0; i < Pixels; i++) given[i] = 1'b0;
  always @(posedge clk) begin
    if (!rst_n) begin
      cycles = 0;
      seen   = 0;
      wrong  = 0;
    end else begin
      if (running) cycles = cycles + 1;
      for (int p = 0; p < rc_pkg::Pipelines; p++) if (hit_valid[p]) begin
        hit     = hits[p*HitW +: HitW];
        hit.ray = '0;   // which context made it hangs on the memory
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
  task automatic access(input logic writes, input logic [12:0] address, input logic [31:0] value);
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
    logic [12:0] address;
    for (int i = 0; i < Accounts; i++) begin
      address = account[i][52:40];
      access(1'b0, address, '0);
      low = answer;
      access(1'b0, address + 13'd1, '0);
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
    repeat (32) @(negedge clk);   // it prepares itself for sixteen cycles

    access(1'b0, 13'(rc_pkg::RegMagic), '0);
    check(answer === rc_pkg::Magic, "the register magic does not say RCLK");
    for (int i = 0; i < Settings; i++) access(1'b1, settings[i][44:32], settings[i][31:0]);
    while (done !== 1'b1 && cycles < MostCycles && wrong < 100) @(negedge clk);
    check(done === 1'b1, "the frame does not end");
    repeat (4) @(negedge clk);
    check(seen == Pixels, "not every pixel came");
    if (!$test$plusargs("nocounters")) begin
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
