#include "model/accel/levels/moving.hpp"

#include <algorithm>

#include "model/accel/encode.hpp"
#include "model/base/stopwatch.hpp"

namespace rayclock {

std::unique_ptr<MovingLevels> MovingLevels::make(const PlacedScene& scene, std::span<const Places> times,
                                                 std::span<const glm::dvec3> eyes, int buffers,
                                                 const Config& given) {
    const std::string name = scene.own.name.empty() ? "the scene" : scene.own.name;
    const Config config = with_two_levels(given, name);
    check_levels(scene, config, name);
    const SharedMesh own = own_mesh(scene);
    std::optional<LevelMaps> maps = map_moving(parts_of(scene, own), times, eyes, config);
    if (!maps) return nullptr;
    std::unique_ptr<MovingLevels> made(new MovingLevels(scene, std::move(*maps), buffers, config));
    made->last_ = times[0];
    return made;
}

MovingLevels::MovingLevels(const PlacedScene& scene, LevelMaps maps, int buffers, const Config& config)
    : config_(config), name_(scene.own.name.empty() ? "the scene" : scene.own.name), buffers_(buffers) {
    const Stopwatch watch;
    const SharedMesh own = own_mesh(scene);
    levels_.maps = std::move(maps);
    compile_parts(parts_of(scene, own), scene.own.materials, config_, name_, buffers, levels_);
    levels_.image.report.seconds = watch.seconds();
    // What is there now comes with the first frame.
    std::fill_n(levels_.image.words.begin(), std::size_t(levels_.upper_lines) * words_per_line, 0u);
}

Upload MovingLevels::next(const Places& places) {
    const Stopwatch watch;
    Upload upload;
    const std::size_t buffer = frame_ % std::size_t(buffers_);
    root_ = std::uint32_t(buffer) * levels_.upper_lines;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i] == last_[i]) continue;
        InstanceMap& map = levels_.maps.instances[i];
        map = map_at(places[i], map.mesh_class, levels_.maps, config_);
        ++upload.instances;
    }
    last_ = places;
    std::vector<std::uint32_t>& words = levels_.image.words;
    const std::size_t begin = std::size_t(root_) * words_per_line;
    held_.assign(words.begin() + std::ptrdiff_t(begin),
                 words.begin() + std::ptrdiff_t(begin + std::size_t(levels_.upper_lines) * words_per_line));
    const UpperReport report = write_upper(levels_.entries, root_, false, config_, name_, words, placed_);
    for (std::size_t e = 0; e < placed_.size(); ++e)
        write_entry(levels_.entries[e], placed_[e], config_, words);
    check_need(report.stack_need, config_, name_);
    upload.nodes = report.nodes;
    take_changes(root_, upload);
    upload.beside = buffers_ > 1 && frame_ > 0;
    upload.resets = !upload.lines.empty() && is_read_[buffer];
    if (upload.resets) is_read_.fill(false);
    is_read_[buffer] = true;
    ++frame_;
    upload.seconds = watch.seconds();
    return upload;
}

/// The lines of the tree that begins in line `first` that are not what they were.
void MovingLevels::take_changes(std::uint32_t first, Upload& upload) {
    const MemoryImage& image = levels_.image;
    upload.image.lattice = image.lattice;
    upload.image.surfaces = image.surfaces;
    upload.image.primitives = image.primitives;
    upload.image.listed = image.listed;
    upload.image.levels = image.levels;
    upload.image.report = image.report;
    upload.image_lines = image.lines();
    for (std::uint32_t i = 0; i < levels_.upper_lines; ++i) {
        const std::uint32_t* const line = image.line(first + i);
        if (std::equal(line, line + words_per_line, &held_[i * words_per_line])) continue;
        upload.lines.push_back(first + i);
        upload.words.insert(upload.words.end(), line, line + words_per_line);
    }
}

}   // namespace rayclock
