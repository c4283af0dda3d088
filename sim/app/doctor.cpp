// rayclock doctor: reports installed tools, settings, and what a missing part disables.
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include "model/base/error.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/files/process/process.hpp"
#include "sim/files/process/tools.hpp"
#include "sim/load/import/assimp.hpp"
#include "sim/run/film/make_film.hpp"
#include "sim/run/rtl/builder.hpp"
#include "sim/silicon/chip/nextpnr.hpp"
#include "sim/silicon/synth/yosys.hpp"
#include "sim/view/page/library.hpp"
#include "sim/view/plot/pdf.hpp"
#include "sim/view/report/json.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace fs = std::filesystem;

namespace {

/// A checked part and its diagnosis.
struct Part {
    std::string name, key, found;   ///< `found` is empty if the part is missing
    std::string problem;            ///< the reason if it is missing, and what that disables
    std::string cure;
};

constexpr const char* no_rtl =
    "no RTL: verify, rtl, bench, and --engine rtl do not work; model and reference do";
constexpr const char* no_new_rtl =
    "no new RTL: verify, rtl, bench, and --engine rtl work only with RTL in the cache";

/// The cure names a package, not a script, because an installed program has no sources next to it.
Part tool(const char* name, const std::string& version, const char* package) {
    return {name, name, version, version.empty() ? no_new_rtl : "",
            fmt::format("{}: apt-get install {}", name, package)};
}

Part vega_part() {
    Part part{"vega", "vega", "", "", "vega: apt-get install libjs-vega"};
    const char* folder = std::getenv("RAYCLOCK_VEGA");
    if (folder && *folder) part.cure = "vega: set RAYCLOCK_VEGA to a folder with Vega's modules, or unset it";
    try {
        chart_library(true);
        part.found = chart_library_folder().string();
    } catch (const UserError& e) {
        part.problem = fmt::format("{}; without it there is no --report and no page", e.what());
    }
    return part;
}

Part cache_part() {
    Part part{"RTL cache", "rtl_cache", "", "",
              "the RTL cache: set RAYCLOCK_CACHE to a folder that can be written"};
    try {
        const CachePlace place = cache_place();
        std::error_code error;
        fs::create_directories(place.folder, error);
        if (error)
            part.problem = fmt::format("{} cannot be created ({})", place.folder.string(), error.message());
        else if (access(place.folder.c_str(), W_OK) != 0)
            part.problem = place.folder.string() + " cannot be written";
        else
            part.found = place.folder.string();
    } catch (const UserError& e) {
        part.problem = e.what();
    }
    if (!part.problem.empty())
        part.problem += fmt::format(": {}; sweep, tradeoff and area cannot cache results", no_new_rtl);
    return part;
}

Part sources_part() {
    const std::string problem = rtl_sources_problem();
    return {"RTL sources", "rtl_sources", problem.empty() ? rtl_sources().string() : "",
            problem.empty() ? "" : problem + ": " + no_rtl, "the RTL sources: set RAYCLOCK_RTL, or unset it"};
}

std::vector<Part> parts() {
    const RtlTools& tools = rtl_tools();
    std::vector<Part> all{tool("verilator", tools.verilator, "verilator"), tool("c++", tools.compiler, "g++"),
                          vega_part(), cache_part(), sources_part()};
    // Both tools run, but Verilator's own sources are missing.
    if (!tools.verilator.empty() && !tools.compiler.empty() && !tools.problem.empty())
        all[0] = {"verilator", "verilator", "", tools.problem + ": " + no_new_rtl,
                  "verilator: install it again"};
    return all;
}

/// Returns remarks about parts that are present.
std::vector<std::string> remarks() {
    std::vector<std::string> all;
    const auto add = [&](const std::string& sentence) {
        if (!sentence.empty()) all.push_back(sentence);
    };
    add(untried("verilator", rtl_tools().verilator));
    add(untried("c++", rtl_tools().compiler));
    add(untried("yosys", synth::yosys_version()));
    const chip::Nextpnr& router = chip::nextpnr();
    add(router.problem.empty() ? router.remark : router.problem + "; only chip needs it");
    try {
        add(cache_place().warning);
    } catch (const UserError&) {}   // already reported for the cache
    return all;
}

struct DoctorOptions {
    JsonOutput json;
};

void declare_doctor(Parser& parser, DoctorOptions& o) { json_option(parser, o.json); }

int run_doctor(const DoctorOptions& o) {
    o.json.check();
    Table table({"part", "found"}, 2);
    nlohmann::ordered_json json, missing = nlohmann::ordered_json::object();
    std::vector<std::string> cures;
    for (const Part& part : parts()) {
        table.add({part.name, part.found.empty() ? "MISSING: " + part.problem : part.found});
        json[part.key] =
            part.found.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(part.found);
        if (!part.found.empty()) continue;
        missing[part.key] = part.problem;
        cures.push_back(part.cure);
    }
    // One command each needs these parts, so they never count as missing.
    const chip::Nextpnr& router = chip::nextpnr();
    const bool routes = router.problem.empty();
    table.add(
        {"nextpnr-ecp5", routes ? fmt::format("{}, {}", router.version, router.program.string()) : "none"});
    const std::string yosys = synth::yosys_version();
    table.add({"yosys", !yosys.empty() ? yosys
                                       : "none: no multipliers and flip-flops in sweep and tradeoff, no area "
                                         "and no chip (apt-get install yosys)"});
    json["yosys"] = yosys.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(yosys);
    const fs::path film = find_program(film_program);
    table.add({film_program,
               film.empty() ? "none: films stay separate frames (apt-get install apngasm)" : film.string()});
    const fs::path pdf = find_program(plot::pdf_program);
    table.add({plot::pdf_program,
               pdf.empty() ? "none: plots are SVG only (apt-get install librsvg2-bin)" : pdf.string()});
    json["pdf"] = pdf.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(pdf.string());
    json["film"] = film.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(film.string());
    const fs::path assimp = find_program(assimp_program);
    table.add({assimp_program,
               assimp.empty()
                   ? fmt::format("none: FBX, X3D and others are not read; install {}", assimp_package)
                   : assimp.string()});
    json["assimp"] =
        assimp.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(assimp.string());
    json["nextpnr"] = routes ? nlohmann::ordered_json(router.version) : nlohmann::ordered_json(nullptr);
    for (const char* name :
         {"RAYCLOCK_RTL", "RAYCLOCK_CACHE", "RAYCLOCK_CXXFLAGS", "RAYCLOCK_NEXTPNR", "RAYCLOCK_VEGA"}) {
        const char* value = std::getenv(name);
        table.add({name, value && *value ? value : "not set"});
    }
    const std::vector<std::string> said = remarks();
    json["missing"] = missing;
    json["remarks"] = said;
    json["complete"] = cures.empty();
    if (!o.json.is_alone()) {
        fmt::print("rayclock {}\n{}", RAYCLOCK_VERSION, table.text());
        for (const std::string& remark : said) fmt::print("{}.\n", remark);
        fmt::print("{}.\n", cures.empty() ? "Everything is there"
                                          : fmt::format("Something is missing; {}", fmt::join(cures, "; ")));
    }
    o.json.write(json);
    return cures.empty() ? 0 : 1;
}

}   // namespace

Command doctor_command() {
    return command("doctor", "list what is installed, and what a missing part disables", "rayclock doctor",
                   declare_doctor, run_doctor);
}

}   // namespace rayclock
