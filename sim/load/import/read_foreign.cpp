// Files of other programs, which Assimp converts to glTF. Repairs known defects of its converter.
#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "sim/load/gltf/buffers.hpp"
#include "sim/load/import/assimp.hpp"
#include "sim/load/mesh/mesh_file.hpp"
#include "sim/load/textures.hpp"

namespace rayclock {
namespace {

using Json = nlohmann::json;

/// Replaces a texture's path on the author's machine by its file name, because the texture now lies next to
/// the mesh.
void mend_image(Json& image) {
    const auto uri = image.find("uri");
    if (uri == image.end() || !uri->is_string()) return;
    std::string name = portable_name(uri->get<std::string>());
    if (leaves_folder(name)) name = std::filesystem::path(name).filename().string();
    *uri = name;
}

/// Returns true if the material is transparent but its opacity is lost.
bool mend_material(Json& material) {
    // This extension repeats the material without its opacity.
    if (const auto given = material.find("extensions"); given != material.end() && given->is_object())
        given->erase("KHR_materials_pbrSpecularGlossiness");
    if (!material.contains("alphaMode") || material["alphaMode"] != "BLEND") return false;
    const Json pbr = material.value("pbrMetallicRoughness", Json::object());
    const Json colour = pbr.value("baseColorFactor", Json::array());
    return !pbr.contains("baseColorTexture") && (colour.size() != 4 || colour[3] == 1.0);
}

std::string word(std::size_t value) {
    std::string bytes(4, '\0');
    for (std::size_t i = 0; i < 4; ++i) bytes[i] = static_cast<char>(value >> 8 * i & 0xff);
    return bytes;
}

std::string glb_of(std::string text, std::string_view binary) {
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string chunks = word(text.size()) + "JSON" + text;
    if (!binary.empty()) (chunks += word(binary.size()) + std::string("BIN\0", 4)).append(binary);
    return "glTF" + word(2) + word(12 + chunks.size()) + chunks;
}

std::string mended(const std::filesystem::path& path, const std::string& glb, Loading& loading) {
    const GltfContainer container = open_gltf(path.string(), glb);
    Json document = Json::parse(container.text, nullptr, false);
    if (!document.is_object()) return glb;   // the glTF reader reports the error
    for (Json& image : document["images"]) mend_image(image);
    std::uint64_t opaque = 0;
    for (Json& material : document["materials"]) opaque += mend_material(material);
    if (opaque > 0)
        loading.note(path.string(), counted(opaque, "transparent material") +
                                        " drawn opaque: Assimp does not say how transparent");
    for (const char* list : {"images", "materials"})
        if (document[list].empty()) document.erase(list);
    return glb_of(document.dump(), container.binary);
}

}   // namespace

PlacedScene read_foreign(const std::filesystem::path& path, std::optional<std::string> unpacked,
                         std::uint64_t file_bytes, Loading& loading) {
    const std::string glb = assimp_glb(path, file_bytes, unpacked);
    unpacked.reset();
    return read_placed_gltf(path, mended(path, glb, loading), loading);
}

}   // namespace rayclock
