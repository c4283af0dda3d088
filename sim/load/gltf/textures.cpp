// Tinting materials by the average of their base texture.
#include "sim/load/gltf/textures.hpp"

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"

namespace rayclock {

bool GltfTextures::tint(GltfMaterial& material) {
    const JsonValue textures = list("textures"), reference = *material.base_texture;
    const JsonValue texture = textures[reference.at("index").whole(textures.size())];
    const auto source = texture.find("source");
    if (!source) {   // the picture comes from an extension
        material.has_textures = true;
        return false;
    }
    const std::uint64_t image = source->whole(list("images").size());
    const auto [found, is_new] = averages_.try_emplace(image);
    if (is_new) found->second = average(image);
    if (!found->second) return false;
    material.surface.colour *= *found->second;
    if (material.is_masked && material.surface.colour.a < 1)
        warnings_.count("material", "with holes in its texture, drawn without them", 0, material.name);
    if (!material.blends) material.surface.colour.a = 1;
    return true;
}

std::optional<glm::vec4> GltfTextures::average(std::uint64_t image) {
    std::string why;
    std::optional<glm::vec4> made;
    const JsonValue entry = in_.at("images")[image];
    try {
        made = loading_.average(buffers_.image(image), why);
    } catch (const UserError& error) {
        if (!entry.find("uri") || leaves_folder(entry.at("uri").string())) throw;
        why = error.what();
    }
    if (!made)
        loading_.note(file_,
                      fmt::format("the texture images[{}] is not drawn: {}", image, printable(why, 300)));
    return made;
}

}   // namespace rayclock
