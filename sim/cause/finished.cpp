#include "sim/cause/finished.hpp"

#include <cmath>
#include <optional>

#include <tbb/parallel_for.h>

#include "model/accel/plane.hpp"
#include "model/accel/surfaces.hpp"
#include "model/base/stopwatch.hpp"
#include "sim/image/srgb.hpp"

namespace rayclock {

namespace {

glm::dvec3 point(const Vec3i& p) { return {p[0], p[1], p[2]}; }

/// The scene as the machine has it, in lattice steps.
Scene on_lattice(const Scene& scene, const Lattice& lattice, const Frame& frame) {
    Scene snapped = scene;
    for (glm::dvec3& v : snapped.vertices) v = point(lattice.snap(v));
    for (Sphere& s : snapped.spheres) {
        const double radius = s.radius / lattice.pitch.x;
        s.centre = point(lattice.snap(s.centre));
        s.radius = std::sqrt(std::max(1.0, std::round(radius * radius)));
    }
    for (Plane& p : snapped.planes) p = snapped_plane(p, lattice);
    for (std::size_t i = 0; i < snapped.lights.size(); ++i)
        snapped.lights[i].position = {frame.shade.place[3 * i], frame.shade.place[3 * i + 1],
                                      frame.shade.place[3 * i + 2]};
    return snapped;
}

Camera on_lattice(Camera camera, const Lattice& lattice, const Frame& frame) {
    const glm::dvec3 view = (camera.at - camera.eye) / lattice.pitch;
    camera.eye = point(frame.eye);
    camera.at = camera.eye + view;
    return camera;
}

}   // namespace

Judgement judge_finished(const Asked& asked, const MemoryImage& image, const Whitted& settings,
                         const FinishedAnswer& answered, const HitFrame& hits, int threads,
                         const Progress& progress) {
    const Stopwatch watch;
    const PictureJudgement judged = judge_picture(asked, image, settings, answered.given, threads, progress);
    const std::size_t pixels = hits.hits.size();
    const std::optional<Scene> moved = aligned(asked.scene, asked.lattice);
    const Scene scene = on_lattice(moved ? *moved : asked.scene, asked.lattice, asked.frame);
    const WhittedFrame snapped = Reference(scene).whitted(
        on_lattice(asked.camera, asked.lattice, asked.frame), hits.size, settings, threads, progress);
    Judgement j;
    j.pixels.assign(pixels, PixelCause::none);
    j.other.assign(pixels, false);
    j.wrong = judged.wrong;
    j.rays = judged.rays;
    j.colours = judged.colours;
    j.widest = judged.widest;
    j.faults = judged.faults;
    for (std::size_t i = 0; i < pixels; ++i) {
        j.other[i] = answered.reference.hits.hits[i].primitive != hits.hits[i].primitive;
        const bool same_colour =
            srgb_bytes(glm::vec3(answered.reference.pixels[i])) == srgb_bytes(answered.picture.pixels[i]);
        if (!judged.pixels[i] && !j.other[i] && same_colour) continue;
        const std::uint64_t mine = answered.given.signatures[i];
        const PixelCause cause = judged.pixels[i]                           ? PixelCause::bug
                                 : mine == answered.reference.signatures[i] ? PixelCause::shading
                                 : mine == snapped.signatures[i]            ? PixelCause::snapping
                                                                            : PixelCause::ray_quantisation;
        j.pixels[i] = cause;
        ++j.causes[std::size_t(cause)];
        if (j.other[i]) ++j.causes_other[std::size_t(cause)];
    }
    j.seconds = watch.seconds();
    return j;
}

}   // namespace rayclock
