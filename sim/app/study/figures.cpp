// rayclock study figures: makes docs/measured/figures.md with its pictures and plots.
#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/split.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/files/image/image.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/study/figures/figures_page.hpp"
#include "sim/study/typed.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

using figures::Engine;

std::vector<Engine> engines_of(const std::string& text) {
    const std::array<std::string, 3> names{"reference", "model", "rtl"};
    std::set<Engine> all;
    for (const std::string& name : split(text, ',')) {
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end())
            throw UserError("--engine: " + shown(name) + " is not reference, model or rtl");
        all.insert(Engine(found - names.begin()));
    }
    return {all.begin(), all.end()};
}

constexpr const char* usual_figures_size = "256x192";
constexpr const char* all_engines = "reference,model,rtl";

struct FiguresOptions {
    std::string output, size = usual_figures_size, engines = all_engines;
    int threads = 0;
    JsonOutput json;
};

void declare_figures(Parser& parser, FiguresOptions& o) {
    parser.option("-o,--output", o.output, "folder for figures.md, and for its pictures in figures/")
        .required();
    parser.option("--size", o.size, "size of the pictures, WIDTHxHEIGHT").with_default();
    parser.option("--engine", o.engines, "engines, separated by commas").with_default();
    threads_option(parser, o.threads);
    json_option(parser, o.json);
}

std::string command_of(const FiguresOptions& o) {
    std::string text = "rayclock study figures -o " + page_path(o.output);
    if (o.size != usual_figures_size) text += " --size " + o.size;
    if (o.engines != all_engines) text += " --engine " + o.engines;
    return text;
}

int run_figures(const FiguresOptions& o) {
    figures::Studio studio;
    studio.size = parse_size(o.size);
    studio.engines = engines_of(o.engines);
    studio.threads = o.threads;
    studio.progress = stopping(terminal_progress());
    o.json.check();
    figures::Page page(studio, o.output);
    const std::string text = figures::make_page(page, command_of(o));
    const std::string path = (std::filesystem::path(o.output) / "figures.md").string();
    write_file(path, text);
    o.json.write(page.numbers);
    if (!o.json.is_alone()) fmt::print("{} written. {}\n", printable(path), page.rtl_sentence());
    return 0;
}

}   // namespace

Command figures_command() {
    return command("figures", "docs/measured/figures.md: the classic figures, drawn by all engines",
                   "rayclock study figures -o docs/measured", declare_figures, run_figures);
}

}   // namespace rayclock
