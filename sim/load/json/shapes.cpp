// Joining OBJ files into a mesh with keyed shapes.
#include "sim/load/json/shapes.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "sim/files/input.hpp"
#include "sim/files/text.hpp"
#include "sim/load/gunzip.hpp"
#include "sim/load/json/motion.hpp"
#include "sim/load/mesh/mesh_file.hpp"
#include "sim/load/mesh/triangulate.hpp"

namespace rayclock {
namespace {

/// Joins the shapes into one list of corners, each with a position and a normal in every shape.
class Joiner {
public:
    Joiner(const JsonValue& list, std::vector<double> times, Loading& loading)
        : list_(list), times_(std::move(times)), loading_(loading) {}

    void add(const JsonValue& key, const std::string& name, ObjShape shape) {
        if (!shapes_.empty()) check_alike(key, name, shape);
        shapes_.push_back(std::move(shape));
        if (shapes_.size() == 1) first_ = name;
    }

    PlacedScene join() {
        // If one corner of any shape lacks a normal, all facets are flat.
        is_smooth_ = std::all_of(shapes_.begin(), shapes_.end(), [](const ObjShape& shape) {
            return std::all_of(shape.corners.begin(), shape.corners.end(),
                               [](const ObjShape::Corner& c) { return c.normal != 0; });
        });
        const ObjShape& first = shapes_[0];
        // The joined mesh takes memory for positions and normals of each shape and for the vertex table.
        if (!loading_.may_make(first.corners.size() * shapes_.size() * (is_smooth_ ? 80 : 32)))
            list_.refuse(loading_.too_much());
        std::size_t begin = 0;
        for (std::size_t f = 0; f < first.ends.size(); begin = first.ends[f++]) face(f, begin);
        return made();
    }

private:
    void check_alike(const JsonValue& key, const std::string& name, const ObjShape& shape) const {
        const ObjShape& first = shapes_[0];
        const auto differ = [&](std::size_t own, std::size_t there, const char* what) {
            if (own != there)
                key.refuse(
                    fmt::format("names {}, which has {} {}, and {} has {}; shapes of one mesh may "
                                "differ only in the positions of their vertices",
                                shown(name), own, what, shown(first_), there));
        };
        differ(shape.positions.size(), first.positions.size(), "vertices");
        differ(shape.ends.size(), first.ends.size(), "faces");
        std::size_t begin = 0;
        for (std::size_t f = 0; f < first.ends.size(); begin = first.ends[f++]) {
            bool is_same = shape.ends[f] == first.ends[f];
            for (std::size_t k = begin; is_same && k < first.ends[f]; ++k)
                is_same = shape.corners[k].position == first.corners[k].position;
            if (!is_same)
                key.refuse(fmt::format("names {}, whose face {} has other vertices than that of {}",
                                       shown(name), f + 1, shown(first_)));
        }
    }

    /// Cuts a face into triangles. All shapes use the triangulation of the first shape.
    void face(std::size_t f, std::size_t begin) {
        const ObjShape& first = shapes_[0];
        points_.clear(), cut_.clear();
        for (std::size_t k = begin; k < first.ends[f]; ++k)
            points_.emplace_back(first.positions[first.corners[k].position - 1]);
        if (points_.size() == 3)
            cut_.push_back({0, 1, 2});
        else
            triangulate(points_, cut_);
        for (const auto& cut : cut_) {
            Triangle triangle{.vertex = {}, .material = first.materials[f]};
            for (std::size_t i = 0; i < 3; ++i) triangle.vertex[i] = vertex(begin + cut[i]);
            triangles_.push_back(triangle);
            coordinates_.push_back({first.corners[begin + cut[0]].st, first.corners[begin + cut[1]].st,
                                    first.corners[begin + cut[2]].st});
        }
    }

    /// Returns the vertex of a corner. Corners share a vertex if they have the same position and the same
    /// normals in all shapes.
    std::uint32_t vertex(std::size_t corner) {
        std::vector<std::uint32_t> key{shapes_[0].corners[corner].position};
        for (std::size_t s = 0; is_smooth_ && s < shapes_.size(); ++s)
            key.push_back(shapes_[s].corners[corner].normal);
        const auto [found, is_new] =
            vertices_.try_emplace(std::move(key), static_cast<std::uint32_t>(corners_.size()));
        if (is_new) corners_.push_back(corner);
        return found->second;
    }

    PlacedScene made() {
        std::vector<std::vector<glm::dvec3>> places, normals;
        for (const ObjShape& shape : shapes_) {
            places.emplace_back();
            for (const std::size_t c : corners_)
                places.back().emplace_back(shape.positions[shape.corners[c].position - 1]);
            if (!is_smooth_) continue;
            normals.emplace_back();
            for (const std::size_t c : corners_)
                normals.back().push_back(
                    unit_or_zero(glm::dvec3(shape.normals[shape.corners[c].normal - 1])));
        }
        PlacedScene scene;
        scene.own.materials = shapes_[0].known, scene.own.textures = shapes_[0].textures;
        scene.meshes.push_back({list_.path(), places[0], is_smooth_ ? normals[0] : std::vector<glm::dvec3>{},
                                std::move(triangles_), std::move(coordinates_)});
        scene.instances.push_back({list_.path(), 0, glm::dmat4(1), {}});
        Deforming deforming;
        deforming.name = list_.where();
        deforming.rest.assign(corners_.size(), glm::dvec3(0));
        if (is_smooth_) deforming.normals.assign(corners_.size(), glm::dvec3(0));
        deforming.targets = keyed_shapes(times_, std::move(places), std::move(normals));
        scene.motion.deforming.push_back(std::move(deforming));
        return scene;
    }

    JsonValue list_;
    std::vector<double> times_;
    Loading& loading_;
    std::string first_;
    std::vector<ObjShape> shapes_;
    bool is_smooth_ = false;
    std::map<std::vector<std::uint32_t>, std::uint32_t> vertices_;
    std::vector<std::size_t> corners_;   // corners of the files, by vertex
    std::vector<Triangle> triangles_;
    std::vector<CornerCoordinates> coordinates_;   // of the first shape
    std::vector<glm::dvec3> points_;
    std::vector<std::array<std::uint32_t, 3>> cut_;
};

}   // namespace

PlacedScene shapes_of(const JsonValue& list, const std::filesystem::path& folder, Loading& loading) {
    Joiner joiner(list, key_times_of(list), loading);
    for (std::size_t i = 0; i < list.size(); ++i) {
        list[i].only_keys({"time", "file"});
        const JsonValue file = list[i].at("file");
        const std::string name = file.string();
        const std::filesystem::path path = folder / name;
        if (mesh_extension(path) != "obj") file.expected("an .obj file (with .gz or without)");
        loading.report_progress("reading shapes", i, list.size());
        std::string text = loading.read(path, file.where());
        if (extension(path) == "gz") text = gunzip(path, text, loading);
        joiner.add(file, name, read_obj_shape(path, std::move(text), loading));
    }
    return joiner.join();
}

}   // namespace rayclock
