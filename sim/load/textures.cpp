// Decodes pictures, and determines which primitives show them.
#include "sim/load/textures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/scene/view.hpp"
#include "sim/files/text.hpp"

namespace rayclock {
namespace {

/// Gives primitives without coordinates a material in the average colour of its texture.
class AverageMaterials {
public:
    explicit AverageMaterials(Scene& scene) : scene_(scene) {}

    /// Returns the number of the material without its texture.
    std::uint32_t of(std::uint32_t material) {
        const auto [found, is_new] =
            made_.try_emplace(material, static_cast<std::uint32_t>(scene_.materials.size()));
        if (!is_new) return found->second;
        scene_.materials.push_back(scene_.materials[material]);
        make_plain(scene_.materials.back());
        return found->second;
    }

    void make_plain(Material& material) {
        const std::uint32_t texture = *material.texture;
        const auto [average, is_new] = averages_.try_emplace(texture);
        if (is_new) average->second = average_of(scene_.textures[texture]);
        material.colour = glm::clamp(material.colour * average->second, 0.0, 1.0);
        material.texture.reset();
    }

private:
    Scene& scene_;
    std::map<std::uint32_t, std::uint32_t> made_;
    std::map<std::uint32_t, glm::dvec3> averages_;
};

std::string picture_name(const std::filesystem::path& path) {
    return "the picture " + printable(path.string());
}

/// Frees the memory too.
void drop_coordinates(PlacedScene& scene) {
    scene.own.coordinates = std::vector<CornerCoordinates>();
    for (SharedMesh& mesh : scene.meshes) mesh.coordinates = std::vector<CornerCoordinates>();
}

/// Settles the textures of one scene, mesh by mesh.
class TextureSettler {
public:
    TextureSettler(PlacedScene& scene, const std::string& where, Loading& loading)
        : scene_(scene), where_(where), loading_(loading), plain_(scene.own), warnings_(where) {}

    void settle() {
        Scene& own = scene_.own;
        if (!loading_.draws_textures()) average_all();
        settle(own, {}, true, "");
        settle_meshes();
        copy_painted_meshes();
        for (Sphere& sphere : own.spheres) settle_sphere(sphere);
        for (const Plane& plane : own.planes) settle_plane(plane);
        if (shows_any_)
            fill_gaps();
        else if (shows_round_)
            drop_coordinates(scene_);
        else
            clear();
        warnings_.say(loading_);
    }

private:
    bool has_texture(std::uint32_t material) const {
        return scene_.own.materials[material].texture.has_value();
    }
    const Texture& texture_of(std::uint32_t material) const {
        return scene_.own.textures[*scene_.own.materials[material].texture];
    }

    void average_all() {
        for (Material& material : scene_.own.materials)
            if (material.texture) plain_.make_plain(material);
    }

    void settle_meshes() {
        for (std::size_t m = 0; m < scene_.meshes.size(); ++m) {
            SharedMesh& mesh = scene_.meshes[m];
            std::vector<Instance*> instances;
            bool keeps_own = false;
            for (Instance& instance : scene_.instances)
                if (instance.mesh == m) {
                    if (instance.material) instances.push_back(&instance);
                    keeps_own = keeps_own || !instance.material;
                }
            std::vector<std::uint32_t> given;
            for (Instance* instance : instances)
                if (has_texture(*instance->material)) {
                    if (is_whole(mesh)) {
                        given.push_back(*instance->material);
                    } else {
                        warnings_.count("instance", without_coordinates);
                        instance->material = plain_.of(*instance->material);
                    }
                }
            settle(mesh, given, keeps_own, fmt::format("mesh {}, ", m));
        }
    }

    static constexpr const char* without_coordinates =
        "with a texture and without texture coordinates, drawn in the texture's average colour";

    static bool has_coordinates(const CornerCoordinates& corners) {
        return std::none_of(corners.begin(), corners.end(),
                            [](const glm::dvec2& st) { return std::isnan(st.x) || std::isnan(st.y); });
    }
    template <class Mesh> static bool is_whole(const Mesh& mesh) {
        return mesh.coordinates.size() == mesh.triangles.size() &&
               std::all_of(mesh.coordinates.begin(), mesh.coordinates.end(), has_coordinates);
    }

    /// `given`: textured materials that instances apply to all triangles. `keeps_own`: some instance shows
    /// the triangles' own materials.
    template <class Mesh> void settle(Mesh& mesh, const std::vector<std::uint32_t>& given, bool keeps_own,
                                      const std::string& name) {
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            std::uint32_t& own = mesh.triangles[i].material;
            const bool is_known = !mesh.coordinates.empty() && has_coordinates(mesh.coordinates[i]);
            if (has_texture(own) && !is_known) {
                if (keeps_own) warnings_.count("triangle", without_coordinates);
                own = plain_.of(own);
            }
            std::vector<std::uint32_t> shown = given;
            if (keeps_own && has_texture(own)) shown.push_back(own);
            if (!shown.empty()) shift(mesh.coordinates[i], shown, fmt::format("{}triangle {}", name, i));
            if (shown.empty() && !mesh.coordinates.empty()) mesh.coordinates[i] = {};
        }
    }

    /// Shifts by common periods of all textures that the triangle shows. A period of `mirror` is one of
    /// `repeat`.
    void shift(CornerCoordinates& corners, const std::vector<std::uint32_t>& shown, const std::string& name) {
        shows_any_ = true;
        Texture coarsest = texture_of(shown.front());
        for (const std::uint32_t material : shown) {
            const Texture& texture = texture_of(material);
            coarsest.wrap_s = std::max(coarsest.wrap_s, texture.wrap_s);
            coarsest.wrap_t = std::max(coarsest.wrap_t, texture.wrap_t);
        }
        if (const std::string fault = coordinate_fault(coarsest, corners); !fault.empty())
            throw UserError(fmt::format("{}: {} (counted from 0) {}", where_, name, fault));
        corners = near_zero(coarsest, corners);
    }

    /// If an instance's own material has a texture, gives the instance a copy of its mesh: with two levels,
    /// the texture records belong to meshes. Instances with the same mesh and material share the copy.
    void copy_painted_meshes() {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> copies;
        for (Instance& instance : scene_.instances) {
            if (!instance.material || !has_texture(*instance.material)) continue;
            const auto [copy, is_new] =
                copies.try_emplace({instance.mesh, *instance.material}, std::uint32_t(scene_.meshes.size()));
            if (is_new) {
                if (!loading_.may_make(bytes_of(scene_.meshes[instance.mesh])))
                    throw UserError(where_ + ": " + loading_.too_much());
                SharedMesh mesh = scene_.meshes[instance.mesh];
                for (Triangle& triangle : mesh.triangles) triangle.material = *instance.material;
                scene_.meshes.push_back(std::move(mesh));
                follow_deformation(instance.mesh, copy->second);
            }
            instance.mesh = copy->second;
            instance.material.reset();
        }
    }

    void follow_deformation(std::uint32_t mesh, std::uint32_t copy) {
        std::vector<Deforming>& deforming = scene_.motion.deforming;
        const auto found = std::ranges::find(deforming, mesh, &Deforming::mesh);
        if (found == deforming.end()) return;
        Deforming same = *found;
        same.mesh = copy;
        deforming.push_back(std::move(same));
    }

    static constexpr const char* without_holes =
        "with a cut-off, drawn without holes; only triangles have holes";

    void settle_plane(const Plane& plane) {
        if (!has_texture(plane.material)) return;
        shows_round_ = true;
        if (scene_.own.materials[plane.material].cutoff > 0) warnings_.count("plane", without_holes);
    }

    /// Gives the sphere a material with an octahedral picture. Spheres with the same material and rotation
    /// share it.
    void settle_sphere(Sphere& sphere) {
        if (!has_texture(sphere.material)) return;
        shows_round_ = true;
        if (scene_.own.materials[sphere.material].cutoff > 0) warnings_.count("sphere", without_holes);
        std::array<double, 9> turn{};
        for (int i = 0; i < 9; ++i) turn[std::size_t(i)] = sphere.turn[i / 3][i % 3];
        const auto [found, is_new] = round_.try_emplace({sphere.material, turn});
        if (is_new) {
            const Texture& flat = texture_of(sphere.material);
            const auto side = std::uint64_t(octahedral_side(flat));
            if (!loading_.may_make(2 * side * side * sizeof(TexelLevel::texels[0])))
                throw UserError(where_ + ": " + loading_.too_much());
            Texture round = octahedral_picture(flat, sphere.turn);
            Material material = scene_.own.materials[sphere.material];
            material.texture = static_cast<std::uint32_t>(scene_.own.textures.size());
            found->second = static_cast<std::uint32_t>(scene_.own.materials.size());
            scene_.own.textures.push_back(std::move(round));
            scene_.own.materials.push_back(std::move(material));
        }
        sphere.material = found->second;
    }

    /// Fills in coordinates for meshes without them, because the flat scene has one entry per triangle.
    void fill_gaps() {
        scene_.own.coordinates.resize(scene_.own.triangles.size());
        for (SharedMesh& mesh : scene_.meshes) mesh.coordinates.resize(mesh.triangles.size());
    }

    void clear() {
        for (Material& material : scene_.own.materials) material.texture.reset();
        scene_.own.textures.clear();
        drop_coordinates(scene_);
    }

    PlacedScene& scene_;
    std::string where_;
    Loading& loading_;
    AverageMaterials plain_;
    Warnings warnings_;
    bool shows_any_ = false;     // a triangle shows a texture
    bool shows_round_ = false;   // a sphere or plane shows one
    std::map<std::pair<std::uint32_t, std::array<double, 9>>, std::uint32_t> round_;   // materials of spheres
};

static_assert(Wrap::repeat < Wrap::mirror && Wrap::mirror < Wrap::clamp);

}   // namespace

std::string coordinate_fault(const Texture& texture, const CornerCoordinates& corners) {
    for (const glm::dvec2& corner : corners)
        for (const double x : {corner.x, corner.y})
            if (!(std::abs(x) <= max_given_coordinate))
                return fmt::format(
                    "has the texture coordinate {0}, which must lie within -{1:.0f} and {1:.0f}", text_of(x),
                    max_given_coordinate);
    for (const glm::dvec2& corner : near_zero(texture, corners))
        for (const double x : {corner.x, corner.y})
            if (!(std::abs(x) <= max_coordinate))
                return fmt::format(
                    "has texture coordinates that lie {} from the middle of the picture's period; the most "
                    "is {}",
                    text_of(std::abs(x)), max_coordinate);
    return {};
}

std::shared_ptr<const Pyramid> read_pyramid(const std::string& bytes, const std::string& file,
                                            const std::string& name, Loading& loading, std::string& why) {
    std::optional<TexelLevel> picture = loading.picture(bytes, why);
    if (!picture) return nullptr;
    const int width = picture->width, height = picture->height;
    const std::uint64_t texels = std::uint64_t(texture_side(width)) * std::uint64_t(texture_side(height));
    if (!loading.may_make(2 * texels * sizeof(picture->texels[0])))
        throw UserError(printable(file) + ": " + name + " " + loading.too_much());
    if (width > max_texture_side || height > max_texture_side)
        loading.note(file, fmt::format("{} has {} x {} texels, drawn with {} x {}", name, width, height,
                                       texture_side(width), texture_side(height)));
    return std::make_shared<const Pyramid>(make_pyramid(resampled(*picture)));
}

std::string portable_name(std::string name) {
    std::replace(name.begin(), name.end(), '\\', '/');
    const bool has_drive = name.size() > 1 && name[1] == ':';
    if (has_drive || name.starts_with('/')) name = std::filesystem::path(name).filename().string();
    return name;
}

std::shared_ptr<const Pyramid> PictureFiles::pyramid(const std::filesystem::path& folder,
                                                     const std::string& name) {
    const std::filesystem::path path = spelled_on_disk((folder / name).lexically_normal());
    const auto [found, is_new] = pyramids_.try_emplace(path.string());
    if (!is_new) return found->second;
    const std::optional<std::string> bytes = this->bytes(path, name);
    if (!bytes) return nullptr;
    std::string why;
    found->second = read_pyramid(*bytes, file_, picture_name(path), loading_, why);
    if (!found->second) note_unreadable(path, why);
    return found->second;
}

std::optional<glm::vec4> PictureFiles::average(const std::filesystem::path& folder, const std::string& name) {
    const std::filesystem::path path = spelled_on_disk((folder / name).lexically_normal());
    const auto [found, is_new] = averages_.try_emplace(path.string());
    if (!is_new) return found->second;
    const std::optional<std::string> bytes = this->bytes(path, name);
    if (!bytes) return std::nullopt;
    std::string why;
    found->second = loading_.average(*bytes, why);
    if (!found->second) note_unreadable(path, why);
    return found->second;
}

const PictureFiles::Listing& PictureFiles::listing(const std::filesystem::path& folder) {
    const auto [found, is_new] = listings_.try_emplace(folder.string());
    if (!is_new) return found->second;
    std::error_code error;
    std::filesystem::directory_iterator entry(folder.empty() ? "." : folder, error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        const auto [known, is_first] = found->second.try_emplace(lower(name), name);
        if (!is_first) known->second = std::min(known->second, name);
    }
    return found->second;
}

/// Returns the path if it exists, otherwise a file whose name differs only in case, otherwise the path.
std::filesystem::path PictureFiles::spelled_on_disk(const std::filesystem::path& path) {
    std::error_code error;
    if (std::filesystem::exists(path, error)) return path;
    const Listing& names = listing(path.parent_path());
    const auto found = names.find(lower(path.filename().string()));
    return found == names.end() ? path : path.parent_path() / found->second;
}

std::optional<std::string> PictureFiles::bytes(const std::filesystem::path& path, const std::string& name) {
    std::string bytes;
    try {
        bytes = loading_.read(path);
    } catch (const UserError& error) {
        loading_.note(file_, std::string("a picture is not drawn: ") + error.what());
        return std::nullopt;
    }
    if (leaves_folder(name))
        loading_.note(file_, picture_name(path) + " lies outside the folder of the " + namer_);
    return bytes;
}

void PictureFiles::note_unreadable(const std::filesystem::path& path, const std::string& why) const {
    loading_.note(file_, picture_name(path) + " is not drawn: " + printable(why, 300));
}

void settle_textures(PlacedScene& scene, const std::string& where, Loading& loading) {
    if (scene.own.textures.empty()) {
        drop_coordinates(scene);
        return;
    }
    TextureSettler(scene, where, loading).settle();
}

}   // namespace rayclock
