// A mesh file of another program (.obj .ply .stl .off .3ds .dae .glb .gltf, and what Assimp reads; each also
// with .gz behind it) as a scene.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "model/scene/scene.hpp"
#include "sim/load/loading.hpp"
#include "sim/load/place.hpp"
#include "sim/load/surface.hpp"

namespace rayclock {

bool is_mesh_file(const std::filesystem::path& path);

/// Triangles in the order of the file, materials in use, camera and lights if the file has them; of glTF,
/// instances and motion as well. `asked_by`: see read_file(). Throws UserError.
PlacedScene load_mesh_file(const std::filesystem::path& path, Loading& loading,
                           const std::string& asked_by = {});

/// The readers of the formats, from the bytes of a file; `path` names the file in sentences, and its folder
/// holds what a file refers to. Each throws UserError for what makes no sense, with line or place, and
/// nothing else.
Scene read_obj(const std::filesystem::path& path, std::string text, Loading& loading);
Scene read_ply(const std::filesystem::path& path, std::string bytes, Loading& loading);
Scene read_stl(const std::filesystem::path& path, std::string bytes, Loading& loading);
Scene read_off(const std::filesystem::path& path, std::string bytes, Loading& loading);
Scene read_3ds(const std::filesystem::path& path, std::string bytes, Loading& loading);
Scene read_dae(const std::filesystem::path& path, std::string bytes, Loading& loading);
Scene read_gltf(const std::filesystem::path& path, std::string bytes, Loading& loading);   ///< flattened
/// By Assimp, as glTF. `unpacked` is what the file holds, if it is compressed.
PlacedScene read_foreign(const std::filesystem::path& path, std::optional<std::string> unpacked,
                         std::uint64_t file_bytes, Loading& loading);
PlacedScene read_placed_gltf(const std::filesystem::path& path, std::string bytes, Loading& loading);

/// An OBJ file as it is written, for who has to compare several of them.
struct ObjShape {
    struct Corner {
        std::uint32_t position = 0, normal = 0;   ///< counted from 1; normal 0: none
    };
    std::vector<glm::vec3> positions, normals;
    std::vector<Corner> corners;            ///< of all faces
    std::vector<std::size_t> ends;          ///< of each face, in `corners`
    std::vector<std::uint32_t> materials;   ///< of each face, in `known`
    std::vector<Material> known;
};
ObjShape read_obj_shape(const std::filesystem::path& path, std::string text, Loading& loading);

/// One `newmtl` block.
struct MtlBlock {
    std::string name;
    MtlSurface surface;
    bool has_textures = false;
    std::string fault;   ///< a sentence about the first value that makes no sense
};
std::vector<MtlBlock> read_mtl(const std::filesystem::path& path, std::string_view text, Loading& loading);

/// Gathers the parts of a file: polygons are cut, parts placed, materials numbered as they are met.
class Assembly {
public:
    Assembly(std::string file, Loading& loading) : file_(std::move(file)), loading_(loading) {}

    /// Cuts a face of at least 3 corners into `part`. `colour` is one of the part's.
    void face(PartBuilder& part, const std::vector<Corner>& corners, std::uint32_t colour = 0);
    /// The part is finished; returns its number.
    std::size_t add(PartBuilder part);
    /// When all are added: if any part has normals, or `must_have`, all get some.
    void make_alike(bool must_have = false);
    bool is_empty(std::size_t part) const { return parts_[part].shape.triangles.empty(); }
    /// A copy of a part. `material` is any number that the caller knows it by, `make` gives it when it is met
    /// first.
    void place(std::size_t part, const glm::dmat4& place, std::uint64_t material,
               const std::function<Material()>& make);
    /// The same into triangles that others will place: materials are those of the scene.
    void gather(Scene& into, std::size_t part, std::uint64_t material, const std::function<Material()>& make);

    /// The scene's number of a material, which is made when it is met first; its colour is multiplied by
    /// `tint`.
    std::uint32_t material(std::uint64_t material, const std::function<Material()>& make,
                           const glm::vec3& tint = glm::vec3(1));

    Scene& scene() { return scene_; }
    /// Says what was left out; refuses a scene without triangles, unless `may_be_empty`.
    Scene take(bool may_be_empty = false);

private:
    void put(Scene& into, std::size_t part, const glm::dmat4& place, std::uint64_t material,
             const std::function<Material()>& make);

    struct Part {
        Scene shape;
        std::vector<glm::vec3> colours;   ///< see PartBuilder::take_colours()
    };

    std::string file_;
    Loading& loading_;
    std::vector<Part> parts_;
    Scene scene_;
    std::map<std::uint64_t, Material> made_;   ///< by the caller's numbers
    std::map<std::pair<std::uint64_t, std::array<float, 3>>, std::uint32_t> materials_;   ///< tinted
    std::uint64_t dropped_ = 0;
    std::vector<glm::dvec3> points_;
    std::vector<std::array<std::uint32_t, 3>> cut_;
};

}   // namespace rayclock
