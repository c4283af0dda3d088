// Draws and judges the frames of the study, and measures each kind of work.
#include "sim/study/scale/measure_scale.hpp"

#include <cmath>
#include <fstream>
#include <limits>
#include <string>

#include <malloc.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/stopwatch.hpp"
#include "model/scene/folded.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/judge/cause/cause.hpp"
#include "sim/run/frame/frame.hpp"
#include "sim/run/request/reference_picture.hpp"

namespace rayclock::scale {

namespace {

/// Resets the peak of peak_bytes() to the memory that the process uses now (proc(5), clear_refs). On a kernel
/// that lacks this file it has no effect, and the peak includes earlier frames.
void reset_peak() {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";
}

/// Returns the most memory that the process has used since reset_peak().
std::uint64_t peak_bytes() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) return 1024 * std::stoull(line.substr(6));
    return 0;
}

/// Runs one kind of work and records its time.
template <class Job> auto timed(Row& row, Work work, Job job) {
    const Stopwatch watch;
    auto made = job();
    row.seconds[std::size_t(work)] = watch.seconds();
    stop_if_interrupted();
    return made;
}

Row measure_row(const std::string& scene, FrameSize size, const Study& study, const Progress& progress) {
    Row row;
    row.scene = scene, row.size = size;
    reset_peak();
    const Request request =
        timed(row, Work::load, [&] { return request_of(scene, study.config, {}, 1, size, progress); });
    if (triangle_count(request.scene) == 0)
        throw UserError("study scale: " + printable(scene) +
                        " has no triangles, whose number the page needs");
    const Camera camera = *request.scene.camera;
    const Job job = timed(row, Work::compile, [&] {
        return make_job(request.scene, camera, size, request.config, progress, request.settings);
    });
    std::vector<RecordedFrame> frames;
    frames.push_back(
        timed(row, Work::record, [&] { return record_frame(job, job.frame, study.threads, progress); }));
    const FrameTiming timing =
        timed(row, Work::replay, [&] { return replay(job.config, job.khz, frames, {}, progress)[0]; });
    const ReferencePicture reference = timed(row, Work::reference, [&] {
        return reference_picture(request, camera, size, study.threads, progress);
    });
    const std::vector<Closest>& answers = frames[0].trace.hits;
    const Picture picture = shade(request.scene, scaled(job, job.frame, answers));
    const Judgement judgement = timed(row, Work::judge, [&] {
        return judge({request.scene, camera, job.frame, job.image.lattice, request.config}, job.image,
                     {reference.hits(), answers, picture}, study.threads, progress);
    });
    row.triangles = triangle_count(request.scene);
    row.image_bytes = job.image.words.size() * sizeof(job.image.words[0]);
    row.cycles = timing.cycles;
    row.judged = judgement.rays.all(), row.wrong = judgement.wrong_for(request.config);
    row.peak_bytes = peak_bytes();
    return row;
}

}   // namespace

Figures measure(const Study& study, const Progress& progress) {
    Figures figures;
    for (const std::string& scene : study.scenes)
        figures.scenes.push_back(measure_row(scene, study.size, study, progress));
    for (const std::string& scene : study.placed)
        figures.placed.push_back(measure_row(scene, study.size, study, progress));
    for (const FrameSize size : study.sizes)
        figures.pictures.push_back(measure_row(study.scenes.front(), size, study, progress));
    figures.largest = measure_row(study.scenes.back(), study.sizes.back(), study, progress);
    return figures;
}

double exponent(const std::vector<Row>& rows, Work work, std::uint64_t (*x)(const Row&)) {
    double n = 0, sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
    for (const Row& row : rows) {
        const double seconds = row.seconds[std::size_t(work)];
        if (seconds <= 0) continue;
        const double a = std::log(double(x(row))), b = std::log(seconds);
        ++n, sum_x += a, sum_y += b, sum_xx += a * a, sum_xy += a * b;
    }
    const double spread = n * sum_xx - sum_x * sum_x;
    return n < 2 || spread <= 0 ? std::numeric_limits<double>::quiet_NaN()
                                : (n * sum_xy - sum_x * sum_y) / spread;
}

}   // namespace rayclock::scale
