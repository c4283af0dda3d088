// The reader of the Verilog sources: which statement gives a signal its value, and from which signals.
#include <catch2/catch.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/view/divergence/rtl_text.hpp"

using namespace rayclock;

namespace {

/// "9: comb sum <- a_i picked", "27: u_inner.d_o picked" of an instance's output.
std::vector<std::string> drivers_of(const ModuleText& module) {
    std::vector<std::string> all;
    for (const SignalDriver& d : module.drivers)
        all.push_back(d.construct == SignalDriver::Construct::instance
                          ? fmt::format("{}: {}({}).{} -> {}", d.line, d.instance, d.module, d.port,
                                        fmt::join(d.targets, " "))
                          : fmt::format("{}: {} {} <- {}", d.line,
                                        d.construct == SignalDriver::Construct::registered ? "ff" : "comb",
                                        fmt::join(d.targets, " "), fmt::join(d.sources, " ")));
    return all;
}

std::vector<std::string> inputs_of(const ModuleText& module) {
    std::vector<std::string> all;
    for (const InputConnection& i : module.inputs)
        all.push_back(fmt::format("{}: {}.{} <- {}", i.line, i.instance, i.port, fmt::join(i.sources, " ")));
    return all;
}

using Lines = std::vector<std::string>;

}   // namespace

TEST_CASE("statements of always_comb, always_ff and assign are drivers, each in its line") {
    const ModuleText module = read_module("box/rc_box.sv", R"(module rc_box (
    input  logic       clk_i,
    output logic [3:0] rsp_o
);
  logic [3:0] sum, next, kept_q;
  always_comb begin
    sum = a_i + 4'd1;
    if (wide_q) sum = next;
    else begin
      sum[1:0] = a_i[bit_q +: 2];
    end
    case (state_q)
      Idle: next = rc_pkg::first(sum);
      default: next = '0;
    endcase
  end
  always_ff @(posedge clk_i or negedge rst_ni)
    if (!rst_ni) kept_q <= '0;
    else if (sum <= kept_q) kept_q <= $unsigned(sum);
  assign rsp_o = sum == next ? kept_q : req_i.data;
endmodule
)");
    CHECK(module.file == "box/rc_box.sv");
    CHECK(module.name == "rc_box");
    CHECK(module.lines.at(6) == "    sum = a_i + 4'd1;");
    CHECK(drivers_of(module) == Lines{"7: comb sum <- a_i", "8: comb sum <- next",
                                      "10: comb sum <- a_i bit_q", "13: comb next <- sum",
                                      "14: comb next <- ", "18: ff kept_q <- ", "19: ff kept_q <- sum",
                                      "20: comb rsp_o <- sum next kept_q req_i"});
}

TEST_CASE("elements of arrays and parts of structs drive the whole, and concatenations all of their parts") {
    const ModuleText module = read_module("rc_box.sv", R"(module rc_box ();
  logic [3:0] mem_q [4];
  always_ff @(posedge clk_i) begin
    if (we_i) mem_q[at_i] <= data_i;
    {valid_q, tag_q[1:0]} <= {valid_i, tag_i};
    if (we_i) mem_q[tail_q[1:0]][3:0] <= tail_i;
    state_q.left[0].x <= mem_q[from_i];
  end
endmodule
)");
    CHECK(drivers_of(module) == Lines{"4: ff mem_q <- data_i", "5: ff valid_q tag_q <- valid_i tag_i",
                                      "6: ff mem_q <- tail_i", "7: ff state_q <- mem_q from_i"});
}

TEST_CASE("comments and directives drive nothing, whatever words are in them") {
    const ModuleText module = read_module("rc_box.sv", R"(// module rc_ghost; assign a = b;
`include "x.svh"
/* module rc_other (); assign c = d;
   assign e = f; */
module rc_box ();   // assign g = h;
  assign one_o = a_i;   // always_ff begin two_o <= b_i; end
  /* assign three_o = c_i; */ assign four_o = d_i /* e_i */;
  /* f *//* assign six_o = g_i; *//**/// assign seven_o = h_i;
`define NAME assign five_o = f_i;
endmodule
)");
    CHECK(module.name == "rc_box");
    CHECK(drivers_of(module) == Lines{"6: comb one_o <- a_i", "7: comb four_o <- d_i"});
    CHECK(read_module("empty.sv", "// module rc_ghost ();\n").name.empty());
}

TEST_CASE("an instance's outputs drive what they are connected to, in nested generate blocks as well") {
    const ModuleText module = read_module("rc_box.sv", R"(module rc_box ();
  for (genvar i = 0; i < 2; ++i) begin : gen_lane
    if (W > 2) begin : gen_wide
      rc_inner #(
          .W(W), .Deep($clog2(W))
      ) u_inner (
          .clk_i,
          .a_i(sum[i]),
          .b_i({picked, wide_q}),
          .c_o(lane[i]),
          .near_no(near_n),
          .d_o
      );
    end else begin : gen_narrow
      assign lane[i] = a_i;
    end
  end
  rc_shift_register u_delay (.data_i(lane[0]), .data_o({rsp_o, rest}));
endmodule
)");
    CHECK(drivers_of(module) == Lines{"10: u_inner(rc_inner).c_o -> lane",
                                      "11: u_inner(rc_inner).near_no -> near_n",
                                      "12: u_inner(rc_inner).d_o -> d_o", "15: comb lane <- a_i",
                                      "18: u_delay(rc_shift_register).data_o -> rsp_o rest"});
    CHECK(inputs_of(module) == Lines{"7: u_inner.clk_i <- clk_i", "8: u_inner.a_i <- sum i",
                                     "9: u_inner.b_i <- picked wide_q", "18: u_delay.data_i <- lane"});
}
