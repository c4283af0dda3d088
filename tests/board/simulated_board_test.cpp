// Frames on the simulated board, from the host's wire to memory and screen, compared with the model's. Faults
// of the whole board: a reset in the middle of a frame, and a memory without refreshes.
#include <fstream>

#include <catch2/catch.hpp>

#include "sim/board/host.hpp"
#include "sim/board/simulated_board.hpp"
#include "sim/files/image/srgb.hpp"
#include "sim/files/scratch.hpp"
#include "sim/run/film/choice.hpp"
#include "sim/run/frame/frame.hpp"
#include "sim/run/request/request.hpp"
#include "sim/run/rtl/sources.hpp"
#include "tests/board/stepped_board.hpp"
#include "tests/support/machine/frames.hpp"

namespace rayclock::test::simulated_board_test {

using namespace rayclock;

namespace {

using Bytes = std::array<std::uint8_t, 3>;

struct Setting {
    /// The caches are small, so that the frame waits for memory.
    ConfigChoice config{"ulx3s-board", {"node_sets=4", "node_ways=1", "prim_sets=4", "prim_ways=1"}};
    std::string scene = "cornell";
    FrameSize size{16, 12};
    int khz = 30'000;   // a slow clock: the frames of the screen take fewer cycles
    std::string sdram = "as4c32m16sb";
    bool is_lit = false;
    int depth = 1;
    bool gates_clock = true;
};

BoardShape shape_of(const Setting& s) {
    return {.khz = s.khz,
            .baud = std::uint32_t(s.khz) * 200,
            .sdram = s.sdram,
            .initial_wait_us = 5,
            .is_lit = s.is_lit,
            .gates_clock = s.gates_clock};
}

/// The channel of a board that also follows its beam: the LEDs must show cycle 0 at the model's distance from
/// the vertical blank.
class WatchedBoard : public SteppedBoard {
public:
    WatchedBoard(const Config& config, const BoardShape& shape)
        : SteppedBoard(config, shape), beam_({.chip_khz = std::uint32_t(shape.khz)}) {
        for (std::uint64_t i = 0; i < board.cycle(); ++i) beam_.clock({});
    }

    std::vector<std::uint64_t> starts;   ///< cycles from the blank to cycle 0, of each frame

private:
    void step() override {
        const bool armed = board.leds() >> 1 & 1, runs = board.leds() >> 2 & 1;
        if (beam_.takes()) taken_at_ = board.cycle();
        if (runs && !ran_) starts.push_back(board.cycle() - taken_at_);
        if (runs) CHECK_FALSE(armed);
        ran_ = runs;
        beam_.clock({});
        board.step();
    }

    ScanOut beam_;
    std::uint64_t taken_at_ = 0;
    bool ran_ = false;
};

BoardShape with_gate(BoardShape shape, bool gates_clock) {
    shape.gates_clock = gates_clock;
    return shape;
}

/// Two boards that get the same bytes, one of them without a clock gate. Their pins must be equal in every
/// cycle.
class TwinBoards : public Channel {
public:
    TwinBoards(const Config& config, const BoardShape& shape)
        : gated_(config, with_gate(shape, true)), plain_(config, with_gate(shape, false)) {}

    Moved exchange(std::span<const std::uint8_t> out, std::span<std::uint8_t> in, LinkTime most) override {
        for (SimulatedBoard* board : {&gated_, &plain_})
            board->from_host().bytes.insert(board->from_host().bytes.end(), out.begin(), out.end());
        std::deque<std::uint8_t>& bytes = gated_.to_host().bytes;
        for (const LinkTime end = now() + most; now() < end && bytes.empty();) step();
        if (bytes != plain_.to_host().bytes) FAIL("cycle " << gated_.cycle() << ": other bytes to the host");
        Moved moved{out.size(), std::min(in.size(), bytes.size())};
        std::copy_n(bytes.begin(), moved.read, in.begin());
        bytes.erase(bytes.begin(), bytes.begin() + std::ptrdiff_t(moved.read));
        plain_.to_host().bytes = bytes;
        return moved;
    }
    LinkTime now() override { return gated_.now(); }

private:
    void step() {
        gated_.step();
        plain_.step();
        SdramChipPins a = gated_.memory_pins(), b = plain_.memory_pins();
        for (SdramChipPins* pins : {&a, &b}) {   // other bits of DQ come from registers without a reset
            const std::uint32_t written = pins->driven ? ~pins->dqm : 0;
            pins->dq &= std::uint16_t((written & 1 ? 0xff : 0) | (written & 2 ? 0xff00 : 0));
        }
        const char* differ = a != b                           ? "the memory's pins"
                             : gated_.leds() != plain_.leds() ? "the LEDs"
                             : gated_.tmds() != plain_.tmds() ? "the screen's pins"
                                                              : nullptr;
        if (differ) FAIL("cycle " << gated_.cycle() << ": " << differ << " differ");
    }

    SimulatedBoard gated_, plain_;
};

std::vector<Bytes> bytes_of_frame(const Job& job, const Trace& frame) {
    std::vector<Bytes> bytes;
    if (job.config.has_shade())
        for (const glm::vec3& pixel : picture_from_colours(job.size, frame.colours).pixels)
            bytes.push_back(srgb_bytes(pixel));
    else
        for (const Closest& hit : frame.hits) bytes.push_back(label_colour(hit.found, hit.prim));
    return bytes;
}

void require_counters(const Config& config, const Accounts& model, const Accounts& board) {
    for (std::size_t u = 0; u < unit_count; ++u) {
        if (Unit(u) == Unit::memory || !is_there(Unit(u), config)) continue;
        INFO("unit " << unit_infos[u].name);
        CHECK(model.units[u] == board.units[u]);
    }
}

/// The picture in the middle of the screen, doubled if it fits.
std::vector<Bytes> on_screen(FrameSize size, const std::vector<Bytes>& bytes) {
    const int scale = Screens::doubles(std::uint32_t(size.width), std::uint32_t(size.height)) ? 2 : 1;
    const int left = (640 - scale * size.width) / 2, top = (480 - scale * size.height) / 2;
    std::vector<Bytes> screen(640 * 480);
    for (int y = 0; y < scale * size.height; ++y)
        for (int x = 0; x < scale * size.width; ++x)
            screen[std::size_t((top + y) * 640 + left + x)] =
                bytes[std::size_t(y / scale * size.width + x / scale)];
    return screen;
}

LinkSettings settings_of(const Setting& s) {
    LinkSettings settings;
    settings.baud = shape_of(s).baud;
    settings.hello = 1;
    return settings;
}

/// Draws frames on the board and on the model, and requires that everything is equal. The camera turns,
/// unless the scene moves.
void require_equal_frames(const Setting& s, int frames) {
    INFO(s.scene << ", " << s.size.width << "x" << s.size.height << ", " << s.khz << " kHz, " << s.sdram);
    Finish finish;
    if (s.depth > 0) finish.depth = s.depth;
    Request request = request_of(s.scene, s.config, finish, 1, s.size, {});
    request.config.board_sdram = s.sdram;
    const Config config = request.config;
    FramesOptions options;
    options.frames = frames;
    if (!moves(request.scene)) options.pan = 5;
    Film film(std::move(request), options, false, s.size);

    std::vector<Job> jobs;
    std::vector<RecordedFrame> recorded;
    for (int f = 0; f < frames; ++f) {
        film.next();
        jobs.push_back(film.job());
        recorded.push_back(film.record(0, {}));
        CHECK(film.moves() == !recorded.back().upload.lines.empty());
    }
    const std::vector<FrameTiming> model = replay(config, s.khz, recorded);

    WatchedBoard watched(config, shape_of(s));
    BoardLink link(watched, settings_of(s));
    BoardHost host(link, config, sdram_part(s.sdram));
    std::uint64_t done = 0;
    host.load(jobs[0].image, done);
    std::vector<Bytes> expected;
    for (int f = 0; f < frames; ++f) {
        INFO("frame " << f);
        const std::size_t i = std::size_t(f);
        if (f > 0) host.update(recorded[i].upload);
        const BoardFrame frame = host.run(jobs[i].frame, LinkTime(1'000'000));
        CHECK(frame.cycles == model[i].cycles);
        CHECK(frame.written_cycles > frame.cycles);
        CHECK(frame.written_cycles < frame.cycles + 2000);
        CHECK(frame.underruns == 0);
        require_counters(config, model[i].accounts, frame.accounts);
        expected = bytes_of_frame(jobs[i], recorded[i].trace);
        CHECK(frame.pixels == expected);
        REQUIRE(watched.starts.size() == i + 1);
        CHECK(watched.starts.back() == BoardMemory::start_cycles);
    }
    if (s.is_lit) {
        watched.board.watch(2);
        CHECK(watched.board.screen().picture().pixels == on_screen(s.size, expected));
        CHECK(watched.board.screen().errors().empty());
        CHECK(watched.board.receiver().errors().empty());
    }
    CHECK(watched.board.sdram().violations().empty());
}

/// A frame as the model draws it.
struct ModelFrame {
    explicit ModelFrame(const Setting& s) {
        Request request = request_of(s.scene, s.config, {}, 1, s.size, {});
        Film film(std::move(request), {}, false, s.size);
        film.next();
        job = film.job();
        recorded.push_back(film.record(0, {}));
        timing = replay(job.config, s.khz, recorded)[0];
        pixels = bytes_of_frame(job, recorded[0].trace);
    }
    Job job;
    std::vector<RecordedFrame> recorded;
    FrameTiming timing;
    std::vector<Bytes> pixels;
};

/// The channel of a board whose reset button is pressed once, in the middle of a frame.
class ResetBoard : public Channel {
public:
    ResetBoard(SimulatedBoard& board, std::uint64_t at) : board_(board), at_(at) {}

    Moved exchange(std::span<const std::uint8_t> out, std::span<std::uint8_t> in, LinkTime most) override {
        const Moved moved = board_.exchange(out, in, std::min(most, LinkTime(1)));
        const bool runs = board_.leds() >> 2 & 1;
        if (runs && begin_ == 0) begin_ = board_.cycle();
        if (runs && !is_reset && board_.cycle() - begin_ >= at_) {
            board_.reset();
            is_reset = true;
        }
        return moved;
    }
    LinkTime now() override { return board_.now(); }

    bool is_reset = false;

private:
    SimulatedBoard& board_;
    std::uint64_t at_, begin_ = 0;
};

/// Builds the RTL with a module in which one text is replaced by another.
class ChangedModule {
public:
    ChangedModule(const std::string& name, const std::string& old, const std::string& fresh)
        : folder_("rayclock-changed") {
        std::string text = module_text(name);
        const std::size_t at = text.find(old);
        REQUIRE(at != std::string::npos);
        REQUIRE(text.find(old, at + 1) == std::string::npos);
        const std::filesystem::path file = folder_.path() / "module.sv";
        std::ofstream(file) << text.replace(at, old.size(), fresh);
        replace_module(name, file);
    }
    ~ChangedModule() { restore_modules(); }
    ChangedModule(const ChangedModule&) = delete;

private:
    TemporaryFolder folder_;
};
/// A refresh comes every 4 ms in place of every 7.8 us, so a row is refreshed after half a minute.
struct StarvedRefresh : ChangedModule {
    StarvedRefresh() : ChangedModule("board_memory", ".RefiPs(RefiPs)", ".RefiPs(32'd4_000_000_000)") {}
};

ConfigChoice camera_chip() { return {"ulx3s", {"dram=board", "scan_out=1", "pixel_writes=1"}}; }

}   // namespace

TEST_CASE("the RTL of the simulated board is built", "[.build]") {
    for (const ConfigChoice& choice : {Setting().config, camera_chip()})
        const SimulatedBoard board(load_config(choice), shape_of({}));
    BoardShape plain = shape_of({});
    plain.gates_clock = false;
    const SimulatedBoard board(load_config(camera_chip()), plain);
    const StarvedRefresh starved;
    const SimulatedBoard another(load_config(camera_chip()), shape_of({}));
    SUCCEED("all are there");
}

TEST_CASE("two frames of a shading chip on the board are the model's", "[simulated]") {
    require_equal_frames({}, 2);
}

TEST_CASE("frames of a scene that moves are the model's", "[simulated]") {
    require_equal_frames({.scene = "tests/board/moving.json"}, 2);
}

TEST_CASE("a frame of a camera's chip on the board is the model's, up to the screen", "[simulated]") {
    require_equal_frames({.config = camera_chip(), .is_lit = true, .depth = 0}, 1);
}

TEST_CASE("a chip whose clock stands still while it is idle leaves every pin as it was",
          "[simulated][long]") {
    const Setting s{.config = camera_chip(), .is_lit = true, .depth = 0};
    const Job job = make_shot(s.scene, s.size, load_config(s.config)).job;
    TwinBoards boards(job.config, shape_of(s));
    BoardLink link(boards, {.baud = shape_of(s).baud, .hello = 1});
    BoardHost host(link, job.config, sdram_part(s.sdram));
    std::uint64_t done = 0;
    host.load(job.image, done);
    for (int f = 0; f < 2; ++f) {
        const BoardFrame frame = host.run(job.frame, LinkTime(1'000'000));
        CHECK(frame.cycles > 0);
        CHECK(frame.pixels.size() == std::size_t(s.size.width * s.size.height));
    }
}

TEST_CASE("a frame that does not end in time is reported in one sentence", "[simulated]") {
    const Config config = load_config(camera_chip());
    SimulatedBoard board(config, shape_of({}));
    BoardLink link(board, {.baud = shape_of({}).baud, .hello = 1});
    BoardHost host(link, config, sdram_part("as4c32m16sb"));
    // The blank, in which the frame would start, is up to 16.8 ms away.
    Frame frame;
    frame.width = 16, frame.height = 12;
    CHECK_THROWS_WITH(host.run(frame, LinkTime(1000)), "the board hangs: the frame has not ended after 1 ms");
}

TEST_CASE("a reset in the middle of a frame is reported, and the next frame is the model's",
          "[simulated][long]") {
    const Setting s{.config = camera_chip(), .depth = 0};
    const ModelFrame model(s);
    SimulatedBoard board(model.job.config, shape_of(s));
    for (const std::uint64_t at : {std::uint64_t(1), model.timing.cycles / 2, model.timing.cycles - 200}) {
        INFO("reset after " << at << " of " << model.timing.cycles << " cycles");
        ResetBoard channel(board, at);
        BoardLink link(channel, settings_of(s));
        BoardHost host(link, model.job.config, sdram_part(s.sdram));
        std::uint64_t done = 0;
        host.load(model.job.image, done);
        CHECK_THROWS_AS(host.run(model.job.frame, LinkTime(1'000'000)), BoardReset);
        REQUIRE(channel.is_reset);
        // The old session is over, and no result of the frame that was cut off is left.
        CHECK_THROWS_AS(host.accounts(), BoardReset);
        BoardLink next_link(board, settings_of(s));
        BoardHost next(next_link, model.job.config, sdram_part(s.sdram));
        CHECK_THROWS_WITH(next.picture(), Catch::Contains("has not drawn a frame"));
        CHECK_THROWS_WITH(next.timing(), Catch::Contains("has not drawn a frame"));
        CHECK_THROWS_WITH(next.draw(LinkTime(1'000'000)), Catch::Contains("no scene was loaded"));

        done = 0;
        next.load(model.job.image, done);
        const BoardFrame frame = next.run(model.job.frame, LinkTime(1'000'000));
        CHECK(frame.cycles == model.timing.cycles);
        CHECK(frame.underruns == 0);
        CHECK(frame.pixels == model.pixels);
        require_counters(model.job.config, model.timing.accounts, frame.accounts);
    }
    CHECK(board.sdram().violations().empty());
}

TEST_CASE("a memory whose refreshes are starved is reported", "[simulated]") {
    const Setting s{.config = camera_chip(), .depth = 0};
    const StarvedRefresh starved;
    const ModelFrame model(s);
    SimulatedBoard board(model.job.config, shape_of(s));
    BoardLink link(board, settings_of(s));
    BoardHost host(link, model.job.config, sdram_part(s.sdram));
    std::uint64_t done = 0;
    host.load(model.job.image, done);
    const auto reported = [&](SdramFault fault) {
        std::size_t count = 0;
        for (const SdramChip::Violation& v : board.sdram().violations()) count += v.fault == fault;
        return count;
    };
    CHECK(reported(SdramFault::retention) == 0);
    for (int ms = 0; ms < 64; ++ms)
        for (int i = 0; i < s.khz; ++i) board.step();
    // A refresh also closes the rows, so some are open for too long now.
    CHECK(reported(SdramFault::retention) == 1);
    CHECK(reported(SdramFault::retention) + reported(SdramFault::tras_longest) ==
          board.sdram().violations().size());
    // The cycles show it too: the model's refreshes cost some.
    CHECK(host.run(model.job.frame, LinkTime(1'000'000)).cycles != model.timing.cycles);
}

// The test gate:board runs this case with Yosys's netlist of the whole board.
TEST_CASE("a frame of a small chip on a board without a clock gate is the model's", "[simulated][slow]") {
    require_equal_frames({.config = {"small", {"dram=board", "scan_out=1", "pixel_writes=1"}},
                          .scene = "tetra:1",
                          .size = {8, 6},
                          .khz = 25'000,
                          .is_lit = true,
                          .depth = 0,
                          .gates_clock = false},
                         2);
}

TEST_CASE("the smaller SDRAM has the rows of its model", "[simulated][slow]") {
    require_equal_frames({.khz = 62'500, .sdram = "is42s16160g", .is_lit = true}, 1);
}

TEST_CASE("the SDRAM's longer latency above 100 MHz is the model's", "[simulated][slow]") {
    require_equal_frames({.khz = 125'000}, 1);
}

TEST_CASE("a frame that waits for memory is the model's", "[simulated][slow]") {
    require_equal_frames({.scene = "gears:1", .size = {40, 30}, .khz = 75'000}, 2);
    ConfigChoice kd = camera_chip();
    for (const char* set : {"node_sets=4", "node_ways=1", "prim_sets=4", "prim_ways=1", "structure=kd"})
        kd.set.push_back(set);
    require_equal_frames({.config = kd, .size = {40, 30}, .khz = 75'000, .depth = 0}, 1);
}

TEST_CASE("two levels and a larger picture are the model's", "[simulated][slow]") {
    ConfigChoice levels = camera_chip();
    levels.set.push_back("levels=2");
    require_equal_frames({.config = levels, .scene = "gears:2", .khz = 75'000, .depth = 0}, 1);
    require_equal_frames({.config = {"ulx3s-board", {}}, .size = {160, 120}, .khz = 75'000, .is_lit = true},
                         1);
}

}   // namespace rayclock::test::simulated_board_test
