// rayclock scenes, config, rtl, doctor: what there is.
#include <cstdio>
#include <filesystem>

#include <fmt/format.h>

#include "model/scene/builtin.hpp"
#include "sim/app/commands.hpp"
#include "sim/app/tables.hpp"
#include "sim/report/json.hpp"
#include "sim/report/text.hpp"
#include "sim/rtl/builder.hpp"

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
    fmt::print("{}", config_json(load_config(o.config, o.set)));
    return 0;
}

int rtl_command(const Options& o) {
    const Config config = load_config(o.config, o.set);
    check_rtl(config);
    const RtlBuild build = build_rtl(config);
    if (build.was_cached) fmt::print("{}: built before, {}\n", config.name, build.library.string());
    else fmt::print("{}: built in {:.1f} s, {}\n", config.name, build.seconds, build.library.string());
    return 0;
}

namespace {

/// First line that a command prints, or nothing if it is not there.
std::string version_of(const char* command) {
    FILE* pipe = popen((std::string(command) + " 2>/dev/null").c_str(), "r");
    std::string line;
    if (!pipe) return line;
    for (int c = 0; (c = std::fgetc(pipe)) != EOF && c != '\n';) line += char(c);
    while (std::fgetc(pipe) != EOF) {}
    return pclose(pipe) == 0 ? line : std::string{};
}

} // namespace

int doctor_command(const Options& o) {
    check_outputs(o);
    struct Part {
        const char* name;
        const char* command;
        const char* without;
    };
    constexpr Part parts[] = {
        {"verilator", "verilator --version", "no RTL: verify, render and simulate --engine rtl do not work; model and reference do"},
        {"c++", "c++ --version", "no RTL that is not built yet"},
        {"yosys", "yosys -V", "no multipliers and flip-flops in sweep and tradeoff; the synthesis check of the tests is left out"},
    };
    bool complete = true;
    nlohmann::ordered_json json;
    Table table({"part", "found"});
    for (const Part& part : parts) {
        const std::string version = version_of(part.command);
        complete = complete && !version.empty();
        table.add({part.name, version.empty() ? std::string("MISSING: ") + part.without : version});
        json[part.name] = version.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(version);
    }
    std::error_code error;
    std::filesystem::create_directories(rtl_cache(), error);
    const std::string cache = rtl_cache().string();
    table.add({"RTL cache", error ? "MISSING: " + cache + " cannot be made; set RAYCLOCK_CACHE" : cache});
    json["rtl_cache"] = error ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(cache);
    const bool sources = std::filesystem::exists(rtl_sources() / "rc_top.sv");
    table.add({"RTL sources", sources ? rtl_sources().string() : "MISSING: " + rtl_sources().string()});
    json["rtl_sources"] = sources ? nlohmann::ordered_json(rtl_sources().string()) : nlohmann::ordered_json(nullptr);
    json["complete"] = complete = complete && !error && sources;
    if (o.json != "-") fmt::print("rayclock {}\n{}{}\n", RAYCLOCK_VERSION, table.text(), complete ? "Everything is there." : "Something is missing; ./bootstrap installs it.");
    if (!o.json.empty()) write_file(o.json, json.dump(2) + "\n");
    return complete ? 0 : 1;
}

} // namespace rayclock
