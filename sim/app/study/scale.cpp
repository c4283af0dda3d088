// rayclock study scale: makes docs/measured/scale.md with its picture.
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/files/image/image.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/study/scale/scale_page.hpp"
#include "sim/study/typed.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

struct ScaleOptions {
    ConfigChoice config;
    std::string output, size = "1024x768";
    std::vector<std::string> scenes{"teapot:12", "teapot:39", "teapot:123", "teapot:389"},
        placed{"crowd:8", "crowd:27", "crowd:84", "crowd:267"},
        sizes{"384x256", "768x512", "1920x1080", "3840x2160"};
    int threads = 0;
    JsonOutput json;

    ScaleOptions() { config.set = {"dram=ddr4"}; }   // ddr3 is too small for the largest scene
};

void declare_scale(Parser& parser, ScaleOptions& o) {
    config_options(parser, o.config);
    parser.option("-o,--output", o.output, "folder for scale.md and its picture").required();
    parser.option("--scenes", o.scenes, "scenes from few to many triangles, separated by commas")
        .by_commas()
        .with_default();
    parser.option("--placed", o.placed, "the same with scenes of instances, whose triangles are written out")
        .by_commas()
        .with_default();
    parser.option("--size", o.size, "size of their pictures, WIDTHxHEIGHT").with_default();
    parser.option("--sizes", o.sizes, "growing pictures of the first scene").by_commas().with_default();
    threads_option(parser, o.threads);
    json_option(parser, o.json);
}

std::string command_of(const ScaleOptions& o) {
    const ScaleOptions usual;
    std::string text = "rayclock study scale -o " + page_path(o.output);
    if (o.config.name != usual.config.name) text += " --config " + page_path(o.config.name);
    if (o.config.set != usual.config.set)
        for (const std::string& item : o.config.set) text += " --set " + item;
    if (o.scenes != usual.scenes) text += fmt::format(" --scenes {}", fmt::join(o.scenes, ","));
    if (o.placed != usual.placed) text += fmt::format(" --placed {}", fmt::join(o.placed, ","));
    if (o.size != usual.size) text += " --size " + o.size;
    if (o.sizes != usual.sizes) text += fmt::format(" --sizes {}", fmt::join(o.sizes, ","));
    if (o.threads != 0) text += fmt::format(" --threads {}", o.threads);
    return text;
}

int run_scale(const ScaleOptions& o) {
    scale::Study study{o.config, o.scenes, o.placed, parse_size(o.size), {}, o.threads};
    if (load_config(o.config).shading)
        throw UserError("study scale: its pictures show camera rays; leave out shading=1");
    for (const std::string& size : o.sizes) study.sizes.push_back(parse_size(size));
    const std::filesystem::path folder(o.output);
    const std::string path = (folder / "scale.md").string(), plot = (folder / "scale").string();
    check_writable(path);
    o.json.check();
    plot::check_plot_path(plot);
    const scale::Figures figures = scale::measure(study, stopping(terminal_progress()));
    plot::write_plot(plot, scale::picture(figures, study));
    write_file(path, scale::page(figures, study, command_of(o), "scale"));
    o.json.write(scale::figures_json(figures));
    if (!o.json.is_alone()) fmt::print("{} written\n", printable(path));
    return 0;
}

}   // namespace

Command scale_command() {
    return command("scale",
                   "docs/measured/scale.md: the cost of a frame against the size of scene and picture",
                   "rayclock study scale -o docs/measured", declare_scale, run_scale);
}

}   // namespace rayclock
