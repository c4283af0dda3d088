// rayclock study textures: writes docs/measured/textures.md and its pictures.
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "model/base/quote.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/files/image/image.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/study/textures/textures_page.hpp"
#include "sim/study/typed.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

struct TexturesOptions {
    ConfigChoice config;
    std::string output, size = "256x192";
    std::vector<std::string> scenes{"room"};
    int depth = 2, threads = 0;
    JsonOutput json;
};

void declare_textures(Parser& parser, TexturesOptions& o) {
    config_options(parser, o.config);
    parser.option("-o,--output", o.output, "folder for textures.md and the folder of its pictures")
        .required();
    parser.option("--scenes", o.scenes, "scenes with textures on triangles, separated by commas")
        .by_commas()
        .with_default();
    parser.option("--size", o.size, "size of the pictures, WIDTHxHEIGHT").with_default();
    parser.option("--depth", o.depth, "bounces of a camera ray").within(0, max_depth).with_default();
    threads_option(parser, o.threads);
    json_option(parser, o.json);
}

std::string command_of(const TexturesOptions& o) {
    const TexturesOptions usual;
    std::string text = "rayclock study textures -o " + page_path(o.output);
    if (o.config.name != usual.config.name) text += " --config " + page_path(o.config.name);
    for (const std::string& item : o.config.set) text += " --set " + item;
    if (o.scenes != usual.scenes) {
        std::vector<std::string> names;
        for (const std::string& scene : o.scenes) names.push_back(page_path(scene));
        text += fmt::format(" --scenes {}", fmt::join(names, ","));
    }
    if (o.size != usual.size) text += " --size " + o.size;
    if (o.depth != usual.depth) text += fmt::format(" --depth {}", o.depth);
    return text;
}

int run_textures(const TexturesOptions& o) {
    const texture_study::Study study{o.config, o.scenes, parse_size(o.size), o.depth, o.threads};
    const std::string path = (std::filesystem::path(o.output) / "textures.md").string();
    texture_study::prepare_pictures(o.scenes, o.output);
    check_writable(path);
    o.json.check();
    const std::vector<texture_study::SceneFigures> figures =
        texture_study::measure(study, stopping(terminal_progress()));
    texture_study::write_pictures(figures, o.output);
    write_file(path, texture_study::page(figures, study, command_of(o)));
    o.json.write(texture_study::figures_json(figures, study));
    if (!o.json.is_alone()) fmt::print("{} written\n", printable(path));
    return 0;
}

}   // namespace

Command textures_command() {
    return command("textures", "docs/measured/textures.md: filters, mip levels and formats of texels",
                   "rayclock study textures -o docs/measured", declare_textures, run_textures);
}

}   // namespace rayclock
