// Names of cells, positions in sources, devices, and the harness around a placed module.
#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>

#include "model/base/error.hpp"
#include "model/core/config.hpp"
#include "sim/silicon/chip/cells.hpp"
#include "sim/run/rtl/sources.hpp"
#include "sim/silicon/synth/yosys.hpp"
#include "sim/silicon/chip/harness.hpp"
#include "sim/silicon/chip/place_and_route.hpp"
#include "tests/support/files/test_folder.hpp"

using namespace rayclock;
using namespace rayclock::chip;

TEST_CASE("a cell belongs to the outermost unit that its name has") {
    const Units chip("chip"), box("box");
    const std::string tree = "u_chip.u_top.gen_pipeline[0].u_pipeline.gen_tree.u_tree.";
    CHECK(chip.of(tree + "gen_box.u_box.u_rank.s4_q_TRELLIS_FF_Q_5") == "box");
    CHECK(chip.of(tree + "x") == wiring_unit);
    CHECK(chip.of("u_chip.u_top.gen_pipeline[0].u_pipeline.u_prim_cache.u_cache.u_tags.x") == "prim_cache");
    CHECK(chip.of("u_chip.u_host.frame_q") == "host");
    CHECK(chip.of("in_q_TRELLIS_FF_Q_7") == harness_unit);
    CHECK(chip.of("$nextpnr_CCU2C_0$CCU2_COMB1") == carry_unit);
    CHECK(box.of("$nextpnr_CCU2C_0$CCU2_COMB1") == "box");
    CHECK(box.of("u_box.u_slab.x") == "box");
    CHECK(Units("rank").of("u_rank.s4_q") == "rank");
    const Units board(board_top);
    CHECK(board.of("u_board." + tree + "gen_box.u_box.u_rank.s4_q_TRELLIS_FF_Q_5") == "box");
    CHECK(board.of("u_board.u_memory.u_sdram.wait_q") == "memory");
    CHECK(board.of("u_board.drawn_base") == wiring_unit);
    CHECK(board.of("wait_q_TRELLIS_FF_Q_7") == harness_unit);
    CHECK(board.of("$nextpnr_CCU2C_0$CCU2_COMB1") == carry_unit);
}

TEST_CASE("names of registers lose their bit numbers") {
    CHECK(register_of("u_top.u_box.u_rank.s4_q_TRELLIS_FF_Q_5", "box") == "u_rank.s4_q");
    CHECK(register_of("u_box.s3_q_TRELLIS_FF_Q_CE_LUT4_Z", "box") == "s3_q");
    CHECK(register_of("u_sched.u_tiles.mem.0.2$DPRAM_COMB2", "sched") == "u_tiles.mem.0.2");
    CHECK(register_of("in_q_TRELLIS_FF_Q_103", "harness") == "in_q");
}

TEST_CASE("the source of a cell is the text in its module, not the place of its instance") {
    const test::TestFolder folder;
    std::ofstream(folder.name("rc_box.sv"))
        << "module rc_box;\n  rc_fifo #(.Depth(4)) u_queue (\n    .clk_i);\n"
           "  rc_ram u_ray (.clk_i); // u_none\nendmodule\n";
    std::ofstream(folder.name("rc_tree.sv")) << "module rc_tree;\n  rc_box u_box (.clk_i);\nendmodule\n";
    std::filesystem::create_directories(folder.name("cells/queues"));
    std::ofstream(folder.name("cells/queues/rc_fifo.sv"))
        << "module rc_fifo;\n  always_ff @(posedge clk_i) begin\n  end\n";
    const std::string rtl = folder.path().string();
    const std::string inner = rtl + "/cells/queues/rc_fifo.sv:2.3-3.6", outer = rtl + "/rc_box.sv:2.32-3.12",
                      at_name = rtl + "/rc_box.sv:2.24-3.12",
                      library = "share/yosys/ecp5/cells_map.v:83.170-83.229";
    CHECK(source_line(outer + "|" + library + "|" + inner, rtl) == "rtl/cells/queues/rc_fifo.sv:2");
    CHECK(source_line(inner + "|" + at_name, rtl) == "rtl/cells/queues/rc_fifo.sv:2");
    CHECK(source_line(at_name + "|" + inner, rtl) == "rtl/cells/queues/rc_fifo.sv:2");
    CHECK(source_line("harness.v:1.1-2.2|" + outer, rtl).empty());
    CHECK(source_line("harness.v:1.1-2.2|" + outer, rtl, true) == "rtl/rc_box.sv:2");
    CHECK(source_line("/moved/rtl/cells/queues/rc_fifo.sv:2.3-3.6", rtl) ==
          "rtl/cells/queues/rc_fifo.sv:2");   // an equal copy
    CHECK(source_line(library, rtl).empty());
    CHECK(source_of_name("box", "u_ray.mem.0.2", rtl) == "rtl/rc_box.sv:4");
    CHECK(source_of_name("tree", "u_box.u_ray.mem.0.2", rtl) == "rtl/rc_box.sv:4");
    CHECK(source_of_name("box", "u_queue.u_fifo.mem.0.2", rtl) == "rtl/rc_box.sv:2");
    CHECK(source_of_name("box", "u_none", rtl).empty());   // a comment
    CHECK(source_of_name("box", "u_que", rtl).empty());
    CHECK(source_of_name("tri", "u_ray", rtl).empty());
}

TEST_CASE("a device is found by its name") {
    CHECK(device_of("lfe5u-85").has.lut == 83640);
    CHECK(device_of("lfe5u-25").has.dsp == 28);
    CHECK_THROWS_WITH(device_of("lfe5u-84"), Catch::Contains("did you mean 'lfe5u-85'"));
}

TEST_CASE("the message about a design that does not fit says by how much, and what to narrow") {
    const Device device = device_of("lfe5u-25");
    const std::map<std::string, Use> units{
        {"box", {20000, 100, 10, 0}}, {"tri", {4000, 100, 19, 0}}, {"harness", {288, 0, 0, 0}}};
    const std::string text = misfit("small", device, units);
    CHECK(text ==
          "'small' does not fit lfe5u-25: it needs 29 multipliers of 28 (1 too many; narrow tri, which takes "
          "19)");
    std::map<std::string, Use> more = units;
    more["list"] = {1, 0, 0, 0};   // one LUT too many, including the harness's
    CHECK_THAT(misfit("small", device, more),
               Catch::Contains(
                   "24,289 LUTs of 24,288 (1 too many; narrow box, which takes 20,000), 29 multipliers"));
    more["tri"].dsp = 18, more["list"].lut = 0;
    CHECK(misfit("small", device, more).empty());
}

TEST_CASE("the harness connects every bit of every port once") {
    const std::string netlist = R"({"modules": {
        "$abstract\\rc_unused": {},
        "$paramod\\rc_fifo\\Width=s32'00000000000000000000000000000100": {"ports": {}},
        "rc_box": {"ports": {"clk_i": {"direction": "input", "bits": [2]}, "rst_ni": {"direction": "input", "bits": [3]},
          "req_i": {"direction": "input", "bits": [4, 5, 6]}, "valid_i": {"direction": "input", "bits": [7]},
          "rsp_o": {"direction": "output", "bits": [8, 9]}}}}})";
    const ModuleInterface interface = interface_of(netlist, "box");
    CHECK(interface.modules == std::vector<std::string>{"box", "fifo"});
    REQUIRE(interface.ports.size() == 5);
    const std::string text = harness_text(Config{}, "box", interface);
    for (const char* words :
         {"reg  [4-1:0]   in_q;", "wire [2-1:0]  out;", ".clk_i(clk_i)", ".rst_ni(rst_q)",
          ".req_i(in_q[0 +: 3])", ".valid_i(in_q[3 +: 1])", ".rsp_o(out[0 +: 2])", "rc_box u_box ("})
        CHECK_THAT(text, Catch::Contains(words));
    CHECK_THAT(harness_text(Config{}, "arbiter", interface), Catch::Contains("#(.Sources("));
}

TEST_CASE("a netlist is the same wherever the sources lie") {
    if (synth::yosys_version().empty()) {
        WARN("yosys is not installed");
        return;
    }
    const test::TestFolder folder;
    const synth::YosysFolder run(folder.path());
    REQUIRE(run.run(
        Config{}, "-defer ",
        "hierarchy -top rc_fifo\nproc\ndelete =A:whitebox =A:lib_whitebox\nwrite_json netlist.json\n"));
    const std::string netlist = run.text("netlist.json");
    CHECK(netlist.find("rtl/cells/queues/rc_fifo_peek.sv:") != netlist.npos);
    CHECK(netlist.find(rtl_sources().string()) == netlist.npos);
    CHECK(netlist.find(folder.path().string()) == netlist.npos);
}

TEST_CASE("a word in a comment or an assertion is not what is synthesised; a line more is") {
    const auto text = [](const std::string& comment, const std::string& assertion) {
        return "module m;" + comment + "\n`ifndef SYNTHESIS\n" + assertion +
               "\n`ifdef X\n`endif\n`endif\n  a <= b; // c\nendmodule\n";
    };
    const std::string plain = synth::synthesised_text(text("", ""));
    CHECK(plain == "module m;\n\n\n\n\n\n  a <= b;\nendmodule\n");
    CHECK(synth::synthesised_text(text("  // one", "assert (x);")) == plain);
    CHECK(synth::synthesised_text(text(" wire w;", "")) != plain);
    CHECK(synth::synthesised_text(text("", "\n")) != plain);   // positions include line numbers
    CHECK(synth::synthesised_text("x = \"//\"; // y\n") == "x = \"//\";\n");
    CHECK(synth::synthesised_text("`ifndef SYNTHESIS\na\n`else\nb\n`endif\nc\n").find("b\n") !=
          std::string::npos);
    CHECK(synth::synthesised_text("/* // */ x;\n") == "/* // */ x;\n");
}

TEST_CASE("all synthesised parts of the sources are kept") {
    std::size_t all = 0, kept = 0;
    for (const RtlText& source : rtl_texts()) {
        const std::string text = synth::synthesised_text(source.text);
        CHECK(std::count(text.begin(), text.end(), '\n') ==
              std::count(source.text.begin(), source.text.end(), '\n'));
        if (!source.name.ends_with(".sv")) continue;
        CHECK(text.find("endmodule") != std::string::npos);
        CHECK(text.find("assert (") == std::string::npos);
        all += source.text.size(), kept += text.size();
    }
    CHECK(kept > all / 2);
}
