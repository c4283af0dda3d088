// The checks of version and extensions, and the search for root nodes.
#include "sim/load/gltf/document.hpp"

#include <algorithm>
#include <array>

namespace rayclock {

void check_gltf_version(const JsonValue& document, const SourcePosition& at) {
    const auto asset = document.find("asset");
    const bool has_version = asset && asset->find("version");
    if (!has_version && document.find("buffers") && document.at("buffers").raw().is_object())
        at.refuse("this is glTF 1.0, which is not supported: it must be converted to 2.0");
    const JsonValue version = document.at("asset").at("version");
    if (version.string().starts_with("1."))
        version.refuse("is \"1.0\": glTF 1.0 is not supported and must be converted to 2.0");
    if (!version.string().starts_with("2.")) version.expected("\"2.0\"");
    const auto required = document.find("extensionsRequired");
    constexpr std::array<std::string_view, 6> harmless{"KHR_lights_punctual",     "KHR_mesh_quantization",
                                                       "EXT_mesh_gpu_instancing", "KHR_texture_transform",
                                                       "KHR_texture_basisu",      "EXT_texture_webp"};
    for (std::size_t i = 0; required && i < required->array().size(); ++i) {
        const std::string name = (*required)[i].string();
        if (!name.starts_with("KHR_materials_") &&
            std::find(harmless.begin(), harmless.end(), name) == harmless.end())
            at.refuse("needs the extension " + shown(name) + ", which is not supported");
    }
}

std::vector<std::uint64_t> gltf_roots(const JsonValue& document, std::size_t count) {
    std::vector<std::uint64_t> found;
    if (const auto scenes = document.find("scenes"); scenes && scenes->array().size() > 0) {
        const JsonValue scene = (*scenes)[document.whole_or("scene", scenes->size(), 0)];
        if (const auto list = scene.find("nodes"))
            for (std::size_t i = 0; i < list->array().size(); ++i) found.push_back((*list)[i].whole(count));
        return found;
    }
    std::vector<bool> is_child(count);
    for (std::size_t i = 0; i < count; ++i)
        if (const auto children = document.at("nodes")[i].find("children"))
            for (std::size_t k = 0; k < children->array().size(); ++k)
                is_child[(*children)[k].whole(count)] = true;
    for (std::size_t i = 0; i < count; ++i)
        if (!is_child[i]) found.push_back(i);
    return found;
}

}   // namespace rayclock
