#pragma once
// Materials of COLLADA files.
#include <cstdint>
#include <map>
#include <string>

#include "model/scene/scene.hpp"
#include "sim/load/dae/document.hpp"

namespace rayclock {

/// Materials of COLLADA by the common profile of their effects. Counts the properties that it ignores.
class DaeMaterials {
public:
    explicit DaeMaterials(DaeDocument& document);

    /// Returns the material of a <material>. It is grey if the effect has no shader of the common profile.
    /// Throws UserError if the document is wrong.
    Material material(const XmlElement& in);
    /// Adds notes to the loading about everything that was left out.
    void say_left_out() const;

private:
    /// The parameters of an effect by their names, and its shader.
    struct Effect {
        std::map<std::string, const XmlElement*> params;
        const XmlElement* shader = nullptr;
    };
    class Shader;
    static float opacity(const Shader& shader);
    float seen_opacity(const Shader& shader);
    const Effect& effect(const XmlElement& in);
    Material made(const Effect& effect, const std::string& name);

    DaeDocument& document_;
    bool is_inverted_ = false;   ///< the exporter wrote 1 - opacity instead of the opacity
    std::map<const XmlElement*, Effect> effects_;
    std::uint64_t odd_ = 0, textured_ = 0, emitting_ = 0, reflecting_ = 0, zero_ = 0, without_effect_ = 0;
};

}   // namespace rayclock
