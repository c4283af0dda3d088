// Declares and checks the options of placers and routers.
#include "sim/app/parts/methods.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/nearest.hpp"
#include "model/base/quote.hpp"

namespace rayclock {

namespace {

void check_method(const char* option, const std::string& name, const std::vector<std::string>& names) {
    if (std::find(names.begin(), names.end(), name) == names.end())
        throw UserError(fmt::format("{}: nextpnr has no {} that is called {}{}", option, option + 2,
                                    shown(name), did_you_mean(name, names)));
}

}   // namespace

void method_options(Parser& parser, MethodOptions& o, const char* group) {
    parser
        .option("--placer", o.placer,
                "nextpnr's placer: heap, static, or mixed (static, then heap); mixed by default for a chip, "
                "heap for a unit alone")
        .under(group);
    parser.option("--router", o.router, "nextpnr's router, router1 or router2").under(group);
    parser
        .option("--placements", o.placements,
                "number of placements; each after the first starts with multipliers and block memories at "
                "better sites; 2 by default for a chip, 1 for a unit alone")
        .under(group);
}

chip::Methods methods_of(const MethodOptions& o, const std::string& top) {
    chip::Methods methods = chip::usual_methods(top);
    if (o.placer) methods.placer = *o.placer;
    if (o.router) methods.router = *o.router;
    if (o.placements) methods.placements = *o.placements;
    check_method("--placer", methods.placer, chip::placers());
    check_method("--router", methods.router, chip::routers());
    if (methods.placements < 1 || methods.placements > 9)
        throw UserError(fmt::format("--placements: {} does not lie in 1..9", methods.placements));
    if (methods.placer == "mixed" && methods.placements == 1)
        throw UserError("--placements: the placer mixed needs at least two placements, not 1");
    return methods;
}

}   // namespace rayclock
