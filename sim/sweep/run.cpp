#include "sim/sweep/run.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <mutex>
#include <variant>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/reference/reference.hpp"
#include "sim/memory/memory_file.hpp"
#include "sim/sweep/cracks.hpp"
#include "sim/sweep/key.hpp"
#include "sim/sweep/table.hpp"
#include "sim/synth/netlist.hpp"
#include "sim/synth/yosys.hpp"
#include "sim/jobs/threads.hpp"

namespace rayclock::sweep {

using nlohmann::ordered_json;

PictureFigures picture_of(const ordered_json& json) {
    PictureFigures p;
    p.error.pixels = json.at("pixels").get<std::uint64_t>();
    p.error.pixels_other_primitive = json.at("pixels_other_primitive").get<std::uint64_t>();
    p.error.psnr_db = json.at("psnr_db").is_null() ? std::numeric_limits<double>::infinity()
                                                   : json.at("psnr_db").get<double>();
    p.error.depth_pixels = json.at("depth_pixels").get<std::uint64_t>();
    p.error.max_abs_depth = json.at("max_abs_depth").get<double>();
    p.error.max_relative_depth = json.at("max_relative_depth").get<double>();
    p.cracks = json.at("cracks").get<std::uint64_t>();
    p.memory_bytes = json.at("memory_bytes").get<std::uint64_t>();
    return p;
}

namespace {

ordered_json picture_json(const PictureFigures& p) {
    ordered_json json = error_json(p.error, std::nullopt);
    json["cracks"] = p.cracks;
    json["memory_bytes"] = p.memory_bytes;
    return json;
}

synth::Netlist netlist_of(const ordered_json& json) {
    return {json.at("multipliers").get<std::uint64_t>(), json.at("flip_flops").get<std::uint64_t>()};
}

/// A frame's figures, or why there are none.
std::variant<ordered_json, std::string> frame_of(const ordered_json& json) {
    if (json.contains("refused")) return json.at("refused").get<std::string>();
    Result r;
    r.clock = json;
    r.picture.emplace();
    cells(r, false, false);   // whatever a table reads can be read
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

struct Traced {
    Job job;
    std::vector<FrameTrace> frames;
};

class Runner {
public:
    Runner(const Plan& plan, jobs::Cache& cache, const Progress& progress)
        : plan_(plan), cache_(cache), progress_(progress) {
        scene_key_ = fmt::format("program {} scene {} {}x{} ", program_stamp(), scene_digest(plan.scene),
                                 plan.size.width, plan.size.height);
        cores_ = jobs::threads_of(plan.threads);
        for (const Point& point : plan.points) outcome_.results.push_back({point, nullptr, {}, {}, {}, {}});
    }

    Outcome run() {
        find_known();
        const std::size_t open = std::size_t(std::count_if(
            groups_.begin(), groups_.end(), [](const auto& g) { return needs_trace(g.second); }));
        inner_threads_ = std::max(1, cores_ / std::clamp(int(open), 1, cores_));
        if (plan_.netlists) plan_netlists();
        for (auto& [format, group] : groups_)
            if (needs_trace(group)) tasks_.push_back([this, &group = group] { trace(group); });
        tell(0);
        jobs::for_each(tasks_.size(), cores_, [&](std::size_t i) { tasks_[i](); });
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

    /// Fills in what the cache has, and counts what is left.
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
            if (const auto picture = cache_.find("picture", group.key, picture_of)) {
                group.picture_known = true;
                for (Result* r : group.results) r->picture = *picture;
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
        tell(1);
    }

    /// Whether to do no more, which makes the outcome partial.
    bool stopped() {
        if (!interrupted()) return false;
        const std::lock_guard lock(mutex_);
        outcome_.partial = true;
        return true;
    }

    void refuse(Result& r, const std::string& sentence) {
        r.point.refused = sentence;
        cache_.keep("frame", frame_key(r), {{"refused", sentence}});
        tell(1);
    }

    /// Compiles and records for a group's format, and times its frames.
    void trace(Group& group) {
        if (stopped()) return;
        Traced traced;
        const Config& config = group.results[0]->point.config;
        try {
            traced.job = {
                config, {}, compile_scene(plan_.scene, plan_.scene.camera->eye, config), plan_.size};
        } catch (const UserError& e) {
            for (Result* r : group.results)
                if (!r->refused()) refuse(*r, e.what());
            return;
        }
        Job& job = traced.job;
        job.frame = make_frame(*plan_.scene.camera, plan_.size, job.image, config);
        traced.frames.push_back(record_frame(job, job.frame, inner_threads_));
        if (!group.picture_known) {
            const PictureFigures picture = compare_picture(traced);
            cache_.keep("picture", group.key, picture_json(picture));
            for (Result* r : group.results) r->picture = picture;
        }
        jobs::for_each(group.results.size(), cores_, [&](std::size_t i) {
            Result& r = *group.results[i];
            if (r.refused()) return;
            if (r.clock.is_null())
                time(r, traced);
            else
                tell(1);
        });
    }

    PictureFigures compare_picture(const Traced& traced) {
        std::call_once(reference_once_, [this] {
            reference_ = Reference(plan_.scene).frame(*plan_.scene.camera, plan_.size, cores_);
        });
        return {frame_error(plan_.scene, hits_of(traced.job, traced.frames[0]), reference_),
                count_cracks(plan_.scene, traced.job, traced.frames[0].trace.hits, inner_threads_),
                traced.job.image.report.bytes};
    }

    void time(Result& r, const Traced& traced) {
        if (stopped()) return;
        try {
            check_capacity(traced.job.image, r.point.config);
        } catch (const UserError& e) {
            refuse(r, e.what());
            return;
        }
        const FrameRun run =
            frame_run(traced.frames[0], replay(r.point.config, r.point.khz, traced.frames)[0]);
        if (run.partial) {
            stopped();
            return;
        }
        r.clock = clock_json(r.point.config, {r.point.khz, {run}});
        cache_.keep("frame", frame_key(r), r.clock);
        tell(1);
    }

    void tell(std::size_t more) {
        const std::lock_guard lock(mutex_);
        done_ += more;
        if (progress_ && all_ > 0) progress_("sweep", done_, all_);
    }

    const Plan& plan_;
    jobs::Cache& cache_;
    const Progress& progress_;
    std::string scene_key_;
    int cores_ = 1, inner_threads_ = 1;
    Outcome outcome_;
    std::map<std::string, Group> groups_;
    std::vector<std::function<void()>> tasks_;   ///< netlists to be counted, then groups to be traced
    std::once_flag reference_once_;
    HitFrame reference_;
    std::mutex mutex_;
    std::size_t done_ = 0, all_ = 0;
};

}   // namespace

Outcome run(const Plan& plan, jobs::Cache& cache, const Progress& progress) {
    return Runner(plan, cache, progress).run();
}

}   // namespace rayclock::sweep
