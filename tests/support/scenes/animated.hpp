#pragma once
// A glTF file built piece by piece, with its animations.
#include <nlohmann/json.hpp>

#include "model/scene/placed.hpp"
#include "sim/load/mesh/mesh_file.hpp"
#include "tests/support/scenes/scene_files.hpp"

namespace rayclock::test {

using Json = nlohmann::json;

/// One octahedron, followed by numbers for each key or each vertex.
struct Animated {
    Json json = Json::parse(Octahedron().gltf(""));
    std::string bytes = Octahedron().bin();

    std::size_t accessor(const std::vector<float>& numbers, const std::string& type, std::size_t width) {
        const std::size_t begin = bytes.size();
        bytes.append(reinterpret_cast<const char*>(numbers.data()), 4 * numbers.size());
        json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", 4 * numbers.size()}});
        json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                     {"componentType", 5126},
                                     {"type", type},
                                     {"count", numbers.size() / width}});
        json["buffers"][0]["byteLength"] = bytes.size();
        return json["accessors"].size() - 1;
    }
    /// Adds an accessor of bytes, four for each element.
    std::size_t byte_accessor(const std::string& all) {
        while (bytes.size() % 4) bytes += '\0';
        json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", all.size()}});
        bytes += all;
        json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                     {"componentType", 5121},
                                     {"type", "VEC4"},
                                     {"count", all.size() / 4}});
        json["buffers"][0]["byteLength"] = bytes.size();
        return json["accessors"].size() - 1;
    }
    void channel(std::size_t node, const std::string& path, const std::vector<float>& times,
                 const std::vector<float>& values, const char* between = nullptr) {
        const std::size_t width = path == "rotation" ? 4 : path == "weights" ? 1 : 3;
        const char* const type = width == 4 ? "VEC4" : width == 1 ? "SCALAR" : "VEC3";
        Json sampler{{"input", accessor(times, "SCALAR", 1)}, {"output", accessor(values, type, width)}};
        if (between) sampler["interpolation"] = between;
        Json& animation = json["animations"][0];
        animation["samplers"].push_back(sampler);
        animation["channels"].push_back(
            {{"sampler", animation["samplers"].size() - 1}, {"target", {{"node", node}, {"path", path}}}});
    }
    PlacedScene load() const {
        const SceneFolder folder;
        const Progress silent;
        Loading loading(silent);
        return load_mesh_file(folder.write("a.glb", glb_of(json.dump(), bytes)), loading);
    }
    std::string says() const {
        try {
            load();
        } catch (const UserError& error) {
            return error.what();
        }
        return {};
    }
};

}   // namespace rayclock::test
