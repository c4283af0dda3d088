// Turns the rows of parameters.inl into a table, with the condition under which each parameter matters.
#include "model/core/parameters.hpp"

#include <algorithm>
#include <stdexcept>

#include "model/core/dram_parts.hpp"

namespace rayclock {

namespace {

namespace condition {
const Condition always{nullptr, [](const Config&) { return true; }, ""};
const Condition ideal{"dram", [](const Config& c) { return !c.dram_part(); }, "dram=ideal"};
const Condition dram{"dram", [](const Config& c) { return c.dram_part() != nullptr; },
                     "dram other than ideal"};
const Condition l2{"l2_sets", [](const Config& c) { return c.l2_sets > 0; }, "l2_sets above 0"};
const Condition tree{"structure", [](const Config& c) { return !c.is_list(); }, "structure other than none"};
const Condition straddlers{"structure",
                           [](const Config& c) { return c.has_octree() || c.is_walked(Structure::bsp); },
                           "octree or bsp"};
const Condition planes{"structure", [](const Config& c) { return c.cuts_space(); }, "kd, octree or bsp"};
const Condition boxes{"structure", [](const Config& c) { return c.has_boxes(); }, "bvh"};
const Condition bvh{"structure", [](const Config& c) { return c.is_bvh(); }, "structure=bvh"};
const Condition leaves{
    "structure",
    [](const Config& c) { return c.has_boxes() || c.is_walked(Structure::spheres) || c.has_octree(); },
    "bvh, spheres or octree"};
const Condition levels{"levels", [](const Config& c) { return c.has_instances(); }, "levels=2"};
const Condition shading{"shading", [](const Config& c) { return c.shading; }, "shading=1"};
const Condition shade{"source", [](const Config& c) { return c.has_shade(); }, "shading=1 and source=camera",
                      &shading};
const Condition textures{"textures", [](const Config& c) { return c.has_textures(); }, "textures=1", &shade};
const Condition stream{"source", [](const Config& c) { return c.is_stream(); }, "source=stream"};
}   // namespace condition

/// Who uses a parameter: the RTL as a constant, or only the host and the model.
enum class ParameterUser { rtl, host };
enum class Group { format, structure, shading, timing, caches, memory };

template <auto member> int get(const Config& config) { return int(config.*member); }
template <auto member> void set(Config& config, int value) {
    config.*member = std::remove_reference_t<decltype(config.*member)>(value);
}

}   // namespace

const std::vector<Parameter>& parameters() {
    using Type = Parameter::Type;
    static const std::vector<Parameter> all = [] {
        std::vector<Parameter> rows;
        Group group{};
        const char* heading = "";
        const auto add = [&](Parameter row) {
            row.group = heading, row.timing_only = group >= Group::timing;
            rows.push_back(row);
        };
// clang-format off
#define GROUP(name, text) group = Group::name, heading = text;
#define ROW(kind, key, user, least, most, unit, effect, text, names, number)                                       \
    add({#key, Type::kind, least, most, unit, "", false, ParameterUser::user == ParameterUser::rtl,                \
         &condition::effect, text, names, number, get<&Config::key>, set<&Config::key>});
#define NUMBER(key, user, usual, least, most, unit, effect, text)                                                  \
    ROW(number, key, user, least, most, unit, effect, text, nullptr, &Config::key)
#define POWER(key, user, usual, least, most, unit, effect, text)                                                   \
    ROW(power, key, user, least, most, unit, effect, text, nullptr, &Config::key)
#define FLAG(key, user, effect, text) ROW(flag, key, user, 0, 1, "", effect, text, nullptr, nullptr)
#define CHOICE(key, user, Enum, usual, effect, text)                                                               \
    ROW(choice, key, user, 0, int(names_of<Enum>().size()) - 1, "", effect, text, &names_of<Enum>(), nullptr)
// clang-format on
#include "model/core/parameters.inl"
#undef GROUP
#undef ROW
#undef NUMBER
#undef POWER
#undef FLAG
#undef CHOICE
        return rows;
    }();
    return all;
}

const Parameter& parameter(std::string_view key) {
    for (const Parameter& p : parameters())
        if (p.is(key)) return p;
    throw std::logic_error("there is no parameter " + std::string(key));
}

const Parameter& parameter(int Config::*number) {
    for (const Parameter& p : parameters())
        if (p.number == number) return p;
    throw std::logic_error("a number of a configuration is no parameter");
}

std::string value_text(const Config& config, const Parameter& p) {
    if (p.is("dram") && config.own_dram) return config.own_dram->name;
    return p.names ? (*p.names)[std::size_t(p.get(config))] : std::to_string(p.get(config));
}

std::string range_text(const Parameter& p) {
    std::string text;
    const auto add = [&](const std::string& value) { text += (text.empty() ? "" : ", ") + value; };
    if (p.type == Parameter::Type::flag) return "0 or 1";
    if (p.names) {
        for (const std::string& name : *p.names) add(name);
        return text;
    }
    const bool is_long = p.power_of_two() && p.hi > 8 * std::max(p.lo, 1);
    if (!p.power_of_two() || is_long) {
        text = std::to_string(p.lo) + " to " + std::to_string(p.hi) + " " + p.unit;
        return is_long ? text + ", a power of two" : text;
    }
    if (p.lo == 0) add("0");
    for (int value = std::max(p.lo, 1); value <= p.hi; value *= 2) add(std::to_string(value));
    return text + " " + p.unit;
}

}   // namespace rayclock
