// Renders and times the points of a sweep in parallel, with a cache.
#include "sim/explore/sweep/evaluate_points.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <mutex>
#include <variant>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/interrupted.hpp"
#include "model/core/parameters.hpp"
#include "sim/explore/sweep/cracks.hpp"
#include "sim/explore/sweep/key.hpp"
#include "sim/explore/sweep/table.hpp"
#include "sim/files/process/parallel.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/run/memory/memory_file.hpp"
#include "sim/run/request/reference_picture.hpp"
#include "sim/silicon/synth/netlist.hpp"
#include "sim/silicon/synth/yosys.hpp"

namespace rayclock::sweep {

using nlohmann::ordered_json;

namespace {

RayCounts ray_counts_of(const ordered_json& rays) {
    RayCounts counts;
    rays.at("primary").get_to(counts.primary);
    rays.at("shadow").get_to(counts.shadow);
    rays.at("reflection").get_to(counts.reflection);
    rays.at("refraction").get_to(counts.refraction);
    return counts;
}

}   // namespace

PictureFigures picture_figures_from_json(const ordered_json& json) {
    PictureFigures p;
    if (json.contains("pixels")) {
        p.error.pixels = json.at("pixels").get<std::uint64_t>();
        p.error.pixels_other_primitive = json.at("pixels_other_primitive").get<std::uint64_t>();
        p.error.psnr_db = json.at("psnr_db").is_null() ? std::numeric_limits<double>::infinity()
                                                       : json.at("psnr_db").get<double>();
        p.error.depth_pixels = json.at("depth_pixels").get<std::uint64_t>();
        p.error.max_abs_depth = json.at("max_abs_depth").get<double>();
        p.error.max_relative_depth = json.at("max_relative_depth").get<double>();
    }
    if (!json.at("cracks").is_null()) p.cracks = json.at("cracks").get<std::uint64_t>();
    p.memory_bytes = json.at("memory_bytes").get<std::uint64_t>();
    p.rays = ray_counts_of(json.at("rays"));
    return p;
}

std::uint64_t Result::film_cycles() const {
    std::uint64_t sum = 0;
    for (const ordered_json& frame : clock.at("frames"))
        for (const char* part : {"cycles", "upload_cycles", "reset_cycles"})
            sum += frame.at(part).get<std::uint64_t>();
    return sum;
}
double Result::film_fps() const {
    return double(frames()) * clock.at("mhz").get<double>() * 1e6 / double(film_cycles());
}

namespace {

ordered_json picture_figures_json(const PictureFigures& p) {
    ordered_json json = p.has_error() ? error_json(p.error, std::nullopt) : ordered_json::object();
    json["cracks"] = p.cracks ? ordered_json(*p.cracks) : ordered_json(nullptr);
    json["memory_bytes"] = p.memory_bytes;
    json["rays"] = rays_json(p.rays);
    return json;
}

synth::Netlist netlist_of(const ordered_json& json) {
    return {json.at("multipliers").get<std::uint64_t>(), json.at("flip_flops").get<std::uint64_t>()};
}

/// Sets the figures that the points of a format share. A sampled point has its own counts of rays.
void set_picture(Result& r, const PictureFigures& picture) {
    r.picture = picture;
    if (r.sampled()) r.picture->rays = ray_counts_of(r.clock.at("sample").at("rays"));
}

/// Returns a frame's figures, or the reason why it has none.
std::variant<ordered_json, std::string> frame_of(const ordered_json& json) {
    if (json.contains("refused")) return json.at("refused").get<std::string>();
    Result r;
    r.clock = json;
    set_picture(r, {});
    table_cells(r, false, false);   // check that a table can read every value
    return json;
}

std::string timing_of(const Config& config) {
    std::string text;
    for (const Parameter& p : parameters()) text += fmt::format("{}={} ", p.key, value_text(config, p));
    return text + own_memory_text(config);
}

/// Points that share a trace.
struct Group {
    std::string key;
    std::vector<Result*> results;
    bool picture_known = false;
};

/// Returns the options of the picture that determine rays, besides scene, size and configuration.
std::string picture_text(const Scene& scene, const PictureChoice& choice) {
    const Whitted& w = choice.settings;
    const FramesOptions& frames = choice.frames;
    std::string text;
    if (choice.finished)
        text += fmt::format("finished {} {} {} {} {} {} ", w.depth, w.threshold, w.aa, w.jitter, w.contrast,
                            w.seed);
    if (frames.frames > 1) text += fmt::format("frames {} {} ", frames.frames, frames.pan);
    if (!moves(scene)) return text;
    return text + fmt::format("film {} {} {} {} {} ",
                              film_digest(*scene.placed, frame_times(frames, true).times), frames.pan,
                              frames.uploads, frames.rebuild, choice.view.is_given());
}

class Runner {
public:
    Runner(const Plan& plan, results::Cache& cache, const Progress& progress)
        : plan_(plan), cache_(cache), progress_(progress) {
        scene_key_ = fmt::format("program {} scene {} {}x{} {}", program_stamp(), scene_digest(plan.scene),
                                 plan.size.width, plan.size.height, picture_text(plan.scene, plan.picture));
        if (plan.stream) scene_key_ += "rays " + plan.stream->digest() + " ";
        if (plan.sample) scene_key_ += fmt::format("sample {} {} ", plan.sample->share, plan.sample->seed);
        cores_ = parallel::threads_of(plan.threads);
        for (const Point& point : plan.points) outcome_.results.push_back({point, nullptr, {}, {}, {}, {}});
        if (plan.stream)
            for (Result& r : outcome_.results)
                if (!r.refused() && !r.point.config.is_stream())
                    r.point.refused = "--rays needs source=stream";
    }

    Evaluation run() {
        find_known();
        const std::size_t open = std::size_t(std::count_if(
            groups_.begin(), groups_.end(), [](const auto& g) { return needs_trace(g.second); }));
        inner_threads_ = std::max(1, cores_ / std::clamp(int(open), 1, cores_));
        if (plan_.netlists) plan_netlists();
        for (auto& [format, group] : groups_)
            if (needs_trace(group)) tasks_.push_back([this, &group = group] { trace(group); });
        report_progress(0);
        parallel::for_each(tasks_.size(), cores_, [&](std::size_t i) { tasks_[i](); });
        outcome_.traces = groups_.size();
        return std::move(outcome_);
    }

private:
    static bool needs_trace(const Group& group) {
        return std::any_of(group.results.begin(), group.results.end(),
                           [](const Result* r) { return !r->refused() && !r->complete(); });
    }
    std::string frame_key(const Result& r) const {
        return fmt::format("{}khz {} {}", scene_key_, r.point.khz, timing_of(r.point.config));
    }

    /// Fills in cached figures and counts the remaining ones.
    void find_known() {
        for (Result& r : outcome_.results) {
            if (r.refused()) continue;
            const std::string format = trace_format(r.point.config);
            Group& group = groups_[format];
            if (group.results.empty()) group.key = scene_key_ + format;
            group.results.push_back(&r);
            if (auto frame = cache_.find("frame", frame_key(r), frame_of)) {
                if (const auto* refused = std::get_if<std::string>(&*frame))
                    r.point.refused = *refused;
                else
                    r.clock = std::get<ordered_json>(*frame);
            }
        }
        for (auto& [format, group] : groups_)
            if (const auto picture = cache_.find("picture", group.key, picture_figures_from_json)) {
                group.picture_known = true;
                for (Result* r : group.results) set_picture(*r, *picture);
            }
        for (const auto& [format, group] : groups_)
            for (const Result* r : group.results) ++(r->refused() || r->complete() ? outcome_.known : all_);
    }

    void plan_netlists() {
        std::map<std::string, std::vector<Result*>> wanted;
        for (Result& r : outcome_.results) {
            if (r.refused() || !synth::exists_in_rtl(r.point.config)) continue;
            if (synth::yosys_version().empty()) {
                outcome_.netlist_note =
                    "Yosys is not installed, so multipliers and flip-flops are not counted";
                return;
            }
            wanted[synth::netlist_key(r.point.config)].push_back(&r);
        }
        for (auto& [key, results] : wanted) {
            if (const auto known = cache_.find("netlist", key, netlist_of)) {
                set_netlist(results, *known);
                continue;
            }
            ++all_;
            tasks_.push_back([this, key = key, results = results] { count(key, results); });
        }
    }
    static void set_netlist(const std::vector<Result*>& results, const synth::Netlist& netlist) {
        for (Result* r : results) {
            r->multipliers = netlist.multipliers;
            r->flip_flops = netlist.flip_flops;
        }
    }
    void count(const std::string& key, const std::vector<Result*>& results) {
        if (stopped()) return;
        try {
            const auto netlist = synth::count_netlist(results[0]->point.config, cache_.folder());
            if (!netlist) {
                stopped();
                return;
            }
            cache_.keep("netlist", key,
                        {{"multipliers", netlist->multipliers}, {"flip_flops", netlist->flip_flops}});
            set_netlist(results, *netlist);
        } catch (const std::runtime_error& e) {
            const std::lock_guard lock(mutex_);
            outcome_.netlist_note = e.what();
        }
        report_progress(1);
    }

    /// Returns true after an interrupt, and marks the outcome as partial.
    bool stopped() {
        if (!interrupted()) return false;
        const std::lock_guard lock(mutex_);
        outcome_.partial = true;
        return true;
    }

    void refuse(Result& r, const std::string& sentence) {
        r.point.refused = sentence;
        cache_.keep("frame", frame_key(r), {{"refused", sentence}});
        report_progress(1);
    }

    /// Compiles and records the scene for a group's format, and times its frames.
    void trace(Group& group) {
        if (stopped()) return;
        try {
            trace_frames(group);
        } catch (const UserError& e) {
            for (Result* r : group.results)
                if (!r->refused() && r->clock.is_null()) refuse(*r, e.what());
        } catch (const std::runtime_error&) {
            if (!stopped()) throw;   // the callback `stop_` throws on an interrupt
        }
    }

    void trace_frames(Group& group) {
        // Renders as simulate does. Each point checks separately whether its memory is large enough.
        Config config = group.results[0]->point.config;
        config.own_dram.reset();
        config.dram = DramName::ideal;
        config.scan_out = config.pixel_writes = false;
        if (plan_.sample) return sample_points(group, config);
        const std::vector<RecordedFrame> frames =
            plan_.stream ? record_stream(group, config) : record_film(group, config);
        parallel::for_each(group.results.size(), cores_, [&](std::size_t i) {
            Result& r = *group.results[i];
            if (r.refused()) return;
            if (r.clock.is_null())
                time(r, frames);
            else
                report_progress(1);
        });
    }

    /// Estimates each point of a group. The points share the scene's memory image.
    void sample_points(Group& group, const Config& config) {
        Film film = film_of(plan_.scene, plan_.size, plan_.picture, config, stop_);
        film.next();
        Job job = film.job();
        if (!group.picture_known) keep_picture(group, {{}, std::nullopt, job.image.report.bytes, {}});
        for (Result* r : group.results) {
            check_memory(*r, job.image);
            if (r->refused()) continue;
            if (!r->clock.is_null()) {   // only the figures of the picture were missing
                report_progress(1);
                continue;
            }
            if (stopped()) return;
            job.config = r->point.config;
            try {
                keep_sample(*r,
                            sample::run(job, {r->point.khz}, *plan_.sample, {}, inner_threads_, stop_)[0]);
            } catch (const Interrupted&) {
                stopped();
                return;
            } catch (const UserError& e) {
                refuse(*r, e.what());
            }
        }
    }

    /// Stores a point's estimates, also in the cache of figures.
    void keep_sample(Result& r, const sample::Sampled& sampled) {
        const FrameResult frame = sampled.frame(r.point.config);
        r.clock = clock_json(r.point.config, {r.point.khz, {frame}});
        const sample::Estimate cycles = sampled.total([](const FrameTiming& t) { return double(t.cycles); });
        r.clock["sample"] = {{"cycles_half_width", cycles.half_width}, {"rays", rays_json(frame.rays)}};
        set_picture(r, *r.picture);
        cache_.keep("frame", frame_key(r), r.clock);
        report_progress(1);
    }

    std::vector<RecordedFrame> record_film(Group& group, const Config& config) {
        Film film = film_of(plan_.scene, plan_.size, plan_.picture, config, stop_);
        std::vector<RecordedFrame> frames;
        while (frames.size() < film.frames()) {
            film.next();
            for (Result* r : group.results) check_memory(*r, film.job().image);
            frames.push_back(film.record(inner_threads_, stop_));
        }
        if (!group.picture_known) keep_picture(group, compare_picture(film, frames.back()));
        return frames;
    }

    std::vector<RecordedFrame> record_stream(Group& group, const Config& config) {
        const StreamJob stream = plan_.stream->job(config, stop_);
        for (Result* r : group.results) check_memory(*r, stream.job.image);
        std::vector<RecordedFrame> frames;
        frames.push_back(record_frame(stream.job, stream.job.frame, inner_threads_, stop_));
        if (!group.picture_known)
            keep_picture(group, {{}, std::nullopt, stream.job.image.report.bytes, frames[0].trace.counts});
        return frames;
    }

    void keep_picture(Group& group, const PictureFigures& picture) {
        cache_.keep("picture", group.key, picture_figures_json(picture));
        for (Result* r : group.results) set_picture(*r, picture);
    }

    /// The reference's last frame, equal for every configuration.
    const ReferencePicture& expected(Film& film) {
        std::call_once(reference_once_, [&] {
            reference_ = reference_picture(film.request(), film.camera(), plan_.size, cores_, stop_);
        });
        return reference_;
    }

    PictureFigures compare_picture(Film& film, const RecordedFrame& last) {
        const ReferencePicture& reference = expected(film);
        const Request& request = film.request();
        const HitFrame hits = hits_of(film.job(), last);
        PictureFigures figures{{}, std::nullopt, film.job().image.report.bytes, last.trace.counts};
        const Picture picture = request.finished ? picture_from_colours(plan_.size, last.trace.colours)
                                                 : shade(request.scene, hits);
        figures.error = frame_error(hits, picture, reference.hits(), reference.picture);
        if (request.finished) return figures;
        if (!request.config.has_instances())
            figures.cracks = count_cracks(request.scene, film.job(), last.trace.hits, inner_threads_);
        return figures;
    }

    void check_memory(Result& r, const MemoryImage& image) {
        if (r.refused() || !r.clock.is_null()) return;
        try {
            check_capacity(image, r.point.config);
        } catch (const UserError& e) {
            refuse(r, e.what());
        }
    }

    void time(Result& r, const std::vector<RecordedFrame>& frames) {
        if (stopped()) return;
        const std::vector<FrameTiming> timings = replay(r.point.config, r.point.khz, frames);
        FramesAtClock run{r.point.khz, {}};
        for (std::size_t f = 0; f < timings.size(); ++f)
            run.frames.push_back(frame_result(frames[f], timings[f]));
        if (run.partial()) {
            stopped();
            return;
        }
        r.clock = clock_json(r.point.config, run);
        cache_.keep("frame", frame_key(r), r.clock);
        report_progress(1);
    }

    void report_progress(std::size_t more) {
        const std::lock_guard lock(mutex_);
        done_ += more;
        if (progress_ && all_ > 0) progress_("sweep", done_, all_);
    }

    const Plan& plan_;
    results::Cache& cache_;
    const Progress& progress_;
    std::string scene_key_;
    int cores_ = 1, inner_threads_ = 1;
    Evaluation outcome_;
    std::map<std::string, Group> groups_;
    std::vector<std::function<void()>> tasks_;   ///< netlists to count, then groups to trace
    const Progress stop_ = stopping({});
    std::once_flag reference_once_;
    ReferencePicture reference_;
    std::mutex mutex_;
    std::size_t done_ = 0, all_ = 0;
};

}   // namespace

Evaluation run(const Plan& plan, results::Cache& cache, const Progress& progress) {
    return Runner(plan, cache, progress).run();
}

}   // namespace rayclock::sweep
