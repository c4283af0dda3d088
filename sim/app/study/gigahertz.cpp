// rayclock study gigahertz: makes docs/measured/gigahertz.md with its picture.
#include <filesystem>

#include <fmt/format.h>

#include "model/base/quote.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/files/image/image.hpp"
#include "sim/files/process/interrupt.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/study/gigahertz/gigahertz_page.hpp"
#include "sim/study/typed.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

const char* const usual_gigahertz_size = "256x192";
const char* const usual_scene = "gears:8";
const char* const usual_finished = "balls:4";

struct GigahertzOptions {
    ConfigChoice config;
    std::string output, size = usual_gigahertz_size, scene = usual_scene, finished = usual_finished;
    int threads = 0;
};

void declare_gigahertz(Parser& parser, GigahertzOptions& o) {
    config_options(parser, o.config);
    parser.option("-o,--output", o.output, "folder for gigahertz.md and its picture").required();
    parser.option("--scene", o.scene, "scene of the camera rays").with_default();
    parser.option("--finished", o.finished, "scene of the finished picture").with_default();
    parser.option("--size", o.size, "size of the picture of camera rays, WIDTHxHEIGHT").with_default();
    threads_option(parser, o.threads);
}

std::string command_of(const GigahertzOptions& o) {
    std::string text = "rayclock study gigahertz -o " + page_path(o.output);
    if (o.config.name != ConfigChoice{}.name) text += " --config " + page_path(o.config.name);
    for (const std::string& item : o.config.set) text += " --set " + item;
    if (o.scene != usual_scene) text += " --scene " + page_path(o.scene);
    if (o.finished != usual_finished) text += " --finished " + page_path(o.finished);
    if (o.size != usual_gigahertz_size) text += " --size " + o.size;
    return text;
}

int run_gigahertz(const GigahertzOptions& o) {
    const gigahertz::Study study{load_config(o.config), o.scene, o.finished, parse_size(o.size), o.threads};
    const std::filesystem::path folder(o.output);
    const std::string path = (folder / "gigahertz.md").string(), plot = (folder / "gigahertz").string();
    check_writable(path);
    plot::check_plot_path(plot);
    const Progress progress = stopping(terminal_progress());
    const gigahertz::Figures figures = gigahertz::measure(study, progress);
    plot::write_plot(plot, gigahertz::picture(figures, study));
    write_file(path, gigahertz::page(figures, study, command_of(o), "gigahertz"));
    fmt::print("{} written\n", printable(path));
    return 0;
}

}   // namespace

Command gigahertz_command() {
    return command("gigahertz", "docs/measured/gigahertz.md: this machine at the clocks of processors",
                   "rayclock study gigahertz -o docs/measured", declare_gigahertz, run_gigahertz);
}

}   // namespace rayclock
