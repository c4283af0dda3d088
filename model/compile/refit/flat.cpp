// Refits the tree of a scene in one level, frame by frame.
#include "model/compile/refit/flat.hpp"

#include <algorithm>

#include <tbb/parallel_for.h>
#include <glm/common.hpp>

#include "model/base/stopwatch.hpp"
#include "model/compile/compile.hpp"
#include "model/compile/emit.hpp"
#include "model/compile/lattice.hpp"
#include "model/compile/plane.hpp"
#include "model/compile/surfaces.hpp"
#include "model/compile/textures.hpp"
#include "model/layout/words.hpp"

namespace rayclock {
namespace {

std::string name_of(const Scene& scene) { return scene.name.empty() ? "the scene" : scene.name; }

/// Returns the lattice as compile_scene() computes it, with the bounds and eyes of all frames.
Lattice lattice_of(const Scene& scene, Bounds bounds, std::span<const glm::dvec3> eyes,
                   const Config& config) {
    for (const glm::dvec3& eye : eyes) bounds = {glm::min(bounds.lo, eye), glm::max(bounds.hi, eye)};
    Scene corners;
    corners.vertices = {bounds.lo, bounds.hi};
    corners.triangles = {{{0, 1, 1}, 0}};
    corners.spheres = scene.spheres, corners.planes = scene.planes;
    return fit_lattice(corners, eyes[0], config.coord_bits, config.shading,
                       room_around_planes(scene, config));
}

}   // namespace

RefittedScene::RefittedScene(const Scene& scene, Bounds bounds, std::span<const glm::dvec3> eyes,
                             double rebuild, const Config& config)
    : config_(config), name_(name_of(scene)), rebuild_(rebuild), tree_(config, name_) {
    check_units(scene, config_, name_);
    image_.lattice = lattice_of(scene, bounds, eyes, config_);
}

/// Returns all primitives: one without area in this frame may have area in the next.
std::vector<PrimData> RefittedScene::snapped(const Scene& scene) const {
    std::vector<PrimData> all(primitive_count(scene));
    tbb::parallel_for(std::size_t(0), all.size(),
                      [&](std::size_t i) { all[i] = snap_primitive(scene, image_.lattice, i); });
    mark_cutouts(scene.triangles, scene.coordinates, scene.materials, config_, all);
    return all;
}

Upload RefittedScene::next(const Scene& given) {
    const Stopwatch watch;
    const std::optional<Scene> moved =
        config_.shading ? align_large_triangles(given, image_.lattice) : std::nullopt;
    const Scene& scene = moved ? *moved : given;
    std::vector<PrimData> prims = snapped(scene);
    // The number is the same in each frame, because spheres do not move.
    const std::size_t coincident = drop_coincident_spheres(prims);
    if (frame_ == 0) {
        std::vector<PrimData> kept = prims;
        std::erase_if(kept, [&](const PrimData& t) { return !counts(t, config_); });
        check_kept(kept, scene, config_, name_);
        const std::uint64_t room = Refit::max_lines(prims.size());
        check_lines(room, config_, name_);
        tree_lines_ = std::uint32_t(room);
        image_.primitives = std::uint32_t(prims.size());
    }
    Upload upload;
    const bool is_built = tree_.follow(std::move(prims), rebuild_);
    const std::vector<std::uint32_t> held = std::move(image_.words);
    image_.words.assign(std::size_t(tree_lines_) * words_per_line, 0);
    tree_.write(0, false, image_.words.data(), tree_lines_);
    image_.report = tree_.report();
    image_.report.triangles = scene.triangles.size();
    image_.report.coincident = coincident;
    image_.report.pitch = image_.lattice.pitch;
    image_.report.bytes = image_.words.size() * sizeof(std::uint32_t);
    if (config_.has_shade()) {
        const auto records = write_textures(scene, image_.lattice, config_, name_, image_);
        write_surfaces(scene, records, config_, name_, image_);
    }
    (is_built ? upload.rebuilt : upload.refitted) = 1;
    upload.cost = tree_.ratio();
    upload.nodes = image_.report.nodes;
    upload.image = without_words(image_);
    upload.image_lines = image_.lines();
    take_changes(held, upload);
    upload.resets = frame_ > 0 && !upload.lines.empty();
    ++frame_;
    upload.seconds = watch.seconds();
    image_.report.seconds = upload.seconds;
    return upload;
}

/// Collects the changed lines. The room behind a tree is left out: nothing reads it, and the memory may hold
/// anything there until a tree reaches that far.
void RefittedScene::take_changes(const std::vector<std::uint32_t>& held, Upload& upload) {
    const bool is_first = held.empty();
    const auto part = [&](std::uint32_t line) {
        return held.begin() + (is_first ? 0 : std::ptrdiff_t(std::size_t(line) * words_per_line));
    };
    const auto tree = std::max(written_, std::uint32_t(tree_.report().bytes / line_bytes));
    take_differences(image_, 0, tree, {held.begin(), part(written_)}, upload);
    written_ = tree;
    const std::vector<std::uint32_t> surfaces(part(tree_lines_), held.end());
    take_differences(image_, tree_lines_, image_.lines() - tree_lines_, surfaces, upload);
}

}   // namespace rayclock
