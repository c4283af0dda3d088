// rc_fuzz: libFuzzer around the target that RC_FUZZ_TARGET names.
//
// RC_FUZZ_LARGE=BYTES blows every input up: its first two bytes choose a part of the rest, which is repeated until there are so
// many bytes. So a small input stands for a large file, and what takes a time that grows with the square is found.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include "tests/fuzz/program/targets.hpp"

namespace rayclock::fuzz {
namespace {

struct Target {
    const char* name;
    void (*run)(std::string_view bytes);
};
constexpr std::array<Target, 10> targets{{{"obj", obj}, {"mtl", mtl}, {"ply", ply}, {"stl", stl}, {"gltf", gltf}, {"scene", scene},
                                          {"config", config}, {"state", state}, {"cache", cache}, {"options", options}}};

void (*chosen)(std::string_view) = nullptr;
std::size_t large = 0;

std::string blown_up(std::string_view bytes) {
    if (bytes.size() < 3) return std::string(bytes);
    const auto place = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]) * (bytes.size() - 2) / 256; };
    const std::size_t from = std::min(place(0), place(1)), to = std::max(place(0), place(1)) + 1;
    bytes.remove_prefix(2);
    std::string all(bytes.substr(0, to));
    while (all.size() + (to - from) + (bytes.size() - to) <= large) all += bytes.substr(from, to - from);
    return all += bytes.substr(to);
}

/// libFuzzer's own limit is by the clock on the wall, which says little on a machine that does other things as well.
constexpr double most_seconds = 10;

double processor_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

} // namespace

std::filesystem::path file(const std::string& name) { return std::filesystem::path(RAYCLOCK_FUZZ_FILES) / name; }

void demand(bool holds, const char* claim) {
    if (holds) return;
    std::fprintf(stderr, "rc_fuzz: this does not hold: %s\n", claim);
    std::abort();
}

void check_sentence(const std::string& sentence) {
    demand(!sentence.empty() && sentence.size() < 1000, "a sentence has up to 1000 letters");
    for (const char c : sentence) demand(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f, "a sentence has no control characters");
}

} // namespace rayclock::fuzz

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
        if (large > 0) chosen(blown_up(bytes));
        else chosen(bytes);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "rc_fuzz: no UserError: %s\n", error.what());
        std::abort();
    }
    demand(processor_seconds() - start < most_seconds, "an input takes less than 10 s");
    return 0;
}
