// Fuzzes configuration files.
#include <nlohmann/json.hpp>

#include "model/core/parameters.hpp"
#include "sim/run/memory/memory_file.hpp"
#include "sim/run/request/config_file.hpp"
#include "tests/fuzz/program/targets.hpp"

namespace rayclock::fuzz {

void config(std::string_view bytes) {
    const std::string path = file("fuzzed.json").string();
    passes([&] {
        const Config config = with_settings(parse_config(path, bytes), {}, path);
        nlohmann::json written{{"name", config.name}};
        for (const Parameter& p : parameters()) {
            const int value = p.get(config);
            demand(value >= p.lo && value <= p.hi, "a legal configuration has its parameters in range");
            written[p.key] = p.names ? nlohmann::json(value_text(config, p)) : nlohmann::json(value);
        }
        if (config.own_dram) written["dram"] = memory_file_json(*config.own_dram);
        const Config again = parse_config(path, written.dump());
        for (const Parameter& p : parameters())
            demand(p.get(config) == p.get(again), "what is written is read again");
        demand(own_memory_text(config) == own_memory_text(again), "a memory is written and read again");
        demand(again.name == config.name, "a name that was made printable stays as it is");
    });
}

}   // namespace rayclock::fuzz
