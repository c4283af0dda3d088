// rayclock board: loads, draws and compares frames on a real or a simulated board.
#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "model/base/error.hpp"
#include "model/base/nearest.hpp"
#include "model/base/quote.hpp"
#include "model/base/stopwatch.hpp"
#include "sim/app/options/command_line.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/parts/board_session.hpp"
#include "sim/files/image/image.hpp"
#include "sim/files/output.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/files/table.hpp"
#include "sim/view/report/json.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

using nlohmann::ordered_json;

void declare_board(Parser& parser, BoardOptions& o) {
    parser.option(
        "ACTION", o.action,
        "check (can be left out): draw SCENE on the board and on the model, and compare; load: only "
        "write SCENE to the board; run: draw what is loaded; read: picture or memory; counters: of "
        "the last frame; serve: simulate a board for other programs");
    scene_option(parser, o.scene);
    finished_options(parser, o.finish);
    view_options(parser, o.view);
    size_option(parser, o.size);
    frames_options(parser, o.frames);
    one_clock_option(parser, o.clock);
    config_options(parser, o.config);
    parser
        .option("--port", o.port,
                "serial port of a board, such as /dev/ttyUSB0, or 'simulated': the board's RTL from pin to "
                "pin. serve makes this file, a link to its pseudo-terminal")
        .with_default();
    parser
        .option("--patience", o.patience,
                "make all time-outs this many times longer than for a real board; default: 500 at a "
                "pseudo-terminal, otherwise 1")
        .within(1, 1'000'000);
    parser.option("--sdram", o.sdram, "memory of the board: as4c32m16sb or is42s16160g").with_default();
    parser.flag("--dark", o.dark, "leave out the simulated screen, which is faster");
    parser.option("--lines", o.lines, "read: FIRST:COUNT, these lines of memory, 64 bytes each");
    parser.option("--cycles", o.cycles, "serve: end when the board has had this many cycles");
    parser.option("-o,--output", o.output,
                  "folder for model.png, board.png and screen.png; of a film for frame_NNNN.png, film.png "
                  "and screen.png. read: file for the picture (PNG) or the lines. serve: PNG file for the "
                  "screen");
    json_option(parser, o.json);
}

/// A board at a port, for an action that takes no scene.
struct LoadedBoard {
    explicit LoadedBoard(const BoardOptions& o) : progress(stopping(terminal_progress())) {
        o.json.check();
        sdram_part(o.sdram);   // throws
        std::unique_ptr<Port> port = open_port(o);
        config = load_config(o.config);
        khz = settle_board(o, config);
        session.emplace(o, config, khz, std::move(port));
    }
    BoardHost& host() { return session->host(); }

    Progress progress;
    Config config;
    int khz = 0;
    std::optional<BoardSession> session;
};

int load_scene_on_board(const BoardOptions& o) {
    const Progress progress = stopping(terminal_progress());
    BoardRequest asked = board_request(o, progress);
    const std::string name = asked.request.scene.name;
    BoardSession session(o, asked.request.config, asked.khz, std::move(asked.port));
    Film film(std::move(asked.request), o.frames, o.view.is_given(), asked.size, progress);
    if (film.frames() > 1)
        throw UserError("--frames: load writes the scene of one frame; check draws the frames of a film");
    film.next();
    const Stopwatch watch;
    std::uint64_t done = 0;
    session.host().load(film.job().image, done, progress);
    session.host().set_frame(film.job().frame);
    const double seconds = watch.seconds();
    if (!o.json.is_alone())
        fmt::print(
            "{} is on the board: {} lines of 64 bytes in {:.1f} s\n"
            "  rayclock board run --port {} draws it\n",
            name, grouped(done), seconds, shell_word(o.port));
    o.json.write({{"lines_written", done}, {"seconds", seconds}});
    return 0;
}

int run_loaded(const BoardOptions& o) {
    if (o.frames.frames < 1 || o.frames.frames > max_frames)
        throw UserError(fmt::format("--frames: {} is not from 1 to {}", o.frames.frames, max_frames));
    LoadedBoard board(o);
    constexpr LinkTime longest{60'000'000};   // the frame's length is unknown
    Table table({"frame", "cycles", "until the last pixel is in memory", "frames/s", "underruns"});
    ordered_json frames = ordered_json::array();
    board.host().reset();
    for (int f = 0; f < o.frames.frames; ++f) {
        const BoardTiming timing = board.host().draw(longest);
        table.add({std::to_string(f), grouped(timing.cycles), grouped(timing.written_cycles),
                   fmt::format("{:.2f}", board.khz * 1e3 / double(timing.written_cycles)),
                   grouped(timing.underruns)});
        frames.push_back({{"cycles", {{"board", timing.cycles}, {"written", timing.written_cycles}}},
                          {"underruns", timing.underruns}});
        if (board.progress) board.progress("drawing", std::uint64_t(f) + 1, std::uint64_t(o.frames.frames));
    }
    if (!o.json.is_alone()) fmt::print("{}", table.text());
    o.json.write({{"frames", frames}});
    return 0;
}

int read_back(const BoardOptions& o) {
    if (o.output.empty()) throw UserError("read: -o names the file for the picture or the lines");
    std::pair<std::uint64_t, std::uint64_t> lines;
    if (o.lines) {
        lines = parse_lines(*o.lines);
        check_writable(o.output);
    } else {
        check_png(o.output);
    }
    LoadedBoard board(o);
    ordered_json json;
    std::string what;
    if (o.lines) {
        const std::vector<MemoryLine> read =
            board.host().read_lines(lines.first, lines.second, board.progress);
        write_file(o.output, std::string(reinterpret_cast<const char*>(read.data()), read.size() * 64));
        what = fmt::format("{} lines of 64 bytes from line {} on", grouped(read.size()), lines.first);
        json["lines"] = {{"first", lines.first}, {"count", lines.second}};
    } else {
        const BoardPicture picture = board.host().picture(board.progress);
        const FrameSize size{int(picture.width), int(picture.height)};
        write_file(o.output, png_bytes(picture_of(size, picture.pixels)));
        what = fmt::format("the picture of {}x{} pixels", size.width, size.height);
        json["frame"] = {{"width", size.width}, {"height", size.height}};
    }
    if (!o.json.is_alone()) fmt::print("{} has {}\n", printable(o.output), what);
    o.json.write(json);
    return 0;
}

int print_counters(const BoardOptions& o) {
    LoadedBoard board(o);
    const BoardTiming timing = board.host().timing();
    const Accounts accounts = board.host().accounts();
    // By CauseKind. The keys have the meaning that they have in the report of simulate.
    constexpr const char* kinds[] = {"", "busy", "starved", "stalled"};
    constexpr const char* keys[] = {"", "busy_with", "starved_by", "stalled"};
    Table table({"unit", "state", "cause", "cycles"}, 3);
    ordered_json units = ordered_json::object();
    for (std::size_t u = 0; u < unit_count; ++u) {
        if (Unit(u) == Unit::memory || !is_there(Unit(u), board.config)) continue;
        ordered_json& unit = units[unit_infos[u].name];
        for (std::size_t c = 0; c < cause_count; ++c) {
            const Cause& cause = unit_infos[u].causes[c];
            if (cause.kind == CauseKind::none) continue;
            const std::size_t kind = std::size_t(cause.kind);
            const std::uint64_t cycles = accounts.units[u][c];
            unit[keys[kind]][cause.name] = cycles;
            if (cycles > 0) table.add({unit_infos[u].name, kinds[kind], cause.name, grouped(cycles)});
        }
    }
    if (!o.json.is_alone())
        fmt::print("{} cycles, {} until the last pixel is in memory\n{}", grouped(timing.cycles),
                   grouped(timing.written_cycles), table.text());
    o.json.write({{"cycles", {{"board", timing.cycles}, {"written", timing.written_cycles}}},
                  {"underruns", timing.underruns},
                  {"units", units}});
    return 0;
}

/// An action of the command.
struct Action {
    const char* name;
    int (*run)(const BoardOptions&);
    bool takes_scene, needs_port;
};
constexpr Action actions[] = {
    {"check", check_frames, true, false},      {"load", load_scene_on_board, true, true},
    {"run", run_loaded, false, true},          {"read", read_back, false, true},
    {"counters", print_counters, false, true}, {"serve", serve_board, false, false}};

/// Throws UserError if an option was given that has no meaning for the action.
void check_meaning(const Action& action, const BoardOptions& o) {
    const std::string_view name = action.name;
    const BoardOptions none;
    const auto refuse = [&](bool is_given, const char* option) {
        if (is_given) throw UserError(fmt::format("{} has no meaning for {}", option, name));
    };
    if (!action.takes_scene) {
        if (!o.scene.empty()) throw UserError(fmt::format("{} takes no scene; load and check do", name));
        refuse(o.finish.is_given(), "an option of the finished picture, such as --depth,");
        refuse(o.view.is_given(), "an option of the view, such as --eye,");
        refuse(o.size != none.size, "--size");
        FramesOptions frames = o.frames;
        if (name == "run") frames.frames = 1;
        refuse(frames.is_given(), "an option of several frames");
    } else if (o.scene.empty()) {
        throw UserError(fmt::format("{}: SCENE is missing", name));
    }
    FramesOptions one = o.frames;   // with the moment of the frame
    one.fps = none.frames.fps, one.time = none.frames.time;
    refuse(name == "load" && one.is_given(), "an option of several frames");
    refuse(o.lines && name != "read", "--lines");
    refuse(o.cycles > 0 && name != "serve", "--cycles");
    refuse(!o.output.empty() && name != "check" && name != "read" && name != "serve", "-o");
    refuse(o.dark && name != "check" && name != "serve", "--dark");
    refuse(o.patience && name == "serve", "--patience");
    if (o.patience && o.is_simulated()) throw UserError("--patience needs --port");
    if (action.needs_port && o.is_simulated())
        throw UserError(
            fmt::format("{} needs --port: a board simulated in this process ends with it, while 'rayclock "
                        "board serve' simulates one for several commands",
                        name));
}

int run_board(const BoardOptions& typed) {
    BoardOptions o = typed;
    const auto is_action = [&](const Action& action) { return action.name == o.action; };
    const Action* action = std::find_if(std::begin(actions), std::end(actions), is_action);
    if (action == std::end(actions)) {   // the word is the scene
        if (!o.scene.empty()) {
            std::vector<std::string> names;
            for (const Action& known : actions) names.emplace_back(known.name);
            throw UserError(fmt::format("board has no action called {}{}; there are {}", shown(o.action),
                                        did_you_mean(o.action, names), fmt::join(names, ", ")));
        }
        o.scene = o.action;
        action = actions;
    }
    check_meaning(*action, o);
    return action->run(o);
}

}   // namespace

Command board_command() {
    return command("board", "load, draw and compare frames on a ULX3S, simulated or real",
                   "rayclock board balls:2 --depth 1 -o out", declare_board, run_board);
}

}   // namespace rayclock
