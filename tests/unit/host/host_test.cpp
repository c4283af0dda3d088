// The registers of the chip's host interface alone: which can be read and written and when, their values, and
// the start and end of a frame.
#include <bit>
#include <cstring>
#include <map>
#include <set>

#include <catch2/catch.hpp>

#include "sim/run/gen/registers.hpp"
#include "sim/run/rtl/rtl_module.hpp"
#include "tests/support/cases/draw.hpp"
#include "tests/support/cases/host_cases.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// The result of an access.
struct Answer {
    bool good = false;
    std::uint32_t value = 0;
    int cycles = 0;   ///< until the answer
};

/// rc_host with a test on all sides. Each counter's value is its own number, and only every other counter
/// exists.
class Face {
public:
    explicit Face(const Config& config) : config_(config), rtl_(config, "rc_host") {
        for (const char* name : {"wb_cyc", "wb_stb", "wb_we", "hit_fires", "counter_there"}) set(name, 0);
        rtl_.reset();
    }

    void set(const char* name, std::uint64_t value) {
        const RcPort& port = rtl_.port(name);
        std::memcpy(port.data, &value, std::min(port.bytes, 8u));
    }
    std::uint64_t get(const char* name) {
        rtl_.settle();
        std::uint64_t value = 0;
        const RcPort& port = rtl_.port(name);
        std::memcpy(&value, port.data, std::min(port.bytes, 8u));
        return value;
    }
    void clock() {
        const std::uint64_t which = get("which");
        set("counter_there", which & 1);
        set("counter", counter(which));
        rtl_.settle();
        seen_running += get("running");
        counted += get("count");
        if (get("clear")) cleared.insert(which);
        REQUIRE_FALSE((get("clear") && (get("start") || get("running"))));
        starts += get("start");
        left -= get("running") ? std::popcount(hits) : 0;
        rtl_.clock();
    }
    static std::uint64_t counter(std::uint64_t which) {
        return (which * 0x9e3779b97f4a7c15u) & ((std::uint64_t(1) << counter_bits) - 1);
    }
    /// From now on these pixels are delivered in each cycle.
    void deliver(unsigned mask) { set("hit_fires", hits = mask); }

    Answer access(bool writes, std::uint32_t address, std::uint32_t value = 0) {
        set("wb_cyc", 1);
        set("wb_stb", 1);
        set("wb_we", writes);
        set("wb_adr", address);
        set("wb_dat", value);
        Answer answer;
        for (; !get("wb_ack") && !get("wb_err"); ++answer.cycles) {
            REQUIRE(answer.cycles < 10);
            clock();
        }
        answer.good = get("wb_ack");
        REQUIRE(get("wb_err") == !answer.good);
        answer.value = std::uint32_t(get("wb_read"));
        clock();
        set("wb_cyc", 0);
        set("wb_stb", 0);
        return answer;
    }
    std::uint32_t read(const char* constant) {
        const Answer answer = access(false, register_address(constant));
        REQUIRE(answer.good);
        return answer.value;
    }
    void write(std::uint32_t address, std::uint32_t value) { REQUIRE(access(true, address, value).good); }
    void wait_until_idle() {
        for (int i = 0; read("Status") & 1; ++i) REQUIRE(i < 20);
    }
    void write_frame(const Frame& frame) {
        std::uint32_t address = frame_base;
        for (const std::uint32_t value : frame_values(frame, config_)) write(address++, value);
    }
    Words frame() {
        rtl_.settle();
        const RcPort& port = rtl_.port("frame");
        Words words((port.bytes + 3) / 4);
        std::memcpy(words.data(), port.data, port.bytes);
        words.resize(std::size_t(bits_of<Frame>(config_) + 31) / 32);
        return words;
    }

    std::uint64_t seen_running = 0, counted = 0, starts = 0;
    std::int64_t left = 0;
    std::set<std::uint64_t> cleared;
    unsigned hits = 0;

private:
    Config config_;
    RtlModule rtl_;
};

Words random_frame(const Config& config, Draw& draw) {
    const int bits = bits_of<Frame>(config);
    Words words(std::size_t(bits + 31) / 32);
    for (std::uint32_t& word : words) word = std::uint32_t(draw.bits(32));
    if (bits % 32) words.back() &= (1u << bits % 32) - 1;
    return words;
}

}   // namespace

TEST_CASE("every counter of every unit has an address of its own", "[host]") {
    std::set<std::uint32_t> addresses;
    std::size_t counters = 0;
    for (std::size_t unit = 0; unit < pipeline_units + shared_units; ++unit)
        for (int pipeline = 0; pipeline < (unit < pipeline_units ? 8 : 1); ++pipeline)
            for (std::size_t cause = 0; cause < cause_count; ++cause, ++counters) {
                const std::uint32_t address = counter_address(Unit(unit), pipeline, cause);
                REQUIRE(address >= counter_base);
                REQUIRE(address + 1 < 1u << address_bits);
                addresses.insert(address);
            }
    CHECK(addresses.size() == counters);
}

TEST_CASE("registers can be read and written as their list says, and nothing else can", "[host]") {
    const Config config = host_config(GENERATE("small", "shaded"));
    Face face(config);
    face.wait_until_idle();
    std::map<std::uint32_t, Access> known;
    for (const HostRegister& r : host_registers()) known[r.address] = r.access;
    for (std::uint32_t i = 0; i < host_parameters(config).size(); ++i)
        known[parameter_base + i] = Access::read;
    for (std::uint32_t i = 0; i < frame_words(config).size(); ++i) known[frame_base + i] = Access::write;
    for (std::uint32_t address = 0; address < 1u << address_bits; ++address) {
        INFO("register " << address);
        const auto at = known.find(address);
        const bool is_counter = address >= counter_base && (address >> 1 & 1);
        const bool readable = is_counter || (at != known.end() && at->second != Access::write);
        const bool writable = at != known.end() && at->second != Access::read;
        const Answer got = face.access(false, address), put = face.access(true, address, 0);
        REQUIRE(got.good == readable);
        REQUIRE(put.good == writable);
        REQUIRE((got.cycles == 2 && put.cycles == 2));
        if (!is_counter) continue;
        const std::uint64_t counter = Face::counter(address >> 1 & ((1u << counter_number_bits) - 1));
        REQUIRE(got.value == std::uint32_t(address & 1 ? counter >> 32 : counter));
    }
    REQUIRE(face.starts == 0);
}

TEST_CASE("the chip says what it is", "[host]") {
    const Config config = host_config(GENERATE("small", "shaded"));
    Face face(config);
    face.wait_until_idle();
    REQUIRE(face.read("Magic") == host_magic);
    REQUIRE(face.read("Version") == host_version);
    REQUIRE(face.read("Count") == 3);
    const std::vector<HostParameter> parameters = host_parameters(config);
    for (std::uint32_t i = 0; i < parameters.size(); ++i) {
        INFO(parameters[i].name);
        REQUIRE(face.access(false, parameter_base + i).value == parameters[i].value);
    }
}

TEST_CASE("a frame's words become its fields, every bit in its place", "[host]") {
    const Config config = host_config(GENERATE("small", "shaded"));
    Face face(config);
    face.wait_until_idle();
    Draw draw{1};
    for (int i = 0; i < 20; ++i) {
        const Words words = random_frame(config, draw);
        face.write_frame(unpack<Frame>(words.data(), config));
        REQUIRE(face.frame() == words);
    }
    // Bits above a word's width are ignored.
    const Words before = face.frame();
    const std::vector<FrameWord> words = frame_words(config);
    const std::vector<std::uint32_t> values = frame_values(unpack<Frame>(before.data(), config), config);
    for (std::uint32_t i = 0; i < words.size(); ++i)
        if (words[i].bits < 32) face.write(frame_base + i, values[i] | ~0u << words[i].bits);
    REQUIRE(face.frame() == before);
}

TEST_CASE("a frame begins after its preparation, ends with its last pixel, and is counted cycle by cycle",
          "[host]") {
    const Config config = host_config(GENERATE("small", "shaded"));
    Draw draw{7};
    Face face(config);
    face.wait_until_idle();
    for (const auto& [width, height] : std::vector<std::pair<std::uint32_t, std::uint32_t>>{
             {5, 7}, {1, 1}, {16, 12}, {0, 9}, {9, 0}, {(1u << config.pixel_bits) - 1, 2}}) {
        INFO(width << "x" << height);
        Words words = random_frame(config, draw);
        Frame frame = unpack<Frame>(words.data(), config);
        frame.width = width;
        frame.height = height;
        face.write_frame(frame);
        face.seen_running = face.counted = face.starts = 0;
        face.cleared.clear();
        face.left = std::int64_t(width) * height;
        face.write(register_address("Start"), 1);   // the first cycle of the preparation is over
        REQUIRE((face.read("Status") & 3) == 1);
        int prepared = 0;
        for (; !face.get("start") && !face.get("done"); ++prepared) {
            REQUIRE(prepared < 20);   // sixteen cycles, including those on the bus
            REQUIRE_FALSE(face.get("running"));
            face.clock();
        }
        REQUIRE(face.cleared == std::set<std::uint64_t>{0, 1, 2, 3, 4, 5, 6, 7});
        if (width * height == 0) {
            REQUIRE(face.read("Status") == 2);
            REQUIRE((face.starts == 0 && face.seen_running == 0));
            continue;
        }
        face.clock();
        REQUIRE((face.starts == 1 && face.get("running")));
        const Words kept = face.frame();
        const int busy_accesses = width * height > 20 ? 1 : 0;
        for (int i = 0; i < busy_accesses; ++i) {   // the accesses that a running frame refuses and allows
            REQUIRE_FALSE(face.access(true, frame_base, 3).good);
            REQUIRE_FALSE(face.access(true, register_address("Start"), 1).good);
            REQUIRE_FALSE(face.access(false, counter_base + 2).good);
            REQUIRE(face.read("Left") == width * height);
            REQUIRE((face.read("Status") & 3) == 1);
            const std::uint64_t from = face.seen_running;
            const std::uint32_t cycles = face.read("Cycles");
            REQUIRE((cycles >= from && cycles <= face.seen_running));
        }
        while (face.left > 0) {
            const int most = int(std::min<std::int64_t>(config.pipelines, face.left));
            face.deliver(draw.below(3) == 0 ? 0u : (1u << draw.between(1, most)) - 1);
            REQUIRE(face.get("running"));
            face.clock();
        }
        face.deliver(0);
        REQUIRE(face.left == 0);
        REQUIRE_FALSE(face.get("running"));
        REQUIRE(face.get("done"));
        REQUIRE(face.frame() == kept);
        REQUIRE(face.counted == face.seen_running);
        REQUIRE(face.read("Cycles") == face.seen_running);
        REQUIRE(face.access(false, register_address("Cycles") + 1).value == face.seen_running >> 32);
        REQUIRE(face.read("Status") == 2);
        REQUIRE(face.access(false, counter_base + 2).good);
        REQUIRE(face.starts == 1);
    }
}

TEST_CASE("the pixels of any picture are counted, up to the largest", "[host]") {
    const Config config = host_config("small");
    const std::uint32_t most = 1u << config.pixel_bits;
    for (const auto& [width, height] : std::vector<std::pair<std::uint32_t, std::uint32_t>>{
             {most, most}, {most - 1, most - 1}, {1, most}, {most, 1}, {257, 256}, {3, 128}, {5, 10923}}) {
        INFO(width << "x" << height);
        Face face(config);
        face.wait_until_idle();
        Frame frame;
        frame.width = width, frame.height = height;
        face.write_frame(frame);
        face.write(register_address("Start"), 1);
        while (!face.get("running")) face.clock();
        REQUIRE(face.read("Left") == width * height);
        face.left = std::int64_t(width) * height;
        if (face.left > 100'000) continue;
        face.deliver(1);
        while (face.get("running")) face.clock();
        CHECK(face.left == 0);
        CHECK(face.get("done"));
    }
}

TEST_CASE("counters that are held can be read while a frame is under way", "[host]") {
    const Config config = host_config("small");
    Draw draw{3};
    Face face(config);
    face.wait_until_idle();
    Frame frame = unpack<Frame>(random_frame(config, draw).data(), config);
    frame.width = frame.height = 8;
    face.write_frame(frame);
    face.write(register_address("Start"), 1);
    while (!face.get("running")) face.clock();
    for (int i = 0; i < 50; ++i) face.clock();
    face.write(register_address("Count"), 0);
    const std::uint32_t cycles = face.read("Cycles");
    REQUIRE(cycles == face.counted);
    REQUIRE(face.access(false, counter_base + 2).good);
    REQUIRE(face.read("Cycles") == cycles);
    REQUIRE((face.read("Status") & 1) == 1);
    face.write(register_address("Count"), 1);
    REQUIRE_FALSE(face.access(false, counter_base + 2).good);
    REQUIRE(face.read("Cycles") > cycles);
}
