// rayclock config: prints a configuration.
#include <fmt/format.h>

#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/view/report/json.hpp"

namespace rayclock {

namespace {

void declare_config(Parser& parser, ConfigChoice& config) {
    parser
        .option("NAME", config.name,
                "default, small, wide, saarcor, rpu, ulx3s, ulx3s-shaded, ulx3s-board, or a JSON file")
        .with_default();
    parser.option("--set", config.set,
                  "key=value: change one parameter of the configuration; may be repeated");
}

int print_config(const ConfigChoice& config) {
    fmt::print("{}\n", config_json_object(load_config(config)).dump(2));
    return 0;
}

}   // namespace

Command config_command() {
    return command("config", "print a configuration with every parameter",
                   "rayclock config small > mine.json", declare_config, print_config);
}

}   // namespace rayclock
