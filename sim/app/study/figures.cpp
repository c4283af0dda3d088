// rayclock study figures: makes docs/measured/figures.md with its pictures and plots.
#include <filesystem>
#include <set>

#include <fmt/format.h>

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

std::vector<Tracer> tracers_of(const std::string& text) {
    std::set<Tracer> all;
    for (const std::string& name : split(text, ',')) all.insert(parse_tracer(name));
    return {all.begin(), all.end()};
}

constexpr const char* usual_figures_size = "256x192";
constexpr const char* all_tracers = "reference,model,rtl";

struct FiguresOptions {
    std::string output, size = usual_figures_size, tracers = all_tracers;
    int threads = 0;
    JsonOutput json;
};

void declare_figures(Parser& parser, FiguresOptions& o) {
    parser.option("-o,--output", o.output, "folder for figures.md, and for its pictures in figures/")
        .required();
    parser.option("--size", o.size, "size of the pictures, WIDTHxHEIGHT").with_default();
    parser.option("--engine", o.tracers, "reference, model and rtl, separated by commas").with_default();
    threads_option(parser, o.threads);
    json_option(parser, o.json);
}

std::string command_of(const FiguresOptions& o) {
    std::string text = "rayclock study figures -o " + page_path(o.output);
    if (o.size != usual_figures_size) text += " --size " + o.size;
    if (o.tracers != all_tracers) text += " --engine " + o.tracers;
    return text;
}

int run_figures(const FiguresOptions& o) {
    figures::Studio studio;
    studio.size = parse_size(o.size);
    studio.tracers = tracers_of(o.tracers);
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
    return command("figures",
                   "docs/measured/figures.md: the classic figures, drawn by reference, model and RTL",
                   "rayclock study figures -o docs/measured", declare_figures, run_figures);
}

}   // namespace rayclock
