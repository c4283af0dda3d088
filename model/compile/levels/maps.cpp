// Sorts instances into classes and fits lattices and maps.
#include "model/compile/levels/fit.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "model/base/error.hpp"
#include "model/compile/compile.hpp"
#include "model/compile/lattice.hpp"
#include "model/compile/plane.hpp"
#include "model/compile/surfaces.hpp"

#include <glm/common.hpp>

namespace rayclock {
namespace {

constexpr std::uint64_t max_corners = 20'000'000;   // corners of all instances; with more, no box is exact

/// The requirements of a class's members on its lattice.
struct Needs {
    glm::dvec3 least{0}, most{0};   ///< steps of the members
    glm::dvec3 lo{0}, hi{0};
    bool is_one = true;   ///< all members see the same lattice
    LatticeInMesh seen;
};

/// Returns the cofactors of a place, which transform normals. Their square gives the change of lengths.
glm::dmat3 cofactors_of(const glm::dmat4& place) {
    const glm::dmat3 m(place);
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

/// True if two maps stretch all directions alike, to 2^-12, up to a common factor. For a square of trace 1 no
/// eigenvalue is below the determinant.
bool stretch_alike(const glm::dmat3& one, const glm::dmat3& other) {
    const auto square_of = [](const glm::dmat3& m) {
        const glm::dmat3 square = glm::transpose(m) * m;
        return square * (1 / (square[0][0] + square[1][1] + square[2][2]));
    };
    const glm::dmat3 a = square_of(one), b = square_of(other);
    double apart = 0;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) apart = std::max(apart, std::abs(a[i][k] - b[i][k]));
    return 3 * apart <= 0x1p-11 * glm::determinant(a);
}

class Mapper {
public:
    Mapper(const LevelParts& parts, std::span<const InstancePlaces> times, std::span<const glm::dvec3> eyes,
           const Config& config)
        : parts_(parts),
          times_(times),
          eyes_(eyes),
          config_(config),
          largest_(largest_of(config)),
          is_out_(parts.instances.size()),
          moves_(parts.instances.size()) {
        for (const InstancePlaces& places : times)
            for (std::size_t i = 0; i < places.size(); ++i) moves_[i] = moves_[i] || places[i] != times[0][i];
        std::uint64_t corners = 0;
        for (const Instance& instance : parts.instances)
            corners += parts.meshes[instance.mesh]->vertices.size();
        is_large_ = corners > max_corners;
    }

    /// Computes everything. Rounding may push boxes beyond the lattice; the lattice then gets a margin.
    /// Returns false if a moving instance would have to be written out.
    bool run() {
        find_bounds();
        const bool has_spheres = parts_.round && !parts_.round->spheres.empty();
        for (double margin = config_.is_stream() && has_spheres ? sphere_margin : 0;;) {
            written_out_ = false;
            const double beyond = map(margin);
            if (moves_out()) return false;
            if (written_out_) continue;   // once more, with more instances written out
            if (beyond <= 0) return true;
            margin += beyond + 1;
            if (margin < largest_ / 4) continue;
            // Never observed. Written-out instances round nothing, and need a margin only for secondary rays.
            if (all_out_)
                throw UserError("two levels need more origin_bits than " +
                                std::to_string(config_.origin_bits) + " for secondary rays on this lattice");
            is_out_.assign(is_out_.size(), true);
            all_out_ = true;
            margin = 0;
        }
    }
    LevelMaps take() { return std::move(maps_); }

private:
    bool moves_out() const {
        for (std::size_t i = 0; i < moves_.size(); ++i)
            if (moves_[i] && is_out_[i]) return true;
        return false;
    }

    void find_bounds() {
        Growing box;
        for (std::size_t i = 0; i < parts_.instances.size(); ++i) {
            if (parts_.is_round(parts_.instances[i].mesh)) continue;
            const SharedMesh& mesh = *parts_.meshes[parts_.instances[i].mesh];
            if (moves_[i] || is_large_ || parts_.deforms(parts_.instances[i].mesh)) {
                const std::array<glm::dvec3, 8>& corners = corners_of(parts_.instances[i].mesh);
                for (std::size_t t = 0; t < (moves_[i] ? times_.size() : 1); ++t)
                    for (const glm::dvec3& corner : corners) box.add(times_[t][i], corner);
                continue;
            }
            for (const Triangle& triangle : mesh.triangles)
                for (const std::uint32_t index : triangle.vertex) box.add(times_[0][i], mesh.vertices[index]);
        }
        if (parts_.round) add_round(box);
        for (const glm::dvec3& eye : eyes_) box.add(glm::dmat4(1), eye);
        bounds_ = {box.lo, box.hi};
    }

    struct Growing {
        glm::dvec3 lo{std::numeric_limits<double>::infinity()}, hi{-std::numeric_limits<double>::infinity()};
        void add(const glm::dmat4& place, const glm::dvec3& p) {
            const auto point = glm::dvec3(place * glm::dvec4(p, 1));
            lo = glm::min(lo, point);
            hi = glm::max(hi, point);
        }
    };
    /// Adds spheres. Planes count only if there is nothing else.
    void add_round(Growing& box) const {
        Scene round;
        round.spheres = parts_.round->spheres;
        if (parts_.instances.size() == 1) round.planes = parts_.round->planes;
        if (primitive_count(round) == 0) return;
        const Bounds all = bounds(round);
        box.add(glm::dmat4(1), all.lo);
        box.add(glm::dmat4(1), all.hi);
    }
    /// Returns the corners of a mesh's bounds. Their images bound the mesh's image.
    const std::array<glm::dvec3, 8>& corners_of(std::uint32_t number) {
        const auto [found, is_new] = corners_.try_emplace(number);
        if (!is_new) return found->second;
        const SharedMesh& mesh = *parts_.meshes[number];
        Growing box;
        for (const Triangle& triangle : mesh.triangles)
            for (const std::uint32_t index : triangle.vertex) box.add(glm::dmat4(1), mesh.vertices[index]);
        if (const Bounds* all = parts_.deforms(number))
            box.add(glm::dmat4(1), all->lo), box.add(glm::dmat4(1), all->hi);
        std::array<glm::dvec3, 8>& corners = found->second;
        for (int c = 0; c < 8; ++c)
            for (int k = 0; k < 3; ++k) corners[std::size_t(c)][k] = c >> k & 1 ? box.hi[k] : box.lo[k];
        return corners;
    }

    Lattice scene_lattice(double margin) const {
        const glm::dvec3 middle = 0.5 * bounds_.lo + 0.5 * bounds_.hi;
        const double room = largest_ / (largest_ - margin);
        Scene corners;
        corners.vertices = {bounds_.lo, bounds_.hi};
        if (margin > 0)
            for (glm::dvec3& corner : corners.vertices) corner = middle + room * (corner - middle);
        corners.triangles = {{{0, 1, 1}, 0}};
        if (parts_.round) corners.planes = parts_.round->planes;
        return fit_lattice(corners, eyes_[0], config_.coord_bits, config_.shading,
                           parts_.round ? room_around_planes(*parts_.round, config_) : 1);
    }

    /// Computes lattice, classes and maps. Returns the number of steps by which boxes reach beyond the range
    /// of a node, at the worst time.
    double map(double margin) {
        maps_ = {};
        maps_.lattice = scene_lattice(margin);
        sort_into_classes();
        make_lattices();
        double beyond = 0;
        // The first time comes last, so its map stays.
        for (std::size_t i = 0; i < parts_.instances.size(); ++i)
            for (std::size_t t = moves_[i] ? times_.size() : 1; t-- > 0;)
                beyond = std::max(beyond, map_one(i, t));
        return beyond;
    }

    double map_one(std::size_t i, std::size_t t) {
        InstanceMap& map = maps_.instances[i];
        const MeshClass& made = maps_.classes[map.mesh_class];
        const FittedMap fitted = fit(seen_at(i, t), made, config_, moves_[i] || is_large_ || made.deforms);
        map = fitted.map;
        map.mesh_class = class_[i];
        if (fitted.stretched && !is_out_[i]) is_out_[i] = written_out_ = true;
        return fitted.stretched ? 0 : fitted.beyond;
    }

    LatticeInMesh seen_at(std::size_t i, std::size_t t) const {
        return lattice_in_mesh(is_out_[i] ? glm::dmat4(1) : times_[t][i], maps_.lattice);
    }

    void sort_into_classes() {
        needs_.clear();
        class_.clear();
        std::vector<std::vector<std::uint32_t>> of_mesh(parts_.meshes.size());
        for (std::size_t i = 0; i < parts_.instances.size(); ++i) {
            const Instance& instance = parts_.instances[i];
            const std::size_t times = moves_[i] ? times_.size() : 1;
            for (std::size_t t = 0; t < times; ++t)
                if (!is_usable(seen_at(i, t))) is_out_[i] = true;
            Needs own = needs_of(seen_at(i, 0));
            for (std::size_t t = 1; t < times; ++t) add(own, needs_of(seen_at(i, t)));
            std::vector<std::uint32_t>& known = of_mesh[instance.mesh];
            const bool has_normals = config_.shading && !parts_.meshes[instance.mesh]->normals.empty();
            const glm::dmat3 normal_map =
                is_out_[i] || !has_normals ? glm::dmat3(1) : cofactors_of(times_[0][i]);
            const auto found =
                is_out_[i] ? known.end() : std::find_if(known.begin(), known.end(), [&](std::uint32_t c) {
                    return fits(needs_[c], own) && stretch_alike(maps_.classes[c].normal_map, normal_map);
                });
            const std::uint32_t at = found != known.end() ? *found : std::uint32_t(needs_.size());
            if (found == known.end()) {
                if (!is_out_[i]) known.push_back(at);
                needs_.push_back(own);
                maps_.classes.push_back({instance.mesh,
                                         is_out_[i] ? times_[0][i] : glm::dmat4(1),
                                         {},
                                         {},
                                         {},
                                         0,
                                         {},
                                         false,
                                         normal_map});
            }
            add(needs_[at], own);
            class_.push_back(at);
            maps_.instances.push_back({at, {}, {}, false, false, 0, {}});
        }
    }

    static bool is_usable(const LatticeInMesh& seen) {
        constexpr double most = 1e200;
        return glm::all(glm::lessThan(seen.step, glm::dvec3(most))) &&
               glm::all(glm::lessThan(glm::abs(seen.middle), glm::dvec3(most)));
    }

    Needs needs_of(const LatticeInMesh& seen) const {
        return {seen.step, seen.step, seen.middle - largest_ * seen.step, seen.middle + largest_ * seen.step,
                true,      seen};
    }

    static bool fits(const Needs& needs, const Needs& more) {
        const glm::dvec3 least = glm::min(needs.least, more.least), most = glm::max(needs.most, more.most);
        return glm::all(glm::lessThanEqual(most, 2.0 * least));
    }

    static void add(Needs& needs, const Needs& more) {
        needs.is_one = needs.is_one && more.is_one && more.seen.middle == needs.seen.middle &&
                       more.seen.step == needs.seen.step;
        needs.least = glm::min(needs.least, more.least);
        needs.most = glm::max(needs.most, more.most);
        needs.lo = glm::min(needs.lo, more.lo);
        needs.hi = glm::max(needs.hi, more.hi);
    }

    /// Sets each class's lattice: the smallest one that covers the members' lattices. If all members see the
    /// same lattice, it is theirs to the bit.
    void make_lattices() {
        for (std::size_t c = 0; c < needs_.size(); ++c) {
            const Needs& needs = needs_[c];
            MeshClass& made = maps_.classes[c];
            made.lattice = {0.5 * needs.lo + 0.5 * needs.hi, (needs.hi - needs.lo) / (2 * largest_),
                            config_.coord_bits};
            if (needs.is_one) made.lattice.centre = needs.seen.middle, made.lattice.pitch = needs.seen.step;
            const SharedMesh& mesh = *parts_.meshes[made.mesh];
            made.deforms = parts_.deforms(made.mesh) != nullptr;
            if (made.deforms)
                take_room(made);
            else
                take_shape(made, mesh, config_);
            if (parts_.is_round(made.mesh)) hold_round(made);
        }
    }

    /// Sets the corners of a box around the spheres. Planes are everywhere.
    void hold_round(MeshClass& made) const {
        LatticeBox box;
        for (const PrimData& prim : snapped(parts_, made, config_)) box.add(box_of(prim, config_.coord_bits));
        if (box.lo[0] <= box.hi[0]) made.points = {box.lo, box.hi};
        made.reach = reach_of(made);
    }

    /// Sets, for a mesh that deforms, the corners of its bounds at all times, enlarged by the corners' error
    /// on the lattice.
    void take_room(MeshClass& made) {
        const std::int32_t off = config_.shading ? 1 << max_fine : 1;
        LatticeBox box;
        for (const glm::dvec3& corner : corners_of(made.mesh))
            box.add(made.lattice.snap(glm::dvec3(made.before * glm::dvec4(corner, 1))));
        for (int c = 0; c < 8; ++c) {
            Vec3i& point = made.points.emplace_back();
            for (std::size_t k = 0; k < 3; ++k) point[k] = c >> k & 1 ? box.hi[k] + off : box.lo[k] - off;
        }
        for (std::size_t k = 0; k < 3; ++k)
            made.longest = std::max(made.longest, box.hi[k] - box.lo[k] + 2 * off);
        made.reach = reach_of(made);
    }

    const LevelParts& parts_;
    std::span<const InstancePlaces> times_;
    std::span<const glm::dvec3> eyes_;
    const Config& config_;
    const double largest_;       // L
    std::vector<bool> is_out_;   // by instance: it is written out
    std::vector<bool> moves_;
    bool is_large_ = false;
    std::map<std::uint32_t, std::array<glm::dvec3, 8>> corners_;   // by mesh
    bool written_out_ = false;                                     // another one was found
    bool all_out_ = false;
    Bounds bounds_;
    LevelMaps maps_;
    std::vector<std::uint32_t> class_;
    std::vector<Needs> needs_;
};

/// Aligns large triangles as in a flat scene; see align_large_triangles() in surfaces.hpp.
void align(MeshClass& made, const SharedMesh& mesh) {
    Scene scene;
    for (const glm::dvec3& at : mesh.vertices)
        scene.vertices.push_back(glm::dvec3(made.before * glm::dvec4(at, 1)));
    scene.triangles = mesh.triangles;
    if (std::optional<Scene> moved = align_large_triangles(scene, made.lattice))
        made.corners = std::move(moved->vertices);
}

}   // namespace

void take_shape(MeshClass& made, const SharedMesh& mesh, const Config& config) {
    made.corners.clear(), made.points.clear();
    made.longest = 0;
    if (config.shading) align(made, mesh);
    std::vector<Vec3i> at(mesh.vertices.size());
    for (std::size_t i = 0; i < at.size(); ++i) at[i] = snapped_corner(made, mesh, std::uint32_t(i));
    std::vector<bool> is_used(at.size());
    for (const Triangle& triangle : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3i &from = at[triangle.vertex[k]], &to = at[triangle.vertex[(k + 1) % 3]];
            for (std::size_t i = 0; i < 3; ++i)
                made.longest = std::max(made.longest, std::abs(to[i] - from[i]));
            is_used[triangle.vertex[k]] = true;
        }
    for (std::size_t i = 0; i < at.size(); ++i)
        if (is_used[i]) made.points.push_back(at[i]);
    std::sort(made.points.begin(), made.points.end());
    made.points.erase(std::unique(made.points.begin(), made.points.end()), made.points.end());
    made.reach = reach_of(made);
}

Vec3i snapped_corner(const MeshClass& made, const SharedMesh& mesh, std::uint32_t index) {
    if (!made.corners.empty()) return made.lattice.snap(made.corners[index]);
    return made.lattice.snap(glm::dvec3(made.before * glm::dvec4(mesh.vertices[index], 1)));
}

LevelMaps map_instances(const LevelParts& parts, const glm::dvec3& eye, const Config& config) {
    InstancePlaces places;
    for (const Instance& instance : parts.instances) places.push_back(instance.place);
    Mapper mapper(parts, std::span(&places, 1), std::span(&eye, 1), config);
    mapper.run();
    return mapper.take();
}

std::optional<LevelMaps> map_moving(const LevelParts& parts, std::span<const InstancePlaces> times,
                                    std::span<const glm::dvec3> eyes, const Config& config) {
    Mapper mapper(parts, times, eyes, config);
    if (!mapper.run()) return {};
    return mapper.take();
}

InstanceMap map_at(const glm::dmat4& place, std::uint32_t mesh_class, const LevelMaps& maps,
                   const Config& config) {
    const MeshClass& made = maps.classes[mesh_class];
    InstanceMap map = fit(lattice_in_mesh(place, maps.lattice), made, config, true).map;
    map.mesh_class = mesh_class;
    return map;
}

}   // namespace rayclock
