// rayclock rtl: builds the RTL of a configuration.
#include <fmt/format.h>

#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/run/rtl/builder.hpp"

namespace rayclock {

namespace {

int build_now(const ConfigChoice& choice) {
    const Config config = load_config(choice);
    check_rtl(config);
    const RtlBuild build = build_rtl(config);
    if (build.was_cached)
        fmt::print("{}: built before, {}\n", config.name, build.library.string());
    else
        fmt::print("{}: built in {:.1f} s, {}\n", config.name, build.seconds, build.library.string());
    return 0;
}

}   // namespace

Command rtl_command() {
    return command("rtl", "build the RTL of a configuration, and print its place in the cache",
                   "rayclock rtl --config small", config_options, build_now);
}

}   // namespace rayclock
