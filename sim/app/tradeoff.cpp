// rayclock tradeoff: the page docs/speed-against-error.md with its plots.
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "model/core/error.hpp"
#include "model/core/quote.hpp"
#include "sim/app/commands.hpp"
#include "sim/image/image.hpp"
#include "sim/report/text.hpp"
#include "sim/rtl/builder.hpp"
#include "sim/sweep/study.hpp"

namespace rayclock {

namespace {

constexpr int khz = default_khz;

/// docs/page.md and gears:8 give docs/page-gears-8, whatever the name holds.
std::string plot_path(const std::string& page, const std::string& scene) {
    std::string name = std::filesystem::path(scene).filename().string();
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '-';
    std::filesystem::path path(page);
    return path.replace_filename(path.stem().string() + "-" + name).string();
}

/// What to type for this page. Where this machine keeps its files is nobody's business.
std::string command_of(const Options& o) {
    const std::filesystem::path path(o.output);
    std::string text = "rayclock tradeoff -o " + (path.is_absolute() ? path.filename() : path).string();
    if (o.scenes != default_tradeoff_scenes()) text += fmt::format(" --scenes {}", fmt::join(o.scenes, ","));
    if (o.size != Options{}.size) text += " --size " + o.size;
    if (o.no_netlist) text += " --no-netlist";
    return text;
}

} // namespace

const std::vector<std::string>& default_tradeoff_scenes() {
    static const std::vector<std::string> scenes{"gears:8", "balls:3", "mount:8", "teapot:12", "tree:6", "rings:3"};
    return scenes;
}

int tradeoff_command(const Options& o) {
    catch_interrupts();
    const FrameSize size = parse_size(o.size);
    check_writable(o.output);
    for (const std::string& name : o.scenes) plot::check_plot_path(plot_path(o.output, name));
    const Progress progress = terminal_progress();
    const sweep::Study study = sweep::make_study(khz);
    sweep::Cache cache(rtl_cache() / "sweep", o.fresh);
    std::vector<sweep::SceneStudy> scenes;
    for (const std::string& name : o.scenes) {
        Options scene_options = o;
        scene_options.scene = name;
        const Scene scene = ready_scene(scene_options, size, progress);
        const Progress tell = !progress ? Progress{} : [&](std::string_view, std::uint64_t done, std::uint64_t all) {
            progress(fmt::format("{} ({} of {})", name, scenes.size() + 1, o.scenes.size()), done, all);
        };
        sweep::Outcome outcome = sweep::run({scene, size, study.points, o.threads, !o.no_netlist}, cache, tell);
        if (outcome.partial) throw UserError("interrupted: no page was written; the same command goes on where it was");
        const std::string plot = std::filesystem::path(plot_path(o.output, name)).filename().string();
        scenes.push_back({scene.name, scene.triangles.size(), size, std::move(outcome), plot});
    }
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const std::vector<sweep::Result> results = sweep::grid_results(study, scenes[i].outcome);
        plot::write_plot(plot_path(o.output, o.scenes[i]), sweep::front_plot(scenes[i].name, size, study.grid, results, sweep::front_of(results)));
    }
    write_file(o.output, sweep::page(study, scenes, khz, command_of(o)));
    fmt::print("{} written\n", printable(o.output));
    return 0;
}

} // namespace rayclock
