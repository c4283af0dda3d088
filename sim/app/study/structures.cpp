// rayclock study structures: makes docs/measured/structures.md with its picture.
#include <filesystem>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/engine/check.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/files/image/image.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/run/rtl/builder.hpp"
#include "sim/study/structures/structures_page.hpp"
#include "sim/study/typed.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

constexpr const char* usual_structures_size = "256x192";
constexpr FrameSize size_of_small{64, 48};

struct StructuresOptions {
    ConfigChoice config;
    std::string output, size = usual_structures_size;
    std::vector<std::string> scenes = structures::large_scenes(), round{"balls:4"};
    LimitsChoice limits;
    JsonOutput json;
    bool fresh = false, no_netlist = false;
    int threads = 0;
};

void declare_structures(Parser& parser, StructuresOptions& o) {
    config_options(parser, o.config);
    parser.option("-o,--output", o.output, "folder for structures.md and its picture").required();
    parser.option("--scenes", o.scenes, "scenes, separated by commas").by_commas().with_default();
    parser
        .option("--round", o.round,
                "those of --scenes whose camera rays meet true spheres instead of triangles")
        .by_commas()
        .with_default();
    parser.option("--size", o.size, "size of the pictures, WIDTHxHEIGHT").with_default();
    limits_options(parser, o.limits);
    json_option(parser, o.json);
    fresh_option(parser, o.fresh);
    netlist_option(parser, o.no_netlist);
    threads_option(parser, o.threads);
}

std::string command_of(const StructuresOptions& o) {
    std::string text = "rayclock study structures -o " + page_path(o.output);
    if (o.config.name != ConfigChoice{}.name) text += " --config " + page_path(o.config.name);
    for (const std::string& item : o.config.set) text += " --set " + item;
    if (o.scenes != structures::large_scenes()) text += fmt::format(" --scenes {}", fmt::join(o.scenes, ","));
    if (o.round != StructuresOptions{}.round) text += fmt::format(" --round {}", fmt::join(o.round, ","));
    if (o.size != usual_structures_size) text += " --size " + o.size;
    return text + (o.no_netlist ? " --no-netlist" : "") + typed_limits(o.limits);
}

/// Returns the area of one pipeline with each structure, without and with the units of finished pictures.
std::vector<structures::Areas> areas_of(const std::vector<structures::NamedStructure>& candidates,
                                        const StructuresOptions& o, const Progress& progress) {
    std::vector<area::Variant> variants;
    for (const structures::NamedStructure& structure : candidates) {
        variants.push_back({structure.name, structure.config});
        variants.push_back({structure.name + ", all units", area::all_units(structure.config)});
    }
    results::Cache cache(rtl_cache() / "area", o.fresh);
    const area::Areas areas = area::run(std::move(variants), {}, o.threads, cache, progress);
    if (areas.partial)
        throw Interrupted("interrupted: no page was written; the same command continues where it stopped");
    std::vector<structures::Areas> counts;
    for (std::size_t i = 0; i < candidates.size(); ++i)
        counts.push_back({area::pipeline_count(areas, 2 * i), area::pipeline_count(areas, 2 * i + 1)});
    return counts;
}

int run_structures(const StructuresOptions& o) {
    structures::Study study{load_config(o.config), parse_size(o.size), o.scenes, o.round, o.threads,
                            limits_of(o.limits)};
    const auto candidates = structures::trees(study.base);
    for (const structures::NamedStructure& structure : candidates)
        check_config(structure.config, "structures");
    const std::filesystem::path folder(o.output);
    const std::string path = (folder / "structures.md").string(), plot = (folder / "structures").string();
    check_writable(path);
    o.json.check();
    plot::check_plot_path(plot);
    const Progress progress = stopping(terminal_progress());
    structures::Figures figures;
    auto machines = candidates;
    machines.push_back(structures::list(study.base));
    if (!o.no_netlist) figures.areas = areas_of(machines, o, progress);
    for (const std::string& scene : study.scenes)
        figures.large.push_back(structures::measure(scene, candidates, study, true, progress));
    study.size = size_of_small;
    auto all = candidates;
    all.push_back(structures::inner_octree(study.base));
    all.push_back(structures::list(study.base));
    for (const std::string& scene : structures::small_scenes())
        figures.small.push_back(structures::measure(scene, all, study, false, progress));
    study.size = parse_size(o.size);
    plot::write_plot(plot, structures::picture(figures, study));
    write_file(path, structures::page(figures, study, command_of(o), "structures"));
    o.json.write(structures::rows(figures, study.limits));
    if (!o.json.is_alone()) fmt::print("{} written\n", printable(path));
    return 0;
}

}   // namespace

Command structures_command() {
    return command("structures", "docs/measured/structures.md: all acceleration structures on one machine",
                   "rayclock study structures -o docs/measured", declare_structures, run_structures);
}

}   // namespace rayclock
