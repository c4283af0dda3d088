// compile_scene: lattice, tree, image, in that order.
#include "model/compile/compile.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <mutex>

#include <tbb/parallel_for.h>
#include <glm/geometric.hpp>

#include "model/base/error.hpp"
#include "model/base/stopwatch.hpp"
#include "model/compile/emit.hpp"
#include "model/compile/lattice.hpp"
#include "model/compile/levels/levels.hpp"
#include "model/compile/plane.hpp"
#include "model/compile/surfaces.hpp"
#include "model/compile/textures.hpp"
#include "model/core/parameters.hpp"
#include "model/engine/bvh/build.hpp"
#include "model/engine/bvh/splits.hpp"
#include "model/engine/engines.hpp"
#include "model/unit/tri/vectors.hpp"

namespace rayclock {

namespace {

/// True if the triangle has area on the lattice; without area it takes no ray. Exact, as the cross product
/// has at most 2 (N + 1) + 1 bits.
bool has_area(const PrimData& t) {
    const Vec3l u = minus(t.b, t.a), v = minus(t.c, t.a);
    return u[1] * v[2] != u[2] * v[1] || u[2] * v[0] != u[0] * v[2] || u[0] * v[1] != u[1] * v[0];
}

/// Returns the primitives that count on the lattice, in the scene's order.
std::vector<PrimData> snap_primitives(const Scene& scene, const Lattice& lattice, const Config& config) {
    std::vector<PrimData> all(primitive_count(scene));
    tbb::parallel_for(std::size_t(0), all.size(),
                      [&](std::size_t i) { all[i] = snap_primitive(scene, lattice, i); });
    std::erase_if(all, [&](const PrimData& t) { return !counts(t, config); });
    mark_cutouts(scene.triangles, scene.coordinates, scene.materials, config, all);
    return all;
}

}   // namespace

/// Returns a box that fills the lattice for a plane. A sphere's box holds all its points that lie in the
/// lattice.
LatticeBox box_of(const PrimData& prim, int coord_bits) {
    const std::int32_t most = (1 << (coord_bits - 1)) - 1;
    if (prim.kind == PrimKind::plane) return {{-most, -most, -most}, {most, most, most}};
    const std::uint64_t square = radius_squared(prim, coord_bits);
    auto radius = std::int32_t(std::sqrt(double(square)));
    while (std::uint64_t(radius) * std::uint64_t(radius) < square) ++radius;
    LatticeBox box;
    for (std::size_t k = 0; k < 3; ++k)
        box.lo[k] = std::max(prim.a[k] - radius, -most), box.hi[k] = std::min(prim.a[k] + radius, most);
    return box;
}

/// Returns the boxes of primitives. The sheared test may err by one step (model/unit/tri/sheared.hpp), so
/// its boxes are a step larger. Lattice::snap leaves out the least coordinate, so their lower corners still
/// fit N bits; upper planes are relative to these.
std::vector<LatticeBox> boxes_of(const std::vector<PrimData>& triangles, const Config& config) {
    std::vector<LatticeBox> boxes(triangles.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (!triangles[i].is_triangle()) {
            boxes[i] = box_of(triangles[i], config.coord_bits);
            continue;
        }
        for (const Vec3i& point : {triangles[i].a, triangles[i].b, triangles[i].c}) boxes[i].add(point);
        if (!config.is_sheared()) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            --boxes[i].lo[k];
            ++boxes[i].hi[k];
        }
    }
    return boxes;
}

/// Refuses a scene that has only triangles, all of zero area.
void check_visible(const Scene& scene, const std::string& name) {
    const bool is_invisible =
        scene.spheres.empty() && scene.planes.empty() &&
        std::all_of(scene.triangles.begin(), scene.triangles.end(), [&](const Triangle& t) {
            const glm::dvec3 a = scene.vertices[t.vertex[0]];
            return glm::cross(scene.vertices[t.vertex[1]] - a, scene.vertices[t.vertex[2]] - a) ==
                   glm::dvec3(0);
        });
    if (is_invisible)
        throw UserError(name +
                        ": every surface is invisible: it is left out, or has no area. A machine cannot hold "
                        "an empty scene; "
                        "render --engine reference draws its background");
}

void check_kept(const std::vector<PrimData>& kept, const Scene& scene, const Config& config,
                const std::string& name) {
    const std::size_t all = primitive_count(scene);
    if (kept.empty()) check_visible(scene, name);
    if (kept.empty())
        throw UserError(name + ": all " + std::to_string(all) +
                        (all == scene.triangles.size() ? " triangles" : " primitives") +
                        " vanish on a lattice of " + std::to_string(config.coord_bits) +
                        " bits; a larger coord_bits or an eye closer to the scene would help");
    check_lines(kept.size() / 2, config, name);   // before the long work: at best two triangles per line
    const auto need = int(std::bit_width(all - 1));
    if (need > config.prim_bits)
        throw UserError(name + ": " + std::to_string(all) +
                        (all == scene.triangles.size() ? " triangles" : " primitives") + " need numbers of " +
                        std::to_string(need) + " bits, and prim_bits is " + std::to_string(config.prim_bits) +
                        ": --set prim_bits=" + std::to_string(need));
}

void check_stack(int need, const Config& config, const std::string& name) {
    if (need <= config.stack_depth) return;
    const std::string begin =
        name + ": a ray may have to keep " + std::to_string(need) + " groups of siblings, and ";
    const auto depth = int(std::bit_ceil(unsigned(need)));
    if (const int most = parameter("stack_depth").hi; depth > most)
        throw UserError(begin + "no stack_depth above " + std::to_string(most) +
                        " exists; wider nodes (--set node_width=8) need fewer");
    throw UserError(begin + "stack_depth is " + std::to_string(config.stack_depth) +
                    ": --set stack_depth=" + std::to_string(depth));
}

bool counts(const PrimData& t, const Config& config) {
    if (t.kind == PrimKind::sphere) return radius_squared(t, config.coord_bits) > 0;
    return config.is_sheared() ? t.a != t.b && t.b != t.c && t.c != t.a : has_area(t);
}

MemoryImage compile_triangles(const std::vector<PrimData>& triangles, const Config& config,
                              const std::string& name, const Progress& progress) {
    const auto report_stage = [&](std::uint64_t stage) {
        if (progress) progress("compiling " + name, stage, 4);
    };
    MemoryImage image;
    report_stage(1);
    if (!config.is_list() && !has_cells(config)) {
        const std::vector<LatticeBox> boxes = boxes_of(triangles, config);
        BinaryTree tree =
            config.has_splits() ? bvh::build_split_tree(boxes, triangles, config) : bvh::build_tree(boxes);
        report_stage(2);
        bvh::optimise_tree(tree);
        report_stage(3);
        (config.engine() == Structure::spheres ? emit_globes : emit_boxes)(tree, triangles, config, name,
                                                                           image);
    } else {
        // Several threads build the cells, and one at a time may report.
        std::mutex mutex;
        const auto report = [&] {
            if (const std::unique_lock lock(mutex, std::try_to_lock); lock) report_stage(1);
        };
        config.is_list() ? emit_list(triangles, config, name, image)
                         : emit_cells(triangles, config, name, image, report);
    }
    for (const PrimData& t : triangles) image.primitives = std::max(image.primitives, t.prim + 1);
    check_stack(image.report.stack_need, config, name);
    report_stage(4);
    return image;
}

MemoryImage compile_scene(const Scene& given, const glm::dvec3& eye, const Config& config,
                          const Progress& progress, double room) {
    const Stopwatch watch;
    const std::string name = given.name.empty() ? "the scene" : given.name;
    if (progress) progress("compiling " + name, 0, 4);
    check_units(given, config, name);
    if (config.has_instances()) {
        if (!given.placed) check_visible(given, name);
        const PlacedScene alone{given.placed ? Scene{} : given, {}, {}};
        MemoryImage image = compile_levels(given.placed ? *given.placed : alone, eye, config).image;
        if (progress) progress("compiling " + name, 4, 4);
        return image;
    }
    const Lattice lattice =
        fit_lattice(given, eye, config.coord_bits, config.shading, room * room_around_planes(given, config));
    const std::optional<Scene> moved = config.shading ? align_large_triangles(given, lattice) : std::nullopt;
    const Scene& scene = moved ? *moved : given;
    std::vector<PrimData> triangles = snap_primitives(scene, lattice, config);
    const std::size_t coincident = drop_coincident_spheres(triangles);
    check_kept(triangles, scene, config, name);
    MemoryImage image = compile_triangles(triangles, config, name, progress);
    image.lattice = lattice;
    if (config.has_shade()) {
        const auto records = write_textures(scene, lattice, config, name, image);
        write_surfaces(scene, records, config, name, image);
    }
    image.report.triangles = scene.triangles.size();
    image.report.collapsed = primitive_count(scene) - triangles.size() - coincident;
    image.report.coincident = coincident;
    image.report.pitch = lattice.pitch;
    image.report.seconds = watch.seconds();
    return image;
}

}   // namespace rayclock
