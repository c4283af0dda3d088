#include "sim/load/dae_material.hpp"

#include <fmt/format.h>

namespace rayclock {
namespace {

/// A colour of three or four numbers under `what`, or false; a texture in its place is told.
bool colour(const XmlElement& shader, const char* what, const std::string& file, glm::vec4& out,
            bool& texture) {
    const XmlElement* const found = shader.find(what);
    if (!found) return false;
    texture |= found->find("texture") != nullptr;
    const XmlElement* const in = found->find("color");
    if (!in) return false;
    const std::vector<float> numbers = dae_numbers(*in, file);
    if (numbers.size() != 3 && numbers.size() != 4)
        Place{file, in->line}.refuse(fmt::format("a colour of {} numbers", numbers.size()));
    out = {numbers[0], numbers[1], numbers[2], numbers.size() == 4 ? numbers[3] : 1.0f};
    return true;
}

float single(const XmlElement& shader, const char* what, const std::string& file, float otherwise) {
    const XmlElement* const in = shader.find(what);
    const XmlElement* const number = in ? in->find("float") : nullptr;
    if (!number) return otherwise;
    const std::vector<float> numbers = dae_numbers(*number, file);
    if (numbers.size() != 1)
        Place{file, number->line}.refuse(fmt::format("{} numbers in the place of one", numbers.size()));
    return numbers[0];
}

}   // namespace

std::vector<float> dae_numbers(const XmlElement& element, const std::string& file) {
    std::vector<float> numbers;
    const Place at{file, element.line};
    std::string_view rest = element.text;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest))
        numbers.push_back(static_cast<float>(finite_number(word, at)));
    return numbers;
}

DaeMaterial dae_material(const XmlElement& effect, const std::string& file) {
    DaeMaterial made;
    const XmlElement* const technique = effect.at("profile_COMMON/technique");
    if (!technique) return made;
    const XmlElement* shader = nullptr;
    for (const char* kind : {"phong", "blinn", "lambert", "constant"})
        if (!shader) shader = technique->find(kind);
    if (!shader) return made;
    MtlSurface& s = made.surface;
    glm::vec4 value(0);
    if (colour(*shader, "diffuse", file, value, made.has_textures)) s.diffuse = glm::vec3(value);
    if (colour(*shader, "specular", file, value, made.has_textures)) {
        s.specular = glm::vec3(value);
        s.illumination = 2;
    }
    s.shine = single(*shader, "shininess", file, s.shine);
    s.index = single(*shader, "index_of_refraction", file, s.index);
    const float strength = single(*shader, "transparency", file, 1);
    if (colour(*shader, "transparent", file, value, made.has_textures)) {
        const std::string mode = shader->find("transparent")->attribute("opaque");
        const float mean = (value.r + value.g + value.b) / 3;
        s.opacity = mode == "RGB_ZERO" ? 1 - mean * strength : value.a * strength;
    }
    return made;
}

}   // namespace rayclock
