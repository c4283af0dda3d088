// rayclock scenes: lists the built-in scenes.
#include <fmt/format.h>

#include "model/scene/builtin.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/view/report/json.hpp"
#include "sim/view/report/tables.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

struct SceneListOptions {
    JsonOutput json;
};

void declare_scenes(Parser& parser, SceneListOptions& o) { json_option(parser, o.json); }

int list_scenes(const SceneListOptions& o) {
    o.json.check();
    Table table({"scene", "size", "triangles", "of a finished picture", "sizes", "purpose"});
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const Builtin& b : builtins()) {
        const std::uint64_t triangles = b.triangles(b.default_size);
        const PrimitiveCounts native = b.counts(b.default_size, Primitives::native);
        table.add({std::string(b.name), std::to_string(b.default_size), grouped(triangles),
                   native.spheres + native.planes > 0 ? primitives_text(native) : std::string{},
                   fmt::format("1..{}", b.max_size), std::string(b.purpose)});
        json.push_back(
            {{"name", b.name},
             {"default_size", b.default_size},
             {"max_size", b.max_size},
             {"triangles", triangles},
             {"finished",
              {{"triangles", native.triangles}, {"spheres", native.spheres}, {"planes", native.planes}}},
             {"purpose", b.purpose}});
    }
    if (!o.json.is_alone())
        fmt::print(
            "{}\nUse as name or name:size, for example gears:8. Files: .obj .ply .stl .off .3ds .dae .glb "
            ".gltf, "
            "each also compressed as .gz, or a .json scene "
            "(scenes/README.md).\n",
            table.text(0));
    o.json.write(json);
    return 0;
}

}   // namespace

Command scenes_command() {
    return command("scenes", "list the built-in scenes", "rayclock scenes", declare_scenes, list_scenes);
}

}   // namespace rayclock
