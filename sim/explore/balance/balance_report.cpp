// Formats the result of a search as text and as JSON.
#include "sim/explore/balance/balance_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/files/table.hpp"

namespace rayclock::balance {

using nlohmann::ordered_json;

namespace {

void add(Table& table, const std::string& name, const Machine& machine, std::vector<std::string> more = {}) {
    const chip::Use use = machine.use.value_or(chip::Use{});
    std::vector<std::string> row{name,
                                 machine.fps ? fmt::format("{:.2f}", *machine.fps) : "",
                                 grouped(use.lut),
                                 grouped(use.ff),
                                 grouped(use.dsp),
                                 grouped(use.bram)};
    row.insert(row.end(), more.begin(), more.end());
    table.add(row);
}

ordered_json use_json(const chip::Use& use) {
    ordered_json json;
    for (const chip::Resource& resource : chip::resources()) json[resource.key] = use.*resource.member;
    return json;
}

ordered_json machine_json(const Machine& machine, const chip::Use& room) {
    ordered_json steps = ordered_json::array();
    for (const Step& step : machine.steps)
        steps.push_back({{"key", step.parameter->key}, {"from", step.from}, {"to", step.to}});
    ordered_json json{{"steps", steps}};
    json["fps"] = machine.fps ? ordered_json(*machine.fps) : ordered_json(nullptr);
    json["use"] = machine.use ? use_json(*machine.use) : ordered_json(nullptr);
    json["fits"] = machine.use && fits(*machine.use, room);
    return json;
}

}   // namespace

std::string steps_text(const std::vector<Step>& steps) {
    std::vector<std::string> parts;
    for (const Step& step : steps)
        parts.push_back(fmt::format("{} {} -> {}", step.parameter->key, step.from, step.to));
    return fmt::format("{}", fmt::join(parts, ", "));
}

std::string excess(const chip::Use& use, const chip::Use& room) {
    std::vector<std::string> parts;
    for (const chip::Resource& resource : chip::resources())
        if (use.*resource.member > room.*resource.member)
            parts.push_back(fmt::format("{} of {} {}", grouped(use.*resource.member),
                                        grouped(room.*resource.member), resource.name));
    return fmt::format("{}", fmt::join(parts, ", "));
}

std::string text(const SearchResult& found, const chip::Use& room) {
    Table path({"step", "fps", "LUT", "FF", "MULT18X18D", "DP16KD"});
    add(path,
        fmt::format("pipelines = {}, all other parameters at their smallest", found.first.config.pipelines),
        found.first);
    for (const Machine& machine : found.path) add(path, steps_text(machine.steps), machine);
    add(path, "room", {{}, {}, {}, room});
    std::string text = path.text();
    for (const Machine& other : found.others)
        text += other.use && fits(*other.use, room)
                    ? fmt::format("  with pipelines = {}: {:.2f} fps at best\n", other.config.pipelines,
                                  other.fps.value_or(0))
                    : fmt::format("  with pipelines = {}: {}\n", other.config.pipelines,
                                  other.use ? excess(*other.use, room) : "cannot draw the scene");
    if (found.next.empty()) return text + "  one step more in any parameter makes it no faster\n";
    Table next({"one step more", "fps", "LUT", "FF", "MULT18X18D", "DP16KD", "too many"});
    for (const Machine& machine : found.next)
        add(next, steps_text(machine.steps), machine, {excess(*machine.use, room)});
    return text + "\n" + next.text();
}

ordered_json json(const SearchResult& found, const chip::Use& room) {
    ordered_json path = ordered_json::array(), next = ordered_json::array(), others = ordered_json::array();
    for (const Machine& machine : found.path) path.push_back(machine_json(machine, room));
    for (const Machine& machine : found.next) next.push_back(machine_json(machine, room));
    for (const Machine& machine : found.others) {
        others.push_back(machine_json(machine, room));
        others.back()["pipelines"] = machine.config.pipelines;
    }
    return {{"room", use_json(room)},
            {"machines", found.machines},
            {"pipelines", found.best().config.pipelines},
            {"first", machine_json(found.first, room)},
            {"path", path},
            {"best", machine_json(found.best(), room)},
            {"next", next},
            {"others", others}};
}

}   // namespace rayclock::balance
