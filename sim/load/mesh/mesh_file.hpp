#pragma once
// Mesh files: .obj .ply .stl .off .3ds .dae .glb .gltf, and the formats that Assimp reads, each also with
// .gz.
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
#include "sim/load/part_builder.hpp"
#include "sim/load/surface.hpp"

namespace rayclock {

/// Returns true if the extension names a format that can be read.
bool is_mesh_file(const std::filesystem::path& path);

/// Loads a mesh file: triangles in the order of the file, materials in use, and camera and lights if the file
/// has them. A glTF file also yields instances and motion. `asked_by`: see read_file(). Throws UserError.
PlacedScene load_mesh_file(const std::filesystem::path& path, Loading& loading,
                           const std::string& asked_by = {});

/// The readers of the formats. Each takes the bytes of a file. `path` names the file in messages, and its
/// folder holds the files that the file names. Each throws UserError with line or place if the file is wrong,
/// and no other exception except std::bad_alloc.
Scene read_obj(const std::filesystem::path& path, std::string text, Loading& loading);
Scene read_ply(const std::filesystem::path& path, std::string bytes, Loading& loading);
Scene read_stl(const std::filesystem::path& path, std::string bytes, Loading& loading);
Scene read_off(const std::filesystem::path& path, std::string bytes, Loading& loading);
Scene read_3ds(const std::filesystem::path& path, std::string bytes, Loading& loading);
Scene read_dae(const std::filesystem::path& path, std::string bytes, Loading& loading);
/// Reads a scene with its instances expanded.
Scene read_gltf(const std::filesystem::path& path, std::string bytes, Loading& loading);
/// Reads a file by Assimp, which converts it to glTF. `unpacked` holds the content of a compressed file.
PlacedScene read_foreign(const std::filesystem::path& path, std::optional<std::string> unpacked,
                         std::uint64_t file_bytes, Loading& loading);
PlacedScene read_placed_gltf(const std::filesystem::path& path, std::string bytes, Loading& loading);

/// An OBJ file as stored, for comparing several files.
struct ObjShape {
    struct Corner {
        std::uint32_t position = 0, normal = 0;   ///< counted from 1; normal 0: none
        glm::dvec2 st = no_coordinates;
    };
    std::vector<glm::vec3> positions, normals;
    std::vector<Corner> corners;            ///< of all faces
    std::vector<std::size_t> ends;          ///< end of each face in `corners`
    std::vector<std::uint32_t> materials;   ///< of each face, an index into `known`
    std::vector<Material> known;
    std::vector<Texture> textures;   ///< of `known`
};
ObjShape read_obj_shape(const std::filesystem::path& path, std::string text, Loading& loading);

/// The picture of a material's diffuse colour: the statement `map_Kd`.
struct MtlPicture {
    std::string file;                 ///< as written, with / as the separator
    glm::dvec2 scale{1}, offset{0};   ///< of the coordinates, before t is inverted
    bool clamps = false;
    std::vector<std::string> ignored;   ///< options without an effect
};

/// One `newmtl` block of an MTL file.
struct MtlBlock {
    std::string name;
    MtlSurface surface;
    bool has_textures = false;   ///< textures other than `picture`
    std::optional<MtlPicture> picture{};
    bool has_diffuse = false;         ///< names its diffuse colour
    std::string fault;                ///< the message about the first wrong value, or empty
    std::filesystem::path folder{};   ///< of the MTL file
};
/// Reads the blocks of an MTL file. Throws UserError if it is not text.
std::vector<MtlBlock> read_mtl(const std::filesystem::path& path, std::string_view text, Loading& loading);

/// Assembles the scene of a file: cuts polygons, places parts, and numbers the materials in the order of
/// their first use.
class Assembly {
public:
    Assembly(std::string file, Loading& loading) : file_(std::move(file)), loading_(loading) {}

    /// Cuts a face of at least 3 corners into `part`. `colour` is a number from PartBuilder::colour().
    void face(PartBuilder& part, const std::vector<Corner>& corners, std::uint32_t colour = 0);
    /// Adds a finished part and returns its number. Throws UserError if it exceeds the allowance.
    std::size_t add(PartBuilder part);
    /// Adds normals to all parts if any part has some, or if `must_have`. Call it after all parts were added.
    void make_alike(bool must_have = false);
    bool is_empty(std::size_t part) const { return parts_[part].shape.triangles.empty(); }
    /// Places a copy of a part in the scene. `material` is any number by which the caller identifies a
    /// material. `make` returns the material and is called at its first use.
    void place(std::size_t part, const glm::dmat4& place, std::uint64_t material,
               const std::function<Material()>& make);
    /// Appends a part to triangles that instances share. Their materials are those of the scene.
    void gather(Scene& into, std::size_t part, std::uint64_t material, const std::function<Material()>& make);

    /// Returns the scene's number of a material, which `make` makes at its first use. `tint` multiplies the
    /// colour.
    std::uint32_t material(std::uint64_t material, const std::function<Material()>& make,
                           const glm::vec3& tint = glm::vec3(1));

    Scene& scene() { return scene_; }
    /// Returns the scene and notes what was left out. Throws UserError if the scene has no triangles, unless
    /// `may_be_empty`.
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
    std::map<std::uint64_t, Material> made_;   ///< by the caller's number
    /// Keyed by the caller's number and tint.
    std::map<std::pair<std::uint64_t, std::array<float, 3>>, std::uint32_t> materials_;
    std::uint64_t dropped_ = 0;
    std::vector<glm::dvec3> points_;
    std::vector<std::array<std::uint32_t, 3>> cut_;
};

}   // namespace rayclock
