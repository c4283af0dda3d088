#pragma once
// Materials of COLLADA files.
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "model/scene/scene.hpp"
#include "sim/load/dae/document.hpp"
#include "sim/load/dae/texture.hpp"

namespace rayclock {

/// Materials of COLLADA by the common profile of their effects. Counts the properties that it ignores.
class DaeMaterials {
public:
    /// `folder` is the folder of the document.
    DaeMaterials(DaeDocument& document, const std::filesystem::path& folder);

    /// Returns the material of a <material>, and reads its picture. It is grey if the effect has no shader of
    /// the common profile. Throws UserError if the document is wrong.
    const Material& material(const XmlElement& in);
    /// Returns the name of the coordinates that the picture of a <material> uses (`texcoord`). Returns
    /// nothing if the material has no picture, or the load draws no pictures.
    std::optional<std::string> coordinates(const XmlElement& in);
    /// Returns all textures. Material::texture is an index into them.
    const std::vector<Texture>& textures() const { return textures_.all(); }
    /// Adds notes to the loading about everything that was left out.
    void say_left_out() const;

private:
    /// The parameters of an effect by their names, and its shader.
    struct Effect {
        DaeParams params;
        const XmlElement* shader = nullptr;
    };
    class Shader;
    static float opacity(const Shader& shader);
    float seen_opacity(const Shader& shader);
    const Effect& effect(const XmlElement& in);
    const XmlElement* effect_of(const XmlElement& in) const;
    Material made(const XmlElement& in);
    Material made(const Effect& effect, const std::string& name);

    DaeDocument& document_;
    DaeTextures textures_;
    bool is_inverted_ = false;   ///< the exporter wrote 1 - opacity instead of the opacity
    std::map<const XmlElement*, Effect> effects_;
    std::map<const XmlElement*, Material> made_;   // by <material>
    std::uint64_t odd_ = 0, averaged_ = 0, textured_ = 0, emitting_ = 0, reflecting_ = 0, zero_ = 0,
                  without_effect_ = 0;
};

}   // namespace rayclock
