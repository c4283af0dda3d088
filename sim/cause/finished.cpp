#include "sim/cause/finished.hpp"

#include <cmath>
#include <optional>

#include <tbb/parallel_for.h>

#include "model/accel/surfaces.hpp"
#include "model/base/stopwatch.hpp"
#include "model/trace/record_shaded.hpp"
#include "sim/cause/seam.hpp"
#include "sim/image/srgb.hpp"

namespace rayclock {

namespace {

glm::dvec3 point(const Vec3i& p) { return {p[0], p[1], p[2]}; }

void place_lights(const Frame& frame, Scene& snapped) {
    for (std::size_t i = 0; i < snapped.lights.size(); ++i)
        snapped.lights[i].position = {frame.shade.place[3 * i], frame.shade.place[3 * i + 1],
                                      frame.shade.place[3 * i + 2]};
}

/// The scene as the machine has it, in lattice steps.
Scene on_lattice(const Scene& scene, const Lattice& lattice, const Frame& frame) {
    Scene snapped = scene;
    for (glm::dvec3& v : snapped.vertices) v = point(lattice.snap(v));
    snap_round(lattice, snapped);
    place_lights(frame, snapped);
    return snapped;
}

Camera on_lattice(Camera camera, const Lattice& lattice, const Frame& frame) {
    const glm::dvec3 view = (camera.at - camera.eye) / lattice.pitch;
    camera.eye = point(frame.eye);
    camera.at = camera.eye + view;
    return camera;
}

/// What the rays of a pixel are found to be.
class SeamWatch final : public ShadeWatch {
public:
    explicit SeamWatch(const Seams& seams) : seams_(seams) {}
    void sent(const Ray& ray) override { ray_ = ray; }
    void answered(const Closest& hit) override {
        const RayFinding found = seams_.look(ray_, hit, &apart);
        has_seam |= found == RayFinding::seam;
        is_lost |= found == RayFinding::none;
    }
    void passed(const PassIn&, const PassOut&) override {}

    bool has_seam = false, is_lost = false;
    double apart = 0;

private:
    const Seams& seams_;
    Ray ray_;
};

/// Of two levels: pixels that are ray_quantisation so far, because every ray is rightly rounded. If one of
/// them is a seam, the pixel is one.
class SeamSearch {
public:
    SeamSearch(const Asked& asked, const MemoryImage& image)
        : asked_(asked),
          image_(image),
          world_(asked, image),
          seams_(world_, asked.config),
          decoder_(image, asked.config) {}
    Scene scene() const {
        Scene snapped = flat_copy(world_.snapped());
        place_lights(asked_.frame, snapped);
        return snapped;
    }
    void look(const std::vector<std::size_t>& pixels, Judgement& j) const {
        std::vector<SeamWatch> found(pixels.size(), SeamWatch(seams_));
        tbb::parallel_for(std::size_t(0), pixels.size(), [&](std::size_t i) {
            ShadedRecorder recorder(image_, asked_.frame, asked_.config, decoder_);
            RecordScratch scratch(asked_.config);
            recorder.follow(x(pixels[i]), y(pixels[i]), scratch, found[i]);
        });
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            j.seams_apart = std::max(j.seams_apart, found[i].apart);
            if (found[i].has_seam) j.pixels[pixels[i]] = PixelCause::seam;
            if (!found[i].is_lost) continue;
            j.pixels[pixels[i]] = PixelCause::bug;
            ++j.wrong;
            if (j.faults.size() < 20) j.faults.push_back({x(pixels[i]), y(pixels[i]), 0, no_finding});
        }
    }

private:
    std::uint32_t x(std::size_t pixel) const { return std::uint32_t(pixel % asked_.frame.width); }
    std::uint32_t y(std::size_t pixel) const { return std::uint32_t(pixel / asked_.frame.width); }

    const Asked& asked_;
    const MemoryImage& image_;
    PlacedWorld world_;
    Seams seams_;
    Decoder decoder_;
};

/// The scene as the machine has it.
Scene snapped_scene(const Asked& asked) {
    const std::optional<Scene> moved = aligned(asked.scene, asked.lattice);
    return on_lattice(moved ? *moved : asked.scene, asked.lattice, asked.frame);
}

}   // namespace

Judgement judge_finished(const Asked& asked, const MemoryImage& image, const Whitted& settings,
                         const FinishedAnswer& answered, const HitFrame& hits, int threads,
                         const Progress& progress) {
    const Stopwatch watch;
    const PictureJudgement judged = judge_picture(asked, image, settings, answered.given, threads, progress);
    const std::size_t pixels = hits.hits.size();
    std::optional<SeamSearch> search;
    if (asked.config.has_instances()) search.emplace(asked, image);
    const Scene scene = search ? search->scene() : snapped_scene(asked);
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
    std::vector<std::size_t> rounded;
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
        if (search && cause == PixelCause::ray_quantisation) rounded.push_back(i);
    }
    if (search) search->look(rounded, j);
    for (std::size_t i = 0; i < pixels; ++i) {
        if (j.pixels[i] == PixelCause::none) continue;
        ++j.causes[std::size_t(j.pixels[i])];
        if (j.other[i]) ++j.causes_other[std::size_t(j.pixels[i])];
    }
    j.seconds = watch.seconds();
    return j;
}

}   // namespace rayclock
