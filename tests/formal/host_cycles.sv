// Property of the register `cycles` of rc_host: a read of its lower word returns the number of
// cycles since the frame was prepared, modulo 2^32. The next read of its upper word returns the
// upper bits of the same number, however far the count has advanced since.
//
// A frame of 2^32 cycles is too long for a run from reset. So a trace begins in any state, with any
// count; only the bus is idle for the first two cycles. A master holds its request until it is
// answered.
module host_cycles (
  input logic                         clk_i,
  input logic                         rst_ni,
  input logic                         wb_cyc_i,
  input logic                         wb_we_i,
  input logic [rc_pkg::RegAddrBits-1:0] wb_adr_i,
  input logic [31:0]                  wb_dat_i,
  input logic [rc_pkg::Pipelines-1:0] hit_fires_i
);
  localparam int unsigned CounterBits = rc_pkg::CounterBits;
  logic [31:0] wb_dat_o;
  logic        wb_ack_o, wb_err_o, count_o, clear_o;
  rc_host u_dut (
    .clk_i(clk_i), .rst_ni(rst_ni), .wb_cyc_i(wb_cyc_i), .wb_stb_i(wb_cyc_i), .wb_we_i(wb_we_i),
    .wb_adr_i(wb_adr_i),
    .wb_dat_i(wb_dat_i), .wb_dat_o(wb_dat_o), .wb_ack_o(wb_ack_o), .wb_err_o(wb_err_o),
    .hit_fires_i(hit_fires_i),
    .count_o(count_o), .clear_o(clear_o), .counter_there_i(1'b0), .counter_i('0));

  // ---- The master.
  logic [1:0]  begun_q = 2'd0;   // cycles since the trace began, at most 2
  logic        cyc_q, we_q, answered_q;
  logic [rc_pkg::RegAddrBits-1:0] adr_q;
  always @(posedge clk_i) begin
    if (begun_q != 2'd2) begun_q <= begun_q + 1'b1;
    {cyc_q, we_q, adr_q} <= {wb_cyc_i, wb_we_i, wb_adr_i};
    answered_q           <= wb_ack_o || wb_err_o;
  end
  always @* begin
    assume (rst_ni);
    assume (begun_q == 2'd2 || !wb_cyc_i);
    assume (begun_q == 2'd0 || !cyc_q || answered_q ||
        {wb_cyc_i, wb_we_i, wb_adr_i} == {1'b1, we_q, adr_q});
  end

  // ---- What should be the case: the count now and a cycle ago, and what its lower word was read
  // with.
  logic [CounterBits-1:0] count_q, before_q, read_q;
  logic                 some_q = 1'b0;   // it was read
  logic                 reads_low, reads_high;
  assign reads_low  = wb_ack_o && !wb_we_i && wb_adr_i == rc_pkg::RegAddrBits'(rc_pkg::RegCycles);
  assign reads_high = wb_ack_o && !wb_we_i &&
      wb_adr_i == rc_pkg::RegAddrBits'(rc_pkg::RegCycles + 1);
  always @(posedge clk_i) begin
    count_q  <= clear_o ? '0 : count_q + {{(CounterBits-1){1'b0}}, count_o};
    before_q <= count_q;
    if (reads_low && begun_q == 2'd2) begin
      some_q <= 1'b1;
      read_q <= before_q;
    end
  end
  (* hierconn *) wire [CounterBits-1:0] \u_dut.cycles_q ;
  always @* assume (begun_q != 2'd0 || count_q == \u_dut.cycles_q );
  always @* if (begun_q == 2'd2) begin
    a_low:  assert (!reads_low || wb_dat_o == before_q[31:0]);
    a_high: assert (!reads_high || !some_q ||
        wb_dat_o == {{(64-CounterBits){1'b0}}, read_q[CounterBits-1:32]});
  end

  // ---- Ties to the inside, as an induction needs them.
  (* hierconn *) wire [31:0] \u_dut.high_q ;
  (* hierconn *) wire        \u_dut.accepted_q ;
  (* hierconn *) wire [rc_pkg::RegAddrBits-1:0] \u_dut.adr_q ;
  (* hierconn *) wire        \u_dut.we_q ;
  always @* begin
    t_same:   assert (begun_q == 2'd0 || count_q == \u_dut.cycles_q );
    t_begun:  assert (begun_q == 2'd2 || !some_q);
    t_access: assert (begun_q != 2'd2 || !(\u_dut.accepted_q || wb_ack_o) ||
                      (cyc_q && !answered_q && \u_dut.adr_q == adr_q && \u_dut.we_q == we_q));
    t_high:   assert (begun_q != 2'd2 || !some_q || reads_low ||
        \u_dut.high_q == {{(64-CounterBits){1'b0}}, read_q[CounterBits-1:32]});
  end
endmodule
