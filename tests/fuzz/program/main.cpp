// rc_fuzz: libFuzzer around the target that RC_FUZZ_TARGET names.
//
// RC_FUZZ_LARGE=BYTES enlarges every input: it repeats a part until the input has this size. So a small input
// represents a large file, and reveals algorithms with quadratic time.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>
#include <vector>

#include "tests/fuzz/program/targets.hpp"

namespace rayclock::fuzz {
namespace {

struct Target {
    const char* name;
    void (*run)(std::string_view bytes);
};
constexpr std::array<Target, 20> targets{
    {{"obj", obj},       {"mtl", mtl},         {"ply", ply},     {"stl", stl},         {"off", off},
     {"3ds", tds},       {"dae", dae},         {"gz", gz},       {"gltf", gltf},       {"scene", scene},
     {"config", config}, {"state", state},     {"cache", cache}, {"merge", merge},     {"compare", compare},
     {"yosys", yosys},   {"nextpnr", nextpnr}, {"rays", rays},   {"options", options}, {"link", board_link}}};

void (*chosen)(std::string_view) = nullptr;
std::size_t large = 0;

std::string blown_up(std::string_view bytes) {
    // Repeats lines or text between commas, so that a list grows and often stays a list. The bytes select the
    // part.
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < bytes.size(); ++i)
        if (bytes[i] == ',' || bytes[i] == '\n') ends.push_back(i);
    if (ends.size() < 2) ends = {0, bytes.size()};
    const std::size_t hash = std::hash<std::string_view>()(bytes);
    const std::size_t first = hash % (ends.size() - 1),
                      count = 1 + hash / 65'536 % std::min<std::size_t>(4, ends.size() - 1 - first);
    const std::size_t from = ends[first], to = ends[first + count];
    std::string all(bytes.substr(0, from));
    const std::string_view part = bytes.substr(from, to - from), rest = bytes.substr(to);
    while (!part.empty() && all.size() + part.size() + rest.size() <= large) all += part;
    return all += rest;
}

/// libFuzzer's own limit is wall-clock time, which depends on other jobs on the machine.
constexpr double most_seconds = 10;

double processor_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

}   // namespace

std::filesystem::path file(const std::string& name) {
    return std::filesystem::path(RAYCLOCK_FUZZ_FILES) / name;
}

void demand(bool holds, const char* claim) {
    if (holds) return;
    std::fprintf(stderr, "rc_fuzz: this does not hold: %s\n", claim);
    std::abort();
}

void check_sentence(const std::string& sentence) {
    demand(!sentence.empty() && sentence.size() < 1000, "a sentence has up to 1000 letters");
    for (const char c : sentence)
        demand(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f, "a sentence has no control characters");
}

}   // namespace rayclock::fuzz

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    using namespace rayclock::fuzz;
    const char* const name = std::getenv("RC_FUZZ_TARGET");
    for (const Target& target : targets)
        if (name && std::strcmp(name, target.name) == 0) chosen = target.run;
    if (!chosen) {
        std::fprintf(stderr, "rc_fuzz: RC_FUZZ_TARGET must name one of:");
        for (const Target& target : targets) std::fprintf(stderr, " %s", target.name);
        std::fprintf(stderr, "\n");
        std::exit(2);
    }
    if (const char* const bytes = std::getenv("RC_FUZZ_LARGE")) large = std::strtoul(bytes, nullptr, 10);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace rayclock::fuzz;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const double start = processor_seconds();
    try {
        if (large > 0)
            chosen(blown_up(bytes));
        else
            chosen(bytes);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "rc_fuzz: no UserError: %s\n", error.what());
        std::abort();
    }
    demand(processor_seconds() - start < most_seconds, "an input takes less than 10 s");
    return 0;
}
