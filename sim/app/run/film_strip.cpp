// Records the frames of a film, compares them and writes their pictures.
#include "sim/app/run/film_strip.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "model/trace/hits.hpp"
#include "sim/app/run/picture_folder.hpp"
#include "sim/files/image/image.hpp"
#include "sim/run/film/make_film.hpp"
#include "sim/run/request/reference_picture.hpp"
#include "sim/view/report/accounts.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

using nlohmann::ordered_json;

namespace {

/// The model's picture of the current frame, and the hits of its pixels.
struct DrawnFrame {
    HitFrame hits;
    Picture picture;
};
DrawnFrame drawn(const Request& request, const Job& job, const RecordedFrame& trace) {
    HitFrame hits = hits_of(job, trace);
    Picture picture =
        request.finished ? picture_from_colours(job.size, trace.trace.colours) : shade(request.scene, hits);
    return {std::move(hits), std::move(picture)};
}

}   // namespace

FilmStrip record_film(Film& film, const StripOptions& o, const Progress& progress,
                      std::vector<RecordedFrame>& traces) {
    FilmStrip strip;
    strip.moves = film.moves();
    strip.fps = film.times().fps;
    strip.times = film.times().times;
    const bool is_film = film.moves() && film.frames() > 1;
    if (is_film) strip.folder = o.folder;
    if (!strip.folder.empty()) strip.staged = std::make_shared<StagedFiles>(strip.folder);
    for (std::size_t f = 0; f < film.frames(); ++f) {
        film.next();
        traces.push_back(film.record(o.threads, progress));
        const bool is_written = !strip.folder.empty(),
                   is_compared = o.compares && film.frames() > 1 && !film.is_still();
        if (!is_written && !is_compared) continue;
        const Request& request = film.request();
        const DrawnFrame model = drawn(request, film.job(), traces.back());
        if (is_written) write_pictures(*strip.staged, {{frame_name(f), model.picture, model.hits}});
        if (!is_compared) continue;
        const ReferencePicture reference =
            reference_picture(request, film.camera(), film.job().size, o.threads);
        strip.errors.push_back(frame_error(model.hits, model.picture, reference.hits(), reference.picture));
    }
    return strip;
}

std::vector<FrameError> all_errors(const FilmStrip& strip, const FrameError& last) {
    std::vector<FrameError> errors = strip.errors;
    if (errors.empty()) return {last};
    errors.back() = last;
    return errors;
}

void check_film_folder(const std::string& folder, std::size_t frames) {
    check_picture_folder(folder, {frame_name(0), frame_name(frames - 1), "film.png"});
}

void finish_film(const FilmStrip& strip, bool quiet) {
    if (strip.folder.empty()) return;
    const std::string said = make_film(*strip.staged, strip.folder, strip.times.size(), strip.fps);
    if (!quiet) fmt::print("  {}\n", said);
}

namespace {

/// The figures reported for every frame, as numbers.
struct FrameFigures {
    double cycles = 0, upload = 0, reset = 0, fps = 0, read = 0, written = 0, nodes = 0, prims = 0,
           visits = 0, tests = 0, made = 0, instances = 0, refitted = 0, rebuilt = 0, cost = 0, seconds = 0;
};

struct Figure {
    const char *key, *head;
    double FrameFigures::*value;
    const char* format;
};
constexpr Figure figures[] = {
    {"cycles", "cycles", &FrameFigures::cycles, "{:.0f}"},
    {"upload_cycles", "upload", &FrameFigures::upload, "{:.0f}"},
    {"reset_cycles", "reset", &FrameFigures::reset, "{:.0f}"},
    {"fps", "fps", &FrameFigures::fps, "{:.2f}"},
    {"bytes_read", "bytes read", &FrameFigures::read, "{:.0f}"},
    {"bytes_written", "written", &FrameFigures::written, "{:.0f}"},
    {"node_hit_rate", "node hits", &FrameFigures::nodes, "{:.4f}"},
    {"prim_hit_rate", "tri hits", &FrameFigures::prims, "{:.4f}"},
    {"node_steps", "visits", &FrameFigures::visits, "{:.0f}"},
    {"triangle_tests", "tests", &FrameFigures::tests, "{:.0f}"},
    {"host_nodes", "nodes made", &FrameFigures::made, "{:.0f}"},
    {"host_instances", "instances", &FrameFigures::instances, "{:.0f}"},
    {"host_refitted", "refitted", &FrameFigures::refitted, "{:.0f}"},
    {"host_rebuilt", "rebuilt", &FrameFigures::rebuilt, "{:.0f}"},
    {"host_cost", "cost", &FrameFigures::cost, "{:.3f}"},
    {"host_seconds", "host ms", &FrameFigures::seconds, "{:.3f}"},
};

FrameFigures figures_of(const FrameResult& run, int khz, const Upload& upload) {
    return {double(run.cycles),
            double(run.upload.cycles),
            double(run.upload.reset),
            per_second(run, khz),
            double(bytes_read(run)),
            double(run.upload.lines) * 64,
            cache_account(run, Unit::node_cache).hit_rate(),
            cache_account(run, Unit::prim_cache).hit_rate(),
            double(run.visits),
            double(run.triangle_tests),
            double(upload.nodes),
            double(upload.instances),
            double(upload.refitted),
            double(upload.rebuilt),
            upload.cost,
            upload.seconds};
}

std::vector<FrameFigures> all_figures(const FramesAtClock& run, const std::vector<RecordedFrame>& traces) {
    std::vector<FrameFigures> all;
    for (std::size_t f = 0; f < run.frames.size(); ++f)
        all.push_back(figures_of(run.frames[f], run.khz, traces[f].upload));
    return all;
}

struct Summary {
    double least = 0, mean = 0, most = 0;
};
Summary summary(const std::vector<FrameFigures>& all, double FrameFigures::*value) {
    Summary s{all[0].*value, 0, all[0].*value};
    for (const FrameFigures& f : all) {
        s.least = std::min(s.least, f.*value);
        s.most = std::max(s.most, f.*value);
        s.mean += f.*value / double(all.size());
    }
    return s;
}

std::string cell(const Figure& figure, double value) {
    if (figure.value == &FrameFigures::seconds) value *= 1e3;
    if (std::string_view(figure.format) == "{:.0f}") return grouped(std::uint64_t(std::llround(value)));
    return fmt::format(fmt::runtime(figure.format), value);
}

ordered_json number(double value) {
    if (value == std::floor(value) && std::abs(value) < 1e15) return std::int64_t(value);
    return value;
}

}   // namespace

std::string film_table(const Config&, const std::vector<FramesAtClock>& runs, const FilmStrip& strip,
                       const std::vector<RecordedFrame>& traces) {
    if (!strip.moves || runs.empty() || runs[0].frames.empty()) return {};
    const std::vector<FrameFigures> all = all_figures(runs[0], traces);
    std::vector<std::string> head{"frame", "time s"};
    for (const Figure& figure : figures) head.emplace_back(figure.head);
    std::vector<double> psnr;
    for (const FrameError& error : strip.errors) psnr.push_back(error.psnr_db);
    if (!psnr.empty()) head.emplace_back("PSNR dB");
    Table table(head);
    const auto psnr_cell = [&](double db) { return std::isfinite(db) ? fmt::format("{:.1f}", db) : "equal"; };
    for (std::size_t f = 0; f < all.size(); ++f) {
        std::vector<std::string> row{std::to_string(f + 1), fmt::format("{:.3f}", strip.times[f])};
        for (const Figure& figure : figures) row.push_back(cell(figure, all[f].*figure.value));
        if (!psnr.empty()) row.push_back(psnr_cell(psnr[f]));
        table.add(row);
    }
    const char* const names[] = {"least", "mean", "most"};
    for (int k = 0; k < 3; ++k) {
        std::vector<std::string> row{names[k], ""};
        for (const Figure& figure : figures) {
            const Summary s = summary(all, figure.value);
            row.push_back(cell(figure, k == 0 ? s.least : k == 1 ? s.mean : s.most));
        }
        if (!psnr.empty())
            row.push_back(k == 1   ? ""
                          : k == 0 ? psnr_cell(*std::min_element(psnr.begin(), psnr.end()))
                                   : psnr_cell(*std::max_element(psnr.begin(), psnr.end())));
        table.add(row);
    }
    const bool is_whole =
        std::any_of(traces.begin(), traces.end(), [](const RecordedFrame& t) { return t.upload.is_whole; });
    const bool deforms = std::any_of(traces.begin(), traces.end(), [](const RecordedFrame& t) {
        return t.upload.refitted + t.upload.rebuilt > 0;
    });
    return fmt::format(
        "\n  frames of the moving scene at {:g} MHz; fps includes the host's writes and resets, but not its\n"
        "  time to {}\n{}",
        runs[0].khz / 1e3,
        is_whole  ? "rebuild everything"
        : deforms ? "refit or rebuild its trees"
                  : "rebuild the scene's tree",
        table.text());
}

ordered_json film_json(const Config&, const std::vector<FramesAtClock>& runs, const FilmStrip& strip,
                       const std::vector<RecordedFrame>& traces) {
    if (!strip.moves) return nullptr;
    ordered_json clocks = ordered_json::array();
    for (const FramesAtClock& run : runs) {
        if (run.frames.empty()) continue;
        const std::vector<FrameFigures> all = all_figures(run, traces);
        ordered_json frames = ordered_json::array();
        for (std::size_t f = 0; f < all.size(); ++f) {
            ordered_json frame{{"time", strip.times[f]}, {"host_whole", traces[f].upload.is_whole}};
            for (const Figure& figure : figures) frame[figure.key] = number(all[f].*figure.value);
            frame["psnr_db"] =
                f < strip.errors.size() ? decibel(strip.errors[f].psnr_db) : ordered_json(nullptr);
            frames.push_back(std::move(frame));
        }
        ordered_json least, mean, most;
        for (const Figure& figure : figures) {
            const Summary s = summary(all, figure.value);
            least[figure.key] = number(s.least), mean[figure.key] = number(s.mean),
            most[figure.key] = number(s.most);
        }
        clocks.push_back(
            {{"mhz", run.khz / 1e3}, {"frames", frames}, {"least", least}, {"mean", mean}, {"most", most}});
    }
    return {{"fps", strip.fps}, {"clocks", clocks}};
}

}   // namespace rayclock
