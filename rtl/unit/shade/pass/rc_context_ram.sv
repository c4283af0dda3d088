// Memory of the state of each context that a pass reads.
//
// If a pass enters in every cycle, a read answers in the same cycle (LUT RAM). If passes come every
// few cycles, the answer to read_i comes in the next cycle and stays (block RAM). The user must not
// read and write a context in the same cycle.
//
// With Parts above 1, the written data must stay stable for Parts cycles from write_i on. The
// answer is ready Parts + 1 cycles after read_i. The user must not start another read or write
// within these cycles.
`default_nettype none
module rc_context_ram #(
  parameter  int unsigned Width  = 1,
  parameter  int unsigned Depth  = 2,
  parameter  int unsigned Parts  = 1,
  localparam int unsigned IndexW = Depth < 2 ? 1 : $clog2(Depth)
) (
  input  logic              clk_i,
  input  logic              rst_ni,      // for the assertions: during reset the ports are arbitrary
  // Write port
  input  logic              write_i,
  input  logic [IndexW-1:0] write_addr_i,
  input  logic [Width-1:0]  write_data_i,
  // Read port
  input  logic              read_i,
  input  logic [IndexW-1:0] read_addr_i,
  output logic [Width-1:0]  read_data_o
);
  if (rc_pkg::ShadeInterval == 1) begin : gen_now
    rc_ram #(.Width(Width), .Depth(Depth)) u_ram (
      .clk_i, .write_i, .write_addr_i, .write_data_i, .read_addr_i, .read_data_o);

    logic unused;
    assign unused = rst_ni ^ read_i;
  end else if (Parts > 1) begin : gen_parts
    localparam int unsigned PartB = $clog2(Parts);
    logic [PartB-1:0]  writing_q, reading_q, write_part, read_part;   // the next part
    logic              goes_on_q;   // parts are left to write
    logic [IndexW-1:0] read_addr_q, read_addr;

    assign write_part = write_i ? '0 : writing_q;
    assign read_part  = read_i ? '0 : reading_q;
    assign read_addr  = read_i ? read_addr_i : read_addr_q;

    always_ff @(posedge clk_i) begin
      goes_on_q   <= rst_ni && (write_i || goes_on_q) && write_part != '1;
      writing_q   <= write_part + 1'b1;
      reading_q   <= read_part + 1'b1;
      read_addr_q <= read_addr;
    end

    rc_ram_parts #(.Width(Width), .Depth(Depth), .Parts(Parts)) u_ram (
      .clk_i, .write_i(write_i || goes_on_q), .write_addr_i, .write_part_i(write_part),
      .write_data_i, .read_addr_i(read_addr), .read_part_i(read_part), .read_data_o);

`ifndef SYNTHESIS
    logic [Parts-1:0]  began_q;   // the cycles in which a write began
    logic [IndexW-1:0] write_addr_q;
    logic [Width-1:0]  write_data_q;

    always_ff @(posedge clk_i) begin
      began_q <= rst_ni ? Parts'({began_q, write_i}) : '0;
      if (write_i) write_addr_q <= write_addr_i;
      if (write_i) write_data_q <= write_data_i;
    end

    always_ff @(posedge clk_i) if (rst_ni && goes_on_q)
      a_still: assert (!write_i && write_addr_i == write_addr_q && write_data_i == write_data_q)
      else $error("rc_context_ram: a context has moved while its parts were written");
    always_ff @(posedge clk_i) if (rst_ni && read_i)
      a_apart: assert (!(write_i && write_addr_i == read_addr_i)
                       && !(began_q[0] && write_addr_q == read_addr_i))
      else $error("rc_context_ram: a context is read before its first part is written");
`endif
  end else begin : gen_next
    rc_ram_sync #(.Width(Width), .Depth(Depth)) u_ram (
      .clk_i, .write_i, .write_addr_i, .write_data_i, .read_i, .read_addr_i, .read_data_o);

`ifndef SYNTHESIS
    always_ff @(posedge clk_i) if (rst_ni)
      a_apart: assert (!(write_i && read_i && write_addr_i == read_addr_i))
      else $error("rc_context_ram: a context is read while it is written");
`endif

    logic unused;
    assign unused = rst_ni;
  end
endmodule
`default_nettype wire
