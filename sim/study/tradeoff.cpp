// Writes docs/measured/speed-against-error.md. All numbers are computed.
#include "sim/study/tradeoff.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/interrupted.hpp"
#include "sim/explore/sweep/table.hpp"
#include "sim/files/image/image.hpp"
#include "sim/run/request/request.hpp"
#include "sim/silicon/synth/yosys.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock::sweep {

namespace {

constexpr int khz = default_khz;

Table table_of(std::vector<std::string> head) { return Table(std::move(head), Table::words_only); }

std::string count_text(const std::optional<std::uint64_t>& n) { return n ? grouped(*n) : "-"; }
std::string decibel_text(double psnr) { return std::isfinite(psnr) ? fmt::format("{:.1f}", psnr) : "equal"; }

class Page {
public:
    Page(const Study& study, const std::vector<SceneStudy>& scenes, const Limits& limits)
        : study_(study), scenes_(scenes), limits_(limits) {}

    std::string series_text(const Series& series) const {
        std::string text = fmt::format("\n### {}\n\n{}\n\n", series.axis.key, series.about);
        text += error_table(series) + "\n" + other_table(series);
        if (series.axis.key.ends_with("_bits")) text += "\n" + step_table(series);
        std::vector<NamedError> pictures;
        for (std::size_t i = 0; i < series.points.size(); ++i)
            for (const SceneStudy& scene : scenes_) {
                const Result& r = result(scene, series.points[i]);
                const std::string name =
                    fmt::format("{}, {} {}", scene.name, series.axis.key, series.axis.values[i]);
                if (r.complete()) pictures.push_back({name, r.picture->error});
            }
        return text + far_note(pictures);
    }

    std::string grid_text(const SceneStudy& scene) const {
        const std::vector<Result> results = grid_results(study_, scene.outcome);
        const Front front = front_of(results);
        std::string text =
            fmt::format("\n### {}\n\n![Error against cost and against speed of {}]({}.svg)\n\n", scene.name,
                        scene.name, scene.plot);
        Table table = table_of({study_.grid[0].key, study_.grid[1].key, "other primitive", "PSNR, dB", "fps",
                                "multipliers", "flip-flops", "memory image, bytes", "front"});
        for (std::size_t i = 0; i < results.size(); ++i) {
            const Result& r = results[i];
            const bool knee = front.knee && front.knee->point == i;
            if (!r.complete() || (!front.pareto[i] && !knee)) continue;
            table.add({r.point.values[0], r.point.values[1], percent_text(r),
                       decibel_text(r.picture->error.psnr_db), fmt::format("{:.2f}", r.fps()),
                       count_text(r.multipliers), count_text(r.flip_flops), grouped(r.picture->memory_bytes),
                       knee ? "**knee**" : "on it"});
        }
        std::vector<NamedError> pictures;
        for (std::size_t i = 0; i < results.size(); ++i)
            if (results[i].complete() && (front.pareto[i] || (front.knee && front.knee->point == i)))
                pictures.push_back({name_of(study_.grid, results[i]), results[i].picture->error});
        return text + table.markdown() + far_note(pictures);
    }

    std::string knee_table() const {
        Table table = table_of({"scene", "triangles", "picture", "knee of the grid", "its error", "its fps",
                                "its multipliers", "error of `default`", "fps", "multipliers"});
        std::vector<NamedError> pictures;
        for (const SceneStudy& scene : scenes_) {
            const std::vector<Result> results = grid_results(study_, scene.outcome);
            const Front front = front_of(results);
            std::vector<std::string> cells{scene.name, grouped(scene.triangles),
                                           fmt::format("{}x{}", scene.size.width, scene.size.height)};
            const auto add = [&](const Result* r) {
                cells.push_back(r && r->complete() ? percent_text(*r) : "-");
                cells.push_back(r && r->complete() ? fmt::format("{:.1f}", r->fps()) : "-");
                cells.push_back(r ? count_text(r->multipliers) : "-");
            };
            const Result* knee = front.knee ? &results[front.knee->point] : nullptr;
            const Result& usual = scene.outcome.results[at_default(study_.series[0])];
            if (knee && knee->complete())
                pictures.push_back(
                    {fmt::format("{}, {}", scene.name, name_of(study_.grid, *knee)), knee->picture->error});
            if (usual.complete())
                pictures.push_back({fmt::format("{}, default", scene.name), usual.picture->error});
            cells.push_back(knee ? name_of(study_.grid, *knee) : "none");
            add(knee);
            add(&usual);
            table.add(cells);
        }
        return table.markdown() + far_note(pictures);
    }

    bool has_netlists() const {
        const std::vector<Result>& results = scenes_[0].outcome.results;
        return std::any_of(results.begin(), results.end(),
                           [](const Result& r) { return r.multipliers.has_value(); });
    }

private:
    /// Returns the share of pixels with another primitive, with a dagger if the picture exceeds a limit.
    std::string percent_text(const Result& r) const {
        const FrameError& error = r.picture->error;
        return fmt::format("{:.3f} %{}", 100 * double(error.pixels_other_primitive) / double(error.pixels),
                           far_from_reference(limits_, error).empty() ? "" : " †");
    }
    /// Returns the note for the dagger, or an empty string.
    std::string far_note(const std::vector<NamedError>& pictures) const {
        const std::string far = far_from_reference(limits_, pictures, pictures.size(), "pictures");
        return far.empty() ? "" : "\n† " + far + "\n";
    }

    const Result& result(const SceneStudy& scene, std::size_t point) const {
        return scene.outcome.results[point];
    }

    /// Returns the point of the series that is `default`.
    std::size_t at_default(const Series& series) const {
        Config base = named_config("default");
        for (std::size_t i = 0; i < series.points.size(); ++i) {
            Config other = base;
            set_parameter(other, series.axis.key, series.axis.values[i], "study");
            if (trace_format(other) == trace_format(base)) return series.points[i];
        }
        return series.points[0];
    }

    std::vector<std::string> head_of(const Series& series, std::initializer_list<const char*> before) const {
        std::vector<std::string> head{series.axis.key};
        head.insert(head.end(), before.begin(), before.end());
        for (const SceneStudy& scene : scenes_) head.push_back(scene.name);
        return head;
    }

    std::string error_table(const Series& series) const {
        std::vector<std::string> head = head_of(series, {"multipliers", "flip-flops"});
        head.push_back("cracks");
        Table table = table_of(head);
        for (std::size_t i = 0; i < series.points.size(); ++i) {
            const Result& first = result(scenes_[0], series.points[i]);
            std::vector<std::string> cells{series.axis.values[i], count_text(first.multipliers),
                                           count_text(first.flip_flops)};
            std::uint64_t cracks = 0;
            for (const SceneStudy& scene : scenes_) {
                const Result& r = result(scene, series.points[i]);
                cells.push_back(r.complete() ? percent_text(r) : "refused");
                if (r.complete()) cracks += r.picture->cracks.value_or(0);
            }
            cells.push_back(grouped(cracks));
            table.add(cells);
        }
        return table.markdown() +
               "\nPixels whose primitive differs from the reference's; cracks summed over all scenes.\n";
    }

    std::string other_table(const Series& series) const {
        Table table = table_of(head_of(series, {}));
        for (std::size_t i = 0; i < series.points.size(); ++i) {
            std::vector<std::string> cells{series.axis.values[i]};
            for (const SceneStudy& scene : scenes_) {
                const Result& r = result(scene, series.points[i]);
                cells.push_back(!r.complete()
                                    ? "refused"
                                    : fmt::format("{} / {:.2g} / {:.2f}",
                                                  decibel_text(r.picture->error.psnr_db),
                                                  r.picture->error.max_abs_depth, r.cycles_per_ray()));
            }
            table.add(cells);
        }
        return table.markdown() + "\nPSNR in dB / largest depth error in scene units / cycles per ray.\n";
    }

    /// Returns the gain and the cost of each step to the next value, summed over all scenes.
    std::string step_table(const Series& series) const {
        Table table = table_of({"step", "bits", "multipliers", "flip-flops", "pixels with another primitive",
                                "cycles of all frames"});
        for (std::size_t i = 0; i + 1 < series.points.size(); ++i) {
            std::uint64_t before = 0, after = 0;
            double cycles_before = 0, cycles_after = 0;
            bool whole = true;
            for (const SceneStudy& scene : scenes_) {
                const Result &a = result(scene, series.points[i]), &b = result(scene, series.points[i + 1]);
                whole = whole && a.complete() && b.complete();
                if (!whole) break;
                before += a.picture->error.pixels_other_primitive;
                after += b.picture->error.pixels_other_primitive;
                cycles_before += a.cycles();
                cycles_after += b.cycles();
            }
            if (!whole) continue;
            const Result &a = result(scenes_[0], series.points[i]),
                         &b = result(scenes_[0], series.points[i + 1]);
            const auto growth = [](const std::optional<std::uint64_t>& from,
                                   const std::optional<std::uint64_t>& to) {
                return from && to ? fmt::format("{:+d}", std::int64_t(*to) - std::int64_t(*from))
                                  : std::string("-");
            };
            table.add(
                {series.axis.values[i] + " to " + series.axis.values[i + 1],
                 std::to_string(std::stoi(series.axis.values[i + 1]) - std::stoi(series.axis.values[i])),
                 growth(a.multipliers, b.multipliers), growth(a.flip_flops, b.flip_flops),
                 grouped(before) + " to " + grouped(after),
                 fmt::format("{:+.2f} %", 100 * (cycles_after / cycles_before - 1))});
        }
        return table.markdown() + "\nCost and effect of the step, summed over all scenes.\n";
    }

    const Study& study_;
    const std::vector<SceneStudy>& scenes_;
    const Limits& limits_;
};

constexpr const char* what_counts = R"(
- **Pixels with another primitive**, **PSNR**, **depth error**: compared with the double-precision reference
  on the scene as given, not snapped to the lattice. A dagger (†) marks a picture beyond a limit
  ([report.md](../guide/report.md#limits)), and the sentence below the table names the farthest.
- **Cracks**: pixels whose ray slips through a surface. The exact oracle finds the first triangle of the same
  snapped scene and quantised ray. A crack is a miss, or a hit farther away on a triangle that shares no
  corner with it. With the exact test the count must be 0. The sheared test moves corners by up to a lattice
  step, so a ray that passes within a step of an outline may miss it. This counts here too, although no
  closed surface lets a ray through ([hard-cases.md](hard-cases.md)).
- **Cycles** and frames per second: one frame with cold caches, one pipeline.
- **Multipliers** and **flip-flops** of `rc_pipeline`, as Yosys maps it to an ECP5. Multipliers are 18x18
  (MULT18X18D). Products are cut into tiles first, and products that never occur in the same cycle share a
  multiplier. Queues, caches and stacks are memories and do not count; neither does anything outside the
  pipelines. A dash means that the hardware does not exist, or Yosys is missing.
- **Front**: a point is on the front if no other point of the grid beats it. A point beats another if it is at
  least as good in pixels with another primitive, multipliers and frames per second, and better in one of them.
  Without Yosys, bytes of the memory
  image replace the multipliers.
- **Knee**: on the front of error against cost alone, with both divided by their range, the point farthest
  below the chord between the front's ends.
)";

std::string page_text(const Study& study, const std::vector<SceneStudy>& scenes, const Limits& limits,
                      const std::string& command) {
    const Page page(study, scenes, limits);
    std::string text =
        "# Speed against error\n\nThe cost of each bit, and its effect on pictures and speed.\n\n";
    text += fmt::format(
        "Made by `{}`, which measures every figure.\nConditions: configuration `default` except for the "
        "varied parameters, {:g} MHz, the first frame of each scene{}.\n",
        command, khz / 1e3,
        page.has_netlists() ? "; " + synth::yosys_version().substr(0, synth::yosys_version().find(" ("))
                            : "");
    text += what_counts;
    text += "\n## In short\n\n" + page.knee_table();
    text += "\n## One width at a time\n";
    for (const Series& series : study.series) text += page.series_text(series);
    text += fmt::format("\n## Two widths together: {} and {}\n\nA point's label is {} / {}.\n",
                        study.grid[0].key, study.grid[1].key, study.grid[0].key, study.grid[1].key);
    for (const SceneStudy& scene : scenes) text += page.grid_text(scene);
    for (const SceneStudy& scene : scenes)
        if (!scene.outcome.netlist_note.empty()) return text + "\n" + scene.outcome.netlist_note + ".\n";
    return text;
}

/// Returns the plot's path: docs/page.md and gears:8 give docs/page-gears-8. Special characters become
/// dashes.
std::string plot_path(const std::string& page, const std::string& scene) {
    std::string name = std::filesystem::path(scene).filename().string();
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '-';
    std::filesystem::path path(page);
    return path.replace_filename(path.stem().string() + "-" + name).string();
}

}   // namespace

const std::vector<std::string>& default_tradeoff_scenes() {
    static const std::vector<std::string> scenes{"gears:8",   "balls:3", "mount:8",
                                                 "teapot:12", "tree:6",  "rings:3"};
    return scenes;
}

void check_tradeoff_paths(const std::string& path, const std::vector<std::string>& scenes) {
    check_writable(path);
    for (const std::string& name : scenes) plot::check_plot_path(plot_path(path, name));
}

void write_tradeoff(const std::string& path, const Tradeoff& what, const std::string& command,
                    results::Cache& cache, const Progress& progress) {
    const Study study = make_study(khz);
    std::vector<SceneStudy> scenes;
    for (const std::string& name : what.scenes) {
        const Scene scene = ready_scene(name, what.size, progress);
        const Progress tell =
            !progress ? Progress{} : [&](std::string_view, std::uint64_t done, std::uint64_t all) {
                progress(fmt::format("{} ({} of {})", name, scenes.size() + 1, what.scenes.size()), done,
                         all);
            };
        Evaluation outcome = run({scene, what.size, study.points, what.threads, what.netlists}, cache, tell);
        if (outcome.partial)
            throw Interrupted(
                "interrupted: no page was written; the same command continues where it stopped");
        const std::string plot = std::filesystem::path(plot_path(path, name)).filename().string();
        scenes.push_back({scene.name, scene.triangles.size(), what.size, std::move(outcome), plot});
    }
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const std::vector<Result> results = grid_results(study, scenes[i].outcome);
        plot::write_plot(plot_path(path, what.scenes[i]),
                         front_plot(scenes[i].name, what.size, study.grid, results, front_of(results)));
    }
    write_file(path, page_text(study, scenes, what.limits, command));
}

}   // namespace rayclock::sweep
