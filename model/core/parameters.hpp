#pragma once
// The parameters of a machine as data, for files, --set, reports and documents: made from parameters.inl.
#include <string_view>

#include "model/core/config.hpp"

namespace rayclock {

/// When a parameter has an effect.
struct Condition {
    const char* decider;   ///< the parameter that decides; null if there is always an effect
    bool (*holds)(const Config& config);
    const char* words;                  ///< "levels=2"; empty if there is always an effect
    const Condition* first = nullptr;   ///< a condition that must hold too; null if there is none
};

/// One parameter, in the form that files, `--set` and reports use.
struct Parameter {
    enum class Type { number, power, flag, choice };
    const char* key;
    Type type;
    int lo, hi;          ///< range, both ends legal
    const char* unit;    ///< empty for a flag or a choice
    const char* group;   ///< heading of its group
    bool timing_only;    ///< decides when things happen, never what a ray does
    bool in_rtl;         ///< a constant of rc_pkg.sv
    const Condition* effect;
    const char* meaning;                               ///< one sentence
    const std::vector<std::string>* names = nullptr;   ///< of a choice: of the values 0, 1 ...
    int Config::*number = nullptr;                     ///< the member, if it is a number or a power
    int (*get)(const Config& config);                  ///< the value; of a choice its index
    void (*set)(Config& config, int value);            ///< no check of range

    bool power_of_two() const { return type == Type::power; }
    bool is(std::string_view name) const { return name == key; }
};
const std::vector<Parameter>& parameters();

/// The parameter of that key; it must exist.
const Parameter& parameter(std::string_view key);
/// The parameter that is this number.
const Parameter& parameter(int Config::*number);

/// A parameter's value as files and reports give it: a number or a name.
std::string value_text(const Config& config, const Parameter& parameter);

/// Throws UserError unless the value lies within the parameter's range.
void check_range(const Parameter& parameter, int value, const std::string& where);

/// The values that a parameter may have, in words: "12 to 20 bits", "1, 2, 4, 8", "0 or 1", "bvh, kd, none".
std::string range_text(const Parameter& parameter);

}   // namespace rayclock
