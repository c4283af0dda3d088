#pragma once
#include "sim/load/surface.hpp"
#include "sim/load/xml.hpp"

namespace rayclock {

struct DaeMaterial {
    MtlSurface surface{.diffuse = glm::vec3(0.8f)};
    bool has_textures = false;
};
/// What the common profile of an effect says; the rest is left out.
DaeMaterial dae_material(const XmlElement& effect, const std::string& file);

/// The numbers of an element's text, all finite.
std::vector<float> dae_numbers(const XmlElement& element, const std::string& file);

}   // namespace rayclock
