// The way of a wrong value back through the RTL: small modules, and a waveform that is made by hand.
#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <unistd.h>

#include "sim/view/divergence/cone.hpp"
#include "sim/view/divergence/fields.hpp"
#include "sim/view/wave/fst.hpp"

using namespace rayclock;

namespace {

constexpr std::uint64_t last_cycle = 9;

/// The widest field of a box's answer.
PayloadField field_of(const Config& config) {
    const std::vector<PayloadField> all = payload_fields(Link::box_rsp, config);
    return *std::max_element(all.begin(), all.end(),
                             [](const PayloadField& a, const PayloadField& b) { return a.width < b.width; });
}

/// A waveform of unit box, the values of its signals by cycle, and the divergence of its answer in the last
/// cycle.
class Wave {
public:
    Wave() {
        out_.open_scope("TOP");
        out_.open_scope("gen_pipeline[0]");
        out_.open_scope("u_box");
    }
    void open(const std::string& scope) { out_.open_scope(scope); }
    void close() { out_.close_scope(); }
    /// `values`: from which cycle on, and what.
    void add(const std::string& name, std::vector<std::pair<std::uint64_t, unsigned>> values) {
        // An element of an array has its number before its range, as Verilator writes it.
        const std::string range = name.ends_with(']') ? fmt::format("[{}:0]", field_.width - 1) : "";
        signals_.push_back({out_.add_bits(name + range, field_.width), std::move(values)});
    }

    /// Each step as "line signal cycle", registers with "q".
    std::vector<std::string> way(unsigned wrong, const std::vector<RtlText>& sources) {
        for (int i = 0; i < 3; ++i) out_.close_scope();
        for (std::uint64_t cycle = 0; cycle <= last_cycle; ++cycle) {
            out_.set_time(10 * cycle);
            for (const auto& [signal, values] : signals_)
                for (const auto& [from, value] : values)
                    if (from == cycle) out_.set_value(signal, value);
        }
        const auto file =
            std::filesystem::temp_directory_path() / ("rayclock-cone-test-" + std::to_string(getpid()));
        std::ofstream(file, std::ios::binary) << out_.finish();
        Divergence divergence;
        divergence.cycle = last_cycle, divergence.unit = "box", divergence.link = "box_rsp";
        divergence.on = Link::box_rsp, divergence.field = field_.name;
        LinkCycle link;
        link.rtl_valid = true;
        link.rtl.assign(std::size_t(bits_of<NodeAnswer>(config_) + 31) / 32, 0);
        for (int i = 0; i < std::min(field_.width, 32); ++i)
            link.rtl[std::size_t((field_.at + i) / 32)] |= (wrong >> i & 1) << ((field_.at + i) % 32);
        Capture capture;
        capture.links = {{0, Link::box_rsp}};
        capture.cycles.assign(last_cycle + 1, {link});
        std::vector<std::string> all;
        for (const ConeStep& step : cone_of(divergence, config_, capture, file.string(), sources)) {
            all.push_back(fmt::format("{} {} {}{}", step.source.line, step.signal, step.cycle,
                                      step.is_register ? " q" : ""));
            for (const SourceLine& other : step.others) all.back() += fmt::format(", or {}", other.line);
        }
        std::filesystem::remove(file);
        return all;
    }

private:
    struct Signal {
        FstWriter::Signal signal;
        std::vector<std::pair<std::uint64_t, unsigned>> values;
    };
    Config config_ = named_config("default");
    PayloadField field_ = field_of(config_);
    FstWriter out_;
    std::vector<Signal> signals_;
};

using Lines = std::vector<std::string>;

}   // namespace

TEST_CASE("the way leads through a register, into an instance, an array's element, and out again") {
    const std::vector<RtlText> sources{{"box/rc_box.sv", R"(module rc_box ();
  assign sum = a_i ^ b_i;
  for (genvar i = 0; i < 2; ++i) begin : gen_lane
    rc_inner u_inner (.clk_i, .x_i(sum), .y_o(kept));
  end
  always_ff @(posedge clk_i) rsp_o <= flag_q ? kept : other;
endmodule
)"},
                                       {"box/rc_inner.sv", R"(module rc_inner ();
  always_ff @(posedge clk_i) mem_q[at_i] <= x_i;
  assign y_o = mem_q[from_i];
endmodule
)"}};
    Wave wave;
    const unsigned wrong = 0x1b;
    wave.add("a_i", {{0, 1}});
    wave.add("b_i", {{0, 2}});
    wave.add("sum", {{0, 3}, {4, wrong}, {5, 3}});
    wave.add("kept", {{0, 0}, {7, wrong}});
    wave.add("other", {{0, 7}});
    wave.add("rsp_o", {{0, 0}, {8, wrong}});
    wave.open("gen_lane[0]");
    wave.open("u_inner");
    wave.add("x_i", {{0, 3}, {4, wrong}, {5, 3}});
    wave.add("mem_q[0]", {{0, 9}});
    wave.add("mem_q[1]", {{0, 5}, {5, wrong}});   // the second element alone holds the value
    wave.add("y_o", {{0, 0}, {7, wrong}});
    wave.close();
    wave.close();
    CHECK(wave.way(wrong, sources) == Lines{"6 rsp_o 9 q", "4 kept 7", "3 gen_lane[0].u_inner.y_o 7",
                                            "2 gen_lane[0].u_inner.mem_q 7 q", "2 sum 4"});
}

TEST_CASE("a register that has held the value from the first cycle on is where the way ends") {
    const std::vector<RtlText> sources{{"box/rc_box.sv", R"(module rc_box ();
  always_ff @(posedge clk_i) rsp_o <= next;
  assign next = a_i;
endmodule
)"}};
    Wave wave;
    const unsigned wrong = 0x1b;
    wave.add("rsp_o", {{0, wrong}});
    wave.add("next", {{0, 1}, {5, wrong}});   // later, and so not the value's origin
    wave.add("a_i", {{0, 1}, {5, wrong}});
    CHECK(wave.way(wrong, sources) == Lines{"2 rsp_o 9 q"});
}

TEST_CASE("the trace follows the branch whose signal held the value, and lists all branches if none did") {
    const std::vector<RtlText> sources{{"box/rc_box.sv", R"(module rc_box ();
  always_comb begin
    if (flag) rsp_o = one;   // rsp_o = three;
    else rsp_o = two;
  end
endmodule
)"}};
    const unsigned wrong = 0x1b;
    Wave wave;
    wave.add("rsp_o", {{0, wrong}});
    wave.add("one", {{0, 1}});
    wave.add("two", {{0, wrong}});
    wave.add("three", {{0, wrong}});
    CHECK(wave.way(wrong, sources) == Lines{"4 rsp_o 9"});
    Wave made;
    made.add("rsp_o", {{0, wrong}});
    made.add("one", {{0, 1}});
    made.add("two", {{0, 2}});
    CHECK(made.way(wrong, sources) == Lines{"3 rsp_o 9, or 4"});
}
