// Finds the cause of each differing pixel of a picture without bounces.
#include "sim/judge/cause/cause.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include "model/base/largest.hpp"
#include "model/base/stopwatch.hpp"
#include "model/scene/folded.hpp"
#include "model/trace/hits.hpp"
#include "sim/files/image/srgb.hpp"
#include "sim/judge/cause/camera_stage_check.hpp"
#include "sim/judge/cause/exact_answers.hpp"
#include "sim/judge/cause/seam.hpp"
#include "sim/judge/cause/snapped.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/judge/reference/tiles.hpp"

namespace rayclock {

namespace {

constexpr int stages = 7;
constexpr int packed_width = 256;
constexpr std::size_t max_stage_faults = 20;
constexpr std::size_t lit_stride = 61;   // every 61st equal pixel also has its light checked
constexpr const char* wrong_light = "the colour is not the local light of the hit by the reference's rules";

/// Returns the machine's triangles in lattice steps, for the reference.
Scene on_lattice(const Scene& scene, const Lattice& lattice) {
    Scene snapped;
    snapped.triangles = scene.triangles;
    snapped.vertices.resize(scene.vertices.size());
    tbb::parallel_for(std::size_t(0), scene.vertices.size(), [&](std::size_t i) {
        const Vec3i p = lattice.snap(scene.vertices[i]);
        snapped.vertices[i] = {p[0], p[1], p[2]};
    });
    return snapped;
}

bool on_edge(const Hit& hit) {
    return hit.primitive != no_primitive && std::min({hit.u, hit.v, 1 - hit.u - hit.v}) <= 0x1p-22f;
}

class Judge {
public:
    Judge(const FrameInputs& inputs, const MemoryImage& image, const FrameAnswers& answered)
        : inputs_(inputs), image_(image), answered_(answered), size_(answered.reference.size) {}

    Judgement operator()(const Progress& progress) {
        const Stopwatch watch;
        prepare();
        for (const std::string& sentence : snapping_faults(inputs_, world_ ? &*world_ : nullptr))
            report(0, sentence);
        find(progress);
        explain();
        check_rules();
        check_light();
        for (std::size_t i = 0; i < judgement_.pixels.size(); ++i) count(i);
        judgement_.seconds = watch.seconds();
        return std::move(judgement_);
    }

    std::vector<PixelStage> stages_of(std::size_t pixel) {
        prepare();
        open_ = {pixel};
        const auto [hits, pictures] = staged();
        std::vector<PixelStage> all;
        for (std::size_t k = 0; k < hits.size(); ++k) {
            if (!world_ && k > 0 && PixelCause(k - 1) == PixelCause::seam)
                continue;   // one level does not have this stage
            all.push_back({k == 0 ? "reference" : cause_info(PixelCause(k - 1)).key, hits[k].hits[0],
                           pictures[k].pixels[0]});
        }
        const PixelStage& last = all.back();
        all.push_back({cause_info(PixelCause::shading).key, last.hit, answered_.picture.pixels[pixel]});
        return all;
    }

private:
    void prepare() {
        if (inputs_.config.has_instances()) prepare_levels();
        tbb::parallel_invoke(
            [&] {
                if (!world_) exact_.emplace(inputs_.scene, inputs_.lattice, inputs_.config);
            },
            [&] {
                if (!world_) steps_ = on_lattice(inputs_.scene, inputs_.lattice);
                snapped_.emplace(steps_);
            },
            [&] { expected_ = shade(inputs_.scene, answered_.reference); });
        camera_stage_.emplace(inputs_, steps_, *snapped_, world_ ? &*world_ : nullptr,
                              seams_ ? &*seams_ : nullptr);
    }
    void prepare_levels() {
        world_.emplace(inputs_, image_);
        exact_.emplace(*world_, inputs_.config);
        seams_.emplace(*world_, inputs_.config);
        steps_ = is_folded(inputs_.scene) ? keep_instances(world_->snapped()) : flat_copy(world_->snapped());
        for (const std::string& sentence : world_->faults()) report(0, sentence);
    }
    void report(std::size_t pixel, const std::string& sentence) {
        ++judgement_.wrong;
        if (judgement_.faults.size() < max_stage_faults)
            judgement_.faults.push_back({std::uint32_t(x(pixel)), std::uint32_t(y(pixel)), 0, sentence});
    }
    /// Returns the hit with the flat scene's order of corners. A mirrored instance has the second and the
    /// third corner exchanged.
    Hit as_flat(Hit hit) const {
        if (!world_ || hit.primitive == no_primitive) return hit;
        const std::uint32_t place = world_->place_of(hit.primitive);
        if (place != oracle::PlacedRay::nowhere && world_->is_mirrored(place)) std::swap(hit.u, hit.v);
        return hit;
    }
    int x(std::size_t pixel) const { return int(pixel % std::size_t(size_.width)); }
    int y(std::size_t pixel) const { return int(pixel / std::size_t(size_.width)); }
    std::uint32_t answered_primitive(std::size_t pixel) const {
        const Closest& answer = answered_.answers[pixel];
        return answer.found ? answer.prim : no_primitive;
    }
    bool holds_another(std::size_t pixel) const {
        return answered_.reference.hits[pixel].primitive != answered_primitive(pixel);
    }
    bool differs(std::size_t pixel) const {
        return holds_another(pixel) ||
               srgb_bytes(expected_.pixels[pixel]) != srgb_bytes(answered_.picture.pixels[pixel]);
    }

    /// Compares every pixel with the oracle's answer. Lists pixels that differ without a bug for explain().
    void find(const Progress& progress) {
        const std::size_t pixels = answered_.answers.size();
        const bool exact = inputs_.config.test() == PrimitiveTest::exact;
        judgement_.pixels.assign(pixels, PixelCause::none);
        judgement_.other.assign(pixels, false);
        std::vector<std::uint8_t> open(pixels), wrong(pixels);
        const auto judge_row = [&](const PixelTile& tile) {
            const int row = tile.rows().begin();
            const std::size_t begin = std::size_t(row) * std::size_t(size_.width),
                              end = begin + std::size_t(size_.width);
            for (std::size_t i = begin; i < end; ++i) {
                const Closest right = exact_->answer(exact_->pixel(inputs_.frame, x(i), row));
                wrong[i] = !same_hit(right, answered_.answers[i]);
                if (wrong[i] && exact)
                    judgement_.pixels[i] = PixelCause::bug;
                else
                    open[i] = differs(i);
            }
        };
        for_each_tile(size_, 0, "judging", progress, judge_row, {size_.width, 1});
        for (std::size_t i = 0; i < pixels; ++i) {
            if (open[i]) open_.push_back(i);
            judgement_.other[i] = holds_another(i);
            if (wrong[i]) report(i, "the camera ray's answer is not the exact one");
        }
        judgement_.rays.primary = pixels;
    }

    /// The hits and colours of all stages but the last for the pixels that differ.
    struct Staged {
        std::array<HitFrame, stages - 1> hits;
        std::array<Picture, stages - 1> pictures;
    };
    Staged staged() {
        const int rows = int((open_.size() + packed_width - 1) / packed_width);
        Staged s;
        std::array<HitFrame, stages - 1>& hits = s.hits;
        for (HitFrame& frame : hits)
            frame = {{packed_width, std::max(1, rows)},
                     std::vector<Hit>(std::size_t(std::max(1, rows)) * packed_width)};
        const PixelRays rays = pixel_rays(inputs_.camera, size_);
        const HitScale scale(inputs_.frame, inputs_.lattice, inputs_.config);
        const Vec3i eye = inputs_.frame.eye;
        tbb::parallel_for(std::size_t(0), open_.size(), [&](std::size_t i) {
            const int px = x(open_[i]), py = y(open_[i]);
            const ExactPixel exact = exact_->pixel(inputs_.frame, px, py);
            const auto at = [&](const Closest& hit) {
                return as_flat(scale({std::uint32_t(px), std::uint32_t(py), hit}));
            };
            const glm::dvec3 from(eye[0], eye[1], eye[2]);
            hits[0].hits[i] = answered_.reference.hits[open_[i]];
            hits[1].hits[i] = snapped_->trace(from, inputs_.lattice.direction(rays.direction(px, py)));
            hits[3].hits[i] = as_flat({exact.primitive, 0, float(double(exact.u) / double(exact.den)),
                                       float(double(exact.v) / double(exact.den))});
            const Vec3i whole = exact_direction(inputs_.frame, inputs_.config, {}, px, py, 0);
            hits[2].hits[i] =
                world_ ? snapped_->trace(from, {whole[0], whole[1], whole[2]}) : hits[3].hits[i];
            hits[4].hits[i] = at(exact_->answer(exact));
            hits[5].hits[i] = at(answered_.answers[open_[i]]);
        });
        for (std::size_t k = 0; k < hits.size(); ++k) s.pictures[k] = shade(inputs_.scene, hits[k]);
        return s;
    }

    /// Finds the cause of each listed pixel from the primitives and colours of its stages.
    void explain() {
        const auto [hits, pictures] = staged();
        for (std::size_t i = 0; i < open_.size(); ++i) {
            std::array<std::uint32_t, stages> primitive{};
            std::array<glm::vec3, stages> colour{};
            for (std::size_t k = 0; k + 1 < stages; ++k) {
                primitive[k] = hits[k].hits[i].primitive;
                colour[k] = pictures[k].pixels[i];
            }
            primitive[stages - 1] = answered_primitive(open_[i]);
            colour[stages - 1] = answered_.picture.pixels[open_[i]];
            const PixelCause found = cause(primitive, colour);
            judgement_.pixels[open_[i]] = found == PixelCause::seam ? seam_or(open_[i]) : found;
        }
    }

    /// Decides whether a pixel that changed at the seam stage is a seam, ray_quantisation or a bug.
    PixelCause seam_or(std::size_t pixel) {
        const Vec3i direction = exact_direction(inputs_.frame, inputs_.config, {}, x(pixel), y(pixel), 0);
        switch (seams_->explain(camera_ray(inputs_.frame.eye, direction), answered_.answers[pixel],
                                &judgement_.seams_apart)) {
            case RayFinding::one_line: return PixelCause::ray_quantisation;
            case RayFinding::seam: return PixelCause::seam;
            case RayFinding::none: break;
        }
        report(pixel, no_finding);
        return PixelCause::bug;
    }

    /// Checks each listed pixel, whatever its cause: the reference's rules must hold on the machine's ray and
    /// for both colours.
    void check_rules() {
        std::vector<CameraFinding> found(open_.size());
        tbb::parallel_for(std::size_t(0), open_.size(), [&](std::size_t i) { found[i] = decide(open_[i]); });
        for (std::size_t i = 0; i < open_.size(); ++i) {
            judgement_.ties += found[i].is_tie;
            if (found[i].fault.empty() || judgement_.pixels[open_[i]] == PixelCause::bug) continue;
            judgement_.pixels[open_[i]] = PixelCause::bug;
            report(open_[i], found[i].fault);
        }
    }
    /// Checks the light of every lit_stride-th pixel. shade() lights both pictures, so a fault in it may show
    /// no difference.
    void check_light() {
        const std::size_t pixels = judgement_.pixels.size();
        std::vector<std::uint8_t> wrong((pixels + lit_stride - 1) / lit_stride);
        tbb::parallel_for(std::size_t(0), wrong.size(), [&](std::size_t i) {
            const std::size_t pixel = i * lit_stride;
            wrong[i] = !is_local_light(answered_.reference.hits[pixel], expected_.pixels[pixel], pixel);
        });
        for (std::size_t i = 0; i < wrong.size(); ++i) {
            PixelCause& cause = judgement_.pixels[i * lit_stride];
            if (!wrong[i] || cause == PixelCause::bug) continue;
            cause = PixelCause::bug;
            report(i * lit_stride, wrong_light);
        }
    }
    CameraFinding decide(std::size_t pixel) const {
        const int px = x(pixel), py = y(pixel);
        const Vec3i d = exact_direction(inputs_.frame, inputs_.config, {}, px, py, 0);
        CameraFinding found =
            camera_stage_->judge(px, py, d, exact_->answer(exact_->pixel(inputs_.frame, px, py)));
        const Hit mine = as_flat(HitScale(inputs_.frame, inputs_.lattice, inputs_.config)(
            {std::uint32_t(px), std::uint32_t(py), answered_.answers[pixel]}));
        const bool is_lit_right =
            is_local_light(answered_.reference.hits[pixel], expected_.pixels[pixel], pixel) &&
            is_local_light(mine, answered_.picture.pixels[pixel], pixel);
        if (!is_lit_right && found.fault.empty()) found.fault = wrong_light;
        return found;
    }
    /// The tolerance is the precision of floats.
    bool is_local_light(const Hit& hit, const glm::vec3& colour, std::size_t pixel) const {
        const std::optional<glm::dvec3> light = camera_stage_->local_light(hit, x(pixel), y(pixel));
        for (int k = 0; light && k < 3; ++k)
            if (std::abs(std::min(double(colour[k]), 1.0) - std::min((*light)[k], 1.0)) > 0x1p-22)
                return false;
        return true;
    }

    static PixelCause cause(const std::array<std::uint32_t, stages>& primitive,
                            const std::array<glm::vec3, stages>& colour) {
        std::size_t at = 0;
        if (primitive.front() != primitive.back()) {
            while (primitive[at] == primitive[at + 1]) ++at;
        } else {
            for (std::size_t k = 1; k + 1 < stages; ++k)
                if (largest(colour[k + 1] - colour[k]) > largest(colour[at + 1] - colour[at])) at = k;
        }
        return PixelCause(at);   // in the order of the stages
    }

    void count(std::size_t pixel) {
        const PixelCause cause = judgement_.pixels[pixel];
        if (cause == PixelCause::none) return;
        ++judgement_.causes[std::size_t(cause)];
        if (!judgement_.other[pixel]) return;
        ++judgement_.causes_other[std::size_t(cause)];
        judgement_.on_edge += on_edge(answered_.reference.hits[pixel]);
    }

    const FrameInputs& inputs_;
    const MemoryImage& image_;
    const FrameAnswers& answered_;
    FrameSize size_;
    std::optional<PlacedWorld> world_;   // of two levels
    std::optional<SeamFinder> seams_;
    Scene steps_;   // the machine's scene in lattice steps
    std::optional<ExactAnswers> exact_;
    std::optional<Reference> snapped_;   // of steps_
    std::optional<CameraStageCheck> camera_stage_;
    Picture expected_;
    std::vector<std::size_t> open_;
    Judgement judgement_;
};

}   // namespace

const PixelCauseInfo& cause_info(PixelCause cause) {
    // Colours of Okabe and Ito 2008, "Color universal design"; white for a bug.
    static constexpr std::array<PixelCauseInfo, pixel_causes + 1> infos{{{"snapping", {230, 159, 0}},
                                                                         {"ray_quantisation", {86, 180, 233}},
                                                                         {"seam", {213, 94, 0}},
                                                                         {"t_rounding", {0, 158, 115}},
                                                                         {"primitive_test", {204, 121, 167}},
                                                                         {"shading", {240, 228, 66}},
                                                                         {"texture", {0, 114, 178}},
                                                                         {"horizon", {128, 128, 160}},
                                                                         {"bug", {255, 255, 255}},
                                                                         {"none", {0, 0, 0}}}};
    return infos[std::size_t(cause)];
}

Judgement judge(const FrameInputs& inputs, const MemoryImage& image, const FrameAnswers& answered,
                int threads, const Progress& progress) {
    return arena_of(threads).execute([&] { return Judge(inputs, image, answered)(progress); });
}

std::vector<PixelStage> stages_of(const FrameInputs& inputs, const MemoryImage& image,
                                  const FrameAnswers& answered, std::size_t pixel) {
    return Judge(inputs, image, answered).stages_of(pixel);
}

Picture cause_picture(const Picture& reference, const Judgement& judgement) {
    constexpr float dimmed = 0.25f, third = 1.0f / 3;
    Picture out{reference.size, std::vector<glm::vec3>(reference.pixels.size())};
    for (std::size_t i = 0; i < out.pixels.size(); ++i) {
        const glm::vec3& p = reference.pixels[i];
        // Luminance of linear light, ITU-R BT.709.
        out.pixels[i] =
            glm::vec3(dimmed * std::clamp(0.2126f * p.r + 0.7152f * p.g + 0.0722f * p.b, 0.0f, 1.0f));
        const PixelCause cause = judgement.pixels[i];
        if (cause == PixelCause::none) continue;
        const auto& c = cause_info(cause).colour;
        for (int k = 0; k < 3; ++k) out.pixels[i][k] = float(linear_from_srgb(c[std::size_t(k)] / 255.0));
        if (!judgement.other[i] && cause != PixelCause::bug) out.pixels[i] *= third;
    }
    return out;
}

}   // namespace rayclock
