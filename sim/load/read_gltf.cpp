// glTF 2.0: the document is checked part by part; the tree of nodes, meshes, colours, cameras and lights are
// taken, and the first animation. A mesh that stands in several places, or moves, becomes instances. A
// texture of the base colour is drawn as its mean. Other textures and vertex colours are left out. Both is
// said.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "sim/files/text.hpp"
#include "sim/load/gltf_buffers.hpp"
#include "sim/load/gltf_deform.hpp"
#include "sim/load/gltf_document.hpp"
#include "sim/load/gltf_material.hpp"
#include "sim/load/gltf_motion.hpp"
#include "sim/load/gltf_textures.hpp"
#include "sim/load/json_motion.hpp"
#include "sim/load/mesh_file.hpp"

namespace rayclock {
namespace {

constexpr int max_depth = 500;   // the tree is walked by recursion

class GltfReader {
public:
    GltfReader(const JsonValue& document, const std::filesystem::path& path, const GltfContainer& container,
               Loading& loading)
        : in_(document),
          at_{path.string()},
          loading_(loading),
          buffers_(document, path, container, loading),
          deformer_(in_, buffers_, loading, [this](std::uint64_t node) { return wheres_[node]; }),
          textures_(in_, buffers_, loading, at_.file),
          assembly_(at_.file, loading) {}

    PlacedScene read() {
        const JsonValue meshes = list("meshes"), materials = list("materials");
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            loading_.tell("checking", i, meshes.size());
            mesh(meshes[i]);
        }
        if (!loading_.may_make(materials.size() * sizeof(GltfMaterial))) at_.refuse(loading_.too_much());
        for (std::size_t i = 0; i < materials.size(); ++i)
            materials_.push_back(gltf_material(materials[i], i));
        tracks_ = gltf_tracks(in_, buffers_, loading_, at_.file);
        tree();
        if (triangles_ == 0) at_.refuse("the file has no triangles");
        for (const Copy& copy : copies_)
            if (!copy.deforms && parts_[copy.mesh].empty()) build(copy.mesh);
        assembly_.make_alike(has_normals_);
        std::vector<std::uint64_t> times(parts_.size());
        for (const Copy& copy : copies_) ++times[copy.mesh];
        for (const Copy& copy : copies_)
            if (copy.deforms)
                deform(copy);
            else if (copy.where.node || times[copy.mesh] > 1)
                share(copy);
            else
                place(copy);
        dropped_.say(loading_, at_.file);
        placed_.own = assembly_.take(!placed_.instances.empty());
        placed_.own.camera = camera_;
        pose(placed_, 0);
        if (!lights_.empty()) placed_.own.lights = lights_of(lights_, bounds(flat_copy(placed_)));
        pose(placed_, 0);
        return std::move(placed_);
    }

private:
    static constexpr std::uint64_t none = std::numeric_limits<std::uint64_t>::max();

    /// Triangles of a mesh with one material. `indices` may be missing.
    struct Primitive {
        const std::vector<glm::vec3>* positions;
        const std::vector<glm::vec3>* normals;
        const std::vector<std::uint32_t>* indices;
        std::uint64_t mode, material, corners;
    };
    struct Copy {
        std::uint64_t mesh, from;   ///< from: the document's node
        Where where;
        bool deforms;
    };

    const std::vector<glm::vec3>& vectors(const JsonValue& attribute, bool must_be_finite) {
        const std::uint64_t index = attribute.whole(count_of("accessors"));
        const auto [found, is_new] = vectors_.try_emplace(index);
        if (!is_new) return found->second;
        const std::vector<double> numbers = buffers_.read(index, 3);
        found->second.resize(numbers.size() / 3);
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const bool fits = std::abs(numbers[i]) <= std::numeric_limits<float>::max();
            if (!fits && must_be_finite)
                in_.at("accessors")[index].refuse(
                    fmt::format("has {} at element {}, which is not a finite number", numbers[i], i / 3));
            found->second[i / 3][static_cast<int>(i % 3)] = fits ? static_cast<float>(numbers[i]) : 0.0f;
        }
        return found->second;
    }

    const std::vector<std::uint32_t>& indices(const JsonValue& reference) {
        const std::uint64_t index = reference.whole(count_of("accessors"));
        const auto [found, is_new] = indices_.try_emplace(index);
        if (!is_new) return found->second;
        const JsonValue type = in_.at("accessors")[index].at("componentType");
        if (type.raw() != 5121 && type.raw() != 5123 && type.raw() != 5125)
            type.expected("5121, 5123 or 5125 for indices");
        for (const double x : buffers_.read(index, 1)) found->second.push_back(static_cast<std::uint32_t>(x));
        return found->second;
    }

    void mesh(const JsonValue& in) {
        std::vector<Primitive> primitives;
        std::uint64_t triangles = 0;
        const JsonValue list = in.at("primitives").array();
        for (std::size_t i = 0; i < list.size(); ++i) {
            const std::uint64_t mode = list[i].whole_or("mode", 7, 4);
            if (mode < 4) {   // points and lines
                ++dropped_.lines;
                continue;
            }
            primitives.push_back(primitive(list[i], mode));
            triangles += mode == 4 ? primitives.back().corners / 3 : primitives.back().corners - 2;
        }
        mesh_triangles_.push_back(triangles);
        meshes_.push_back(std::move(primitives));
        parts_.emplace_back();
    }

    Primitive primitive(const JsonValue& in, std::uint64_t mode) {
        const JsonValue attributes = in.at("attributes");
        Primitive made{&vectors(attributes.at("POSITION"), true), nullptr, nullptr, mode, none, 0};
        const std::size_t vertices = made.positions->size();
        if (const auto normal = attributes.find("NORMAL")) {
            made.normals = &vectors(*normal, false);
            if (made.normals->size() != vertices)
                normal->refuse(fmt::format("has {} normals for {} vertices", made.normals->size(), vertices));
            has_normals_ = true;
        }
        made.corners = vertices;
        if (const auto reference = in.find("indices")) {
            made.indices = &indices(*reference);
            const auto [largest, is_new] = largest_.try_emplace(made.indices);
            if (is_new) largest->second = *std::max_element(made.indices->begin(), made.indices->end());
            if (largest->second >= vertices)
                reference->refuse(
                    fmt::format("reach vertex {}, which is out of range: there are {} (0 is the first)",
                                largest->second, vertices));
            made.corners = made.indices->size();
        }
        if (made.corners < 3 || (mode == 4 && made.corners % 3 != 0))
            in.refuse(fmt::format("has {} corners, which do not make triangles", made.corners));
        if (const auto material = in.find("material")) made.material = material->whole(count_of("materials"));
        dropped_.colours += attributes.find("COLOR_0").has_value();
        return made;
    }

    void tree() {
        const std::size_t count = count_of("nodes");
        visited_.resize(count), wheres_.resize(count);
        for (const std::uint64_t root : gltf_roots(in_, count)) visit(root, 0, {});
        if (triangles_ > max_triangles)
            at_.refuse(fmt::format("{} placed triangles; the most is {}", triangles_, max_triangles));
    }

    /// Where a node stands whose parent stands there.
    Where where_of(const JsonValue& in, std::uint64_t index, const Where& above) {
        const glm::dmat4 own = gltf_transform(in);
        const auto tracks = tracks_.find(index);
        if (tracks == tracks_.end() || !tracks->second.move_node()) return {above.place * own, above.node};
        std::vector<MotionNode>& nodes = placed_.motion.nodes;
        MotionNode node = gltf_node(in, own, &tracks->second);
        node.parent = anchor(above, placed_.motion);
        nodes.push_back(std::move(node));
        return {glm::dmat4(1), static_cast<std::uint32_t>(nodes.size() - 1)};
    }

    const GltfTracks* tracks_of(std::uint64_t node) const {
        const auto found = tracks_.find(node);
        return found == tracks_.end() ? nullptr : &found->second;
    }

    void visit(std::uint64_t index, int depth, const Where& above) {
        const JsonValue in = in_.at("nodes")[index];
        if (visited_[index]) in.refuse("is met twice in the tree of nodes");
        if (depth > max_depth) in.refuse(fmt::format("lies deeper than {} nodes", max_depth));
        visited_[index] = true;
        const Where where = where_of(in, index, above);
        wheres_[index] = where;
        const glm::dmat4& place = where.place;
        if (const auto mesh = in.find("mesh")) {
            const std::uint64_t number = mesh->whole(mesh_triangles_.size());
            if (mesh_triangles_[number] > 0)
                copies_.push_back({number, index, where,
                                   GltfDeformer::deforms(in, in_.at("meshes")[number], tracks_of(index))});
            triangles_ += mesh_triangles_[number];
        }
        if (const auto camera = in.find("camera")) {
            const auto made = gltf_camera(in_.at("cameras")[camera->whole(count_of("cameras"))], place);
            if (!camera_ && made && where.node) {
                placed_.motion.camera.node = where.node;
                placed_.motion.camera.seen = *made;
            }
            if (!camera_) camera_ = made;
        }
        if (const auto extensions = in.find("extensions")) {
            if (extensions->find("EXT_mesh_gpu_instancing"))
                in.refuse("uses EXT_mesh_gpu_instancing, which is not supported");
            if (const auto light = extensions->find("KHR_lights_punctual")) {
                const JsonValue all = in_.at("extensions").at("KHR_lights_punctual").at("lights").array();
                lights_.push_back(gltf_light(all[light->at("light").whole(all.size())], place));
                if (where.node && !lights_.back().is_directional) {
                    LightMotion moving{.light = static_cast<std::uint32_t>(lights_.size() - 1)};
                    moving.node = where.node;
                    moving.point = glm::dvec3(place[3]);
                    placed_.motion.lights.push_back(moving);
                }
            }
        }
        const auto children = in.find("children");
        if (!children) return;
        for (std::size_t i = 0; i < children->array().size(); ++i)
            visit((*children)[i].whole(visited_.size()), depth + 1, where);
    }

    /// By the numbers of its vertices.
    template <class Use> static void each_triangle(const Primitive& primitive, const Use& use) {
        const auto vertex = [&](std::uint64_t k) {
            return primitive.indices ? (*primitive.indices)[k] : static_cast<std::uint32_t>(k);
        };
        if (primitive.mode == 4)
            for (std::uint64_t k = 0; k < primitive.corners; k += 3)
                use(vertex(k), vertex(k + 1), vertex(k + 2));
        else if (primitive.mode == 5)   // a strip: every second triangle is turned over
            for (std::uint64_t k = 0; k + 2 < primitive.corners; ++k)
                use(vertex(k + k % 2), vertex(k + 1 - k % 2), vertex(k + 2));
        else   // a fan
            for (std::uint64_t k = 0; k + 2 < primitive.corners; ++k)
                use(vertex(0), vertex(k + 1), vertex(k + 2));
    }

    /// Makes the parts of a mesh, when it is placed first.
    void build(std::uint64_t mesh) {
        for (const Primitive& primitive : meshes_[mesh]) {
            if (!loading_.may_make(primitive.corners * sizeof(std::uint64_t)))
                at_.refuse(loading_.too_much());
            PartBuilder builder(primitive.mode == 4 ? primitive.corners / 3 : primitive.corners - 2,
                                primitive.normals != nullptr);
            const auto corner = [&](std::uint32_t i) {
                return Corner{glm::dvec3((*primitive.positions)[i]),
                              primitive.normals ? glm::dvec3((*primitive.normals)[i]) : glm::dvec3(0)};
            };
            each_triangle(primitive, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
                builder.add(corner(a), corner(b), corner(c), 0);
            });
            parts_[mesh].push_back(assembly_.add(std::move(builder)));
        }
    }

    void place(const Copy& copy) {
        for (std::size_t i = 0; i < parts_[copy.mesh].size(); ++i) {
            const std::uint64_t number = meshes_[copy.mesh][i].material;
            assembly_.place(parts_[copy.mesh][i], copy.where.place, number, [&] { return material(number); });
        }
    }

    /// An instance of the mesh, which is made when it is needed first.
    void share(const Copy& copy) {
        const auto [found, is_new] =
            shared_.try_emplace(copy.mesh, static_cast<std::uint32_t>(placed_.meshes.size()));
        if (is_new) {
            Scene mesh;
            for (std::size_t i = 0; i < parts_[copy.mesh].size(); ++i) {
                const std::uint64_t number = meshes_[copy.mesh][i].material;
                assembly_.gather(mesh, parts_[copy.mesh][i], number, [&] { return material(number); });
            }
            placed_.meshes.push_back({fmt::format("meshes[{}]", copy.mesh), std::move(mesh.vertices),
                                      std::move(mesh.normals), std::move(mesh.triangles)});
        }
        add_instance(copy.from, found->second, copy.where);
    }

    /// A mesh of its own, all of whose triangles stay, because they may get an area later. Joints say where a
    /// skin is, and not the node that has it. Primitives without normals are facets where others have some.
    void deform(const Copy& copy) {
        const JsonValue node = in_.at("nodes")[copy.from];
        const std::vector<Primitive>& primitives = meshes_[copy.mesh];
        const bool is_smooth = std::any_of(primitives.begin(), primitives.end(),
                                           [](const Primitive& primitive) { return primitive.normals; });
        Deforming made = deformer_.make(node, in_.at("meshes")[copy.mesh], tracks_of(copy.from), is_smooth);
        SharedMesh mesh{fmt::format("meshes[{}]", copy.mesh), made.rest, made.normals, {}};
        if (!loading_.may_make(mesh_triangles_[copy.mesh] * sizeof(Triangle)))
            at_.refuse(loading_.too_much());
        std::uint32_t base = 0;
        std::vector<std::uint32_t> facets;
        for (const Primitive& primitive : primitives) {
            const std::uint32_t own =
                assembly_.material(primitive.material, [&] { return material(primitive.material); });
            each_triangle(primitive, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
                if (!primitive.normals) facets.push_back(static_cast<std::uint32_t>(mesh.triangles.size()));
                mesh.triangles.push_back({{base + a, base + b, base + c}, own});
            });
            base += static_cast<std::uint32_t>(primitive.positions->size());
        }
        if (has_normals_ && !facets.empty()) make_faceted(facets, made, mesh);
        made.mesh = static_cast<std::uint32_t>(placed_.meshes.size());
        static const Where in_the_scene{};
        const Where& where = made.joints.empty() ? copy.where : in_the_scene;
        if (made.is_still())
            rayclock::deform(made, 0, {}, mesh);
        else
            placed_.motion.deforming.push_back(std::move(made));
        placed_.meshes.push_back(std::move(mesh));
        add_instance(copy.from, static_cast<std::uint32_t>(placed_.meshes.size() - 1), where);
    }

    void add_instance(std::uint64_t node, std::uint32_t mesh, const Where& where) {
        if (where.node)
            placed_.motion.hung.push_back(
                {static_cast<std::uint32_t>(placed_.instances.size()), *where.node, where.place});
        placed_.instances.push_back({fmt::format("nodes[{}]", node), mesh, where.place, {}});
    }

    Material material(std::uint64_t number) {
        if (number == none) return Material{.name = "default"};
        GltfMaterial material = materials_[number];
        if (material.base_texture) dropped_.averaged += textures_.tint(material);
        dropped_.textures += material.has_textures;
        dropped_.odd += is_out_of_range(material.surface);
        return material_of(material.surface, material.name);
    }

    JsonValue list(std::string_view key) const {
        return in_.find(key).value_or(JsonValue(empty_, at_.file)).array();
    }
    std::uint64_t count_of(std::string_view key) const { return list(key).size(); }

    JsonValue in_;
    Place at_;
    Loading& loading_;
    GltfBuffers buffers_;
    GltfDeformer deformer_;
    GltfTextures textures_;
    Assembly assembly_;
    const Json empty_ = Json::array();
    std::map<std::uint64_t, std::vector<glm::vec3>> vectors_;   // by accessor
    std::map<std::uint64_t, std::vector<std::uint32_t>> indices_;
    std::map<const void*, std::uint32_t> largest_;   // of indices
    std::vector<std::vector<Primitive>> meshes_;
    std::vector<std::vector<std::size_t>> parts_;   // of meshes that are placed
    std::vector<std::uint64_t> mesh_triangles_;
    std::vector<GltfMaterial> materials_;
    std::vector<bool> visited_;
    std::vector<std::optional<Where>> wheres_;        // of nodes that stand in the scene
    std::map<std::uint64_t, GltfTracks> tracks_;      // by node
    std::map<std::uint64_t, std::uint32_t> shared_;   // meshes as meshes of ours
    PlacedScene placed_;
    std::vector<Copy> copies_;
    std::vector<PlacedLight> lights_;
    std::optional<Camera> camera_;
    bool has_normals_ = false;
    std::uint64_t triangles_ = 0;
    GltfDropped dropped_;
};

}   // namespace

Scene read_gltf(const std::filesystem::path& path, std::string bytes, Loading& loading) {
    return flattened(read_placed_gltf(path, std::move(bytes), loading));
}

PlacedScene read_placed_gltf(const std::filesystem::path& path, std::string bytes, Loading& loading) {
    const std::string file = path.string();
    const GltfContainer container = open_gltf(file, bytes);
    const std::string_view text = without_mark(container.text);
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == text.npos || text[first] != '{')
        Place{file, 1}.refuse("this is not glTF: it begins with " + shown(text.substr(0, 8)));
    const Json parsed = parse_json(file, text);
    const JsonValue document(parsed, file);
    check_gltf_version(document, Place{file});
    return GltfReader(document, path, container, loading).read();
}

}   // namespace rayclock
