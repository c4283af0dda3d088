#pragma once
// Textures of loaded scenes: decodes pictures to mip levels, and completes the coordinates of all triangles
// in the last step of a load.
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "sim/load/loading.hpp"

namespace rayclock {

/// Returns the sentence that explains why a triangle cannot be drawn with a texture, or an empty string.
/// `corners`: the coordinates as in the file.
std::string coordinate_fault(const Texture& texture, const CornerCoordinates& corners);

/// Decodes a picture and makes its levels. Returns null, with the reason in `why`, if it cannot be read.
/// Resamples sides to powers of two; adds a note if the limit shrinks a side. `file` names the scene in
/// notes, `name` the picture. Throws UserError if the picture exceeds the allowance.
std::shared_ptr<const Pyramid> read_pyramid(const std::string& bytes, const std::string& file,
                                            const std::string& name, Loading& loading, std::string& why);

/// The continuation of a note about a "material" that shows the average colour of its picture.
constexpr const char* averaged_texture =
    "with a texture of its colour, drawn in the texture's average colour";

/// Returns the name of a picture with / as the separator. An absolute name becomes the name of a file next to
/// the mesh, because its folder belongs to the author's machine.
std::string portable_name(std::string name);

/// The pictures that a mesh file names. Reads each picture once. Ignores the case of file names, because
/// programs for DOS and Windows do not keep it. Meshes are often distributed without their pictures, so an
/// unreadable picture only causes a note.
class PictureFiles {
public:
    /// `file` begins the notes. `namer` is the kind of file that holds the names, for example "mesh". The
    /// caller must keep `loading` alive.
    PictureFiles(std::string file, std::string namer, Loading& loading)
        : file_(std::move(file)), namer_(std::move(namer)), loading_(loading) {}

    /// Returns the levels of the picture `name`, which is relative to `folder`, or null if it cannot be read.
    std::shared_ptr<const Pyramid> pyramid(const std::filesystem::path& folder, const std::string& name);
    /// Returns its average: linear red, green, blue, and opacity. Returns nothing if it cannot be read.
    std::optional<glm::vec4> average(const std::filesystem::path& folder, const std::string& name);

private:
    /// The files of a folder by their names in lower case. If two are equal, the first in alphabetical order.
    using Listing = std::map<std::string, std::string>;

    const Listing& listing(const std::filesystem::path& folder);
    std::filesystem::path spelled_on_disk(const std::filesystem::path& path);
    std::optional<std::string> bytes(const std::filesystem::path& path, const std::string& name);
    void note_unreadable(const std::filesystem::path& path, const std::string& why) const;

    std::string file_, namer_;
    Loading& loading_;
    std::map<std::string, std::shared_ptr<const Pyramid>> pyramids_;   ///< by path
    std::map<std::string, std::optional<glm::vec4>> averages_;         ///< by path
    std::map<std::string, Listing> listings_;                          ///< by folder
};

/// Completes the textures of a loaded scene. Shifts the coordinates of each textured triangle close to 0.
/// Triangles without coordinates get the average colour of their texture. Spheres get octahedral pictures.
/// Removes all coordinates and textures that no primitive shows, for example if the load averages textures.
/// `where` begins the notes. Throws UserError if the coordinates of a triangle span too much.
void settle_textures(PlacedScene& scene, const std::string& where, Loading& loading);

}   // namespace rayclock
