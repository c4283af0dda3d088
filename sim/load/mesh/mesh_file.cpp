// The table of mesh formats, and the assembly of a scene from parts.
#include "sim/load/mesh/mesh_file.hpp"

#include <algorithm>

#include <glm/common.hpp>

#include "sim/files/input.hpp"
#include "sim/files/text.hpp"
#include "sim/load/gunzip.hpp"
#include "sim/load/import/assimp.hpp"
#include "sim/load/mesh/triangulate.hpp"

namespace rayclock {
namespace {

using Read = Scene (*)(const std::filesystem::path&, std::string, Loading&);

const std::map<std::string, Read>& formats() {
    static const std::map<std::string, Read> all{{"obj", read_obj}, {"ply", read_ply}, {"stl", read_stl},
                                                 {"off", read_off}, {"3ds", read_3ds}, {"dae", read_dae},
                                                 {"glb", nullptr},  {"gltf", nullptr}};
    return all;
}

}   // namespace

bool is_mesh_file(const std::filesystem::path& path) {
    const std::string kind = mesh_extension(path);
    return formats().contains(kind) || assimp_reads(kind);
}

PlacedScene load_mesh_file(const std::filesystem::path& path, Loading& loading, const std::string& asked_by) {
    loading.report_progress("reading", 0, 1);
    std::string bytes = loading.read(path, asked_by);
    const bool is_packed = extension(path) == "gz";
    if (is_packed) bytes = gunzip(path, bytes, loading);
    PlacedScene scene;
    if (const auto own = formats().find(mesh_extension(path)); own == formats().end())
        scene = read_foreign(path, is_packed ? std::optional(bytes) : std::nullopt, bytes.size(), loading);
    else
        scene = own->second ? PlacedScene{own->second(path, std::move(bytes), loading), {}, {}}
                            : read_placed_gltf(path, std::move(bytes), loading);
    scene.own.name = printable(path.filename().string(), 80);
    return scene;
}

void Assembly::face(PartBuilder& part, const std::vector<Corner>& corners, std::uint32_t colour) {
    if (corners.size() == 3) return part.add(corners[0], corners[1], corners[2], colour);
    points_.clear(), cut_.clear();
    for (const Corner& corner : corners) points_.push_back(corner.position);
    triangulate(points_, cut_);
    for (const auto& [a, b, c] : cut_) part.add(corners[a], corners[b], corners[c], colour);
}

std::size_t Assembly::add(PartBuilder part) {
    dropped_ += part.dropped();
    parts_.push_back({part.take(), part.take_colours()});
    if (!loading_.may_make(parts_.back().shape)) SourcePosition{file_}.refuse(loading_.too_much());
    return parts_.size() - 1;
}

void Assembly::make_alike(bool must_have) {
    const auto is_smooth = [](const Part& part) { return !part.shape.normals.empty(); };
    if (must_have || std::any_of(parts_.begin(), parts_.end(), is_smooth))
        for (Part& part : parts_) make_smooth(part.shape);
}

void Assembly::place(std::size_t number, const glm::dmat4& place, std::uint64_t material,
                     const std::function<Material()>& make) {
    put(scene_, number, place, material, make);
}

void Assembly::gather(Scene& into, std::size_t number, std::uint64_t material,
                      const std::function<Material()>& make) {
    put(into, number, glm::dmat4(1), material, make);
}

void Assembly::put(Scene& into, std::size_t number, const glm::dmat4& place, std::uint64_t material,
                   const std::function<Material()>& make) {
    const Part& part = parts_[number];
    if (part.shape.triangles.empty()) return;
    if (!loading_.may_make(part.shape)) SourcePosition{file_}.refuse(loading_.too_much());
    if (part.colours.empty()) return append_part(into, part.shape, place, this->material(material, make), 0);
    Scene coloured = part.shape;
    for (Triangle& t : coloured.triangles)
        t.material =
            this->material(material, make, t.material == 0 ? glm::vec3(1) : part.colours[t.material - 1]);
    append_part(into, coloured, place, std::nullopt, 0);
}

std::uint32_t Assembly::material(std::uint64_t material, const std::function<Material()>& make,
                                 const glm::vec3& tint) {
    const auto [found, is_new] = materials_.try_emplace({material, {tint.r, tint.g, tint.b}},
                                                        static_cast<std::uint32_t>(scene_.materials.size()));
    if (!is_new) return found->second;
    auto base = made_.find(material);
    if (base == made_.end()) base = made_.emplace(material, make()).first;
    if (!loading_.may_make(sizeof(Material))) SourcePosition{file_}.refuse(loading_.too_much());
    scene_.materials.push_back(base->second);
    glm::dvec3& colour = scene_.materials.back().colour;
    colour = glm::clamp(colour * glm::dvec3(tint), 0.0, 1.0);
    return found->second;
}

Scene Assembly::take(bool may_be_empty) {
    if (scene_.triangles.empty() && !may_be_empty)
        SourcePosition{file_}.refuse("the file has no triangles: all its faces are points or lines");
    if (dropped_ > 0)
        loading_.note(file_, counted(dropped_, "triangle") + " with two corners in one place left out");
    return std::move(scene_);
}

}   // namespace rayclock
