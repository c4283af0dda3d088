#pragma once
// Small files of scenes: a temporary folder for them, and one mesh written in every format.
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "model/base/error.hpp"
#include "sim/load/load.hpp"
#include "tests/support/files/test_folder.hpp"

namespace rayclock::test {

/// A temporary folder for files of scenes.
class SceneFolder : public TestFolder {
public:
    /// Writes a file and loads it.
    Scene load(const std::string& name, const std::string& bytes) const {
        return load_scene(write(name, bytes));
    }
};

using Corners = std::array<glm::dvec3, 3>;

inline std::vector<Corners> corners_of(const Scene& scene) {
    std::vector<Corners> all;
    for (const Triangle& t : scene.triangles)
        all.push_back(
            {scene.vertices[t.vertex[0]], scene.vertices[t.vertex[1]], scene.vertices[t.vertex[2]]});
    return all;
}

/// Returns the message of the UserError, or an empty string if it loads.
inline std::string complaint(const std::string& spec) {
    try {
        load_scene(spec);
    } catch (const UserError& error) {
        return error.what();
    }
    return {};
}

template <class T> std::string raw(T value, bool is_big_endian = false) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return is_big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

/// An octahedron whose corners 32-bit floats represent exactly. It is off centre, so that the axes differ.
struct Octahedron {
    std::vector<glm::dvec3> vertices{{3, 0.25, 0},  {-1, 0.25, 0}, {1, 2.5, 0},
                                     {1, -1.75, 0}, {1, 0.25, 4},  {1, 0.25, -1.5}};
    std::vector<std::array<std::uint32_t, 3>> triangles{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                                        {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};

    std::vector<Corners> corners() const;
    std::string obj() const;
    std::string ply_ascii() const;
    std::string ply_binary(bool is_big_endian) const;
    std::string stl_ascii() const;
    std::string stl_binary() const;
    std::string bin() const;                          ///< positions, then 16-bit indices
    std::string gltf(const std::string& uri) const;   ///< uri of the buffer; empty inside a GLB
    std::string glb() const;
    std::string json() const;
    std::string off() const;
    std::string tds() const;   ///< 3DS, where z is up
    std::string dae(const std::string& up_axis) const;
};

/// Compresses with gzip.
std::string gz_of(const std::string& bytes);

/// Returns a chunk of 3DS.
std::string chunk(std::uint16_t id, const std::string& inside);

/// Wraps a JSON document and a buffer into a GLB.
std::string glb_of(std::string text, std::string binary);

std::string base64(const std::string& bytes);

}   // namespace rayclock::test
