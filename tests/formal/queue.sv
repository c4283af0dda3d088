// Properties of rc_queue, if it never gets more than Depth entries: those of rc_fifo (fifo.sv), and
// it accepts every push. Depth may be 1.
module queue #(
  parameter  int unsigned Depth  = 4,
  parameter  int unsigned Width  = 2,
  localparam int unsigned Places = Depth < 2 ? 2 : Depth,
  localparam int unsigned IndexW = $clog2(Places)
) (
  input logic             clk_i,
  input logic             rst_ni,
  input logic             push_i,
  input logic [Width-1:0] data_i,
  input logic             pop_i,
  input logic             pick_i
);
  logic             valid_o;
  logic [Width-1:0] data_o;
  rc_queue #(.Width(Width), .Depth(Depth)) u_dut (
    .clk_i(clk_i), .rst_ni(rst_ni), .push_i(push_i), .data_i(data_i), .valid_o(valid_o),
    .pop_i(pop_i), .data_o(data_o));
  (* hierconn *) wire            \u_dut.ready ;
  (* hierconn *) wire [IndexW:0] \u_dut.u_fifo.u_fifo.head_q ;
  (* hierconn *) wire [IndexW:0] \u_dut.u_fifo.u_fifo.tail_q ;
  (* hierconn *) wire [Width-1:0] \u_dut.u_fifo.u_fifo.mem[0] , \u_dut.u_fifo.u_fifo.mem[1] ;
`ifdef Depth_4
  (* hierconn *) wire [Width-1:0] \u_dut.u_fifo.u_fifo.mem[2] , \u_dut.u_fifo.u_fifo.mem[3] ;
`else
  wire [Width-1:0] \u_dut.u_fifo.u_fifo.mem[2] = '0, \u_dut.u_fifo.u_fifo.mem[3] = '0;
`endif

  logic begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  logic             follows_q;
  logic [IndexW:0]  count_q, ahead_q, inside;
  logic [Width-1:0] token_q;
  assign inside = \u_dut.u_fifo.u_fifo.tail_q - \u_dut.u_fifo.u_fifo.head_q ;
  always @* if (rst_ni) begin
    assume (!push_i || count_q < Depth);
    assume (!pop_i || valid_o);
  end
  always @(posedge clk_i) begin
    if (!rst_ni) begin
      count_q   <= '0;
      follows_q <= 1'b0;
    end else begin
      count_q <= count_q + push_i - pop_i;
      if (!follows_q && push_i && pick_i) begin
        follows_q <= 1'b1;
        ahead_q   <= count_q - pop_i;
        token_q   <= data_i;
      end else if (follows_q && pop_i) begin
        if (ahead_q == '0) follows_q <= 1'b0;
        ahead_q <= ahead_q - 1'b1;
      end
    end
  end

  logic [IndexW-1:0]  place;
  logic [4*Width-1:0] all;
  logic [Width-1:0]   kept;
  assign place = \u_dut.u_fifo.u_fifo.head_q [IndexW-1:0] + ahead_q[IndexW-1:0];
  assign all   = {\u_dut.u_fifo.u_fifo.mem[3] , \u_dut.u_fifo.u_fifo.mem[2] ,
      \u_dut.u_fifo.u_fifo.mem[1] , \u_dut.u_fifo.u_fifo.mem[0] };
  assign kept  = all[place*Width +: Width];

  always @* if (begun_q && rst_ni) begin
    a_count: assert (count_q <= Depth && count_q == inside);
    a_place: assert (!push_i || \u_dut.ready );
    a_valid: assert (valid_o == (count_q != '0));
    a_ahead: assert (!follows_q || ahead_q < count_q);
    a_kept:  assert (!follows_q || kept == token_q);
    a_token: assert (!follows_q || ahead_q != '0 || data_o == token_q);
  end
endmodule
