// Moving scenes on a chip: with two levels, with a refitted tree of one level, or compiled anew in each
// frame.
#include "sim/run/film/film.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/base/error.hpp"
#include "model/base/stopwatch.hpp"
#include "model/compile/surfaces.hpp"

namespace rayclock {
namespace {

/// The bounds of all corners of the triangles that were added.
struct Growing {
    Bounds box{glm::dvec3(std::numeric_limits<double>::infinity()),
               glm::dvec3(-std::numeric_limits<double>::infinity())};
    /// Adds a part, which has vertices and triangles.
    template <class Part> void add(const Part& part, const glm::dmat4& place = glm::dmat4(1)) {
        for (const Triangle& t : part.triangles)
            for (const std::uint32_t v : t.vertex) {
                const auto point = glm::dvec3(place * glm::dvec4(part.vertices[v], 1));
                box = {glm::min(box.lo, point), glm::max(box.hi, point)};
            }
    }
};

/// Extends the bounds by a mesh in its current shape.
void grow(std::optional<Bounds>& all, const SharedMesh& mesh) {
    Growing growing;
    if (all) growing.box = *all;
    growing.add(mesh);
    all = growing.box;
}

}   // namespace

Camera panned(const Camera& camera, double pan, int i) {
    if (i == 0 || pan == 0) return camera;
    // Rodrigues' rotation formula turns the view direction about the up axis.
    const double angle = pan * i * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    const glm::dvec3 axis = glm::normalize(camera.up), view = camera.at - camera.eye;
    Camera turned = camera;
    turned.at = camera.eye + view * c + glm::cross(axis, view) * s + axis * glm::dot(axis, view) * (1 - c);
    return turned;
}

Film::Film(Request request, const FramesOptions& options, bool view_is_given, FrameSize size,
           const Progress& progress, bool for_chip)
    : request_(std::move(request)),
      pan_(options.pan),
      size_(size),
      progress_(progress),
      for_chip_(for_chip),
      rebuild_(options.rebuild),
      first_camera_(*request_.scene.camera) {
    Scene& scene = request_.scene;
    moves_ = scene.placed && !scene.placed->motion.empty();
    times_ = frame_times(options, moves_);
    if (options.uploads != "between" && options.uploads != "double")
        throw UserError(fmt::format("--uploads must be between or double, not '{}'", options.uploads));
    if (!(options.rebuild >= 0))
        throw UserError(fmt::format("--rebuild must be 0 or more, not {}", options.rebuild));
    is_double_ = moves_ && options.uploads == "double";
    if (!moves_) return;
    placed_ = *scene.placed;
    placed_.own.name = scene.name;
    placed_.own.materials = scene.materials;   // the picture's settings may have changed them
    placed_.own.textures = scene.textures;
    if (placed_.own.lights.empty()) placed_.own.lights = scene.lights;
    camera_moves_ = !placed_.motion.camera.empty() && !view_is_given;
    if (!for_chip) return;
    if (request_.config.has_instances()) prepare_levels();
    if (!request_.config.has_instances() && !placed_.motion.deforming.empty() &&
        Refit::serves(request_.config))
        prepare_flat();
    if (is_double_ && !levels_)
        throw UserError(
            "--uploads double needs a scene's tree apart from what does not move: levels=2, instances that "
            "are not sheared or flattened, and below planes no meshes that deform");
}

Camera Film::camera_of(std::size_t f, const std::optional<Camera>& moving) const {
    Camera camera = panned(camera_moves_ && moving ? *moving : first_camera_, pan_, int(f));
    camera.window = first_camera_.window;
    return camera;
}

/// Visits all times once, because the lattice must cover all of them.
void Film::prepare_levels() {
    std::vector<InstancePlaces> times;
    ShapeBounds shapes(placed_.motion.deforming.empty() ? 0 : placed_.meshes.size());
    std::vector<glm::dvec3> eyes;
    for (std::size_t f = 0; f < frames(); ++f) {
        pose(placed_, times_.times[f]);
        times.push_back(places_of(placed_));
        eyes.push_back(camera_of(f, placed_.own.camera).eye);
        for (const Deforming& deforming : placed_.motion.deforming)
            grow(shapes[deforming.mesh], placed_.meshes[deforming.mesh]);
    }
    levels_ = MovingLevels::make(placed_, times, eyes, is_double_ ? 2 : 1, request_.config, shapes);
}

/// Does the same for one level.
void Film::prepare_flat() {
    Growing bounds;
    std::vector<glm::dvec3> eyes;
    for (std::size_t f = 0; f < frames(); ++f) {
        pose(placed_, times_.times[f]);
        bounds.add(placed_.own);
        for (const Instance& instance : placed_.instances)
            bounds.add(placed_.meshes[instance.mesh], instance.place);
        eyes.push_back(camera_of(f, placed_.own.camera).eye);
    }
    flat_ = std::make_unique<RefittedScene>(request_.scene, bounds.box, eyes, rebuild_, request_.config);
}

void Film::pose_at(std::size_t f) {
    pose(placed_, times_.times[f]);
    request_.scene.camera = camera_of(f, placed_.own.camera);
    request_.scene.lights = placed_.own.lights;
    is_stale_ = true;
}

const Request& Film::request() {
    if (!is_stale_) return request_;
    const Camera camera = *request_.scene.camera;
    Scene flat = flat_copy(placed_);
    flat.camera = camera;
    if (request_.config.has_instances()) flat.placed = std::make_shared<const PlacedScene>(placed_);
    request_.scene = std::move(flat);
    is_stale_ = false;
    return request_;
}

void Film::next() {
    const std::size_t f = frame_++;
    upload_ = {};
    if (!moves_) {
        request_.scene.camera = panned(first_camera_, pan_, int(f));
        if (!for_chip_) return;
        if (f == 0)
            job_ = make_job(request_.scene, camera(), size_, request_.config, progress_, request_.settings);
        job_.frame = job_frame(job_, camera());
        return;
    }
    pose_at(f);
    if (!for_chip_) return;
    if (flat_) return next_flat();
    if (!levels_) return next_whole();
    upload_ = levels_->next(placed_, rebuild_);
    if (f == 0) {
        check_frame_size(size_);
        job_.config = request_.config;
        job_.image = levels_->image();
        job_.size = size_;
        check_capacity(job_.image, job_.config);
    } else {
        apply(upload_, job_.image);
    }
    job_.mirrored = mirrored_primitives(placed_, job_.image);
    set_registers();
    job_.frame.root = levels_->root();
}

void Film::set_registers() {
    if (job_.config.shading)   // lights move too
        job_.frame.shade = make_shade_frame(request_.scene, request_.settings, job_.image,
                                            std::uint32_t(job_.size.height), job_.config);
    job_.frame = job_frame(job_, camera());
}

/// Refits the tree to the moved triangles.
void Film::next_flat() {
    upload_ = flat_->next(request().scene);
    upload_.instances = placed_.instances.size();
    if (frame_ == 1) {
        check_frame_size(size_);
        job_.config = request_.config;
        job_.size = size_;
        check_capacity(flat_->image(), job_.config);
    }
    job_.image = flat_->image();
    set_registers();
}

/// Compiles the scene again, independently of the previous frame.
void Film::next_whole() {
    const std::vector<std::uint32_t> held = std::move(job_.image.words);
    request();
    const Stopwatch watch;
    request_.scene.placed = std::make_shared<const PlacedScene>(placed_);
    job_ = make_job(request_.scene, camera(), size_, request_.config, progress_, request_.settings);
    if (!request_.config.has_instances()) request_.scene.placed.reset();
    upload_.image = without_words(job_.image);
    upload_.image_lines = job_.image.lines();
    take_differences(job_.image, 0, job_.image.lines(), held, upload_);
    upload_.is_whole = true;
    upload_.rebuilt = !placed_.motion.deforming.empty();
    upload_.cost = upload_.rebuilt ? 1 : 0;
    upload_.nodes = job_.image.report.nodes;
    upload_.instances = placed_.instances.size();
    upload_.resets = frame_ > 1 && !upload_.lines.empty();
    upload_.seconds = watch.seconds();
}

RecordedFrame Film::record(int threads, const Progress& progress) {
    RecordedFrame trace = record_frame(job_, job_.frame, threads, progress);
    trace.upload = take_upload();
    return trace;
}

}   // namespace rayclock
