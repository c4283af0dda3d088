// Properties of rc_gather, if a sequence starts only when the line is empty, and offers at most
// total_i items:
// - an offered line stays until it is accepted, and no item is accepted meanwhile;
// - a line is offered exactly when it is full or has the last item;
// - the items of the accepted lines are those that came: none is lost, none comes twice, and each
//   lies in its place with its data; behind the last one the line is 0.
//
// The proof follows one place of the line, which is arbitrary: `place_i` is constant.
module gather #(
  parameter  int unsigned Records   = 4,
  parameter  int unsigned Width     = 2,
  parameter  int unsigned TotalBits = 4,
  localparam int unsigned CountW    = $clog2(Records + 1)
) (
  input logic                 clk_i,
  input logic                 rst_ni,
  input logic                 start_i,
  input logic [TotalBits-1:0] total_i,
  input logic                 valid_i,
  input logic [Width-1:0]     data_i,
  input logic                 line_ready_i,
  input logic [CountW-1:0]    place_i
);
  logic                     ready_o, line_valid_o;
  logic [Records*Width-1:0] line_o;
  logic [Records-1:0]       accepted_o;
  rc_gather #(.Records(Records), .Width(Width), .TotalBits(TotalBits)) u_dut (
    .clk_i(clk_i), .rst_ni(rst_ni), .start_i(start_i), .total_i(total_i), .valid_i(valid_i),
    .ready_o(ready_o), .data_i(data_i), .line_valid_o(line_valid_o), .line_ready_i(line_ready_i),
    .line_o(line_o), .accepted_o(accepted_o));
  (* hierconn *) wire [CountW-1:0]    \u_dut.count_q ;
  (* hierconn *) wire [TotalBits-1:0] \u_dut.left_q ;

  logic begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  // ---- What should be the case: items in the line, items to come, and the followed place.
  logic                 started_q;
  logic [CountW-1:0]    items_q, place_q;
  logic [TotalBits-1:0] left_q;
  logic [Width-1:0]     data_q;
  logic                 goes, line_goes;
  assign goes      = valid_i && ready_o;
  assign line_goes = line_valid_o && line_ready_i;
  always @(posedge clk_i) begin
    place_q <= place_i;
    if (!rst_ni) begin
      started_q <= 1'b0;
      items_q   <= '0;
      left_q    <= '0;
      data_q    <= '0;
    end else if (start_i) begin
      started_q <= 1'b1;
      items_q   <= '0;
      left_q    <= total_i;
      data_q    <= '0;
    end else begin
      items_q <= line_goes ? '0 : items_q + goes;
      left_q  <= left_q - goes;
      data_q  <= line_goes ? '0 : goes && items_q == place_i ? data_i : data_q;
    end
  end
  always @* if (begun_q) assume (place_i < Records && (place_i == place_q || !rst_ni));
  always @* if (rst_ni) begin
    assume (!start_i || (items_q == '0 && !valid_i));
    assume (!valid_i || (started_q && left_q != '0));
  end

  logic                     stalled_q;
  logic [Records*Width-1:0] line_q;
  always @(posedge clk_i) begin
    stalled_q <= rst_ni && line_valid_o && !line_ready_i;
    line_q    <= line_o;
  end

  always @* if (begun_q && rst_ni) begin
    a_stays:  assert (!stalled_q || (line_valid_o && line_o == line_q));
    a_ready:  assert (ready_o == !line_valid_o);
    a_most:   assert (items_q <= Records);
    if (started_q) begin
      a_offer:  assert (line_valid_o == (items_q == Records || (items_q != '0 && left_q == '0)));
      a_count:  assert (\u_dut.count_q == items_q && \u_dut.left_q == left_q);
      a_data:   assert (line_o[place_i*Width +: Width] == data_q);
      a_empty:  assert (items_q > place_i || data_q == '0);
      a_leaves: assert (accepted_o[place_i] == (line_goes && items_q > place_i));
    end else begin
      a_idle:   assert (!line_valid_o);
    end
  end
endmodule
