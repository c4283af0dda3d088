// An array of Flags flags in registers: one port sets a flag and another clears a flag, in the same
// cycle. If both address one flag, the set wins. Reset clears all flags. A change is visible in the
// next cycle.
//
// In a fast chip each flag compares both addresses with its own number, because Yosys turns an
// indexed write into a shifter. A relaxed chip uses the index, which simulates many times faster.
`default_nettype none
module rc_flags #(
  parameter  int unsigned Flags  = 2,
  localparam int unsigned IndexW = Flags < 2 ? 1 : $clog2(Flags)
) (
  input  logic              clk_i,
  input  logic              rst_ni,
  input  logic              clear_i,
  input  logic [IndexW-1:0] clear_at_i,
  input  logic              set_i,
  input  logic [IndexW-1:0] set_at_i,
  output logic [Flags-1:0]  flags_o
);
  if (Flags < 1) begin : gen_refuse
    $error("rc_flags: Flags must be at least 1");
  end

  if (rc_pkg::PathCut == 0) begin : gen_indexed
    logic [Flags-1:0] flags_q;

    always_ff @(posedge clk_i) begin
      if (!rst_ni) begin
        flags_q <= '0;
      end else begin
        if (clear_i) flags_q[clear_at_i] <= 1'b0;
        if (set_i)   flags_q[set_at_i] <= 1'b1;
      end
    end

    assign flags_o = flags_q;
  end else begin : gen_compared
    for (genvar f = 0; f < Flags; f++) begin : gen_flag
      logic flag_q;
      always_ff @(posedge clk_i) begin
        if (!rst_ni)                                  flag_q <= 1'b0;
        else if (set_i && set_at_i == IndexW'(f))     flag_q <= 1'b1;
        else if (clear_i && clear_at_i == IndexW'(f)) flag_q <= 1'b0;
      end

      assign flags_o[f] = flag_q;
    end
  end
endmodule
`default_nettype wire
