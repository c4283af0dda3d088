// The counters of all units, as the host reads them. which_i is {group, unit, cause}.
//
// Group 0 holds the units that all pipelines share, group p + 1 those of pipeline p. rc_pkg's
// UnitsThere lists the shared units, then the units of one pipeline, in the same order. A unit that
// the chip lacks has no counters. Model: model/machine/units.hpp.
`default_nettype none
module rc_counters #(
  localparam int unsigned Units = rc_pkg::Pipelines * rc_pkg::PipelineUnits + rc_pkg::SharedUnits
) (
  input  logic                         clk_i,
  input  logic                         count_i,    // counts causes_i in this cycle
  // Shared units lowest, then pipeline by pipeline
  input  logic [Units*rc_pkg::CauseBits-1:0] causes_i,
  input  logic                         clear_i,    // clears which_i's cause in all units
  input  logic [rc_pkg::CounterNumberBits-1:0] which_i,
  output logic                         there_o,    // which_i names a counter of this chip
  output logic [rc_pkg::CounterBits-1:0] count_o   // valid only while nothing is counted
);
  localparam int unsigned CounterBits   = rc_pkg::CounterBits;
  localparam int unsigned SharedUnits   = rc_pkg::SharedUnits;
  localparam int unsigned PipelineUnits = rc_pkg::PipelineUnits;
  localparam int unsigned CauseBits     = rc_pkg::CauseBits;

  logic [rc_pkg::CounterNumberBits-CauseBits-1:0] which_unit;   // {group, number}
  logic [CauseBits-1:0]                     which_cause;

  assign {which_unit, which_cause} = which_i;

  logic [Units-1:0]             there;
  logic [Units*CounterBits-1:0] counts;

  // One set of counters for each unit that exists; all others read 0.
  for (genvar k = 0; k < Units; k++) begin : gen_unit
    localparam int unsigned Group = k < SharedUnits ? 0 : (k - SharedUnits) / PipelineUnits + 1;
    localparam int unsigned Unit  = k < SharedUnits ? k : (k - SharedUnits) % PipelineUnits;
    localparam int unsigned Row   = k < SharedUnits ? k : SharedUnits + Unit;   // in UnitsThere
    if (rc_pkg::UnitsThere[Row]) begin : gen_there
      logic [CounterBits-1:0] count;
      rc_cause_counters u_counters (
        .clk_i, .count_i, .cause_i(causes_i[k*CauseBits +: CauseBits]), .clear_i,
        .at_i(which_cause), .count_o(count));

      assign there[k]                             = which_unit == {4'(Group), 5'(Unit)};
      assign counts[k*CounterBits +: CounterBits] = there[k] ? count : '0;
    end else begin : gen_none
      assign there[k]                             = 1'b0;
      assign counts[k*CounterBits +: CounterBits] = '0;

      logic unused;
      assign unused = ^causes_i[k*CauseBits +: CauseBits];
    end
  end

  // The selected counter: at most one is not 0.
  assign there_o = there != '0;
  always_comb begin
    count_o = '0;
    for (int k = 0; k < Units; k++) count_o = count_o | counts[k*CounterBits +: CounterBits];
  end
endmodule
`default_nettype wire
