// Credit counter: admits a request into a pipeline without stalls only if the result queue has room
// for its answer.
//
// A request is in flight from admit_i until the consumer accepts its answer (leave_i); at most
// Credits are. With Cut open_o is a register, because an admission often enables hundreds of
// registers. No cycle changes. The user must not set admit_i while open_o is 0. Proof:
// tests/formal/credit_counter.sv.
`default_nettype none
module rc_credit_counter #(
  parameter  int unsigned Credits = 4,
  parameter  int unsigned Cut     = rc_pkg::PathCut,
  localparam int unsigned CountW  = $clog2(Credits + 1)
) (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic admit_i,   // a request enters this cycle
  input  logic leave_i,   // an answer leaves this cycle
  output logic open_o
);
  if (Credits < 1) begin : gen_refuse
    $error("rc_credit_counter: Credits must be at least 1");
  end

  localparam logic [CountW-1:0] Full = CountW'(Credits);
  logic [CountW-1:0] in_flight_q;

  // Gate: open while a credit is left.
  if (Cut == 0) begin : gen_compared
    assign open_o = in_flight_q != Full;
  end else begin : gen_register
    logic open_q, last;

    assign open_o = open_q;
    assign last   = in_flight_q == Full - 1'b1;

    always_ff @(posedge clk_i) begin
      if (!rst_ni) open_q <= 1'b1;
      else         open_q <= leave_i || (open_q && !(admit_i && last));
    end
  end

  // Requests in flight.
  always_ff @(posedge clk_i) begin
    if (!rst_ni) in_flight_q <= '0;
    else if (admit_i && !leave_i) in_flight_q <= in_flight_q + 1'b1;
    else if (leave_i && !admit_i) in_flight_q <= in_flight_q - 1'b1;
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni && admit_i) a_admit_if_open: assert (open_o)
    else $error("a request came without a credit");
  always_ff @(posedge clk_i) if (rst_ni && leave_i)
    a_leave_if_inside: assert (in_flight_q != '0)
    else $error("an answer left without a request");
`endif
endmodule
`default_nettype wire
