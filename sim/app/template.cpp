// rayclock template: writes the files from which a user starts a replacement of a unit.
#include <fmt/format.h>

#include "model/base/quote.hpp"
#include "sim/app/options/command_line.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/files/folder.hpp"
#include "sim/run/elastic/template.hpp"

namespace rayclock {

namespace {

struct TemplateOptions {
    std::string unit, output;
    ConfigChoice config;
    JsonOutput json;
};

void declare_template(Parser& parser, TemplateOptions& o) {
    parser.option("UNIT", o.unit, "a unit of the chip: tri, box, prim_cache, ...").required();
    config_options(parser, o.config);
    parser.option("-o,--output", o.output, "folder to write; it must be new or empty").required();
    json_option(parser, o.json);
}

int run_template(const TemplateOptions& o) {
    o.json.check();
    const Config config = load_config(o.config);
    check_rtl(config);
    std::string options = shell_word(o.config.name);
    for (const std::string& item : o.config.set) options += " --set " + shell_word(item);
    const std::vector<TemplateFile> files = unit_template(o.unit, config, options);
    NewFolder folder(o.output);
    for (const TemplateFile& file : files) folder.write(file.name, file.bytes);
    folder.publish();
    if (!o.json.is_alone())
        fmt::print("unit {} of '{}' -> {}: README.md has the ports, the rules and the run lines\n", o.unit,
                   printable(config.name), printable(o.output));
    nlohmann::ordered_json names = nlohmann::ordered_json::array();
    for (const TemplateFile& file : files) names.push_back(file.name);
    o.json.write({{"unit", o.unit}, {"config", config.name}, {"folder", o.output}, {"files", names}});
    return 0;
}

}   // namespace

Command template_command() {
    return command("template", "write a unit's module, a wrapper and a README",
                   "rayclock template tri -o my_tri", declare_template, run_template);
}

}   // namespace rayclock
