// glTF 2.0. Checks and reads the tree of nodes, meshes, colours, cameras, lights and the first animation. A
// mesh that stands in several places or moves becomes instances. Reads base-colour textures, or replaces them
// by their averages. Replaces the colours of a triangle's corners by their mean. Ignores other textures. Adds
// a note for each of these changes.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "model/base/error.hpp"
#include "sim/files/text.hpp"
#include "sim/load/gltf/buffers.hpp"
#include "sim/load/gltf/deform.hpp"
#include "sim/load/gltf/document.hpp"
#include "sim/load/gltf/material.hpp"
#include "sim/load/gltf/motion.hpp"
#include "sim/load/gltf/textures.hpp"
#include "sim/load/json/motion.hpp"
#include "sim/load/mesh/mesh_file.hpp"
#include "sim/load/textures.hpp"

namespace rayclock {
namespace {

constexpr int max_node_depth = 500;   // visit() is recursive

class GltfReader {
public:
    GltfReader(const JsonValue& document, const std::filesystem::path& path, const GltfContainer& container,
               Loading& loading)
        : in_(document),
          at_{path.string()},
          loading_(loading),
          warnings_(at_.file),
          buffers_(document, path, container, loading, warnings_),
          deformer_(in_, buffers_, loading, warnings_, [this](std::uint64_t node) { return wheres_[node]; }),
          textures_(in_, buffers_, loading, warnings_, at_.file),
          assembly_(at_.file, loading) {}

    PlacedScene read() {
        const std::size_t meshes = count_of("meshes");
        if (!loading_.may_make(meshes * sizeof(Mesh) + count_of("materials") * sizeof(GltfMaterial)))
            at_.refuse(loading_.too_much());
        meshes_.resize(meshes), parts_.resize(meshes), materials_.resize(count_of("materials"));
        tracks_ = gltf_tracks(in_, buffers_, loading_, at_.file);
        tree();
        if (triangles_ == 0) return nothing_visible();
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
        placed_.own = assembly_.take(!placed_.instances.empty());
        placed_.own.textures = textures_.all();
        warnings_.say(loading_);
        placed_.own.camera = camera_;
        pose(placed_, 0);
        if (!lights_.empty()) placed_.own.lights = lights_of(lights_, bounds(flat_copy(placed_)));
        pose(placed_, 0);
        return std::move(placed_);
    }

private:
    static constexpr std::uint64_t none = std::numeric_limits<std::uint64_t>::max();
    /// Memory of the scene, the reference's hierarchy and the memory image together: 9 million triangles took
    /// 2.7 GB.
    static constexpr std::uint64_t bytes_of_a_placed_triangle = 300;

    /// The vectors of an accessor, with 0 for numbers that are not finite.
    struct Vectors {
        std::vector<glm::vec3> values;
        std::vector<std::uint32_t> faults;   ///< elements with such a number
    };
    using Colours = std::vector<std::optional<glm::vec3>>;
    /// The triangles of a mesh with one material. `indices` may be null.
    struct Primitive {
        const std::vector<glm::vec3>* positions;
        const std::vector<glm::vec3>* normals;
        const std::vector<std::uint32_t>* indices;
        const Colours* colours;
        std::uint64_t mode, material, corners;
        const std::vector<glm::dvec2>* coordinates = nullptr;
    };
    /// The drawn primitives of a mesh. mesh() reads them at the first use.
    struct Mesh {
        std::vector<Primitive> primitives;
        std::uint64_t triangles = 0;
        bool is_read = false;
        std::optional<Bounds> invisible;   ///< of primitives that are not drawn
    };
    struct Copy {
        std::uint64_t mesh, from;   ///< from: the document's node
        NodePlace where;
        bool deforms;
    };

    const Vectors& vectors(const JsonValue& attribute) {
        const std::uint64_t index = attribute.whole(count_of("accessors"));
        const auto [found, is_new] = vectors_.try_emplace(index);
        if (!is_new) return found->second;
        const std::vector<double> numbers = buffers_.read(index, 3);
        Vectors& made = found->second;
        made.values.resize(numbers.size() / 3);
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const bool fits = std::abs(numbers[i]) <= std::numeric_limits<float>::max();
            made.values[i / 3][static_cast<int>(i % 3)] = fits ? static_cast<float>(numbers[i]) : 0.0f;
            const auto element = static_cast<std::uint32_t>(i / 3);
            if (!fits && (made.faults.empty() || made.faults.back() != element))
                made.faults.push_back(element);
        }
        return made;
    }

    /// Returns red, green and blue, whether or not the accessor has an opacity too.
    const Colours& colours(const JsonValue& attribute) {
        const std::uint64_t index = attribute.whole(count_of("accessors"));
        const auto [found, is_new] = colours_.try_emplace(index);
        if (!is_new) return found->second;
        const std::uint64_t width = in_.at("accessors")[index].at("type").string() == "VEC4" ? 4 : 3;
        const std::vector<double> numbers = buffers_.read(index, width);
        if (!loading_.may_make(numbers.size() / width * sizeof(Colours::value_type)))
            attribute.refuse(loading_.too_much());
        found->second.resize(numbers.size() / width);
        for (std::size_t i = 0; i < found->second.size(); ++i) {
            glm::vec3 colour(numbers[width * i], numbers[width * i + 1], numbers[width * i + 2]);
            const bool is_known = std::isfinite(colour.r + colour.g + colour.b);
            if (!is_known)
                warnings_.count("vertex", "with a colour that is not finite, drawn without it", 0,
                                attribute.path());
            else if (clamp_colour(colour))
                warnings_.count("vertex", odd_colour, 0, attribute.path());
            if (is_known) found->second[i] = colour;
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

    /// Reads a mesh that a node uses.
    const Mesh& mesh(std::uint64_t number) {
        Mesh& made = meshes_[number];
        if (made.is_read) return made;
        made.is_read = true;
        loading_.report_progress("checking", number, meshes_.size());
        const JsonValue list = in_.at("meshes")[number].at("primitives").array();
        for (std::size_t i = 0; i < list.size(); ++i) {
            const std::uint64_t mode = list[i].whole_or("mode", 7, 4);
            if (!is_drawn(list[i], mode, made)) continue;
            made.primitives.push_back(primitive(list[i], mode));
            const std::uint64_t corners = made.primitives.back().corners;
            made.triangles += mode == 4 ? corners / 3 : corners - 2;
        }
        return made;
    }

    static void widen(std::optional<Bounds>& bounds, const glm::dvec3& point) {
        if (!bounds) bounds = Bounds{point, point};
        bounds = Bounds{glm::min(bounds->lo, point), glm::max(bounds->hi, point)};
    }

    bool is_drawn(const JsonValue& in, std::uint64_t mode, Mesh& into) {
        const auto left_out = [&](const char* what, const char* why) {
            warnings_.count(what, why, 0, in.path());
        };
        if (mode < 4) {
            left_out("primitive", "of points or lines left out");
            return false;
        }
        if (!in.at("attributes").find("POSITION")) {
            left_out("primitive", "without positions left out");
            return false;
        }
        if (const auto material = in.find("material");
            material && this->material(material->whole(materials_.size())).is_invisible) {
            for (const glm::vec3& p : vectors(in.at("attributes").at("POSITION")).values)
                widen(into.invisible, glm::dvec3(p));
            left_out("invisible primitive",
                     "left out: opacity below the cutoff of the material (alphaMode MASK)");
            return false;
        }
        return true;
    }

    /// Returns a scene that shows nothing. Its triangle has no area but spans the bounds of the invisible
    /// primitives, so that camera and lights are placed as for visible ones.
    PlacedScene nothing_visible() {
        if (!invisible_) at_.refuse("the file has no triangles");
        Scene& own = placed_.own;
        own.vertices = {invisible_->lo, invisible_->hi};
        own.triangles = {{{0, 1, 1}, 0}};
        own.materials = {Material{.name = "default"}};
        own.camera = camera_;
        warnings_.say(loading_);
        return std::move(placed_);
    }

    Primitive primitive(const JsonValue& in, std::uint64_t mode) {
        const JsonValue attributes = in.at("attributes"), position = attributes.at("POSITION");
        refuse_compressed(in, position);
        const Vectors& positions = vectors(position);
        Primitive made{&positions.values, nullptr, nullptr, nullptr, mode, none, 0};
        const std::size_t vertices = made.positions->size();
        if (const auto normal = attributes.find("NORMAL")) {
            const Vectors& normals = vectors(*normal);
            made.normals = &normals.values;
            if (made.normals->size() != vertices)
                normal->refuse(fmt::format("has {} normals for {} vertices", made.normals->size(), vertices));
            for (std::size_t i = 0; i < normals.faults.size(); ++i)
                warnings_.count("normal", "with components that are not finite, left out", 0, normal->path());
            has_normals_ = true;
        }
        if (const auto colour = attributes.find("COLOR_0")) {
            made.colours = &colours(*colour);
            if (made.colours->size() != vertices)
                colour->refuse(fmt::format("has {} colours for {} vertices", made.colours->size(), vertices));
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
        check_positions(position, positions.faults, made);
        if (const auto material = in.find("material")) made.material = material->whole(materials_.size());
        made.coordinates = coordinates(attributes, made);
        return made;
    }

    /// The picture of a material, and how it maps to meshes.
    struct Painted {
        std::optional<std::uint32_t> texture;
        GltfMapping mapping;
    };
    const Painted& painted(std::uint64_t number) {
        const auto [found, is_new] = painted_.try_emplace(number);
        if (!is_new || number == none || !material(number).base_texture) return found->second;
        found->second.texture = textures_.texture(material(number));
        if (found->second.texture) found->second.mapping = textures_.mapping(material(number));
        return found->second;
    }

    /// Returns the texture coordinates of all vertices, for the picture of the primitive's material. Without
    /// a picture it returns set 0 unchanged, for scenes that give the mesh another material; an invalid set
    /// then counts as missing. Returns null if the set is missing.
    const std::vector<glm::dvec2>* coordinates(const JsonValue& attributes, const Primitive& made) {
        if (!loading_.draws_textures()) return nullptr;
        const Painted& paint = painted(made.material);
        const auto attribute = attributes.find(fmt::format("TEXCOORD_{}", paint.mapping.set));
        if (!attribute) return nullptr;
        const std::pair key{attribute->whole(count_of("accessors")), paint.texture ? made.material : none};
        const auto [found, is_new] = coordinates_.try_emplace(key);
        if (is_new && paint.texture) {
            found->second = mapped(*attribute, paint.mapping);
        } else if (is_new) {
            try {
                found->second = mapped(*attribute, {});
            } catch (const UserError&) {
                return nullptr;
            }
        }
        const bool fits = found->second.size() == made.positions->size();
        if (!fits && paint.texture)
            attribute->refuse(fmt::format("has {} texture coordinates for {} vertices", found->second.size(),
                                          made.positions->size()));
        if (paint.texture) check_coordinates(*attribute, found->second, made, *paint.texture);
        return fits ? &found->second : nullptr;
    }

    std::vector<glm::dvec2> mapped(const JsonValue& attribute, const GltfMapping& mapping) {
        const std::uint64_t index = attribute.whole(count_of("accessors"));
        const std::vector<double> numbers = buffers_.read(index, 2);
        std::vector<glm::dvec2> points(numbers.size() / 2);
        for (std::size_t i = 0; i < points.size(); ++i)
            points[i] = mapping({numbers[2 * i], numbers[2 * i + 1]});
        return points;
    }

    /// Throws UserError if a triangle uses coordinates that cannot be drawn.
    void check_coordinates(const JsonValue& attribute, const std::vector<glm::dvec2>& points,
                           const Primitive& made, std::uint32_t texture) {
        each_triangle(made, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            const std::string why =
                coordinate_fault(textures_.all()[texture], {points[a], points[b], points[c]});
            if (!why.empty())
                in_.at("accessors")[attribute.whole(count_of("accessors"))].refuse(
                    fmt::format("does not fit: the triangle of the vertices {}, {} and {} {}", a, b, c, why));
        });
    }

    glm::dvec2 point_of(const Primitive& primitive, std::uint32_t vertex) const {
        return primitive.coordinates ? (*primitive.coordinates)[vertex] : no_coordinates;
    }

    /// Throws UserError for Draco compression. Its accessors have no data, which would otherwise mean zeros.
    void refuse_compressed(const JsonValue& in, const JsonValue& position) const {
        const auto extensions = in.find("extensions");
        const JsonValue accessor = in_.at("accessors")[position.whole(count_of("accessors"))];
        if (extensions && extensions->find("KHR_draco_mesh_compression") && !accessor.find("bufferView"))
            in.refuse("is compressed by KHR_draco_mesh_compression, which is not supported");
    }

    /// Throws UserError if a triangle uses a vertex whose position is not finite. Counts unused ones.
    void check_positions(const JsonValue& position, const std::vector<std::uint32_t>& faults,
                         const Primitive& made) {
        if (faults.empty()) return;
        const auto check = [&](std::uint32_t vertex) {
            if (!std::binary_search(faults.begin(), faults.end(), vertex)) return;
            in_.at("accessors")[position.whole(count_of("accessors"))].refuse(fmt::format(
                "has a number at element {} that is not finite as a 32-bit float, and a triangle uses it",
                vertex));
        };
        each_triangle(
            made, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) { check(a), check(b), check(c); });
        for (std::size_t i = 0; i < faults.size(); ++i)
            warnings_.count("unused vertex", "with coordinates that are not finite, left out", 0,
                            position.path());
    }

    void tree() {
        const std::size_t count = count_of("nodes");
        visited_.resize(count), wheres_.resize(count);
        for (const std::uint64_t root : gltf_roots(in_, count)) visit(root, 0, {});
        if (!loading_.may_make(triangles_ * bytes_of_a_placed_triangle)) at_.refuse(loading_.too_much());
    }

    bool deforms(const JsonValue& node, std::uint64_t index, std::uint64_t mesh) {
        const JsonValue in = in_.at("meshes")[mesh];
        if (node.find("skin")) return true;
        const auto [known, is_new] = has_targets_.try_emplace(mesh);
        if (is_new) known->second = gltf_target_count(in) > 0;
        return known->second && GltfDeformer::deforms(node, in, tracks_of(index));
    }

    /// Returns the place of a node below the place of its parent.
    NodePlace where_of(const JsonValue& in, std::uint64_t index, const NodePlace& above) {
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

    void visit(std::uint64_t index, int depth, const NodePlace& above) {
        const JsonValue in = in_.at("nodes")[index];
        if (visited_[index]) in.refuse("appears twice in the tree of nodes");
        if (depth > max_node_depth) in.refuse(fmt::format("is nested deeper than {} nodes", max_node_depth));
        visited_[index] = true;
        const NodePlace where = where_of(in, index, above);
        wheres_[index] = where;
        const glm::dmat4& place = where.place;
        if (const auto mesh = in.find("mesh")) {
            const std::uint64_t number = mesh->whole(meshes_.size());
            if (this->mesh(number).triangles > 0) add_copies(in, number, index, where);
            if (const auto& box = meshes_[number].invisible)
                for (const glm::dvec3& corner : {box->lo, box->hi})
                    widen(invisible_, glm::dvec3(place * glm::dvec4(corner, 1)));
        }
        if (const auto camera = in.find("camera")) {
            const auto made = gltf_camera(in_.at("cameras")[camera->whole(count_of("cameras"))], place);
            if (!made) warnings_.count("orthographic camera", "left out", 0, in.path());
            if (!camera_ && made && where.node) {
                placed_.motion.camera.node = where.node;
                placed_.motion.camera.seen = *made;
            }
            if (!camera_) camera_ = made;
        }
        if (const auto extensions = in.find("extensions")) {
            if (const auto light = extensions->find("KHR_lights_punctual")) {
                const JsonValue all = in_.at("extensions").at("KHR_lights_punctual").at("lights").array();
                const JsonValue given = all[light->at("light").whole(all.size())];
                lights_.push_back(gltf_light(given, place));
                if (given.at("type").string() == "spot")
                    warnings_.count("spot light", "drawn as a point light", 0, in.path());
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

    /// Adds a node's mesh at its place, or at many places by EXT_mesh_gpu_instancing.
    void add_copies(const JsonValue& in, std::uint64_t number, std::uint64_t index, const NodePlace& where) {
        const bool does_deform = deforms(in, index, number);
        const auto extensions = in.find("extensions");
        const auto many = extensions ? extensions->find("EXT_mesh_gpu_instancing") : std::nullopt;
        std::vector<glm::dmat4> places{glm::dmat4(1)};
        if (many && !in.find("skin"))
            places = gltf_places(many->at("attributes"), buffers_, count_of("accessors"));
        triangles_ += meshes_[number].triangles * places.size();
        if (triangles_ > max_triangles) refuse_triangles();
        if (!loading_.may_make(places.size() * sizeof(Copy))) in.refuse(loading_.too_much());
        for (const glm::dmat4& place : places)
            copies_.push_back({number, index, {where.place * place, where.node}, does_deform});
    }

    [[noreturn]] void refuse_triangles() const {
        at_.refuse(fmt::format("{} placed triangles; the most is {}", triangles_, max_triangles));
    }

    /// Calls `use` with the three vertex numbers of each triangle.
    template <class Use> static void each_triangle(const Primitive& primitive, const Use& use) {
        const auto vertex = [&](std::uint64_t k) {
            return primitive.indices ? (*primitive.indices)[k] : static_cast<std::uint32_t>(k);
        };
        if (primitive.mode == 4)
            for (std::uint64_t k = 0; k < primitive.corners; k += 3)
                use(vertex(k), vertex(k + 1), vertex(k + 2));
        else if (primitive.mode == 5)   // a strip: every second triangle is reversed
            for (std::uint64_t k = 0; k + 2 < primitive.corners; ++k)
                use(vertex(k + k % 2), vertex(k + 1 - k % 2), vertex(k + 2));
        else   // a fan
            for (std::uint64_t k = 0; k + 2 < primitive.corners; ++k)
                use(vertex(0), vertex(k + 1), vertex(k + 2));
    }

    /// Builds the parts of a mesh, before its first placement.
    void build(std::uint64_t mesh) {
        for (const Primitive& primitive : meshes_[mesh].primitives) {
            if (!loading_.may_make(primitive.corners * sizeof(std::uint64_t)))
                at_.refuse(loading_.too_much());
            PartBuilder builder(primitive.mode == 4 ? primitive.corners / 3 : primitive.corners - 2,
                                primitive.normals != nullptr);
            const auto corner = [&](std::uint32_t i) {
                return Corner{glm::dvec3((*primitive.positions)[i]),
                              primitive.normals ? glm::dvec3((*primitive.normals)[i]) : glm::dvec3(0),
                              point_of(primitive, i)};
            };
            each_triangle(primitive, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
                builder.add(corner(a), corner(b), corner(c), builder.colour(colour_of(primitive, a, b, c)));
            });
            parts_[mesh].push_back(assembly_.add(std::move(builder)));
        }
    }

    std::optional<glm::vec3> colour_of(const Primitive& primitive, std::uint32_t a, std::uint32_t b,
                                       std::uint32_t c) {
        if (!primitive.colours) return std::nullopt;
        FaceColour colour;
        for (const std::uint32_t i : {a, b, c}) colour.add((*primitive.colours)[i]);
        if (colour.varies()) warnings_.count("face", mixed_colours);
        return colour.mean();
    }

    void place(const Copy& copy) {
        for (std::size_t i = 0; i < parts_[copy.mesh].size(); ++i) {
            const std::uint64_t number = meshes_[copy.mesh].primitives[i].material;
            assembly_.place(parts_[copy.mesh][i], copy.where.place, number,
                            [&] { return made_material(number); });
        }
    }

    /// Adds an instance of the mesh, and makes the shared mesh at the first one.
    void share(const Copy& copy) {
        const auto [found, is_new] =
            shared_.try_emplace(copy.mesh, static_cast<std::uint32_t>(placed_.meshes.size()));
        if (is_new) {
            Scene mesh;
            for (std::size_t i = 0; i < parts_[copy.mesh].size(); ++i) {
                const std::uint64_t number = meshes_[copy.mesh].primitives[i].material;
                assembly_.gather(mesh, parts_[copy.mesh][i], number, [&] { return made_material(number); });
            }
            placed_.meshes.push_back({fmt::format("meshes[{}]", copy.mesh), std::move(mesh.vertices),
                                      std::move(mesh.normals), std::move(mesh.triangles),
                                      std::move(mesh.coordinates)});
        }
        add_instance(copy.from, found->second, copy.where);
    }

    /// Adds a mesh of its own for a node that deforms. It keeps degenerate triangles, because they may get an
    /// area later. Joints place a skin instead of its node. Primitives without normals become facets if
    /// others have normals.
    void deform(const Copy& copy) {
        const JsonValue node = in_.at("nodes")[copy.from];
        const std::vector<Primitive>& primitives = meshes_[copy.mesh].primitives;
        const bool is_smooth = std::any_of(primitives.begin(), primitives.end(),
                                           [](const Primitive& primitive) { return primitive.normals; });
        const bool is_painted = std::any_of(primitives.begin(), primitives.end(),
                                            [](const Primitive& primitive) { return primitive.coordinates; });
        Deforming made = deformer_.make(node, in_.at("meshes")[copy.mesh], tracks_of(copy.from), is_smooth);
        SharedMesh mesh{fmt::format("meshes[{}]", copy.mesh), made.rest, made.normals, {}};
        if (!loading_.may_make(meshes_[copy.mesh].triangles * sizeof(Triangle)))
            at_.refuse(loading_.too_much());
        std::uint32_t base = 0;
        std::vector<std::uint32_t> facets;
        for (const Primitive& primitive : primitives) {
            each_triangle(primitive, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
                if (!primitive.normals) facets.push_back(static_cast<std::uint32_t>(mesh.triangles.size()));
                const std::uint32_t own = assembly_.material(
                    primitive.material, [&] { return made_material(primitive.material); },
                    colour_of(primitive, a, b, c).value_or(glm::vec3(1)));
                mesh.triangles.push_back({{base + a, base + b, base + c}, own});
                if (is_painted)
                    mesh.coordinates.push_back(
                        {point_of(primitive, a), point_of(primitive, b), point_of(primitive, c)});
            });
            base += static_cast<std::uint32_t>(primitive.positions->size());
        }
        if (has_normals_ && !facets.empty()) make_faceted(facets, made, mesh);
        made.mesh = static_cast<std::uint32_t>(placed_.meshes.size());
        static const NodePlace in_the_scene{};
        const NodePlace& where = made.joints.empty() ? copy.where : in_the_scene;
        if (made.is_still())
            rayclock::deform(made, 0, {}, mesh);
        else
            placed_.motion.deforming.push_back(std::move(made));
        placed_.meshes.push_back(std::move(mesh));
        add_instance(copy.from, static_cast<std::uint32_t>(placed_.meshes.size() - 1), where);
    }

    void add_instance(std::uint64_t node, std::uint32_t mesh, const NodePlace& where) {
        if (where.node)
            placed_.motion.attached.push_back(
                {static_cast<std::uint32_t>(placed_.instances.size()), *where.node, where.place});
        placed_.instances.push_back({fmt::format("nodes[{}]", node), mesh, where.place, {}});
    }

    GltfMaterial& material(std::uint64_t number) {
        auto& made = materials_[number];
        if (!made) made = gltf_material(in_.at("materials")[number], number);
        return *made;
    }

    Material made_material(std::uint64_t number) {
        if (number == none) return Material{.name = "default"};
        GltfMaterial material = this->material(number);
        const auto note_if = [&](bool is_so, const char* became) {
            if (is_so) warnings_.count("material", became, 0, material.name);
        };
        std::optional<std::uint32_t> texture;
        if (material.base_texture) texture = textures_.texture(material);
        if (texture) textures_.take_opacity(material, *texture);
        note_if(material.base_texture && !texture && textures_.tint(material), averaged_texture);
        note_if(material.has_textures, "with other textures, which are not drawn");
        note_if(material.has_extensions, "with extensions that are not drawn");
        note_if(is_out_of_range(material.surface), "with values out of range, taken as the nearest within");
        Material made = material_of(material.surface, material.name);
        made.texture = texture;
        if (texture && material.is_masked) made.cutoff = std::clamp(material.cutoff, 0.0, 1.0);
        note_if(!add_emission(made, glm::dvec3(material.surface.emission)), mixed_emission);
        return made;
    }

    JsonValue list(std::string_view key) const {
        return in_.find(key).value_or(JsonValue(empty_, at_.file)).array();
    }
    std::uint64_t count_of(std::string_view key) const { return list(key).size(); }

    JsonValue in_;
    SourcePosition at_;
    Loading& loading_;
    Warnings warnings_;
    GltfBuffers buffers_;
    GltfDeformer deformer_;
    GltfTextures textures_;
    Assembly assembly_;
    const Json empty_ = Json::array();
    std::map<std::uint64_t, Vectors> vectors_;   // by accessor
    std::map<std::uint64_t, Colours> colours_;
    std::map<std::uint64_t, std::vector<std::uint32_t>> indices_;
    std::map<const void*, std::uint32_t> largest_;   // by list of indices
    std::vector<Mesh> meshes_;
    std::vector<std::vector<std::size_t>> parts_;   // by mesh, for placed meshes
    std::vector<std::optional<GltfMaterial>> materials_;
    std::map<std::uint64_t, bool> has_targets_;   // by mesh, filled at the first query
    std::map<std::uint64_t, Painted> painted_;    // by material
    /// By accessor, and by the material if it has a picture.
    std::map<std::pair<std::uint64_t, std::uint64_t>, std::vector<glm::dvec2>> coordinates_;
    std::vector<bool> visited_;
    std::vector<std::optional<NodePlace>> wheres_;    // of the nodes in the scene
    std::map<std::uint64_t, GltfTracks> tracks_;      // by node
    std::map<std::uint64_t, std::uint32_t> shared_;   // number of the shared mesh by the document's mesh
    PlacedScene placed_;
    std::vector<Copy> copies_;
    std::optional<Bounds> invisible_;   // of primitives that are not drawn
    std::vector<PlacedLight> lights_;
    std::optional<Camera> camera_;
    bool has_normals_ = false;
    std::uint64_t triangles_ = 0;
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
        SourcePosition{file, 1}.refuse("this is not glTF: it begins with " + shown(text.substr(0, 8)));
    const Json parsed = parse_json(file, text);
    const JsonValue document(parsed, file);
    check_gltf_version(document, SourcePosition{file});
    return GltfReader(document, path, container, loading).read();
}

}   // namespace rayclock
