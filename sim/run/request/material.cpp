// Parsing and applying --material.
#include "sim/run/request/material.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/nearest.hpp"
#include "model/scene/placed.hpp"
#include "sim/files/json_value.hpp"
#include "sim/files/text.hpp"
#include "sim/load/json/parts.hpp"

namespace rayclock {
namespace {

constexpr const char* option = "--material";

/// Removes the text before the next `mark`, and the mark, from the front of `rest`. Returns the text.
std::string_view take_part(std::string_view& rest, char mark) {
    const std::size_t end = std::min(rest.find(mark), rest.size());
    const std::string_view part = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return part;
}

/// Returns true for the default material, which the readers of all formats call "default".
bool is_nobodys(const Material& material) { return material.name == "default"; }

Material named(std::string_view name) {
    std::vector<std::string> known;
    for (const Material& material : make_placed("spheres", Primitives::native).own.materials) {
        if (material.name == name) return material;
        known.push_back(material.name);
    }
    throw UserError(
        fmt::format("{}: no material is called {}{}", option, shown(name), did_you_mean(name, known)));
}

/// Parses a value: "0.5", "true", "1:0.5:0".
Json value_of(std::string_view text) {
    const SourcePosition at{option};
    if (text == "true" || text == "false") return text == "true";
    if (text.find(':') == text.npos) return finite_number(text, at);
    Json list = Json::array();
    while (!text.empty()) list.push_back(finite_number(take_part(text, ':'), at));
    return list;
}

}   // namespace

void give_material(Scene& scene, const std::string& typed) {
    std::optional<Material> base;
    Json keys = Json::object();
    for (std::string_view rest = typed; !rest.empty();) {
        std::string_view part = take_part(rest, ',');
        const std::string_view key = take_part(part, '=');
        if (part.empty() && (base || !keys.empty()))
            throw UserError(std::string(option) + ": " + shown(key) + " is not key=value");
        if (part.empty())
            base = named(key);
        else
            keys[std::string(key)] = value_of(part);
    }
    if (!base && keys.empty()) throw UserError(std::string(option) + " needs a name or key=value");
    for (Material& material : scene.materials) {
        if (!is_nobodys(material)) continue;
        Material made = base.value_or(material);
        made.name = material.name;
        material = material_of(JsonValue(keys, option), made);
    }
    if (!may_give_material(scene))
        throw UserError(std::string(option) +
                        " applies to surfaces without a material, and every surface of " +
                        printable(scene.name) + " has one");
}

bool may_give_material(const Scene& scene) {
    return std::any_of(scene.materials.begin(), scene.materials.end(), is_nobodys);
}

bool has_bounces(const Scene& scene) {
    return std::any_of(scene.materials.begin(), scene.materials.end(),
                       [](const Material& m) { return m.mirror > 0 || m.transmit > 0; });
}

}   // namespace rayclock
