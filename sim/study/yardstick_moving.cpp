// Simulates scenes that move, for comparison with published chips that rendered such scenes.
#include <algorithm>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/interrupted.hpp"
#include "sim/run/film/film.hpp"
#include "sim/study/yardstick.hpp"
#include "sim/view/report/accounts.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

struct MovingRow {
    const char* scene;
    const char* config;
    int mhz;
    const char* published;
};
constexpr const char *saarcor = "SaarCOR 20 to 60 over all scenes",
                     *rpu = "D-RPU up to 35, dynamic scenes included";
constexpr MovingRow published_moving_rows[] = {
    {"clockwork:32", "saarcor", 90, saarcor},
    {"clockwork:32", "rpu", 66, rpu},
    {"clockwork:32", "default", 66, ""},
    {"crowd:15", "saarcor", 90, saarcor},
    {"crowd:15", "rpu", 66, rpu},
    {"crowd:15", "default", 66, ""},
    {"flight:1000", "saarcor", 90, saarcor},
    {"flight:1000", "rpu", 66, rpu},
    {"flight:1000", "default", 66, ""},
};

/// Means over all frames except the first, which writes the whole memory.
struct Means {
    double fps = 0, least = 1e300, rays = 0, cycles = 0, read = 0, written = 0, instances = 0;
    void add(const FrameResult& run, const Upload& upload, int khz, double share) {
        const double here = per_second(run, khz);
        fps += here * share;
        least = std::min(least, here);
        rays += double(run.pixels) * share;
        cycles += double(run.cycles) * share;
        read += double(bytes_read(run)) * share;
        written += double(run.upload.lines) * 64 * share;
        instances += double(upload.instances) * share;
    }
};

Means means_of(const MovingRow& row, FrameSize size, int threads, const Progress& progress) {
    FramesOptions options;
    options.frames = moving_frames + 1;
    options.fps = usual_fps;
    const Request request = request_of(row.scene, {row.config, {"levels=2"}}, {}, 1, size, progress);
    Film film(request, options, false, size, progress);
    std::vector<RecordedFrame> traces;
    for (std::size_t f = 0; f < film.frames(); ++f) {
        film.next();
        traces.push_back(film.record(threads, progress));
    }
    const int khz = 1000 * row.mhz;
    const std::vector<FrameTiming> timings = replay(film.job().config, khz, traces, {}, progress);
    Means means;
    for (std::size_t f = 1; f < traces.size(); ++f) {
        const FrameResult run = frame_result(traces[f], timings[f]);
        if (run.partial) throw Interrupted("interrupted: no page was written");
        means.add(run, traces[f].upload, khz, 1.0 / moving_frames);
    }
    return means;
}

}   // namespace

std::string moving_table(int threads, const Progress& progress) {
    const FrameSize size{512, 384};
    Table table({"scene", "configuration, MHz", "instances that move", "fps", "least", "cycles/ray",
                 "bytes/ray", "bytes written a frame", "published fps, 512x384"},
                Table::words_only);
    for (const MovingRow& row : published_moving_rows) {
        const Means m = means_of(row, size, threads, progress);
        table.add({row.scene, fmt::format("{}, {}", row.config, row.mhz), fmt::format("{:.0f}", m.instances),
                   fmt::format("{:.1f}", m.fps), fmt::format("{:.1f}", m.least),
                   fmt::format("{:.1f}", m.cycles / m.rays), fmt::format("{:.0f}", m.read / m.rays),
                   grouped(std::uint64_t(m.written)), row.published});
    }
    return table.markdown();
}

}   // namespace rayclock
