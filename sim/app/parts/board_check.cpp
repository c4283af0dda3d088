// rayclock board check: draws frames on a board, and compares them with the model's.
#include <algorithm>
#include <filesystem>
#include <functional>
#include <optional>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/stopwatch.hpp"
#include "sim/app/parts/board_session.hpp"
#include "sim/app/run/film_strip.hpp"
#include "sim/app/run/picture_folder.hpp"
#include "sim/board/server.hpp"
#include "sim/files/image/image.hpp"
#include "sim/files/image/srgb.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/files/table.hpp"
#include "sim/run/film/make_film.hpp"
#include "sim/run/frame/frame.hpp"
#include "sim/run/request/request.hpp"
#include "sim/view/report/json.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

std::vector<PixelBytes> bytes_of(const Picture& picture) {
    std::vector<PixelBytes> bytes;
    for (const glm::vec3& pixel : picture.pixels) bytes.push_back(srgb_bytes(pixel));
    return bytes;
}

/// Returns the bytes that the board must have for a frame of the model.
std::vector<PixelBytes> expected_bytes(const Config& config, FrameSize size, const Trace& trace) {
    if (config.has_shade()) return bytes_of(picture_from_colours(size, trace.colours));
    std::vector<PixelBytes> bytes;
    for (const Closest& hit : trace.hits) bytes.push_back(label_colour(hit.found, hit.prim));
    return bytes;
}

/// The screen around a picture: the middle of 640x480 pixels, black around it.
std::vector<PixelBytes> expected_screen(FrameSize size, const std::vector<PixelBytes>& bytes) {
    const bool doubles = Screens::doubles(std::uint32_t(size.width), std::uint32_t(size.height));
    const int scale = doubles ? 2 : 1, left = (int(Screens::width) - scale * size.width) / 2,
              top = (int(Screens::height) - scale * size.height) / 2;
    std::vector<PixelBytes> screen(Screens::width * Screens::height);
    for (int y = 0; y < scale * size.height; ++y)
        for (int x = 0; x < scale * size.width; ++x)
            screen[std::size_t(top + y) * Screens::width + std::size_t(left + x)] =
                bytes[std::size_t(y / scale * size.width + x / scale)];
    return screen;
}

std::uint64_t differences(const std::vector<PixelBytes>& a, const std::vector<PixelBytes>& b) {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += i >= b.size() || a[i] != b[i];
    return count;
}

/// The results of the comparison of one frame.
struct FrameCheck {
    FrameTiming model;
    BoardFrame board;
    std::string first_counter;   ///< a sentence about the first counter that differs
    std::size_t uploaded_lines = 0;
    std::uint64_t wrong_pixels = 0;

    bool is_good() const {
        return model.cycles == board.cycles && first_counter.empty() && wrong_pixels == 0 &&
               board.underruns == 0;
    }
    std::uint64_t gap() const {
        return std::max(model.cycles, board.cycles) - std::min(model.cycles, board.cycles);
    }
};

/// The results of the comparison.
struct BoardCheck {
    std::vector<FrameCheck> frames;
    std::uint32_t underruns = 0;   ///< also while the screen shows the last frame
    // Of a simulated board, after the last frame:
    std::optional<std::uint64_t> wrong_screen_pixels;
    std::vector<std::string> faults;   ///< of SDRAM, screen and cable, the first ones
    std::uint64_t simulated_cycles = 0;

    bool is_good() const {
        return std::all_of(frames.begin(), frames.end(), std::mem_fn(&FrameCheck::is_good)) &&
               underruns == 0 && wrong_screen_pixels.value_or(0) == 0 && faults.empty();
    }
};

/// The board does not count the memory's cycles, so that account is not compared.
std::string counter_sentence(const Config& config, const Accounts& model, const Accounts& board) {
    for (std::size_t u = 0; u < unit_count; ++u)
        for (std::size_t c = 0; Unit(u) != Unit::memory && is_there(Unit(u), config) && c < cause_count; ++c)
            if (model.units[u][c] != board.units[u][c])
                return fmt::format("unit {}, counter {}: the model has {} and the board {}",
                                   unit_infos[u].name, c, model.units[u][c], board.units[u][c]);
    return {};
}

/// Returns the time after which a drawing board counts as hung. It is twice the model's frame plus 250 ms for
/// the vertical blank and the link.
LinkTime longest_frame(std::uint64_t cycles, int khz) {
    return LinkTime(2000 * cycles / std::uint64_t(khz) + 250'000);
}

/// The model's frames, their timings, and the memory image of the first.
struct Recorded {
    MemoryImage image;
    std::vector<RecordedFrame> frames;
    std::vector<FrameTiming> timings;
};

Recorded record(Film& film, const Config& config, int khz, const Progress& progress) {
    Recorded recorded;
    for (std::size_t f = 0; f < film.frames(); ++f) {
        film.next();
        if (f == 0) recorded.image = film.job().image;
        recorded.frames.push_back(film.record(0, progress));
    }
    recorded.timings = replay(config, khz, recorded.frames, {}, progress);
    stop_if_interrupted();
    return recorded;
}

/// A picture size, a configuration and a clock, which hold for all frames.
struct BoardJob {
    FrameSize size;
    Config config;
    int khz;
};

/// Runs the model's frames on the board and compares each. Returns the bytes of the last picture.
std::vector<PixelBytes> run_frames(BoardHost& host, const BoardJob& job, const Recorded& recorded,
                                   BoardCheck& check, const Progress& progress) {
    std::uint64_t done = 0;
    host.load(recorded.image, done, progress);
    std::vector<PixelBytes> expected;
    for (std::size_t f = 0; f < recorded.timings.size(); ++f) {
        const RecordedFrame& frame = recorded.frames[f];
        FrameCheck& now = check.frames.emplace_back();
        now.model = recorded.timings[f];
        now.uploaded_lines = f == 0 ? recorded.image.lines() : frame.upload.lines.size();
        if (f > 0) host.update(frame.upload);
        now.board = host.run(frame.frame, longest_frame(now.model.cycles, job.khz), progress);
        now.first_counter = counter_sentence(job.config, now.model.accounts, now.board.accounts);
        expected = expected_bytes(job.config, job.size, frame.trace);
        now.wrong_pixels = differences(expected, now.board.pixels);
    }
    return expected;
}

/// Compares the screen of a simulated board with the last picture.
void check_screen(SimulatedBoard& board, FrameSize size, const std::vector<PixelBytes>& expected,
                  BoardCheck& check, const Progress& progress) {
    board.watch(2, progress);
    check.wrong_screen_pixels = differences(expected_screen(size, expected), board.screen().picture().pixels);
    check.faults = screen_faults(board);
}

std::string frame_text(const FrameCheck& frame, int khz) {
    return fmt::format(
        "  cycles: model {}, board {}; {} more until the last pixel is in memory\n"
        "  {:.2f} frames per second without the wait for the vertical blank; a board starts at most {:.1f}, "
        "one "
        "per screen period\n"
        "  counters: {}\n"
        "  pixels: {} of {} differ\n",
        grouped(frame.model.cycles), grouped(frame.board.cycles),
        grouped(frame.board.written_cycles - frame.board.cycles),
        khz * 1e3 / double(frame.board.written_cycles), ScreenTiming::frames_per_second(),
        frame.first_counter.empty() ? "equal" : frame.first_counter, frame.wrong_pixels,
        frame.board.pixels.size());
}

/// A row for each frame, and a sentence for each frame whose counters differ.
std::string film_text(const BoardCheck& check) {
    Table table({"frame", "lines written", "cycles, model", "cycles, board", "wrong pixels", "counters"});
    std::string sentences;
    for (std::size_t f = 0; f < check.frames.size(); ++f) {
        const FrameCheck& frame = check.frames[f];
        table.add({std::to_string(f), grouped(frame.uploaded_lines), grouped(frame.model.cycles),
                   grouped(frame.board.cycles), grouped(frame.wrong_pixels),
                   frame.first_counter.empty() ? "equal" : "DIFFER"});
        if (!frame.first_counter.empty())
            sentences += fmt::format("  frame {}: {}\n", f, frame.first_counter);
    }
    return table.text() + sentences;
}

nlohmann::ordered_json json_of(const BoardCheck& check) {
    nlohmann::ordered_json frames = nlohmann::ordered_json::array(), screen;
    if (check.wrong_screen_pixels) screen = *check.wrong_screen_pixels;
    for (const FrameCheck& frame : check.frames)
        frames.push_back({{"lines_written", frame.uploaded_lines},
                          {"cycles",
                           {{"model", frame.model.cycles},
                            {"board", frame.board.cycles},
                            {"written", frame.board.written_cycles}}},
                          {"cycle_gap", frame.gap()},
                          {"counters_equal", frame.first_counter.empty()},
                          {"wrong_pixels", frame.wrong_pixels},
                          {"underruns", frame.board.underruns}});
    return {{"frames", frames},
            {"underruns", check.underruns},
            {"wrong_screen_pixels", screen},
            {"faults", check.faults},
            {"good", check.is_good()}};
}

void print(const BoardOptions& o, const std::string& scene, const BoardJob& job, bool is_simulated,
           const BoardCheck& check, double seconds) {
    fmt::print("{} on {} at {:.1f} MHz, {}x{} pixels\n", scene, is_simulated ? "the simulated board" : o.port,
               job.khz / 1e3, job.size.width, job.size.height);
    fmt::print("{}", check.frames.size() > 1 ? film_text(check) : frame_text(check.frames[0], job.khz));
    if (check.wrong_screen_pixels)
        fmt::print("  screen: {} of {} pixels differ, {} shown too late\n", *check.wrong_screen_pixels,
                   Screens::width * Screens::height, check.underruns);
    else if (!is_simulated)
        fmt::print("  screen: {} pixels shown too late\n", check.underruns);
    for (const std::string& fault : check.faults) fmt::print("  fault: {}\n", fault);
    if (is_simulated)
        fmt::print("  simulated {} cycles in {:.1f} s, {:.2f} M cycles/s\n", grouped(check.simulated_cycles),
                   seconds, double(check.simulated_cycles) / seconds / 1e6);
    fmt::print("{}\n", check.is_good() ? "EQUAL" : "DIFFERENT");
}

/// Writes the pictures of model, board and screen, or the board's film. `board` is null for a real one.
void write_pictures(const BoardOptions& o, const Film& film, FrameSize size, SimulatedBoard* board,
                    const std::vector<PixelBytes>& expected, const BoardCheck& check) {
    StagedFiles staged(o.output);
    const auto write = [&](const std::string& file, const Picture& picture) {
        write_file((staged.stage() / file).string(), png_bytes(picture));
    };
    if (check.wrong_screen_pixels)
        write("screen.png",
              picture_of({int(Screens::width), int(Screens::height)}, board->screen().picture().pixels));
    if (film.frames() > 1) {
        for (std::size_t f = 0; f < film.frames(); ++f)
            write(frame_name(f), picture_of(size, check.frames[f].board.pixels));
        const std::string said = make_film(staged, o.output, film.frames(), film.times().fps);
        if (!o.json.is_alone()) fmt::print("  {}\n", said);
    } else {
        write("model.png", picture_of(size, expected));
        write("board.png", picture_of(size, check.frames[0].board.pixels));
        staged.publish();
    }
}

}   // namespace

int check_frames(const BoardOptions& o) {
    const Progress progress = stopping(terminal_progress());
    if (!o.output.empty()) check_picture_folder(o.output, {"model.png", "board.png", "screen.png"});
    BoardRequest asked = board_request(o, progress);
    const BoardJob job{.size = asked.size, .config = asked.request.config, .khz = asked.khz};
    if (o.frames.uploads != FramesOptions{}.uploads)
        throw UserError("--uploads " + shown(o.frames.uploads) +
                        ": a board's host writes only between frames");
    const std::string scene = asked.request.scene.name;
    Film film(std::move(asked.request), o.frames, o.view.is_given(), job.size, progress);
    if (!o.output.empty() && film.frames() > 1) check_film_folder(o.output, film.frames());
    // Another bitstream is refused before the model's work.
    std::optional<BoardSession> session;
    if (asked.port) session.emplace(o, job.config, job.khz, std::move(asked.port));
    const Recorded recorded = record(film, job.config, job.khz, progress);

    const Stopwatch watch;
    if (!session) session.emplace(o, job.config, job.khz, nullptr);
    SimulatedBoard* const board = session->simulated();
    BoardHost& host = session->host();
    BoardCheck check;
    const std::vector<PixelBytes> expected = run_frames(host, job, recorded, check, progress);
    if (board && !o.dark) check_screen(*board, job.size, expected, check, progress);
    // A short frame ends before the screen shows it.
    check.underruns = host.underruns(board ? LinkTime(0) : three_screen_periods);
    if (board) {
        const std::vector<std::string> faults = memory_faults(*board);
        check.faults.insert(check.faults.end(), faults.begin(), faults.end());
        check.simulated_cycles = board->cycle();
    }
    const double seconds = watch.seconds();

    if (!o.json.is_alone()) print(o, scene, job, board != nullptr, check, seconds);
    if (!o.output.empty()) write_pictures(o, film, job.size, board, expected, check);
    o.json.write(json_of(check));
    return check.is_good() ? 0 : 1;
}

}   // namespace rayclock
