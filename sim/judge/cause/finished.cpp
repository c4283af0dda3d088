// Finds the cause of each differing pixel of a finished picture.
#include "sim/judge/cause/finished.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "model/base/stopwatch.hpp"
#include "model/scene/texture.hpp"
#include "sim/files/image/srgb.hpp"
#include "sim/judge/cause/guide.hpp"
#include "sim/judge/cause/snapped.hpp"
#include "sim/judge/reference/tiles.hpp"

namespace rayclock {

namespace {

constexpr std::size_t max_shading_faults = 20;

/// Passes the events of one pixel to several watches.
class Watches final : public ShadeWatch {
public:
    explicit Watches(std::vector<ShadeWatch*> all) : all_(std::move(all)) {}
    void sent(const Ray& ray) override {
        for (ShadeWatch* w : all_) w->sent(ray);
    }
    void answered(const Closest& hit) override {
        for (ShadeWatch* w : all_) w->answered(hit);
    }
    void passed(const PassIn& in, const PassOut& out) override {
        for (ShadeWatch* w : all_) w->passed(in, out);
    }
    void filtered(const TexReq& hit, const TexRecord& record, const TexelPlace& place,
                  const TexRsp& answer) override {
        for (ShadeWatch* w : all_) w->filtered(hit, record, place, answer);
    }

private:
    std::vector<ShadeWatch*> all_;
};

/// Collects the findings of a pixel's rays, with two levels.
class SeamWatch final : public ShadeWatch {
public:
    explicit SeamWatch(const SeamFinder& seams) : seams_(seams) {}
    void sent(const Ray& ray) override { ray_ = ray; }
    void answered(const Closest& hit) override {
        // The seam search does not know which cut-outs this ray ignores, and would report them as hits. The
        // guide tests their holes.
        if (ray_.holes > 0 && !hit.found) return;
        const RayFinding found = seams_.explain(ray_, hit, &apart);
        has_seam |= found == RayFinding::seam;
        is_lost |= found == RayFinding::none;
    }
    void passed(const PassIn&, const PassOut&) override {}

    bool has_seam = false, is_lost = false;
    double apart = 0;

private:
    const SeamFinder& seams_;
    Ray ray_;
};

/// The stages from the scene as given to the machine, for one frame.
class CauseStages {
public:
    CauseStages(const FrameInputs& inputs, const Whitted& settings, const PictureJudge& judge)
        : inputs_(inputs),
          settings_(settings),
          judge_(judge),
          size_{int(inputs.frame.width), int(inputs.frame.height)},
          world_(snapped_scene(inputs, judge.placed())),
          camera_(snapped_camera(inputs)),
          bound_(inputs, pixel_rays(inputs.camera, size_)),
          reference_(world_.scene) {
        if (judge.placed()) seams_.emplace(*judge.placed(), inputs.config);
    }
    const std::vector<std::string>& faults() const { return world_.faults; }

    struct Found {
        PixelCause cause = PixelCause::bug;
        std::string fault;   ///< of a bug
        std::uint32_t ties = 0;
        double seams_apart = 0;
    };
    /// The scratch data of one thread, which follows the machine's pixels one after the other.
    struct Bench {
        ShadedRecorder recorder;
        RecordScratch scratch;
        PathJudge judge;
        MachinePath path;
        explicit Bench(const CauseStages& owner)
            : recorder(owner.judge_.recorder()), scratch(owner.inputs_.config), judge(owner.judge_.rules()) {}
    };
    /// `reference`: signature of the pixel's rays in the scene as given; `mine`: of the machine's.
    Found operator()(Bench& bench, std::uint32_t x, std::uint32_t y, std::uint64_t reference,
                     std::uint64_t mine, const glm::dvec3& colour) const {
        const GuideFinding last = last_stage(x, y, bench, colour);
        Found found;
        found.ties = last.ties;
        if (!last.fault.empty()) {
            found.fault = last.fault;
        } else if (mine == reference) {
            found.cause = last.has_texture ? PixelCause::texture : PixelCause::shading;
        } else if (last.has_horizon) {
            found.cause = PixelCause::horizon;
        } else if (mine == reference_.pixel(camera_, size_, settings_, x, y).signature) {
            found.cause = PixelCause::snapping;
        } else {
            find_seam(x, y, bench, last, found);
        }
        return found;
    }

private:
    /// Draws the pixel with the reference on the machine's rays, and checks its colour.
    GuideFinding last_stage(std::uint32_t x, std::uint32_t y, Bench& bench, const glm::dvec3& colour) const {
        Watches both({&bench.judge, &bench.path});
        bench.judge.start(x, y);
        bench.path.start();
        bench.recorder.follow(x, y, bench.scratch, both);
        const std::array<Range, 3> bounds = bench.judge.bounds();
        double width = unit_step;
        for (const Range& range : bounds) width = std::max(width, range.hi - range.lo + unit_step);
        const GuideRules rules{inputs_,
                               world_.scene,
                               reference_,
                               bound_,
                               sample_spread(camera_, size_, settings_.aa),
                               settings_.contrast,
                               judge_.placed(),
                               seams_ ? &*seams_ : nullptr};
        Guide guide(rules, bench.path, width * double(bench.path.samples.size()));
        const WhittedPixel pixel = reference_.pixel(camera_, size_, settings_, x, y, &guide);
        guide.finish();
        GuideFinding found = guide.finding();
        // The bounds do not include the rounding of R0 in Schlick's term. R0 has unit_bits, and each bounce
        // may add its error to a weight.
        const double slack = unit_step * double(1 + bench.path.visits.size());
        for (std::size_t k = 0; k < 3 && found.fault.empty() && !found.has_horizon; ++k)
            if (bounds[k].wider(slack).holds(pixel.colour[int(k)]))
                continue;
            else if (found.has_lost)
                found.has_horizon = true;
            else
                found.fault = "by the reference's rules its rays give another colour: " +
                              std::to_string(pixel.colour[int(k)]) + " in channel " + std::to_string(k) +
                              ", and the machine's is " + std::to_string(colour[int(k)]);
        return found;
    }

    void find_seam(std::uint32_t x, std::uint32_t y, Bench& bench, const GuideFinding& last,
                   Found& found) const {
        found.cause = last.has_seam ? PixelCause::seam : PixelCause::ray_quantisation;
        if (!seams_) return;
        SeamWatch watch(*seams_);
        bench.recorder.follow(x, y, bench.scratch, watch);
        found.seams_apart = watch.apart;
        if (watch.has_seam) found.cause = PixelCause::seam;
        if (!watch.is_lost) return;
        found.cause = PixelCause::bug;
        found.fault = no_finding;
    }

    const FrameInputs& inputs_;
    const Whitted& settings_;
    const PictureJudge& judge_;
    FrameSize size_;
    SnappedScene world_;
    Camera camera_;
    CameraBound bound_;
    Reference reference_;
    std::optional<SeamFinder> seams_;
};

}   // namespace

Judgement judge_finished(const FrameInputs& inputs, const MemoryImage& image, const Whitted& settings,
                         const FinishedAnswer& answered, const HitFrame& hits, int threads,
                         const Progress& progress) {
    const Stopwatch watch;
    const PictureJudge judge(inputs, image, settings);
    const PictureJudgement judged = judge.judge(answered.given, threads, progress);
    const std::size_t pixels = hits.hits.size();
    Judgement j;
    j.pixels.assign(pixels, PixelCause::none);
    j.other.assign(pixels, false);
    j.wrong = judged.wrong;
    j.rays = judged.rays;
    j.colours = judged.colours;
    j.widest = judged.widest;
    j.faults = judged.faults;

    const bool can_follow = !judge.placed() || judge.placed()->faults().empty();
    std::optional<CauseStages> cause_stages;
    if (can_follow) cause_stages.emplace(inputs, settings, judge);
    std::vector<std::optional<CauseStages::Found>> found(pixels);
    const auto width = std::size_t(hits.size.width);
    const auto follow_row = [&](const PixelTile& tile) {
        const auto y = std::size_t(tile.rows().begin());
        std::optional<CauseStages::Bench> bench;
        for (std::size_t i = y * width; i < (y + 1) * width; ++i) {
            const bool is_other = answered.reference.hits.hits[i].primitive != hits.hits[i].primitive;
            const glm::vec3& mine = answered.picture.pixels[i];
            const bool differs =
                is_other || srgb_bytes(glm::vec3(answered.reference.pixels[i])) != srgb_bytes(mine);
            if (!cause_stages || judged.pixels[i] || !differs) continue;
            if (!bench) bench.emplace(*cause_stages);
            found[i] = (*cause_stages)(*bench, std::uint32_t(i % width), std::uint32_t(y),
                                       answered.reference.signatures[i], answered.given.signatures[i], mine);
        }
    };
    for_each_tile(hits.size, threads, "finding causes", progress, follow_row, {hits.size.width, 1});

    const auto report = [&](std::size_t pixel, const std::string& sentence) {
        ++j.wrong;
        if (j.faults.size() < max_shading_faults)
            j.faults.push_back({std::uint32_t(pixel % width), std::uint32_t(pixel / width), 0, sentence});
    };
    if (cause_stages)
        for (const std::string& sentence : cause_stages->faults()) report(0, sentence);
    for (std::size_t i = 0; i < pixels; ++i) {
        j.other[i] = answered.reference.hits.hits[i].primitive != hits.hits[i].primitive;
        if (judged.pixels[i]) {
            j.pixels[i] = PixelCause::bug;
        } else if (found[i]) {
            j.pixels[i] = found[i]->cause;
            j.ties += found[i]->ties;
            j.seams_apart = std::max(j.seams_apart, found[i]->seams_apart);
            if (found[i]->cause == PixelCause::bug) report(i, found[i]->fault);
        }
        if (j.pixels[i] == PixelCause::none) continue;
        ++j.causes[std::size_t(j.pixels[i])];
        if (j.other[i]) ++j.causes_other[std::size_t(j.pixels[i])];
    }
    j.seconds = watch.seconds();
    return j;
}

}   // namespace rayclock
