// Memories as files: a machine gets exactly the values of the file, and a wrong value is reported with its
// line.
#include <catch2/catch.hpp>

#include "model/base/error.hpp"
#include "sim/run/memory/memory_file.hpp"

using namespace rayclock;
using Catch::Contains;

namespace {

/// Returns the file of a memory with one value changed.
std::string file_with(const char* key, const nlohmann::ordered_json& value) {
    nlohmann::ordered_json json = memory_file_json(dram_part("ddr4"));
    json[key] = value;
    return json.dump(2);
}
void check_refused(const std::string& text, const std::vector<std::string>& words) {
    INFO(text);
    std::string said;
    try {
        parse_memory("mine.json", text);
    } catch (const UserError& e) {
        said = e.what();
    }
    CHECK(said.starts_with("mine.json: "));
    CHECK(said.find('\n') == said.npos);
    for (const std::string& word : words) CHECK_THAT(said, Contains(word));
}

}   // namespace

TEST_CASE("a memory that is written to a file is read again, every value", "[dram]") {
    for (const std::string& name : names_of<DramName>()) {
        if (name == "ideal") continue;
        const DramPart& part = dram_part(name);
        const std::string text = memory_file_json(part).dump(2);
        const DramPart again = parse_memory("mine.json", text);
        CHECK(memory_file_json(again).dump(2) == text);
        CHECK(again.name == part.name);
        CHECK(again.trefi == part.trefi);
        CHECK(again.tccd_l == part.tccd_l);
    }
}

TEST_CASE("a memory starts from another and changes what it names", "[dram]") {
    const DramPart part = parse_memory("dir/fast.json", R"({"like": "sdr", "tck_ns": 6.25, "cl_clocks": 2})");
    CHECK(part.name == "fast");
    CHECK(part.tck == 6250);
    CHECK(part.cl == 2);
    CHECK(part.trcd == dram_part("sdr").trcd);
    CHECK(peak_bytes_per_second(part) == 320'000'000);
}

TEST_CASE("a memory file that makes no sense is refused with its line and value", "[dram]") {
    check_refused("[1, 2]", {"a memory is a JSON object"});
    check_refused("{\"like\": \"ddr4\",\n \"trcd\": 13}", {"line 2", "'trcd'", "did you mean 'trcd_ns'"});
    check_refused("{\"like\": \"ddr9\"}", {"line 1", "'ddr9'", "ddr3"});
    check_refused("{\"bus_bits\": 16}", {"transfers_per_clock is missing", "like"});
    check_refused("{\"like\": \"ddr4\",\n\n\"trcd_ns\": -1}",
                  {"line 3", "trcd_ns", "from 0 to 10000 nanoseconds", "-1"});
    check_refused(file_with("trcd_ns", "13 ns"), {"trcd_ns", "13 ns"});
    check_refused(file_with("trcd_ns", 13.7505), {"trcd_ns", "whole number of picoseconds", "13.7505"});
    check_refused(file_with("tck_ns", 0), {"tck_ns", "from 0.1 to 1000"});
    check_refused(file_with("bus_bits", 48), {"bus_bits", "power of two", "48"});
    check_refused(file_with("banks", 16.5), {"banks", "whole number from 1 to 32", "16.5"});
    check_refused(file_with("banks", 33), {"banks", "33"});
    check_refused(file_with("bank_groups", 3), {"bank_groups must divide banks, 16, not 3"});
    check_refused(file_with("burst_length", 1), {"multiple of transfers_per_clock, 2, not 1"});
    check_refused(file_with("columns", 4), {"columns", "multiple of 512", "256"});
    check_refused(file_with("trc_ns", 20), {"trc_ns must be at least tras_ns, 32, not 20"});
    nlohmann::ordered_json busy = memory_file_json(dram_part("ddr4"));
    busy["trefi_ns"] = 1000, busy["trfc_ns"] = 900;
    check_refused(busy.dump(), {"trefi_ns must be at least 11", "not 1000"});
}

TEST_CASE("every key of a memory file has a range that holds on both sides", "[dram]") {
    const nlohmann::ordered_json sound = memory_file_json(dram_part("ddr4"));
    int keys = 0;
    for (const auto& [key, value] : sound.items()) {
        if (value.is_string()) continue;
        ++keys;
        check_refused(file_with(key.c_str(), -1), {key, "-1"});
        check_refused(file_with(key.c_str(), 1e9), {key});
        check_refused(file_with(key.c_str(), "many"), {key, "many"});
    }
    CHECK(keys == 28);
}
