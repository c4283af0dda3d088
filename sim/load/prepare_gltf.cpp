// glTF 2.0: the document is checked part by part and written anew with nothing but the tree of nodes, meshes of plain
// floats and 32-bit indices in one buffer, colours, cameras and lights. Animations, skins, morph targets and textures
// are left out. Each node gets a camera or light of its own, because the importer keeps one place for each.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "sim/load/gltf_buffers.hpp"
#include "sim/load/prepare.hpp"
#include "sim/load/text.hpp"

namespace rayclock {
namespace {

constexpr int max_depth = 500;    // the importer walks the tree by recursion

/// Before anything else, because version 1 has objects where 2 has arrays.
void check_version(const JsonValue& document, const Place& at) {
    const JsonValue version = document.at("asset").at("version");
    if (!version.string().starts_with("2.")) version.expected("\"2.0\"");
    const auto required = document.find("extensionsRequired");
    constexpr std::array<std::string_view, 5> harmless{"KHR_lights_punctual", "KHR_mesh_quantization", "KHR_texture_transform",
                                                       "KHR_texture_basisu", "EXT_texture_webp"};
    for (std::size_t i = 0; required && i < required->array().size(); ++i) {
        const std::string name = (*required)[i].string();
        if (!name.starts_with("KHR_materials_") && std::find(harmless.begin(), harmless.end(), name) == harmless.end())
            at.refuse("needs the extension " + shown(name) + ", which is not supported");
    }
}

class GltfWriter {
public:
    GltfWriter(const JsonValue& document, const std::filesystem::path& path, const GltfContainer& container)
        : in_(document), at_{path.string()}, buffers_(document, path, container) {}

    Prepared write(const Progress& progress) {
        const JsonValue none(empty_, at_.file);
        const JsonValue meshes = in_.find("meshes").value_or(none).array();
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            if (progress) progress("checking", i, meshes.size());
            mesh(meshes[i]);
        }
        const JsonValue materials = in_.find("materials").value_or(none).array();
        for (std::size_t i = 0; i < materials.size(); ++i) material(materials[i], i);
        tree();
        if (triangles_ == 0) at_.refuse("the file has no triangles");
        return finish();
    }

private:
    /// Appends numbers to the one buffer as 4-byte values and describes them by a new accessor.
    template <class T> std::size_t store(const std::vector<double>& numbers, int component, const char* type, std::size_t width) {
        const std::size_t start = buffer_.size();
        for (const double x : numbers) {
            const T value = static_cast<T>(x);
            buffer_.append(reinterpret_cast<const char*>(&value), sizeof value);
        }
        views_.push_back({{"buffer", 0}, {"byteOffset", start}, {"byteLength", buffer_.size() - start}});
        accessors_.push_back({{"bufferView", views_.size() - 1}, {"componentType", component}, {"count", numbers.size() / width}, {"type", type}});
        return accessors_.size() - 1;
    }

    struct Stored {
        std::size_t accessor = 0, count = 0;
        double largest = 0;    ///< of indices
    };

    Stored vectors(const JsonValue& attribute, bool must_be_finite) {
        const std::uint64_t index = attribute.whole(count_of("accessors"));
        if (const auto known = vectors_.find(index); known != vectors_.end()) return known->second;
        std::vector<double> numbers = buffers_.read(index, 3);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            if (!(std::abs(numbers[i]) <= std::numeric_limits<float>::max())) {
                if (must_be_finite)
                    in_.at("accessors")[index].refuse(fmt::format("has {} at element {}, which is not a finite number", numbers[i], i / 3));
                numbers[i] = 0;
            }
        return vectors_[index] = {store<float>(numbers, 5126, "VEC3", 3), numbers.size() / 3};
    }

    Stored indices(const JsonValue& reference) {
        const std::uint64_t index = reference.whole(count_of("accessors"));
        if (const auto known = indices_.find(index); known != indices_.end()) return known->second;
        const JsonValue type = in_.at("accessors")[index].at("componentType");
        if (type.raw() != 5121 && type.raw() != 5123 && type.raw() != 5125) type.expected("5121, 5123 or 5125 for indices");
        const std::vector<double> numbers = buffers_.read(index, 1);
        const double largest = *std::max_element(numbers.begin(), numbers.end());
        return indices_[index] = {store<std::uint32_t>(numbers, 5125, "SCALAR", 1), numbers.size(), largest};
    }

    void mesh(const JsonValue& in) {
        Json primitives = Json::array();
        std::uint64_t triangles = 0;
        const JsonValue list = in.at("primitives").array();
        for (std::size_t i = 0; i < list.size(); ++i) {
            const std::uint64_t mode = list[i].whole_or("mode", 7, 4);
            if (mode >= 4) triangles += primitive(list[i], mode, primitives);  // the others are points and lines
        }
        mesh_triangles_.push_back(triangles);
        meshes_.push_back({{"primitives", primitives}});
    }

    std::uint64_t primitive(const JsonValue& in, std::uint64_t mode, Json& out) {
        const JsonValue attributes = in.at("attributes");
        const Stored position = vectors(attributes.at("POSITION"), true);
        Json made = {{"attributes", {{"POSITION", position.accessor}}}, {"mode", mode}};
        if (const auto normal = attributes.find("NORMAL")) {
            const Stored stored = vectors(*normal, false);
            if (stored.count != position.count) normal->refuse(fmt::format("has {} normals for {} vertices", stored.count, position.count));
            made["attributes"]["NORMAL"] = stored.accessor;
        }
        std::size_t corners = position.count;
        if (const auto reference = in.find("indices")) {
            const Stored stored = indices(*reference);
            if (stored.largest >= static_cast<double>(position.count))
                reference->refuse(fmt::format("reach vertex {}, which is out of range: there are {} (0 is the first)", stored.largest,
                                              position.count));
            made["indices"] = stored.accessor;
            corners = stored.count;
        }
        if (corners < 3 || (mode == 4 && corners % 3 != 0)) in.refuse(fmt::format("has {} corners, which do not make triangles", corners));
        if (const auto material = in.find("material")) made["material"] = material->whole(count_of("materials"));
        out.push_back(made);
        return mode == 4 ? corners / 3 : corners - 2;
    }

    void material(const JsonValue& in, std::size_t number) {
        const auto name = in.object().find("name");
        names_.push_back(name ? name->string() : fmt::format("material {}", number));
        std::array<double, 4> colour{1, 1, 1, 1};
        Json surface = {{"metallicFactor", 1.0}, {"roughnessFactor", 1.0}};
        if (const auto pbr = in.find("pbrMetallicRoughness")) {
            if (const auto factor = pbr->find("baseColorFactor")) {
                if (!factor->raw().is_array() || factor->size() != 4) factor->expected("4 numbers");
                for (std::size_t i = 0; i < 4; ++i) colour[i] = (*factor)[i].number();
            }
            surface["metallicFactor"] = pbr->number_or("metallicFactor", 1);
            surface["roughnessFactor"] = pbr->number_or("roughnessFactor", 1);
        }
        // Only blending makes a surface show what is behind it.
        const auto mode = in.find("alphaMode");
        if (!mode || mode->string() != "BLEND") colour[3] = 1;
        surface["baseColorFactor"] = colour;
        Json extensions = Json::object();
        double index = 1.5;  // the format's default
        if (const auto given = in.find("extensions")) {
            if (const auto transmission = given->find("KHR_materials_transmission"))
                extensions["KHR_materials_transmission"] = {{"transmissionFactor", transmission->number_or("transmissionFactor", 0)}};
            if (const auto refraction = given->find("KHR_materials_ior")) index = refraction->number_or("ior", index);
        }
        refraction_.push_back(index);
        materials_.push_back({{"name", fmt::format("m{}", number)}, {"pbrMetallicRoughness", surface}, {"extensions", extensions}});
    }

    void tree() {
        const std::size_t count = count_of("nodes");
        nodes_ = Json(Json::value_t::array);
        for (std::size_t i = 0; i < count; ++i) nodes_.push_back({{"name", fmt::format("n{}", i)}});
        visited_.resize(count);
        for (const std::uint64_t root : roots(count)) {
            roots_.push_back(root);
            visit(root, 0);
        }
        if (triangles_ > max_triangles) at_.refuse(fmt::format("{} placed triangles; the most is {}", triangles_, max_triangles));
    }

    /// The nodes of the default scene; without any scene, the nodes that have no parent.
    std::vector<std::uint64_t> roots(std::size_t count) {
        std::vector<std::uint64_t> found;
        if (const auto scenes = in_.find("scenes"); scenes && scenes->array().size() > 0) {
            const JsonValue scene = (*scenes)[in_.whole_or("scene", scenes->size(), 0)];
            if (const auto list = scene.find("nodes"))
                for (std::size_t i = 0; i < list->array().size(); ++i) found.push_back((*list)[i].whole(count));
            return found;
        }
        std::vector<bool> is_child(count);
        for (std::size_t i = 0; i < count; ++i)
            if (const auto children = in_.at("nodes")[i].find("children"))
                for (std::size_t k = 0; k < children->array().size(); ++k) is_child[(*children)[k].whole(count)] = true;
        for (std::size_t i = 0; i < count; ++i)
            if (!is_child[i]) found.push_back(i);
        return found;
    }

    void visit(std::uint64_t index, int depth) {
        const JsonValue in = in_.at("nodes")[index];
        if (visited_[index]) in.refuse("is met twice in the tree of nodes");
        if (depth > max_depth) in.refuse(fmt::format("lies deeper than {} nodes", max_depth));
        visited_[index] = true;
        Json& out = nodes_[index];
        transform(in, out);
        if (const auto mesh = in.find("mesh")) {
            const std::uint64_t number = mesh->whole(mesh_triangles_.size());
            if (mesh_triangles_[number] > 0) out["mesh"] = number;
            triangles_ += mesh_triangles_[number];
        }
        if (const auto camera = in.find("camera")) place_camera(in_.at("cameras")[camera->whole(count_of("cameras"))], out);
        if (const auto extensions = in.find("extensions")) {
            if (extensions->find("EXT_mesh_gpu_instancing")) in.refuse("uses EXT_mesh_gpu_instancing, which is not supported");
            if (const auto light = extensions->find("KHR_lights_punctual")) place_light(light->at("light"), out);
        }
        const auto children = in.find("children");
        if (!children || children->array().size() == 0) return;
        out["children"] = Json::array();
        for (std::size_t i = 0; i < children->size(); ++i) {
            const std::uint64_t child = (*children)[i].whole(visited_.size());
            out["children"].push_back(child);
            visit(child, depth + 1);
        }
    }

    static void transform(const JsonValue& in, Json& out) {
        constexpr std::array<std::pair<const char*, std::size_t>, 4> parts{{{"matrix", 16}, {"translation", 3}, {"rotation", 4}, {"scale", 3}}};
        for (const auto& [key, length] : parts) {
            const auto part = in.find(key);
            if (!part) continue;
            if (!part->raw().is_array() || part->size() != length) part->expected(fmt::format("{} numbers", length));
            for (std::size_t i = 0; i < length; ++i) (*part)[i].number();
            out[key] = part->raw();
        }
    }

    void place_camera(const JsonValue& camera, Json& node) {
        const auto lens = camera.find("perspective");
        if (!lens) return;  // parallel rays are not in our camera
        node["camera"] = cameras_.size();
        // Without the aspect the importer hands over the vertical angle untouched.
        cameras_.push_back({{"type", "perspective"}, {"perspective", {{"yfov", lens->at("yfov").number()}, {"znear", 0.1}}}});
    }

    void place_light(const JsonValue& reference, Json& node) {
        const JsonValue all = in_.at("extensions").at("KHR_lights_punctual").at("lights").array();
        const JsonValue light = all[reference.whole(all.size())];
        const std::string type = light.at("type").string();
        if (type != "point" && type != "spot" && type != "directional") light.at("type").expected("\"point\", \"spot\" or \"directional\"");
        const glm::dvec3 colour = light.find("color") ? light.at("color").triple() : glm::dvec3(1);
        const double intensity = light.number_or("intensity", 1);
        if (!(intensity >= 0 && colour.x >= 0 && colour.y >= 0 && colour.z >= 0)) light.refuse("must not be negative");
        node["extensions"]["KHR_lights_punctual"]["light"] = lights_.size();
        // A spot's cone is not in our lights.
        lights_.push_back({{"type", type == "spot" ? "point" : type}, {"color", {colour.x, colour.y, colour.z}}, {"intensity", intensity}});
    }

    Prepared finish() {
        Json out = {{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", roots_}}}}, {"nodes", nodes_}, {"meshes", meshes_},
                    {"accessors", accessors_}, {"bufferViews", views_}, {"materials", materials_}, {"cameras", cameras_}};
        out["buffers"] = {{{"uri", "mesh.bin"}, {"byteLength", buffer_.size()}}};
        out["extensionsUsed"] = {"KHR_lights_punctual", "KHR_materials_transmission"};
        out["extensions"]["KHR_lights_punctual"]["lights"] = lights_;
        Prepared prepared;
        prepared.main = "mesh.gltf";
        prepared.files["mesh.gltf"] = out.dump();
        prepared.files["mesh.bin"] = std::move(buffer_);
        prepared.materials = std::move(names_);
        prepared.refraction = std::move(refraction_);
        return prepared;
    }

    std::uint64_t count_of(std::string_view key) const {
        const auto list = in_.find(key);
        return list ? list->array().size() : 0;
    }

    JsonValue in_;
    Place at_;
    GltfBuffers buffers_;
    const Json empty_ = Json::array();
    std::string buffer_;
    Json accessors_ = Json::array(), views_ = Json::array(), meshes_ = Json::array(), materials_ = Json::array();
    Json nodes_ = Json::array(), cameras_ = Json::array(), lights_ = Json::array(), roots_ = Json::array();
    std::map<std::uint64_t, Stored> vectors_, indices_;
    std::vector<std::uint64_t> mesh_triangles_;
    std::vector<bool> visited_;
    std::vector<std::string> names_;
    std::vector<double> refraction_;
    std::uint64_t triangles_ = 0;
};

} // namespace

Prepared prepare_gltf(const std::filesystem::path& path, std::string bytes, const Progress& progress) {
    const std::string file = path.string();
    const GltfContainer container = open_gltf(file, bytes);
    const std::string_view text = without_mark(container.text);
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == text.npos || text[first] != '{') Place{file, 1}.refuse("this is not glTF: it begins with " + shown(text.substr(0, 8)));
    const Json parsed = parse_json(file, text);
    const JsonValue document(parsed, file);
    check_version(document, Place{file});
    return GltfWriter(document, path, container).write(progress);
}

} // namespace rayclock
