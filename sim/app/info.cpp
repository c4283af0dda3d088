// rayclock scenes, config, rtl: what there is.
#include <fmt/format.h>

#include "model/scene/builtin.hpp"
#include "sim/app/commands.hpp"
#include "sim/app/tables.hpp"
#include "sim/report/json.hpp"
#include "sim/report/text.hpp"
#include "sim/rtl/builder.hpp"
#include "sim/rtl/interrupt.hpp"

namespace rayclock {

int scenes_command(const Options& o) {
    check_outputs(o);
    Table table({"scene", "size", "triangles", "of a finished picture", "sizes", "purpose"});
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const Builtin& b : builtins()) {
        const std::uint64_t triangles = b.triangles(b.default_size);
        const PrimitiveCounts native = b.counts(b.default_size, Primitives::native);
        table.add({std::string(b.name), std::to_string(b.default_size), grouped(triangles), native.spheres + native.planes > 0 ? primitives_text(native) : std::string{}, fmt::format("1..{}", b.max_size), std::string(b.purpose)});
        json.push_back({{"name", b.name}, {"default_size", b.default_size}, {"max_size", b.max_size}, {"triangles", triangles},
                        {"finished", {{"triangles", native.triangles}, {"spheres", native.spheres}, {"planes", native.planes}}}, {"purpose", b.purpose}});
    }
    if (o.json != "-") fmt::print("{}\nUse as name or name:size, for example gears:8. Files: .obj .ply .stl .glb .gltf, or a .json scene (scenes/README.md).\n", table.text(0));
    if (!o.json.empty()) write_file(o.json, json.dump(2) + "\n");
    return 0;
}

int config_command(const Options& o) {
    fmt::print("{}\n", config_json_object(load_config(o.config, o.set)).dump(2));
    return 0;
}

int rtl_command(const Options& o) {
    catch_interrupts();
    const Config config = load_config(o.config, o.set);
    check_rtl(config);
    const RtlBuild build = build_rtl(config);
    if (build.was_cached) fmt::print("{}: built before, {}\n", config.name, build.library.string());
    else fmt::print("{}: built in {:.1f} s, {}\n", config.name, build.seconds, build.library.string());
    return 0;
}

} // namespace rayclock
