// The chip: wires the machine, its host interface and the counters.
//
// A board connects only these ports: the register bus, the memory, the hits. docs/machine/chip.md
// describes them. With Counters = 0 the chip has no unit counters, and the bus answers a read of
// one with an error. Reset must be held for four cycles more than the largest cache has sets.
`default_nettype none
module rc_chip #(
  parameter int unsigned Counters = 1
) (
  input  logic                                      clk_i,
  input  logic                                      rst_ni,
  // Registers: Wishbone B4, classic, 32 bits, word addresses
  input  logic                                      wb_cyc_i,
  input  logic                                      wb_stb_i,
  input  logic                                      wb_we_i,
  input  logic [rc_pkg::RegAddrBits-1:0]            wb_adr_i,
  input  logic [31:0]                               wb_dat_i,
  output logic [31:0]                               wb_dat_o,
  output logic                                      wb_ack_o,
  output logic                                      wb_err_o,
  // Memory: reads of lines of 64 bytes, and writes if the chip writes hits; answers to reads by id
  // in any order, always accepted
  output logic                                      mem_req_valid_o,
  input  logic                                      mem_req_ready_i,
  output rc_pkg::mem_req_t                          mem_req_o,
  input  logic                                      mem_rsp_fires_i,
  input  rc_pkg::mem_rsp_t                          mem_rsp_i,
  // Picture, pixel by pixel in arbitrary order: one stream per pipeline. Idle if hits are written
  output logic [rc_pkg::Pipelines-1:0]              hit_valid_o,
  input  logic [rc_pkg::Pipelines-1:0]              hit_ready_i,
  output logic [rc_pkg::Pipelines*rc_pkg::HitW-1:0] hit_o,
  // Status
  output logic                                      running_o,   // this cycle belongs to a frame
  output logic                                      done_o       // a frame has ended
);
  localparam int unsigned Units = rc_pkg::Pipelines * rc_pkg::PipelineUnits + rc_pkg::SharedUnits;

  logic                         start, count, clear, counter_there;
  rc_pkg::frame_t               frame;
  logic [rc_pkg::CounterNumberBits-1:0] counter;
  logic [rc_pkg::CounterBits-1:0] counter_value;
  logic [Units*rc_pkg::CauseBits-1:0] causes;
  logic [rc_pkg::MostAnswers-1:0] hit_fires;

  rc_host #(.Counters(Counters)) u_host (
    .clk_i, .rst_ni,
    .wb_cyc_i, .wb_stb_i, .wb_we_i, .wb_adr_i, .wb_dat_i, .wb_dat_o, .wb_ack_o, .wb_err_o,
    .start_o(start), .frame_o(frame), .hit_fires_i(hit_fires),
    .count_o(count), .clear_o(clear), .counter_o(counter),
    .counter_there_i(counter_there), .counter_i(counter_value), .running_o, .done_o);

  if (Counters != 0) begin : gen_counters
    rc_counters u_counters (
      .clk_i, .count_i(count), .causes_i(causes), .clear_i(clear), .which_i(counter),
      .there_o(counter_there), .count_o(counter_value));
  end else begin : gen_none
    assign {counter_there, counter_value} = '0;

    logic unused;
    assign unused = ^{causes, count, clear, counter};
  end

  rc_top u_top (
    .clk_i, .rst_ni, .start_i(start), .frame_i(frame),
    .mem_req_valid_o, .mem_req_ready_i, .mem_req_o, .mem_rsp_fires_i, .mem_rsp_i,
    .hit_valid_o, .hit_ready_i, .hit_o, .hit_fires_o(hit_fires), .causes_o(causes));
endmodule
`default_nettype wire
