#include "sim/load/mesh_file.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <assimp/scene.h>

#include "sim/load/file.hpp"
#include "sim/load/importer.hpp"
#include "sim/load/place.hpp"
#include "sim/load/prepare.hpp"
#include "sim/load/surface.hpp"
#include "sim/load/text.hpp"
#include "sim/load/triangulate.hpp"

namespace rayclock {
namespace {

using Prepare = Prepared (*)(const std::filesystem::path&, std::string, const Progress&);

const std::map<std::string, Prepare>& formats() {
    static const std::map<std::string, Prepare> all{
        {"obj", prepare_obj}, {"ply", prepare_ply}, {"stl", prepare_stl}, {"glb", prepare_gltf}, {"gltf", prepare_gltf}};
    return all;
}

glm::dmat4 matrix_of(const aiMatrix4x4& m) {
    glm::dmat4 out;
    for (unsigned row = 0; row < 4; ++row)
        for (unsigned column = 0; column < 4; ++column) out[static_cast<int>(column)][static_cast<int>(row)] = m[row][column];
    return out;
}

class Converter {
public:
    Converter(std::string file, const Prepared& prepared, const aiScene& in) : at_{std::move(file)}, prepared_(prepared), in_(in) {
        for (unsigned i = 0; i < in.mNumCameras; ++i) camera_at_[in.mCameras[i]->mName.C_Str()] = in.mCameras[i];
        for (unsigned i = 0; i < in.mNumLights; ++i) light_at_[in.mLights[i]->mName.C_Str()] = in.mLights[i];
    }

    Scene convert(const Progress& progress) {
        for (unsigned i = 0; i < in_.mNumMeshes; ++i) {
            if (progress) progress("joining", i, in_.mNumMeshes);
            parts_.push_back(part(*in_.mMeshes[i]));
        }
        const auto is_smooth = [](const Scene& part) { return !part.normals.empty(); };
        if (std::any_of(parts_.begin(), parts_.end(), is_smooth)) std::for_each(parts_.begin(), parts_.end(), make_smooth);
        visit(*in_.mRootNode, glm::dmat4(1));
        if (scene_.triangles.empty()) at_.refuse("the file has no triangles: all its faces are points or lines");
        if (!lights_.empty()) scene_.lights = lights_of(lights_, bounds(scene_));
        return std::move(scene_);
    }

private:
    Corner corner(const aiMesh& mesh, unsigned index) const {
        if (index >= mesh.mNumVertices) at_.refuse("a face names vertex " + std::to_string(index) + ", which is out of range");
        const aiVector3D& p = mesh.mVertices[index];
        Corner out{{p.x, p.y, p.z}, {}};
        if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))) at_.refuse("a coordinate is not a finite number");
        if (prepared_.has_normals && mesh.HasNormals()) out.normal = {mesh.mNormals[index].x, mesh.mNormals[index].y, mesh.mNormals[index].z};
        return out;
    }

    Scene part(const aiMesh& mesh) {
        PartBuilder builder(mesh.mNumFaces, prepared_.has_normals && mesh.HasNormals());
        std::vector<Corner> corners;
        std::vector<glm::dvec3> points;
        std::vector<std::array<std::uint32_t, 3>> cut;
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            if (face.mNumIndices < 3) continue;
            corners.clear(), points.clear(), cut.clear();
            for (unsigned k = 0; k < face.mNumIndices; ++k) {
                corners.push_back(corner(mesh, face.mIndices[k]));
                points.push_back(corners.back().position);
            }
            triangulate(points, cut);
            for (const auto& [a, b, c] : cut) builder.add(corners[a], corners[b], corners[c], mesh.mMaterialIndex);
        }
        return builder.take();
    }

    /// Our number for the importer's material; only those in use get one.
    std::uint32_t material(unsigned index) {
        const auto [found, is_new] = materials_.try_emplace(index, static_cast<std::uint32_t>(scene_.materials.size()));
        const bool is_known = index < in_.mNumMaterials;
        if (is_new) scene_.materials.push_back(is_known ? material_of(*in_.mMaterials[index], prepared_) : Material{.name = "default"});
        return found->second;
    }

    void visit(const aiNode& node, const glm::dmat4& above) {
        const glm::dmat4 place = above * matrix_of(node.mTransformation);
        for (unsigned i = 0; i < node.mNumMeshes; ++i) {
            const unsigned mesh = node.mMeshes[i];
            if (mesh >= parts_.size() || parts_[mesh].triangles.empty()) continue;
            append(scene_, parts_[mesh], place, material(in_.mMeshes[mesh]->mMaterialIndex), 0);
        }
        const std::string name = node.mName.C_Str();
        if (const auto found = camera_at_.find(name); found != camera_at_.end() && !scene_.camera) scene_.camera = camera_of(*found->second, place);
        if (const auto found = light_at_.find(name); found != light_at_.end()) lights_.push_back({found->second, place});
        for (unsigned i = 0; i < node.mNumChildren; ++i) visit(*node.mChildren[i], place);
    }

    Place at_;
    const Prepared& prepared_;
    const aiScene& in_;
    Scene scene_;
    std::vector<Scene> parts_;
    std::map<unsigned, std::uint32_t> materials_;
    std::map<std::string, const aiCamera*> camera_at_;    // by the name of their node
    std::map<std::string, const aiLight*> light_at_;
    std::vector<PlacedLight> lights_;
};

} // namespace

bool is_mesh_file(const std::filesystem::path& path) { return formats().contains(extension(path)); }

Scene load_mesh_file(const std::filesystem::path& path, const Progress& progress) {
    const std::string file = path.string();
    if (progress) progress("reading", 0, 1);
    const Prepared prepared = formats().at(extension(path))(path, read_file(path), progress);
    const Imported imported = import_files(file, prepared, progress);
    Scene scene = Converter(file, prepared, *imported.scene).convert(progress);
    scene.name = path.filename().string();
    return scene;
}

} // namespace rayclock
