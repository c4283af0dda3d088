// rayclock study streams: makes docs/measured/stream-figures.md.
#include <filesystem>

#include <fmt/format.h>

#include "model/base/quote.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/files/output.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/study/streams.hpp"
#include "sim/study/typed.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

constexpr const char *usual_streams_size = "128x96", *routed_clock = "104";

struct StreamsOptions {
    ConfigChoice config;
    std::string output, size = usual_streams_size, clock = routed_clock;
    std::vector<std::string> scenes{"gears:8", "balls:4", "tetra:8", "teapot:12"};
    JsonOutput json;
    int threads = 0;
};

void declare_streams(Parser& parser, StreamsOptions& o) {
    config_options(parser, o.config);
    parser.option("-o,--output", o.output, "folder for stream-figures.md").required();
    parser.option("--scenes", o.scenes, "scenes, separated by commas").by_commas().with_default();
    parser.option("--size", o.size, "size of the pictures whose camera rays are followed").with_default();
    parser.option("--clock", o.clock, "clock in MHz").with_default();
    json_option(parser, o.json);
    threads_option(parser, o.threads);
}

std::string command_of(const StreamsOptions& o) {
    std::string text = "rayclock study streams -o " + page_path(o.output);
    if (o.config.name != ConfigChoice{}.name) text += " --config " + page_path(o.config.name);
    for (const std::string& item : o.config.set) text += " --set " + item;
    if (o.scenes != StreamsOptions{}.scenes) {
        std::vector<std::string> told;
        for (const std::string& scene : o.scenes) told.push_back(page_path(scene));
        text += fmt::format(" --scenes {}", fmt::join(told, ","));
    }
    if (o.size != usual_streams_size) text += " --size " + o.size;
    if (o.clock != routed_clock) text += " --clock " + o.clock;
    return text;
}

int run_streams(const StreamsOptions& o) {
    const std::string path = (std::filesystem::path(o.output) / "stream-figures.md").string();
    check_writable(path);
    o.json.check();
    const Progress progress = stopping(terminal_progress());
    const streams::Study study{load_config(o.config), o.scenes, parse_size(o.size), parse_clocks(o.clock)[0],
                               o.threads};
    const std::vector<streams::Row> rows = streams::measure(study, progress);
    write_file(path, streams::page(rows, study, command_of(o)));
    o.json.write(streams::rows_json(rows));
    if (!o.json.is_alone()) fmt::print("{} written\n", printable(path));
    return 0;
}

}   // namespace

Command streams_command() {
    return command("streams",
                   "docs/measured/stream-figures.md: rays of many kinds from memory, on every structure",
                   "rayclock study streams -o docs/measured", declare_streams, run_streams);
}

}   // namespace rayclock
