// Computes the correct meshes, instances and maps of a machine of two levels.
#include "sim/judge/paths/placed.hpp"

#include <cmath>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "model/compile/surfaces.hpp"
#include "model/engine/engines.hpp"
#include "sim/judge/paths/answer.hpp"

namespace rayclock {

namespace {

using oracle::PlacedRay;
using oracle::PlacedSolids;
using oracle::SolidPlace;
using oracle::Solids;

/// Returns a scene without instances as a single mesh with one instance.
PlacedScene alone(const Scene& scene) {
    PlacedScene placed;
    placed.own.vertices = scene.vertices, placed.own.normals = scene.normals;
    placed.own.triangles = scene.triangles, placed.own.coordinates = scene.coordinates;
    placed.own.textures = scene.textures;
    placed.own.spheres = scene.spheres, placed.own.planes = scene.planes;
    return placed;
}

/// Numbers of two special meshes: the scene's own triangles, and its spheres and planes.
constexpr std::uint32_t own_triangles = no_primitive, own_round = no_primitive - 1;

SharedMesh own_mesh_of(const Scene& own) {
    return {"", own.vertices, own.normals, own.triangles, own.coordinates};
}

SolidPlace solid_place(std::uint32_t mesh, std::uint32_t first, const Placement& map) {
    SolidPlace place{mesh, first, {}, {}};
    for (std::size_t i = 0; i < 9; ++i) place.a[i] = map.a[i];
    for (std::size_t i = 0; i < 3; ++i) place.b[i] = map.b[i];
    return place;
}

/// Returns a lattice in scene units of one step.
Lattice steps(int coord_bits) {
    Lattice lattice;
    lattice.coord_bits = coord_bits;
    return lattice;
}

bool can_be_met(const oracle::Solid& solid) {
    if (solid.shape == oracle::Solid::Shape::sphere) return solid.radius_squared > 0;
    return oracle::normal<std::int64_t>(solid.corners) != oracle::Triple<std::int64_t>{};
}

/// Returns the inverse of a place's linear part, row by row, from cofactors in long doubles.
std::array<long double, 9> inverse_of(const glm::dmat4& place) {
    std::array<long double, 9> rows{};
    long double volume = 0;
    const auto at = [&](std::size_t row, std::size_t column) {
        return (long double)(place[int(column % 3)][int(row % 3)]);
    };
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            rows[3 * k + i] = at(i + 1, k + 1) * at(i + 2, k + 2) - at(i + 1, k + 2) * at(i + 2, k + 1);
    for (std::size_t k = 0; k < 3; ++k) volume += at(0, k) * rows[3 * k];
    for (long double& entry : rows) entry /= volume;
    return rows;
}

}   // namespace

PlacedWorld::PlacedWorld(const FrameInputs& inputs, const MemoryImage& image)
    : inputs_(inputs), config_(inputs.config) {
    const PlacedScene own = inputs.scene.placed ? PlacedScene{} : alone(inputs.scene);
    const PlacedScene& scene = inputs.scene.placed ? *inputs.scene.placed : own;
    const LevelLattices& lattices = *image.levels;
    list_instances(scene, lattices);
    const SharedMesh own_mesh = own_mesh_of(scene.own);
    for (std::size_t c = 0; c < lattices.classes.size(); ++c)
        for (const Placed& placed : instances_)
            if (placed.mesh_class == c) {
                classes_.push_back(
                    placed.mesh == own_round
                        ? make_round(scene)
                        : make(scene, placed.mesh == own_triangles ? own_mesh : scene.meshes[placed.mesh],
                               lattices.classes[c], placed.place));
                break;
            }
    read_maps(image);
    std::vector<SolidPlace> places;
    for (Placed& placed : instances_) {
        const Made& made = classes_[placed.mesh_class];
        const bool is_there = std::any_of(made.solids.begin(), made.solids.end(), can_be_met);
        const auto fault = [&](const std::string& what) { faults_.push_back(placed.name + what); };
        if (placed.found.size() != (is_there ? 1u : 0u))
            fault(" is placed " + std::to_string(placed.found.size()) + " times by memory");
        if (is_there && placed.found.empty()) placed.found.emplace_back();
        const Placement map = placed.found.empty() ? Placement{} : placed.found[0];
        if (!made.is_within) fault(": a corner of its mesh lies outside of the mesh's lattice");
        if (!made.is_near) fault(": a corner of its mesh lies further from the scene's than it may");
        if (is_there) judge_map(placed, lattices.classes[placed.mesh_class], map);
        const SolidPlace& place = places.emplace_back(solid_place(placed.mesh_class, placed.first, map));
        glm::dmat3 linear;
        for (int i = 0; i < 9; ++i) linear[i % 3][i / 3] = double(place.a[std::size_t(i)]);
        placed.is_mirrored = glm::determinant(linear) < 0;
        placed.is_same = linear == std::ldexp(1.0, config_.map_frac()) * glm::dmat3(1) &&
                         place.b == std::array<std::int64_t, 3>{};
        if (is_there && config_.shading && (map.is_same != 0) != placed.is_same)
            fault(map.is_same ? " is said to be placed by the identity, and is not"
                              : " is placed by the identity, and memory does not say so");
        if (is_there && placed.mesh == own_round && !placed.is_same) fault(" are not placed by the identity");
    }
    std::vector<Solids> meshes;
    for (const Made& made : classes_) meshes.emplace_back(made.solids);
    solids_.emplace(std::move(meshes), std::move(places), config_.map_frac(), config_.coord_bits,
                    config_.dir_bits);
}

/// Lists the instances in the order of their primitives' numbers; spheres and planes come last.
void PlacedWorld::list_instances(const PlacedScene& scene, const LevelLattices& lattices) {
    std::uint32_t first = 0;
    const auto add = [&](Placed placed, std::size_t triangles) {
        if (triangles == 0) return;
        placed.first = first;
        first += std::uint32_t(triangles);
        placed.mesh_class = lattices.of_instance.at(instances_.size());
        instances_.push_back(std::move(placed));
    };
    Placed own;
    own.name = "the scene's own mesh", own.mesh = own_triangles;
    add(std::move(own), scene.own.triangles.size());
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        Placed placed;
        placed.name = "instance " + std::to_string(i), placed.mesh = instance.mesh;
        placed.place = instance.place, placed.material = instance.material;
        add(std::move(placed), scene.meshes[instance.mesh].triangles.size());
    }
    Placed round;
    round.name = "the scene's own spheres and planes", round.mesh = own_round;
    add(std::move(round), scene.own.spheres.size() + scene.own.planes.size());
}

/// Converts the spheres and planes to the scene's lattice, which the host cannot choose.
PlacedWorld::Made PlacedWorld::make_round(const PlacedScene& scene) const {
    Made made;
    made.scene.spheres = scene.own.spheres, made.scene.planes = scene.own.planes;
    made.scene.materials = inputs_.scene.materials.empty() ? scene.own.materials : inputs_.scene.materials;
    made.scene.textures = scene.own.textures;
    made.solids = solids_of(made.scene, inputs_.lattice, config_.coord_bits);
    return made;
}

/// Converts a mesh to the lattice of its class. Corners move as in a flat scene (align_large_triangles()),
/// and normals transform like planes.
PlacedWorld::Made PlacedWorld::make(const PlacedScene& scene, const SharedMesh& mesh,
                                    const LevelLattices::Class& of, const glm::dmat4& first) const {
    Scene part;
    part.vertices = mesh.vertices, part.normals = mesh.normals, part.triangles = mesh.triangles;
    part.coordinates = mesh.coordinates;
    Made made;
    append(made.scene, part, of.before, {}, 0);
    const std::vector<glm::dvec3> given = made.scene.vertices;
    const std::vector<double> most = corner_bounds(made.scene, of.lattice, config_);
    if (config_.shading)
        if (std::optional<Scene> moved = align_large_triangles(made.scene, of.lattice))
            made.scene = std::move(*moved);
    for (glm::dvec3& at : made.scene.vertices) at = (at - of.lattice.centre) / of.lattice.pitch;
    // Each normal has unit length in the scene, at the first instance's place.
    const std::array<long double, 9> back = inverse_of(of.before == glm::dmat4(1) ? first : glm::dmat4(1));
    for (glm::dvec3& normal : made.scene.normals) {
        long double square = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const long double at = back[k] * (long double)normal.x + back[3 + k] * (long double)normal.y +
                                   back[6 + k] * (long double)normal.z;
            square += at * at;
        }
        if (square > 0) normal *= of.lattice.pitch / double(std::sqrt(square));
    }
    made.scene.materials = inputs_.scene.materials.empty() ? scene.own.materials : inputs_.scene.materials;
    made.scene.textures = scene.own.textures;
    made.solids = solids_of(made.scene, steps(config_.coord_bits), config_.coord_bits);
    const double end = std::ldexp(1, config_.coord_bits - 1) - 0.5,
                 slack = lattice_slack + (config_.shading ? std::ldexp(1, max_fine) : 0);
    for (const Triangle& triangle : made.scene.triangles)
        for (const std::uint32_t index : triangle.vertex) {
            const glm::dvec3 at = glm::abs((given[index] - of.lattice.centre) / of.lattice.pitch);
            made.is_within = made.is_within && std::max({at.x, at.y, at.z}) <= end + slack;
            made.is_near =
                made.is_near &&
                corner_error(of.lattice, steps(config_.coord_bits).snap(made.scene.vertices[index]),
                             given[index]) <= most[index];
        }
    return made;
}

/// Reads every instance that the scene's tree leads to.
void PlacedWorld::read_maps(const MemoryImage& image) {
    const bool has_cells = rayclock::has_cells(config_);
    std::vector<std::uint32_t> lines{inputs_.frame.root};
    for (std::size_t seen = 0; !lines.empty(); ++seen) {
        const std::uint32_t at = lines.back();
        lines.pop_back();
        if (seen > image.lines()) return faults_.push_back("the scene's tree in memory does not end");
        const std::uint32_t* const words = image.line(at);
        if (line_kind(words) == LineKind::scene_node) {
            with_engine(config_.engine(), [&]<class E>(E) {
                const auto node = unpack<typename E::Node>(words, config_);
                std::uint32_t next = node.base;
                for (std::size_t i = 0; i < std::size_t(config_.node_width); ++i)
                    if (node.kind[i] == 1) lines.push_back(next++);
            });
            continue;
        }
        const Placement map = unpack<Placement>(words, config_);
        const auto placed = std::find_if(instances_.begin(), instances_.end(),
                                         [&](const Placed& p) { return p.first == map.first; });
        if (line_kind(words) != LineKind::placement || placed == instances_.end()) {
            faults_.push_back("line " + std::to_string(at) + " of memory places no instance of the scene");
            continue;
        }
        of_line_[at] = std::uint32_t(placed - instances_.begin());
        // A tree of cells has one line for each cell that an instance reaches into. All these lines must be
        // equal.
        if (has_cells && !placed->found.empty() && placed->found[0] == map) continue;
        placed->line = map.here;
        placed->found.push_back(map);
    }
    for (std::uint32_t i = 0; i < instances_.size(); ++i)
        if (config_.shading && !instances_[i].found.empty() && place_at(instances_[i].line) != i)
            faults_.push_back(instances_[i].name + " is told that it lies in another line of memory");
}

/// Judges a map: each number is the place's, rounded to nearest. In a row whose magnitudes would sum to more
/// than 1 it is rounded towards 0. The host's doubles may have an error of `slack`.
void PlacedWorld::judge_map(const Placed& placed, const LevelLattices::Class& of, const Placement& map) {
    const bool is_out = of.before != glm::dmat4(1);
    if (is_out && of.before != placed.place)
        faults_.push_back(placed.name + " is written out in another place");
    const glm::dmat4 place = is_out ? glm::dmat4(1) : placed.place;
    const std::array<long double, 9> back = inverse_of(place);
    const Lattice& scene = inputs_.lattice;
    bool good = true;
    for (std::size_t i = 0; i < 3; ++i) {
        std::array<long double, 3> row{};
        long double moved = -(long double)of.lattice.centre[int(i)], size = std::abs(moved), sum = 0;
        const long double one = std::ldexp(1.0L, config_.map_frac());
        const long double unit = one / (long double)of.lattice.pitch[int(i)];
        std::int64_t stored_sum = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const long double step = back[3 * i + k];
            row[k] = step * (long double)scene.pitch[int(k)] * unit;
            sum += std::abs(std::round(row[k]));
            moved += step * ((long double)scene.centre[int(k)] - (long double)place[3][int(k)]);
            size += std::abs(step) *
                    (std::abs((long double)scene.centre[int(k)]) + std::abs((long double)place[3][int(k)]));
        }
        const bool is_cut = sum + 1 > one;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto stored = (long double)map.a[3 * i + k];
            const long double slack = 1e-3L + std::abs(row[k]) * 0x1p-40L;
            const bool is_nearest = std::abs(stored - row[k]) <= 0.5L + slack;
            const bool is_below =
                std::abs(stored - row[k]) < 1 + slack && std::abs(stored) <= std::abs(row[k]) + slack;
            good = good && (is_nearest || (is_cut && is_below));
            stored_sum += std::abs(std::int64_t(map.a[3 * i + k]));
        }
        const long double end = std::ldexp(1.0L, config_.coord_bits - 1) - 1;
        good = good && (long double)stored_sum <= one &&
               (long double)stored_sum * end + std::abs((long double)map.b[i]) <= (end + 0.25L) * one;
        good =
            good && std::abs((long double)map.b[i] - moved * unit) <= 0.5L + 1e-3L + size * unit * 0x1p-44L;
    }
    if (!good) faults_.push_back(placed.name + " has another map in memory than its place");
}

oracle::PlacedRay PlacedWorld::ray(const Ray& ray) const {
    PlacedRay placed{solid_ray(ray, config_)};
    if (!config_.has_homes() || ray.kind == RayKind::camera) return placed;
    placed.home = place_at(ray.home.line);
    Ray at_home = ray;
    at_home.o = ray.home.o, at_home.d = ray.home.d;
    placed.at_home = solid_ray(at_home, config_);
    return placed;
}

std::uint32_t PlacedWorld::place_at(std::uint32_t line) const {
    const auto found = of_line_.find(line);
    return found == of_line_.end() ? PlacedRay::nowhere : found->second;
}

const Material& PlacedWorld::material(std::uint32_t primitive) const {
    const Placed& placed = instances_[place_of(primitive)];
    const Made& made = classes_[placed.mesh_class];
    return placed.material ? made.scene.materials[*placed.material]
                           : material_of(made.scene, primitive - placed.first);
}

Surface PlacedWorld::surface(std::uint32_t primitive) const {
    const Placed& placed = instances_[place_of(primitive)];
    const Made& made = classes_[placed.mesh_class];
    return expected_surface(made.scene, made.solids, config_, primitive - placed.first, material(primitive));
}

std::optional<TexturedSurface> PlacedWorld::textured(std::uint32_t primitive) const {
    const Placed& placed = instances_[place_of(primitive)];
    if (placed.material) return std::nullopt;
    return textured_surface(classes_[placed.mesh_class].scene,
                            placed.mesh == own_round ? inputs_.lattice : steps(config_.coord_bits),
                            primitive - placed.first);
}

bool PlacedWorld::may_have_holes(std::uint32_t primitive) const {
    const Placed& placed = instances_[place_of(primitive)];
    return !placed.material &&
           rayclock::may_have_holes(classes_[placed.mesh_class].scene, primitive - placed.first);
}

bool PlacedWorld::holds_normals(std::uint32_t primitive, const Surface& seen) const {
    const Placed& placed = instances_[place_of(primitive)];
    return rayclock::holds_normals(classes_[placed.mesh_class].scene, primitive - placed.first, seen);
}

const Plane& PlacedWorld::plane(std::uint32_t primitive) const {
    const Placed& placed = instances_[place_of(primitive)];
    const Scene& scene = classes_[placed.mesh_class].scene;
    return scene.planes[primitive - placed.first - scene.spheres.size()];
}

bool PlacedWorld::is_map_of(std::uint32_t place, const Placement& placement) const {
    const Placed& placed = instances_[place];
    return !placed.found.empty() && placed.found[0] == placement;
}

PlacedScene PlacedWorld::snapped() const {
    PlacedScene scene;
    scene.own.name = inputs_.scene.name;
    scene.own.materials = inputs_.scene.materials, scene.own.textures = inputs_.scene.textures;
    scene.own.lights = inputs_.scene.lights;
    scene.own.background = inputs_.scene.background;
    for (const Made& made : classes_) {
        SharedMesh mesh{"", made.scene.vertices, made.scene.normals, made.scene.triangles,
                        made.scene.coordinates};
        const Lattice lattice = steps(config_.coord_bits);
        for (glm::dvec3& v : mesh.vertices) {
            const Vec3i at = lattice.snap(v);
            v = {at[0], at[1], at[2]};
        }
        scene.meshes.push_back(std::move(mesh));
    }
    for (std::uint32_t i = 0; i < instances_.size(); ++i) {
        const SolidPlace& map = solids_->places()[i];
        if (instances_[i].mesh == own_round) {
            const Scene& round = classes_[instances_[i].mesh_class].scene;
            scene.own.spheres = round.spheres, scene.own.planes = round.planes;
            snap_round(inputs_.lattice, scene.own);
            continue;
        }
        glm::dmat4 there(1);
        for (std::size_t row = 0; row < 3; ++row) {
            for (std::size_t k = 0; k < 3; ++k)
                there[int(k)][int(row)] = std::ldexp(double(map.a[3 * row + k]), -config_.map_frac());
            there[3][int(row)] = std::ldexp(double(map.b[row]), -config_.map_frac());
        }
        const bool is_placed =
            !instances_[i].found.empty() && std::abs(glm::determinant(glm::dmat3(there))) > 0;
        scene.instances.push_back({instances_[i].name, map.mesh,
                                   is_placed ? glm::inverse(there) : glm::dmat4(1), instances_[i].material});
    }
    return scene;
}

}   // namespace rayclock
