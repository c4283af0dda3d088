// Fuzzes scenes in JSON, with the files to which they refer.
#include "sim/load/json/scene.hpp"
#include "tests/fuzz/program/scenes.hpp"
#include "tests/fuzz/program/targets.hpp"

namespace rayclock::fuzz {

void scene(std::string_view bytes) {
    check_reader(
        bytes,
        [&](Loading& loading) {
            return flattened(read_json_scene(file("fuzzed.json"), bytes, loading).scene);
        },
        Finite::checked);
}

}   // namespace rayclock::fuzz
