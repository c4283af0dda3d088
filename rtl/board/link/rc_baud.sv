// Fractional divider of a UART: a phase accumulator that overflows once per bit on average.
//
// Each cycle with run_i adds Step to the phase; tick_o is high in the cycle of an overflow. So
// ticks are ClkKhz * 1000 / Baud cycles apart on average, and each is at most one cycle late.
// load_i sets the phase: to 0, or to half a bit with half_i. The elaboration refuses rates that the
// rounding of Step changes by more than 0.5 %.
`default_nettype none
module rc_baud #(
  parameter int unsigned ClkKhz = 75000,     // clock, in kHz
  parameter int unsigned Baud   = 3000000    // bits per second
) (
  input  logic clk_i,
  input  logic load_i,
  input  logic half_i,
  input  logic run_i,
  output logic tick_o
);
  // Bits of the phase. Step is Baud / clock with PhaseW bits of fraction, rounded to nearest.
  localparam int unsigned PhaseW = 20;
  localparam logic [63:0] ClkHz  = 64'(ClkKhz) * 1000;
  localparam logic [63:0] Scaled = (64'(Baud) << PhaseW) + ClkHz / 2;
  localparam int unsigned Step   = 32'(Scaled / ClkHz);

  if (64'(Baud) * 4 > ClkHz) begin : gen_refuse
    $error("rc_baud: a bit must last four cycles or more");
  end
  if (Step < 100) begin : gen_refuse_step
    $error("rc_baud: the clock is too fast for this rate");
  end

  logic [PhaseW-1:0] phase_q, sum;
  logic              carry;

  assign {carry, sum} = {1'b0, phase_q} + (PhaseW + 1)'(Step);
  assign tick_o       = run_i && carry;

  always_ff @(posedge clk_i) begin
    if (load_i)     phase_q <= {half_i, {(PhaseW - 1){1'b0}}};
    else if (run_i) phase_q <= sum;
  end
endmodule
`default_nettype wire
