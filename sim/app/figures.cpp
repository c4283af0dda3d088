// rayclock figures: the page docs/figures.md with its pictures and plots.
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "model/core/error.hpp"
#include "model/core/quote.hpp"
#include "sim/app/commands.hpp"
#include "sim/figures/page.hpp"
#include "sim/report/text.hpp"

namespace rayclock {

namespace {

using figures::Engine;

std::vector<Engine> engines_of(const std::string& text) {
    std::vector<Engine> all;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t comma = std::min(text.find(',', from), text.size());
        const std::string name = text.substr(from, comma - from);
        if (name == "reference") all.push_back(Engine::reference);
        else if (name == "model") all.push_back(Engine::model);
        else if (name == "rtl") all.push_back(Engine::rtl);
        else throw UserError("--engine: " + shown(name) + " is not reference, model or rtl");
        from = comma + 1;
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

/// What to type for this page. Where this machine keeps its files is nobody's business.
std::string command_of(const Options& o) {
    const std::filesystem::path path(o.output);
    std::string text = "rayclock figures -o " + (path.is_absolute() ? path.filename() : path).string();
    if (o.figure_size != Options{}.figure_size) text += " --size " + o.figure_size;
    if (o.engines != Options{}.engines) text += " --engine " + o.engines;
    return text;
}

} // namespace

int figures_command(const Options& o) {
    catch_interrupts();
    figures::Studio studio;
    studio.size = parse_size(o.figure_size);
    studio.engines = engines_of(o.engines);
    studio.threads = o.threads;
    studio.progress = terminal_progress();
    check_outputs(o);
    figures::Page page(studio, o.output);
    const std::string text = figures::make_page(page, command_of(o));
    const std::string path = (std::filesystem::path(o.output) / "figures.md").string();
    write_file(path, text);
    if (!o.json.empty()) write_file(o.json, page.numbers.dump(2) + "\n");
    if (o.json != "-") fmt::print("{} written. {}\n", printable(path), page.rtl_sentence());
    return 0;
}

} // namespace rayclock
