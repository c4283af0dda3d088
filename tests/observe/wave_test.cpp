// Waveforms, read back by GTKWave's own reader, and what GTKWave is told to show.
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <map>
#include <unistd.h>

#include "sim/view/wave/fst.hpp"
#include "sim/view/wave/gtkw.hpp"

using namespace rayclock;

namespace {

/// All that is in a waveform, by name.
struct Waves {
    std::map<std::string, std::uint32_t> signals;
    std::map<std::uint32_t, std::vector<std::pair<std::uint64_t, std::string>>> changes;
};
Waves waves_of(const std::string& bytes) {
    const auto file =
        std::filesystem::temp_directory_path() / ("rayclock-wave-test-" + std::to_string(getpid()));
    std::ofstream(file, std::ios::binary) << bytes;
    Waves waves;
    std::string path;
    FstVisitor visitor;
    visitor.open_scope = [&](const std::string& name) { path += name + "."; };
    visitor.close_scope = [&] {
        path.pop_back();
        path.resize(path.rfind('.') + 1);
    };
    visitor.signal = [&](std::uint32_t signal, const std::string& name, int, bool) {
        waves.signals[path + name] = signal;
    };
    visitor.change = [&](std::uint64_t time, std::uint32_t signal, std::string_view value) {
        waves.changes[signal].emplace_back(time, value);
    };
    read_fst(file, visitor);
    std::filesystem::remove(file);
    return waves;
}

using Changes = std::vector<std::pair<std::uint64_t, std::string>>;

}   // namespace

TEST_CASE("a waveform is read as it was written, by GTKWave's reader") {
    FstWriter out;
    out.open_scope("links");
    const auto wide = out.add_bits("wide", 70);
    out.open_scope("box");
    const auto bit = out.add_bits("bit", 1), number = out.add_bits("number", 12);
    const auto text = out.add_text("cause");
    out.add_alias("again", 12, number);
    out.close_scope();
    out.close_scope();
    const std::string x(70, 'x'), ones(70, '1');
    out.set_time(10);
    out.set_bits(wide, x);
    out.set_value(bit, 1);
    out.set_value(number, 5);
    out.set_text(text, "busy");
    out.set_time(20);
    out.set_bits(wide, ones);
    out.set_value(number, 5);   // no change
    out.set_text(text, "stalled by memory");
    out.set_time(35);
    out.set_value(number, 4095);
    const Waves waves = waves_of(out.finish());

    REQUIRE(waves.signals.size() == 5);
    const auto changes = [&](const char* name) { return waves.changes.at(waves.signals.at(name)); };
    CHECK(changes("links.wide[69:0]") == Changes{{10, x}, {20, ones}});
    CHECK(changes("links.box.bit") == Changes{{10, "1"}});
    CHECK(changes("links.box.number[11:0]") == Changes{{10, "000000000101"}, {35, "111111111111"}});
    CHECK(changes("links.box.again[11:0]") == changes("links.box.number[11:0]"));
    CHECK(changes("links.box.cause").back() ==
          std::pair<std::uint64_t, std::string>{20, "stalled by memory"});
}

TEST_CASE("bits of a payload are digits from the top down") {
    CHECK(digits_of({0b1011, 0b1}, 0, 4) == "1011");
    CHECK(digits_of({0x80000000u, 0b1}, 31, 2) == "11");
    CHECK(digits_of({0x80000000u, 0b10}, 31, 3) == "101");
}

TEST_CASE("a file that is not a waveform is refused") {
    CHECK_THROWS_WITH(waves_of("no waveform at all"), Catch::Contains("is not a waveform"));
}

TEST_CASE("a save file of GTKWave names its waveform, its marker and its groups") {
    const std::string text = gtkw_text({"a.fst",
                                        105,
                                        40,
                                        {{"link box", {{GtkwSignal::As::hexadecimal, "links.box.t[11:0]"}}},
                                         {"far", {{GtkwSignal::As::bits, "links.far.v"}}, false}}});
    CHECK(text.find("[dumpfile] \"a.fst\"\n[timestart] 40\n") != std::string::npos);
    CHECK(text.find(" 105 -1 ") != std::string::npos);
    // Flags of GTKWave: 0x22 right-aligned hexadecimal, 0x28 binary, 0x800200 and 0x1000200 a group, 0x400000
    // shut.
    CHECK(text.find("@800200\n-link box\n@22\nlinks.box.t[11:0]\n@1000200\n-link box\n") !=
          std::string::npos);
    CHECK(text.find("@c00200\n-far\n@28\nlinks.far.v\n@1400200\n-far\n") != std::string::npos);
}
