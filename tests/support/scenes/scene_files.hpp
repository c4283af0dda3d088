#pragma once
// Small files for the tests of loading: a temporary folder, and one mesh written in every format.
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <unistd.h>

#include <glm/vec3.hpp>

#include "model/base/error.hpp"
#include "sim/load/load.hpp"

namespace rayclock::test {

class Folder {
public:
    Folder() {
        static int number = 0;
        path_ = std::filesystem::temp_directory_path() /
                ("rayclock_load_" + std::to_string(getpid()) + "_" + std::to_string(number++));
        std::filesystem::create_directories(path_);
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::string write(const std::string& name, const std::string& bytes) const {
        std::ofstream(path_ / name, std::ios::binary) << bytes;
        return (path_ / name).string();
    }
    std::string name(const std::string& name) const { return (path_ / name).string(); }
    Scene load(const std::string& name, const std::string& bytes) const {
        return load_scene(write(name, bytes));
    }

private:
    std::filesystem::path path_;
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
