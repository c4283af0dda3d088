// Phong, Blinn, Lambert and constant shaders of COLLADA, converted to rayclock's material.
#include "sim/load/dae/material.hpp"

#include <optional>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "sim/load/surface.hpp"
#include "sim/load/textures.hpp"

namespace rayclock {
namespace {

void take_params(const XmlElement& in, const char* kind, const char* key, DaeParams& out) {
    for (const XmlElement& child : in.children)
        if (child.name == kind && !child.children.empty())
            out.insert_or_assign(child.attribute(key), &child.children.back());
}

}   // namespace

/// Reads the values of a shader, and follows its references to parameters.
class DaeMaterials::Shader {
public:
    Shader(const XmlElement& in, const DaeParams& params, const DaeDocument& document)
        : in_(in), params_(params), document_(document) {}

    const XmlElement* find(const char* what) const { return in_.find(what); }
    const XmlElement* texture(const char* what) const {
        const XmlElement* const found = in_.find(what);
        return found ? found->find("texture") : nullptr;
    }
    std::optional<glm::vec4> colour(const char* what) const {
        const XmlElement* const value = this->value(what, "color");
        if (!value) return std::nullopt;
        const std::vector<float> numbers = document_.finite(*value);
        if (numbers.size() != 3 && numbers.size() != 4)
            document_.refuse(*value, fmt::format("a colour of {} numbers", numbers.size()));
        return glm::vec4(numbers[0], numbers[1], numbers[2], numbers.size() == 4 ? numbers[3] : 1.0f);
    }
    std::optional<float> number(const char* what) const {
        const XmlElement* const value = this->value(what, "float");
        return value ? std::optional(document_.finite(*value, 1)[0]) : std::nullopt;
    }

private:
    /// Returns the element with the numbers: a child of this kind, or the parameter that the shader
    /// references instead.
    const XmlElement* value(const char* what, const char* kind) const {
        const XmlElement* const found = in_.find(what);
        if (!found) return nullptr;
        if (const XmlElement* const given = found->find(kind)) return given;
        const XmlElement* const param = found->find("param");
        if (!param) return nullptr;
        const auto named = params_.find(param->attribute("ref"));
        if (named == params_.end())
            document_.refuse(
                *param, "param names " + shown(param->attribute("ref")) + ", which its effect does not have");
        return named->second;
    }

    const XmlElement& in_;
    const DaeParams& params_;
    const DaeDocument& document_;
};

/// Returns the opacity by "Determining Transparency" of the COLLADA 1.5 specification.
float DaeMaterials::opacity(const Shader& shader) {
    const XmlElement* const transparent = shader.find("transparent");
    const std::string mode = transparent ? transparent->attribute("opaque") : std::string{};
    const glm::vec4 colour = shader.colour("transparent").value_or(glm::vec4(1));
    const float strength = shader.number("transparency").value_or(1.0f);
    const float luminance = glm::dot(glm::vec3(colour), glm::vec3(0.212671f, 0.715160f, 0.072169f));
    // A texture alone has no value that can be drawn here.
    if (shader.texture("transparent") && (mode == "RGB_ZERO" || mode == "A_ZERO")) return 1;
    if (mode == "RGB_ZERO") return transparent ? 1 - luminance * strength : strength;
    if (mode == "A_ZERO") return 1 - colour.a * strength;
    if (mode == "RGB_ONE") return luminance * strength;
    return colour.a * strength;
}

DaeMaterials::DaeMaterials(DaeDocument& document, const std::filesystem::path& folder)
    : document_(document), textures_(document, folder) {
    const XmlElement* const tool = document.top().at("asset/contributor/authoring_tool");
    is_inverted_ = tool && tool->text.find("FBX COLLADA exporter") != std::string::npos;
}

float DaeMaterials::seen_opacity(const Shader& shader) {
    const XmlElement* const transparent = shader.find("transparent");
    const auto strength = shader.number("transparency");
    if (!strength) return opacity(shader);
    // COLLADA 1.4.0 did not define 0, and programs of its time wrote 0 for opaque materials.
    if (*strength == 0 && (!transparent || transparent->attribute("opaque").empty())) {
        ++zero_;
        return 1;
    }
    return is_inverted_ ? 1 - opacity(shader) : opacity(shader);
}

const DaeMaterials::Effect& DaeMaterials::effect(const XmlElement& in) {
    const auto [found, is_new] = effects_.try_emplace(&in);
    Effect& made = found->second;
    if (!is_new) return made;
    take_params(in, "newparam", "sid", made.params);
    const XmlElement* const profile = in.find("profile_COMMON");
    if (!profile) return made;
    take_params(*profile, "newparam", "sid", made.params);
    const XmlElement* const technique = profile->find("technique");
    if (!technique) return made;
    take_params(*technique, "newparam", "sid", made.params);
    for (const char* kind : {"phong", "blinn", "lambert", "constant"})
        if (!made.shader) made.shader = technique->find(kind);
    constexpr std::size_t max_children = 100;   // each material looks through all of them
    if (made.shader && made.shader->children.size() > max_children)
        document_.refuse(*made.shader,
                         fmt::format("{} with more than {} elements", made.shader->name, max_children));
    return made;
}

const XmlElement* DaeMaterials::effect_of(const XmlElement& in) const {
    const XmlElement* const instance = in.find("instance_effect");
    return instance ? document_.find(instance->attribute("url")) : nullptr;
}

std::optional<std::string> DaeMaterials::coordinates(const XmlElement& in) {
    const XmlElement* const found = effect_of(in);
    const XmlElement* const shader = found ? effect(*found).shader : nullptr;
    const XmlElement* const texture = shader ? shader->at("diffuse/texture") : nullptr;
    if (!texture || !document_.loading().draws_textures()) return std::nullopt;
    return texture->attribute("texcoord");
}

const Material& DaeMaterials::material(const XmlElement& in) {
    const auto known = made_.find(&in);
    return known != made_.end() ? known->second : made_.emplace(&in, made(in)).first->second;
}

Material DaeMaterials::made(const XmlElement& in) {
    const std::string given = in.attribute("name"), name = given.empty() ? in.attribute("id") : given;
    const XmlElement *const instance = in.find("instance_effect"), *const found = effect_of(in);
    if (!found || !effect(*found).shader) {
        ++without_effect_;
        return material_of(MtlSurface{.diffuse = glm::vec3(0.8f)}, name);
    }
    if (!instance->find("setparam")) return made(effect(*found), name);
    Effect changed = effect(*found);
    document_.charge(sizeof(XmlElement) * changed.params.size());
    take_params(*instance, "setparam", "ref", changed.params);
    return made(changed, name);
}

Material DaeMaterials::made(const Effect& effect, const std::string& name) {
    const Shader shader(*effect.shader, effect.params, document_);
    const auto is_light = [](const glm::vec4& c) { return c.r > 0 || c.g > 0 || c.b > 0; };
    const glm::vec4 black(0, 0, 0, 1);
    const glm::vec4 emission = shader.colour("emission").value_or(black);
    // A shader without a diffuse colour scatters no light.
    MtlSurface surface{.diffuse = glm::vec3(shader.colour("diffuse").value_or(black))};
    std::optional<std::uint32_t> texture;
    if (const XmlElement* const picture = shader.texture("diffuse")) {
        texture = textures_.texture(*picture, effect.params);
        const auto average = texture ? std::nullopt : textures_.average(*picture, effect.params);
        averaged_ += average.has_value();
        surface.diffuse = texture ? glm::vec3(1) : average.value_or(glm::vec3(0.8f));
    }
    const bool glows = is_light(emission) && !is_light(glm::vec4(surface.diffuse, 1));
    if (glows) surface.diffuse = glm::vec3(emission);
    if (const auto specular = shader.colour("specular")) {
        surface.specular = glm::vec3(*specular);
        surface.illumination = 2;
    }
    surface.shine = shader.number("shininess").value_or(surface.shine);
    surface.index = shader.number("index_of_refraction").value_or(surface.index);
    if (shader.find("transparent") || shader.find("transparency")) surface.opacity = seen_opacity(shader);
    for (const char* what : {"emission", "specular", "reflective", "transparent"})
        if (shader.texture(what)) {
            ++textured_;
            break;
        }
    emitting_ += is_light(emission) && !glows;
    reflecting_ += shader.number("reflectivity").value_or(0) > 0 &&
                   is_light(shader.colour("reflective").value_or(black));
    odd_ += is_out_of_range(surface);
    Material out = material_of(surface, name);
    out.texture = texture;
    if (glows) {   // emits its own light and reflects none
        out.ambient += out.diffuse;
        out.diffuse = 0;
    }
    return out;
}

void DaeMaterials::say_left_out() const {
    const auto say = [&](std::uint64_t count, const char* what, const std::string& sentence) {
        if (count > 0) document_.loading().note(document_.file(), counted(count, what) + sentence);
    };
    say(odd_, "material", " with values out of range, taken as the nearest within");
    say(averaged_, "material", std::string(" ") + averaged_texture);
    say(textured_, "material", " with other textures, which are not drawn");
    say(emitting_, "material", " with emission and a diffuse colour, drawn without the emission");
    say(reflecting_, "material", " with a reflective colour, which is not drawn");
    say(zero_, "material", " with a transparency of 0 and no word on what it means, drawn opaque");
    textures_.say_left_out();
    say(without_effect_, "material", " without an effect of the common profile, drawn grey");
}

}   // namespace rayclock
