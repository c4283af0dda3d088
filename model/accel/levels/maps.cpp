#include "model/accel/levels/maps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/accel/surfaces.hpp"
#include "model/base/error.hpp"

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace rayclock {
namespace {

/// The scene's lattice seen from a mesh: its middle, and for each axis of the mesh what a step along each of
/// the scene's axes is there.
struct Seen {
    glm::dvec3 middle{0};
    std::array<glm::dvec3, 3> row{};
    glm::dvec3 step{0};   ///< of each row, the sum of sizes: how far one step along all axes reaches
};

Seen seen_from(const glm::dmat4& place, const Lattice& lattice) {
    const glm::dmat3 back = glm::inverse(glm::dmat3(place));
    Seen seen;
    seen.middle = back * (lattice.centre - glm::dvec3(place[3]));
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
            seen.row[std::size_t(i)][k] = back[k][i] * lattice.pitch[k];
            seen.step[i] += std::abs(seen.row[std::size_t(i)][k]);
        }
    return seen;
}

/// What a class's members need of its lattice.
struct Needs {
    glm::dvec3 least{0}, most{0};   ///< steps of the members
    glm::dvec3 lo{0}, hi{0};
    bool is_one = true;   ///< all members see the same
    Seen seen;
};

class Mapper {
public:
    Mapper(const LevelParts& parts, const glm::dvec3& eye, const Config& config)
        : parts_(parts),
          eye_(eye),
          config_(config),
          largest_(double((1 << (config.coord_bits - 1)) - 1)),
          is_out_(parts.instances.size()) {}

    /// Boxes may reach beyond the lattice by what is rounded: then it gets a margin.
    LevelMaps run() {
        find_bounds();
        for (double margin = 0;;) {
            written_out_ = false;
            const double beyond = map(margin);
            if (written_out_) continue;   // once more, with more instances written out
            if (beyond <= 0) return std::move(maps_);
            margin += beyond + 1;
            if (margin < largest_ / 4) continue;
            // Not seen yet. What is written out rounds nothing, and needs no margin but that of secondary
            // rays.
            if (all_out_)
                throw UserError("two levels need more origin_bits than " +
                                std::to_string(config_.origin_bits) + " for secondary rays on this lattice");
            is_out_.assign(is_out_.size(), true);
            all_out_ = true;
            margin = 0;
        }
    }

private:
    void find_bounds() {
        constexpr double far = std::numeric_limits<double>::infinity();
        Bounds box{glm::dvec3(far), glm::dvec3(-far)};
        for (const Instance& instance : parts_.instances) {
            const SharedMesh& mesh = *parts_.meshes[instance.mesh];
            for (const Triangle& triangle : mesh.triangles)
                for (const std::uint32_t index : triangle.vertex) {
                    const auto point = glm::dvec3(instance.place * glm::dvec4(mesh.vertices[index], 1));
                    box.lo = glm::min(box.lo, point);
                    box.hi = glm::max(box.hi, point);
                }
        }
        bounds_ = {glm::min(box.lo, eye_), glm::max(box.hi, eye_)};
    }

    Lattice scene_lattice(double margin) const {
        const glm::dvec3 middle = 0.5 * bounds_.lo + 0.5 * bounds_.hi;
        const double room = largest_ / (largest_ - margin);
        Scene corners;
        corners.vertices = {bounds_.lo, bounds_.hi};
        if (margin > 0)
            for (glm::dvec3& corner : corners.vertices) corner = middle + room * (corner - middle);
        corners.triangles = {{{0, 1, 1}, 0}};
        return fit_lattice(corners, eye_, config_.coord_bits, config_.shading != 0);
    }

    /// All of it; returns by how many steps boxes reach beyond what a node can say.
    double map(double margin) {
        maps_ = {};
        maps_.lattice = scene_lattice(margin);
        sort_into_classes();
        make_lattices();
        double beyond = 0;
        for (std::size_t i = 0; i < parts_.instances.size(); ++i)
            beyond = std::max(beyond, map_one(i, maps_.instances[i], seen_[i]));
        return beyond;
    }

    void sort_into_classes() {
        seen_.clear();
        needs_.clear();
        std::vector<std::vector<std::uint32_t>> of_mesh(parts_.meshes.size());
        for (std::size_t i = 0; i < parts_.instances.size(); ++i) {
            const Instance& instance = parts_.instances[i];
            Seen seen = seen_from(instance.place, maps_.lattice);
            if (!is_usable(seen)) is_out_[i] = true;
            if (is_out_[i]) seen = seen_from(glm::dmat4(1), maps_.lattice);
            seen_.push_back(seen);
            std::vector<std::uint32_t>& known = of_mesh[instance.mesh];
            const auto found =
                is_out_[i] ? known.end() : std::find_if(known.begin(), known.end(), [&](std::uint32_t c) {
                    return fits(needs_[c], seen);
                });
            const std::uint32_t at = found != known.end() ? *found : std::uint32_t(needs_.size());
            if (found == known.end()) {
                if (!is_out_[i]) known.push_back(at);
                needs_.push_back({seen.step, seen.step, seen.middle, seen.middle, true, seen});
                maps_.classes.push_back(
                    {instance.mesh, is_out_[i] ? instance.place : glm::dmat4(1), {}, {}, {}, 0});
            }
            add(needs_[at], seen);
            maps_.instances.push_back({at, {}, {}, false, 0, {}});
        }
    }

    static bool is_usable(const Seen& seen) {
        constexpr double most = 1e200;
        return glm::all(glm::lessThan(seen.step, glm::dvec3(most))) &&
               glm::all(glm::lessThan(glm::abs(seen.middle), glm::dvec3(most)));
    }

    static bool fits(const Needs& needs, const Seen& seen) {
        const glm::dvec3 least = glm::min(needs.least, seen.step), most = glm::max(needs.most, seen.step);
        return glm::all(glm::lessThanEqual(most, 2.0 * least));
    }

    void add(Needs& needs, const Seen& seen) const {
        needs.is_one = needs.is_one && seen.middle == needs.seen.middle && seen.step == needs.seen.step;
        needs.least = glm::min(needs.least, seen.step);
        needs.most = glm::max(needs.most, seen.step);
        needs.lo = glm::min(needs.lo, seen.middle - largest_ * seen.step);
        needs.hi = glm::max(needs.hi, seen.middle + largest_ * seen.step);
    }

    /// The smallest lattice that covers what all members see; to the bit theirs, if all see the same.
    void make_lattices() {
        for (std::size_t c = 0; c < needs_.size(); ++c) {
            const Needs& needs = needs_[c];
            MeshClass& made = maps_.classes[c];
            made.lattice = {0.5 * needs.lo + 0.5 * needs.hi, (needs.hi - needs.lo) / (2 * largest_),
                            config_.coord_bits};
            if (needs.is_one) made.lattice.centre = needs.seen.middle, made.lattice.pitch = needs.seen.step;
            const SharedMesh& mesh = *parts_.meshes[made.mesh];
            if (config_.shading) align(made, mesh);
            for (const Triangle& triangle : mesh.triangles)
                for (std::size_t k = 0; k < 3; ++k) {
                    const Vec3i from = snapped_corner(made, mesh, triangle.vertex[k]),
                                to = snapped_corner(made, mesh, triangle.vertex[(k + 1) % 3]);
                    for (std::size_t i = 0; i < 3; ++i)
                        made.longest = std::max(made.longest, std::abs(to[i] - from[i]));
                }
            std::vector<bool> is_used(mesh.vertices.size());
            for (const Triangle& triangle : mesh.triangles)
                for (const std::uint32_t index : triangle.vertex) is_used[index] = true;
            for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
                if (is_used[i]) made.points.push_back(snapped_corner(made, mesh, std::uint32_t(i)));
            std::sort(made.points.begin(), made.points.end());
            made.points.erase(std::unique(made.points.begin(), made.points.end()), made.points.end());
        }
    }

    /// As in a flat scene; see there.
    static void align(MeshClass& made, const SharedMesh& mesh) {
        Scene scene;
        for (const glm::dvec3& at : mesh.vertices)
            scene.vertices.push_back(glm::dvec3(made.before * glm::dvec4(at, 1)));
        scene.triangles = mesh.triangles;
        if (std::optional<Scene> moved = aligned(scene, made.lattice))
            made.corners = std::move(moved->vertices);
    }

    /// Returns by how many steps its box reaches beyond what a node can say.
    double map_one(std::size_t number, InstanceMap& map, const Seen& seen) {
        const MeshClass& made = maps_.classes[map.mesh_class];
        const int frac = config_.map_frac();
        const std::int64_t one = std::int64_t(1) << frac;
        map.is_whole = true;
        glm::dmat3 linear;   // as stored
        glm::dvec3 moved;
        for (std::size_t i = 0; i < 3; ++i) {
            const double unit = std::ldexp(1, frac) / made.lattice.pitch[int(i)];
            std::array<double, 3> exact;
            std::int64_t sum = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                exact[k] = seen.row[i][int(k)] * unit;
                sum += std::abs(std::llround(exact[k]));
            }
            for (std::size_t k = 0; k < 3; ++k) {
                const double entry = sum > one ? std::trunc(exact[k]) : std::round(exact[k]);
                map.a[3 * i + k] = std::int32_t(entry);
                linear[int(k)][int(i)] = std::ldexp(entry, -frac);
                map.is_whole = map.is_whole && map.a[3 * i + k] % one == 0;
            }
            map.b[i] = std::llround((seen.middle[int(i)] - made.lattice.centre[int(i)]) * unit);
            moved[int(i)] = std::ldexp(double(map.b[i]), -frac);
            map.is_whole = map.is_whole && map.b[i] % one == 0;
        }
        return place_box(number, made, linear, moved, map);
    }

    /// The box of the mesh's corners as the stored map places them, with what a hit may be off around each:
    /// a triangle lies within its corners' box, and so do the triangle's points, each with that around it.
    double place_box(std::size_t number, const MeshClass& made, const glm::dmat3& linear,
                     const glm::dvec3& moved, InstanceMap& map) {
        const glm::dmat3 back = glm::inverse(linear);
        glm::dvec3 reach(0);   // of a step in the mesh
        for (int i = 0; i < 3; ++i)
            reach[i] = std::abs(back[0][i]) + std::abs(back[1][i]) + std::abs(back[2][i]);
        const double stretch = std::max({reach.x, reach.y, reach.z});   // alpha
        const double shortest = std::ldexp(1, config_.dir_bits - 2);    // of a direction's largest component
        if (!(stretch <= most_stretch)) {
            is_out_[number] = written_out_ = true;
            return 0;
        }
        const double last = (2 * largest_ + 1.25 * stretch + 1) / (shortest - stretch / 2);
        map.off = map.is_whole ? 0 : 0.5 + 0.5 * last;
        if (config_.shading) map.off = off_of_secondary(made, map.is_whole, stretch);
        constexpr double far = std::numeric_limits<double>::infinity();
        glm::dvec3 lo(far), hi(-far);
        for (const Vec3i& point : made.points) {
            const glm::dvec3 placed = back * (glm::dvec3(point[0], point[1], point[2]) - moved);
            lo = glm::min(lo, placed);
            hi = glm::max(hi, placed);
        }
        const double slack = map.is_whole ? 0 : 1.0 / 64;   // of double arithmetic here
        double beyond = 0;
        for (int i = 0; i < 3; ++i) {
            const double least = std::floor(lo[i] - reach[i] * map.off - slack),
                         most = std::ceil(hi[i] + reach[i] * map.off + slack);
            beyond = std::max({beyond, -(largest_ + 1) - least, most - (largest_ + 1)});
            map.box.lo[std::size_t(i)] = std::int32_t(least);
            map.box.hi[std::size_t(i)] = std::int32_t(most);
        }
        return beyond;
    }

    /// The same for all rays of a chip that shades, bounce after bounce: docs/motion.md, Secondary rays.
    /// Where a ray leaves the instance again, it begins as far off as it was when it met it, and a little
    /// more.
    double off_of_secondary(const MeshClass& made, bool is_whole, double stretch) const {
        const double frac = std::ldexp(1, -config_.origin_bits), slope = is_whole ? 0 : 0.5,
                     camera = std::ldexp(1, config_.dir_bits - 2), bounce = 0.57 * camera;
        const auto reach = [&](double begin, double shortest) {   // S, of a ray that begins so far off
            return (2 * largest_ + 2 + stretch * (1.25 + begin)) / (shortest - slope * stretch);
        };
        const double anew = std::ldexp(1, -config_.t_frac_bits) + frac + 1.25 + 2.5 * frac * made.longest;
        double off = frac + slope * reach(frac, camera);
        for (int bounces = 0; bounces <= config_.bounces; ++bounces) {
            const double begin = off + anew;
            off = begin + slope * reach(begin, bounce);
        }
        return off;
    }

    const LevelParts& parts_;
    const glm::dvec3 eye_;
    const Config& config_;
    const double largest_;       // L
    std::vector<bool> is_out_;   // by instance: it is written out
    bool written_out_ = false;   // one more was found
    bool all_out_ = false;
    Bounds bounds_;
    LevelMaps maps_;
    std::vector<Seen> seen_;
    std::vector<Needs> needs_;
};

}   // namespace

Vec3i snapped_corner(const MeshClass& made, const SharedMesh& mesh, std::uint32_t index) {
    if (!made.corners.empty()) return made.lattice.snap(made.corners[index]);
    return made.lattice.snap(glm::dvec3(made.before * glm::dvec4(mesh.vertices[index], 1)));
}

LevelMaps map_instances(const LevelParts& parts, const glm::dvec3& eye, const Config& config) {
    return Mapper(parts, eye, config).run();
}

}   // namespace rayclock
