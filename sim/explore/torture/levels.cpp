// Builds torture images with instances.
#include "sim/explore/torture/levels.hpp"

#include <cmath>
#include <cstdlib>

#include "model/base/axes.hpp"
#include "model/compile/compile.hpp"
#include "model/compile/emit.hpp"
#include "model/compile/levels/upper.hpp"
#include "model/layout/words.hpp"
#include "sim/explore/torture/textures.hpp"

namespace rayclock::torture {

namespace {

/// An instance: its mesh and map. Every corner of its mesh is the scene's, moved by the map and rounded.
struct Standing {
    std::size_t mesh = 0;
    InstanceMap map;
};

/// Rows of an instance's map as fractions, signed.
using Rows = std::array<std::array<double, 3>, 3>;

/// Returns a random permutation of the axes with random signs, which needs no rounding.
Rows quarters(Dice& dice) {
    Rows rows{};
    const auto first = std::size_t(dice.below(3));
    const std::size_t step = dice.percent(50) ? 1 : 2;
    for (std::size_t k = 0; k < 3; ++k) rows[k][(first + step * k) % 3] = dice.percent(50) ? 1 : -1;
    return rows;
}

/// Returns a random rotation, made from a quaternion.
Rows turned(Dice& dice) {
    double q[4], square = 0;
    do {
        square = 0;
        for (double& x : q) x = dice.between(-9, 9), square += x * x;
    } while (square == 0);
    const double w = q[0], x = q[1], y = q[2], z = q[3], s = 2 / square;
    return {{{1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w)},
             {s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w)},
             {s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y)}}};
}

double longest_row(const Rows& rows) {
    double most = 0;
    for (const auto& row : rows)
        most = std::max(most, std::abs(row[0]) + std::abs(row[1]) + std::abs(row[2]));
    return most;
}

/// Truncates the rows to integers, so the magnitudes of a row sum to at most 1.
InstanceMap map_of(const Rows& rows, double scale, const Config& config) {
    InstanceMap map;
    const double one = std::ldexp(1.0, config.map_frac());
    for (std::size_t i = 0; i < 9; ++i) map.a[i] = std::int32_t(rows[i / 3][i % 3] * scale * one);
    return map;
}

/// Moves the mesh, often as far as possible. Every point of the scene's lattice must stay within the mesh's
/// lattice.
void push_away(InstanceMap& map, Dice& dice, const Config& config) {
    const std::int64_t one = std::int64_t(1) << config.map_frac(), most = max_of(config.coord_bits);
    for (std::size_t k = 0; k < 3; ++k) {
        std::int64_t row = 0;
        for (std::size_t i = 0; i < 3; ++i) row += std::abs(std::int64_t(map.a[3 * k + i]));
        const std::int64_t free = (one - row) * most, part = dice.between(-8, 8);
        map.b[k] = free / 8 * part;
    }
}

Vec3i moved(const InstanceMap& map, const Vec3i& p, const Config& config) {
    return by_axis([&](std::size_t k) {
        std::int64_t sum = map.b[k] + (std::int64_t(1) << (config.map_frac() - 1));
        for (std::size_t i = 0; i < 3; ++i) sum += std::int64_t(map.a[3 * k + i]) * p[i];
        return std::int32_t(sum >> config.map_frac());
    });
}

class PlacedImage {
public:
    PlacedImage(const std::vector<PrimData>& prims, const Config& config, Dice& dice, const std::string& name,
                SurfaceStyle style)
        : config_(config), dice_(dice), name_(name), style_(style), textures_(config, dice, style) {
        std::vector<PrimData> cut = prims;
        textures_.make_cutouts(cut);
        deal(cut);
    }

    MemoryImage make() {
        for (const std::vector<PrimData>& mesh : meshes_)
            lowers_.push_back(compile_triangles(mesh, config_.lower(), name_));
        std::vector<UpperEntry> entries;
        std::uint32_t number = 0;
        for (const Standing& standing : standings_) {
            const MemoryImage& lower = lowers_[standing.mesh];
            entries.push_back({&standing.map, number, 0, 0, 0, lower.report.stack_need, lower.report.depth});
            number += std::uint32_t(meshes_[standing.mesh].size());
        }
        std::vector<PlacedEntry> placed;
        const UpperReport report =
            write_upper(entries, 0, true, config_.upper(), name_, image_.words, placed);
        check_stack(report.stack_need, config_, name_);
        leave_room();
        image_.first_mesh_line = image_.lines();
        for (MemoryImage& lower : lowers_) append(lower);
        if (config_.shading) textures_.append(image_.words);
        image_.first_surface_line = image_.lines();
        if (config_.shading) append_surfaces(entries);
        for (std::size_t i = 0; i < entries.size(); ++i) entries[i].root = roots_[standings_[i].mesh];
        write_entries(entries, placed, config_, image_.words);
        check_lines(image_.lines(), config_, name_);
        image_.lattice.coord_bits = config_.coord_bits;
        image_.primitives = number;
        return std::move(image_);
    }

private:
    /// Deals the primitives to three meshes. The first has the identity map, and all spheres and planes. The
    /// second is turned by quarters, the third by any angle.
    void deal(const std::vector<PrimData>& prims) {
        std::array<std::vector<PrimData>, 3> dealt;
        for (const PrimData& prim : prims)
            dealt[prim.is_triangle() ? std::size_t(dice_.below(3)) : 0].push_back(prim);
        InstanceMap same = map_of({{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 1, config_),
                    whole = map_of(quarters(dice_), 1, config_);
        same.is_same = same.is_whole = whole.is_whole = true;
        add_mesh(dealt[0], same);
        add_mesh(dealt[1], whole);
        const Rows rows = turned(dice_);
        add_mesh(dealt[2], map_of(rows, 1 / longest_row(rows), config_));
        for (int again = dice_.below(3); again > 0; --again) stand_again();
    }

    /// Returns the primitives in the space of the map. A mesh that is turned by any angle is a little
    /// smaller, so rounding moves no point beyond the scene's lattice.
    void add_mesh(const std::vector<PrimData>& prims, InstanceMap map) {
        std::vector<PrimData> mesh;
        map.box = {};
        for (PrimData prim : prims) {
            if (!map.is_whole)
                for (Vec3i* corner : {&prim.a, &prim.b, &prim.c})
                    for (auto& x : *corner) x -= x / 8;
            const LatticeBox box = boxes_of({prim}, config_)[0];
            if (!map.is_same)
                for (Vec3i* corner : {&prim.a, &prim.b, &prim.c}) *corner = moved(map, *corner, config_);
            if (!counts(prim, config_)) continue;
            prim.prim = std::uint32_t(mesh.size());
            mesh.push_back(prim);
            map.box.add(box);
        }
        if (mesh.empty()) return;
        if (!map.is_whole) grow(map.box, 8);
        standings_.push_back({meshes_.size(), map});
        meshes_.push_back(std::move(mesh));
    }

    /// Repeats a mesh of triangles. If the chip shades, a ray's point must also lie on the scene's lattice,
    /// which only quarter turns guarantee.
    void stand_again() {
        const std::size_t mesh = std::size_t(dice_.below(int(meshes_.size())));
        for (const PrimData& prim : meshes_[mesh])
            if (!prim.is_triangle()) return;
        const Rows rows = config_.shading ? quarters(dice_) : turned(dice_);
        const double half = config_.shading ? 1 : std::ldexp(1.0, -dice_.below(4));
        InstanceMap map = map_of(rows, half / longest_row(rows), config_);
        if (!config_.shading) push_away(map, dice_, config_);
        const std::int32_t most = max_of(config_.coord_bits);
        map.box = {{-most, -most, -most}, {most, most, most}};
        standings_.push_back({mesh, map});
    }

    void grow(LatticeBox& box, std::int32_t by) const {
        const std::int32_t most = max_of(config_.coord_bits);
        for (std::size_t k = 0; k < 3; ++k) {
            box.lo[k] = std::max(box.lo[k] - by, -most);
            box.hi[k] = std::min(box.hi[k] + by, most);
        }
    }

    void leave_room() {
        // An upper bound of the lines that follow.
        std::size_t lines = config_.shading ? standings_.size() + textures_.lines() : 0;
        for (std::size_t m = 0; m < meshes_.size(); ++m)
            lines += lowers_[m].lines() + (config_.shading ? meshes_[m].size() : 0);
        const std::size_t all = std::size_t(1) << config_.addr_bits, used = image_.lines();
        const std::size_t wanted[] = {used, 300, lines < all ? all - lines : used};
        const std::size_t first = wanted[dice_.below(3)];
        if (first > used && first + lines <= all) image_.words.resize(first * words_per_line, 0);
    }

    void append(const MemoryImage& lower) {
        const std::uint32_t root = image_.lines();
        roots_.push_back(root);
        image_.words.insert(image_.words.end(), lower.words.begin(), lower.words.end());
        move_nodes(image_.words, root, config_.lower_engine(), config_);
    }

    void append_surfaces(std::vector<UpperEntry>& entries) {
        std::vector<std::uint32_t> first;
        for (const std::vector<PrimData>& mesh : meshes_) {
            first.push_back(image_.lines());
            for (const PrimData& prim : mesh) append_surface(prim);
        }
        for (std::size_t i = 0; i < entries.size(); ++i) {
            entries[i].first_surface_line = first[standings_[i].mesh] - entries[i].first;
            if (dice_.percent(75) || style_ == SurfaceStyle::holes) continue;
            entries[i].material = image_.lines();
            append_surface(PrimData{});
        }
    }
    void append_surface(const PrimData& prim) {
        Surface surface = random_surface(prim, config_, dice_, style_);
        surface.record = textures_.record_for(prim);   // ignored in an instance's material
        append_line(surface, config_, image_.words);
    }

    const Config& config_;
    Dice& dice_;
    const std::string name_;
    SurfaceStyle style_;
    Textures textures_;
    std::vector<std::vector<PrimData>> meshes_;
    std::vector<Standing> standings_;
    std::vector<MemoryImage> lowers_;    // by mesh
    std::vector<std::uint32_t> roots_;   // by mesh
    MemoryImage image_;
};

}   // namespace

MemoryImage placed_image(const std::vector<PrimData>& prims, const Config& config, Dice& dice,
                         const std::string& name, SurfaceStyle style) {
    return PlacedImage(prims, config, dice, name, style).make();
}

}   // namespace rayclock::torture
