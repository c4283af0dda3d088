#pragma once
#include <cstdint>
#include <map>
#include <string>

#include "model/scene/scene.hpp"
#include "sim/load/dae_document.hpp"

namespace rayclock {

/// Materials of COLLADA by the common profile of their effects. What it leaves out is counted.
class DaeMaterials {
public:
    explicit DaeMaterials(DaeDocument& document);

    /// Of a <material>; grey if its effect says nothing of how it looks.
    Material material(const XmlElement& in);
    void say_left_out() const;

private:
    /// Parameters by their names, and the shader that uses them.
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
    bool is_inverted_ = false;   ///< its program writes 0 where the standard has 1 for an opaque material
    std::map<const XmlElement*, Effect> effects_;
    std::uint64_t odd_ = 0, textured_ = 0, emitting_ = 0, reflecting_ = 0, zero_ = 0, without_effect_ = 0;
};

}   // namespace rayclock
