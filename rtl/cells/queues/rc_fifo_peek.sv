// First-in first-out queue of Depth entries that also reports its next head. Depth is a power of
// two, at least 2. Latency 1.
//
// ready_o and valid_o come from registers only, so the queue cuts every combinational path between
// its sides. With Cut the head entry, ready_o and valid_o are registers themselves: a unit that
// reads its own memories by the head has the whole cycle. No cycle changes.
//
// With Cut the queue also reports which entry comes to the head at the end of a cycle. Block RAM is
// read with that address (rc_ram_prefetch). With Second the entry after the head is in a register,
// for a user that selects one of many items by the next head.
//
// Model: model/core/ring.hpp (Ring). Proof: tests/formal/fifo.sv.
`default_nettype none
module rc_fifo_peek #(
  parameter  int unsigned Width  = 1,
  parameter  int unsigned Depth  = 4,
  parameter  int unsigned Cut    = rc_pkg::PathCut,
  parameter  bit          Second = 0,
  localparam int unsigned IndexW = $clog2(Depth)
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  // Input
  input  logic             valid_i,
  output logic             ready_o,
  input  logic [Width-1:0] data_i,
  // Output
  output logic             valid_o,
  input  logic             ready_i,
  output logic [Width-1:0] data_o,
  // With Cut: an entry comes to the head at the end of this cycle, and its value
  output logic             next_fires_o,
  output logic [Width-1:0] next_o
);
  if (Width < 1) begin : gen_refuse
    $error("rc_fifo_peek: Width must be at least 1");
  end
  if (Depth < 2 || (Depth & (Depth - 1)) != 0) begin : gen_refuse_depth
    $error("rc_fifo_peek: Depth must be a power of two, at least 2");
  end

  logic [Width-1:0] mem [Depth];
  logic [IndexW:0]  head_q, tail_q;  // one wrap bit above the index

  if (Cut == 0) begin : gen_at_once
    assign valid_o = head_q != tail_q;
    assign ready_o = head_q != {~tail_q[IndexW], tail_q[IndexW-1:0]};
    assign data_o  = mem[head_q[IndexW-1:0]];
    assign {next_fires_o, next_o} = '0;
  end else begin : gen_ahead
    // The next head comes from the memory, or from the input if the memory holds no other entry.
    // many_q (at least two entries) is a register, because it has hundreds of loads.
    logic             valid_q, ready_q, many_q, more, third, one_place, comes, goes;
    logic [IndexW:0]  next_q, after;
    logic [Width-1:0] data_q, second;

    assign after     = tail_q + 1'b1;
    assign more      = many_q;
    assign third     = many_q && next_q + 1'b1 != tail_q;
    assign comes     = valid_i && ready_q;
    assign goes      = valid_q && ready_i;
    assign one_place = after == {~head_q[IndexW], head_q[IndexW-1:0]};

    assign valid_o   = valid_q;
    assign ready_o   = ready_q;
    assign data_o    = data_q;

    // Next head.
    assign next_o       = more ? second : data_i;
    assign next_fires_o = (!valid_q || ready_i) && (more || comes);

    // Entry after the head: a register with Second, otherwise read from the memory.
    if (Second) begin : gen_second
      logic [IndexW-1:0] following;
      logic [Width-1:0]  second_q;
      assign following = next_q[IndexW-1:0] + 1'b1;
      always_ff @(posedge clk_i) if (goes || !many_q) second_q <= third ? mem[following] : data_i;
      assign second = second_q;
    end else begin : gen_read
      assign second = mem[next_q[IndexW-1:0]];
    end

    always_ff @(posedge clk_i) begin
      if (!rst_ni) begin
        valid_q <= 1'b0;
        ready_q <= 1'b1;
        many_q  <= 1'b0;
        next_q  <= (IndexW+1)'(1);
      end else begin
        valid_q <= (valid_q && !ready_i) || more || comes;
        ready_q <= goes || (ready_q && !(valid_i && one_place));
        many_q  <= goes ? (comes ? many_q : third) : many_q || (comes && valid_q);
        if (goes) next_q <= next_q + 1'b1;
      end
      if (!valid_q || ready_i) data_q <= next_o;
    end
  end

  // Memory and its pointers.
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      head_q <= '0;
      tail_q <= '0;
    end else begin
      if (valid_o && ready_i) head_q <= head_q + 1'b1;
      if (valid_i && ready_o) tail_q <= tail_q + 1'b1;
    end
    if (valid_i && ready_o) mem[tail_q[IndexW-1:0]] <= data_i;
  end
endmodule
`default_nettype wire
