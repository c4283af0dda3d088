// Writes the trees of a film's frames, and collects the differences.
#include "model/compile/levels/moving.hpp"

#include <algorithm>
#include <stdexcept>

#include "model/base/stopwatch.hpp"
#include "model/compile/surfaces.hpp"
#include "model/engine/engines.hpp"
#include "model/layout/words.hpp"

namespace rayclock {

namespace {

std::string name_of(const PlacedScene& scene) {
    return scene.own.name.empty() ? "the scene" : scene.own.name;
}

/// Returns the number of meshes of the parts before those of the scene: its own triangles. Spheres and planes
/// come last.
std::uint32_t before_meshes(const LevelParts& parts, const PlacedScene& scene) {
    return std::uint32_t(parts.meshes.size() - scene.meshes.size() - (parts.round ? 1 : 0));
}

/// Returns the parts, with the shapes' bounds moved from the scene's mesh numbers to those of the parts.
LevelParts parts_of(const PlacedScene& scene, const SharedMesh& own, const ShapeBounds& shapes) {
    LevelParts parts = parts_of(scene, own);
    if (shapes.empty()) return parts;
    parts.deforming.resize(before_meshes(parts, scene));   // the scene's own triangles do not deform
    parts.deforming.insert(parts.deforming.end(), shapes.begin(), shapes.end());
    return parts;
}

}   // namespace

std::unique_ptr<MovingLevels> MovingLevels::make(const PlacedScene& scene,
                                                 std::span<const InstancePlaces> times,
                                                 std::span<const glm::dvec3> eyes, int buffers,
                                                 const Config& given, const ShapeBounds& shapes) {
    const std::string name = name_of(scene);
    const Config config = with_two_levels(given, name);
    check_levels(scene, config, name);
    const bool deforms = !shapes.empty();
    if (deforms && (has_cells(config) || !Refit::serves(config.lower()))) return nullptr;
    const SharedMesh own = own_mesh(scene);
    std::optional<LevelMaps> maps = map_moving(parts_of(scene, own, shapes), times, eyes, config);
    if (!maps) return nullptr;
    std::unique_ptr<MovingLevels> made(
        new MovingLevels(scene, std::move(*maps), times, buffers, config, shapes));
    made->last_ = times[0];
    return made;
}

/// Returns the room for the scene's tree. A tree of boxes or globes has a bound. For planes, the trees of all
/// frames are built, and the largest gives the room.
std::uint32_t MovingLevels::room(const std::vector<UpperEntry>& entries,
                                 std::span<const InstancePlaces> times) {
    if (!has_cells(config_)) return max_upper_lines(entries.size());
    std::vector<InstanceMap>& maps = levels_.maps.instances;   // the entries refer to these
    const std::vector<InstanceMap> now = maps;
    std::uint32_t most = 0;
    for (const InstancePlaces& places : times) {
        for (std::size_t i = 0; i < places.size(); ++i)
            maps[i] = map_at(places[i], maps[i].mesh_class, levels_.maps, config_);
        std::vector<std::uint32_t> words;
        most = std::max(most, write_upper(entries, 0, false, config_.upper(), name_, words, placed_).lines);
    }
    std::copy(now.begin(), now.end(), maps.begin());
    return most;
}

MovingLevels::MovingLevels(const PlacedScene& scene, LevelMaps maps, std::span<const InstancePlaces> times,
                           int buffers, const Config& config, const ShapeBounds& shapes)
    : config_(config), name_(name_of(scene)), buffers_(buffers) {
    const Stopwatch watch;
    const SharedMesh own = own_mesh(scene);
    const LevelParts parts = parts_of(scene, own, shapes);
    levels_.maps = std::move(maps);
    const std::uint32_t before = before_meshes(parts, scene);
    for (std::uint32_t c = 0; c < levels_.maps.classes.size(); ++c) {
        MeshClass& made = levels_.maps.classes[c];
        if (!made.deforms) continue;
        const SharedMesh& mesh = *parts.meshes[made.mesh];
        take_shape(made, mesh, config_);
        followers_.push_back(
            {c, made.mesh - before, std::uint32_t(mesh.triangles.size()), Refit(config_.lower(), name_)});
    }
    compile_parts(
        parts, scene.own.materials, config_, name_, buffers,
        [&](const std::vector<UpperEntry>& entries) { return room(entries, times); }, levels_);
    levels_.image.report.seconds = watch.seconds();
    // The first frame brings the content of these lines.
    std::fill_n(levels_.image.words.begin(), std::size_t(levels_.upper_lines) * words_per_line, 0u);
}

Upload MovingLevels::next(const InstancePlaces& places) { return next(places, nullptr, 0); }

Upload MovingLevels::next(const PlacedScene& scene, double rebuild) {
    return next(places_of(scene), &scene, rebuild);
}

Upload MovingLevels::next(const InstancePlaces& places, const PlacedScene* scene, double rebuild) {
    const Stopwatch watch;
    Upload upload;
    const std::size_t buffer = frame_ % std::size_t(buffers_);
    root_ = std::uint32_t(buffer) * levels_.upper_lines;
    hold(buffer);
    if (scene) follow(*scene, rebuild, buffer, upload);
    for (std::size_t i = 0; i < places.size(); ++i) {
        InstanceMap& map = levels_.maps.instances[i];
        if (places[i] == last_[i] && !levels_.maps.classes[map.mesh_class].deforms) continue;
        map = map_at(places[i], map.mesh_class, levels_.maps, config_);
        ++upload.instances;
    }
    last_ = places;
    std::vector<std::uint32_t>& words = levels_.image.words;
    const UpperReport report =
        write_upper(levels_.entries, root_, false, config_.upper(), name_, words, placed_);
    write_entries(levels_.entries, placed_, config_, words);
    check_need(report.stack_need, config_, name_);
    if (report.lines > levels_.upper_lines)
        throw std::logic_error("a scene's tree takes more lines than any of its film");
    upload.nodes += report.nodes;
    upload.image = without_words(levels_.image);
    upload.image_lines = levels_.image.lines();
    for (const Region& region : regions_) take_region(region, buffer, upload);
    upload.overlaps_previous_frame = buffers_ > 1 && frame_ > 0;
    upload.resets = !upload.lines.empty() && is_read_[buffer];
    if (upload.resets) is_read_.fill(false);
    is_read_[buffer] = true;
    ++frame_;
    upload.seconds = watch.seconds();
    return upload;
}

/// Records the memory's content where the frame's trees will lie.
void MovingLevels::hold(std::size_t buffer) {
    const bool is_new = frame_ < std::size_t(buffers_);
    const auto part = [&](std::uint32_t first, std::uint32_t lines, Follower* follower) {
        const std::uint32_t known = follower ? follower->written[buffer] : lines;
        const auto begin = levels_.image.words.begin() + std::ptrdiff_t(std::size_t(first) * words_per_line),
                   end = begin + std::ptrdiff_t(std::size_t(known) * words_per_line);
        regions_.push_back({first, lines, is_new && first != root_, follower, {begin, end}});
    };
    regions_.clear();
    part(root_, levels_.upper_lines, nullptr);
    for (Follower& follower : followers_) {
        const std::uint32_t c = follower.mesh_class, room = levels_.rooms[c], count = follower.triangles;
        if (levels_.roots[c] == 0) continue;
        part(levels_.roots[c] + std::uint32_t(buffer) * room, room, &follower);
        if (!config_.shading) continue;
        const LevelsImage::Surfaces& surfaces = levels_.surfaces[c][buffer];
        part(surfaces.first, count, nullptr);
        // The records lie in the order of their triangles, without gaps.
        const auto records = count - std::uint32_t(std::ranges::count(surfaces.records, 0u));
        const auto first = std::ranges::find_if(surfaces.records, [](std::uint32_t r) { return r != 0; });
        if (first != surfaces.records.end()) part(*first, records, nullptr);
    }
    std::sort(regions_.begin(), regions_.end(),
              [](const Region& a, const Region& b) { return a.first < b.first; });
}

/// The tree and surfaces of a deforming mesh come whole with the first frame that reads them. They do so
/// whatever the memory held, because a line of them may be all zeros. The same holds for lines that only a
/// longer tree reaches.
void MovingLevels::take_region(const Region& region, std::size_t buffer, Upload& upload) const {
    std::uint32_t lines = region.lines;
    if (Follower* const follower = region.follower) {
        std::uint32_t& written = follower->written[buffer];
        lines = written = std::max(written, std::uint32_t(follower->tree.report().bytes / line_bytes));
    }
    take_differences(levels_.image, region.first, lines,
                     region.is_new ? std::vector<std::uint32_t>{} : region.held, upload);
}

void MovingLevels::follow(const PlacedScene& scene, double rebuild, std::size_t buffer, Upload& upload) {
    for (Follower& follower : followers_) {
        const SharedMesh& mesh = scene.meshes[follower.mesh];
        if (mesh.triangles.empty()) continue;
        MeshClass& made = levels_.maps.classes[follower.mesh_class];
        take_shape(made, mesh, config_);
        std::vector<PrimData> prims = snapped_triangles(mesh, made, config_);
        mark_cutouts(mesh.triangles, mesh.coordinates, scene.own.materials, config_, prims);
        const bool is_built = follower.tree.follow(std::move(prims), rebuild);
        ++(is_built ? upload.rebuilt : upload.refitted);
        upload.cost = std::max(upload.cost, follower.tree.ratio());
        upload.nodes += follower.tree.report().nodes;
        draw(follower, mesh, scene.own, buffer);
    }
}

/// Writes the tree, surfaces and texture records of a mesh into a buffer. Makes the class's instances refer
/// to them. `own`: the scene with the materials and textures.
void MovingLevels::draw(Follower& follower, const SharedMesh& mesh, const Scene& own, std::size_t buffer) {
    const std::uint32_t c = follower.mesh_class, room = levels_.rooms[c],
                        root = levels_.roots[c] + std::uint32_t(buffer) * room;
    std::vector<std::uint32_t>& words = levels_.image.words;
    follower.tree.write(root, true, &words[std::size_t(root) * words_per_line], room);
    std::uint32_t surfaces = 0;
    if (config_.shading) {
        const LevelsImage::Surfaces& copy = levels_.surfaces[c][buffer];
        surfaces = copy.first;
        MemoryImage part;
        part.lattice.coord_bits = config_.coord_bits;
        Scene shown = class_surfaces(mesh, levels_.maps.classes[c], own.materials);
        shown.textures = own.textures;
        write_surfaces(shown, copy.records, config_, name_, part);
        rewrite_records(shown, part.lattice, config_, levels_.textures, copy.records, levels_.image);
        std::copy(part.words.begin(), part.words.end(),
                  words.begin() + std::ptrdiff_t(std::size_t(surfaces) * words_per_line));
    }
    for (UpperEntry& entry : levels_.entries) {
        if (entry.map->mesh_class != c) continue;
        entry.root = root;
        entry.stack_need = follower.tree.report().stack_need;
        entry.depth = follower.tree.report().depth;
        if (config_.shading) entry.first_surface_line = surfaces - entry.first;
    }
}

}   // namespace rayclock
