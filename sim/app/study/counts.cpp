// rayclock study counts: counts rays of Haines' Standard Procedural Databases on reference and model, and
// compares them with the published counts.
#include <algorithm>

#include <fmt/format.h>

#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/files/image/image.hpp"
#include "sim/study/spd.hpp"
#include "sim/study/typed.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

constexpr const char* published_size = "513x513";

struct CountsOptions {
    std::vector<std::string> scenes = spd::published_scenes();
    std::string size = published_size, output;
    int threads = 0;
    JsonOutput json;
};

void declare_counts(Parser& parser, CountsOptions& o) {
    parser.option("SCENE", o.scenes, "scenes; by default all that have a published count");
    parser.option("--size", o.size, "size of the picture, WIDTHxHEIGHT; the published counts are of 513x513")
        .with_default();
    parser.option("-o,--output", o.output, "Markdown file to write");
    threads_option(parser, o.threads);
    json_option(parser, o.json);
}

std::string command_of(const CountsOptions& o) {
    std::string text = "rayclock study counts";
    if (o.scenes != spd::published_scenes()) text += fmt::format(" {}", fmt::join(o.scenes, " "));
    if (o.size != published_size) text += " --size " + o.size;
    return text + " -o " + page_path(o.output);
}

int run_counts(const CountsOptions& o) {
    const FrameSize size = parse_size(o.size);
    o.json.check();
    if (!o.output.empty()) check_writable(o.output);
    const Progress progress = terminal_progress();
    std::vector<spd::Counted> all;
    for (const std::string& scene : o.scenes) all.push_back(spd::count(scene, size, o.threads, progress));
    if (!o.json.is_alone()) fmt::print("{}", spd::text(all));
    if (!o.output.empty()) write_file(o.output, spd::page(all, size, command_of(o)));
    o.json.write(spd::json(all, size));
    return std::all_of(all.begin(), all.end(), spd::is_good) ? 0 : 1;
}

}   // namespace

Command counts_command() {
    return command("counts",
                   "docs/measured/ray-counts.md: rays of Haines' scenes, compared with the published counts",
                   "rayclock study counts -o docs/measured/ray-counts.md", declare_counts, run_counts);
}

}   // namespace rayclock
