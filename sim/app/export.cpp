// rayclock export: writes a frame of a chip as files for another simulator or a board.
#include <fmt/format.h>

#include "model/base/quote.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/files/folder.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/silicon/export/export.hpp"
#include "sim/study/typed.hpp"
#include "sim/view/report/json.hpp"
#include "sim/view/report/tables.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

struct ExportOptions {
    std::string scene, size = "128x96", output;
    ConfigChoice config;
    Finish finish;
    ViewChoice view;
    JsonOutput json;
};

void declare_export(Parser& parser, ExportOptions& o) {
    scene_option(parser, o.scene).required();
    finished_options(parser, o.finish);
    view_options(parser, o.view);
    size_option(parser, o.size);
    config_options(parser, o.config);
    parser.option("-o,--output", o.output, "folder to write; it must be new or empty").required();
    json_option(parser, o.json);
}

/// Returns the command with the options that affect the export.
std::string command_of(const ExportOptions& o) {
    std::string text = fmt::format("rayclock export {} --size {} --config {}", page_path(o.scene), o.size,
                                   page_path(o.config.name));
    for (const std::string& set : o.config.set) text += " --set " + set;
    return printable(text);
}

int run_export(const ExportOptions& o) {
    const FrameSize size = parse_size(o.size);
    o.json.check();
    NewFolder folder(o.output);
    const Progress progress = stopping(terminal_progress());
    Request request = request_of(o.scene, o.config, o.finish, default_seed, size, progress, o.view);
    check_rtl(request.config);
    set_parameter(request.config, "dram", "ideal", "export");   // the test bench has only this memory
    request.config.dram_channels = 1;
    const Job job =
        make_job(request.scene, *request.scene.camera, size, request.config, progress, request.settings);
    const std::string title = fmt::format("{}, {}x{}, on the chip '{}'", request.scene.name, size.width,
                                          size.height, request.config.name);
    const Export made = make_export(job, title, command_of(o), progress);
    for (const ExportedFile& file : made.files) folder.write(file.name, file.bytes);
    folder.publish();
    if (!o.json.is_alone())
        fmt::print("{}: {}, {} lines of memory, {} cycles -> {}\n", request.scene.name,
                   primitives_text(request.scene), grouped(job.image.lines()), grouped(made.cycles),
                   printable(o.output));
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    for (const ExportedFile& file : made.files) files.push_back(file.name);
    o.json.write({{"scene", scene_json(request.scene)},
                  {"config", config_json_object(request.config)},
                  {"frame", {{"width", size.width}, {"height", size.height}}},
                  {"cycles", made.cycles},
                  {"digest", digest_text(made.digest)},
                  {"files", files}});
    return 0;
}

}   // namespace

Command export_command() {
    return command("export", "write a chip, a frame and a test bench for other simulators",
                   "rayclock export gears:4 --config small -o gears_chip", declare_export, run_export);
}

}   // namespace rayclock
