// Renders a scene for a configuration, and caches images and results.
#include "sim/explore/fit/measure.hpp"

#include <limits>
#include <stdexcept>

#include "model/base/error.hpp"
#include "model/base/interrupted.hpp"
#include "model/compile/compile.hpp"
#include "model/compile/frame.hpp"
#include "model/trace/hits.hpp"
#include "model/unit/raygen/raygen.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/run/request/reference_picture.hpp"

namespace rayclock::fit {

namespace {

/// Returns the parameters that affect the bytes of an image.
std::vector<int> image_key(const Config& c) {
    return {c.coord_bits, c.box_bits, c.node_width, c.leaf_size, c.addr_bits, c.prim_bits, c.stack_depth};
}
/// Returns the parameters that affect an outcome.
std::vector<int> outcome_key(const Config& c) {
    std::vector<int> key = image_key(c);
    key.insert(key.end(),
               {c.dir_bits, c.t_frac_bits, c.recip_bits, c.bary_bits, c.pixel_bits, c.origin_bits});
    return key;
}

/// Returns the largest square of a direction's length, over all pixels.
std::int64_t largest_square(const Frame& frame, const Config& config) {
    std::int64_t largest = 0;
    for (std::uint32_t y = 0; y < frame.height; ++y)
        for (std::uint32_t x = 0; x < frame.width; ++x) {
            std::int64_t square = 0;
            for (const std::int64_t d : pixel_direction(x, y, frame, config)) square += d * d;
            largest = std::max(largest, square);
        }
    return largest;
}

/// Returns the number of pixels that hold another primitive than the reference's.
std::uint64_t others(const HitFrame& frame, const HitFrame& reference) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < frame.hits.size(); ++i)
        sum += frame.hits[i].primitive != reference.hits[i].primitive;
    return sum;
}

}   // namespace

Measurer::Measurer(const Scene& scene, FrameSize size, int threads, const PictureChoice& choice)
    : scene_(scene), size_(size), threads_(threads), choice_(choice) {
    if (!is_plain()) {
        expect_frames();
        return;
    }
    references_.push_back(Reference(scene).frame(*scene.camera, size, threads));
    expected_.push_back(shade(scene, references_[0]));
}

bool Measurer::is_plain() const {
    return !choice_.finished && choice_.frames.frames == 1 && !moves(scene_) && !scene_.placed;
}

void Measurer::expect_frames() {
    Film film = film_of(scene_, size_, choice_, named_config("default"), {}, false);
    for (std::size_t f = 0; f < film.frames(); ++f) {
        film.next();
        ReferencePicture drawn =
            reference_picture(film.request(), film.camera(), size_, threads_, stopping({}));
        references_.push_back(std::move(drawn.frame.hits));
        expected_.push_back(std::move(drawn.picture));
    }
}

const Measurement& Measurer::operator()(const Config& config) {
    const std::vector<int> key = outcome_key(config);
    const auto known = done_.find(key);
    if (known != done_.end()) return known->second;
    if (interrupted()) throw Interrupted("interrupted: nothing is written");
    if (on_measured) on_measured(config, done_.size());
    return done_.emplace(key, measure(config)).first->second;
}

const MemoryImage& Measurer::image(const Config& config) {
    const std::vector<int> key = image_key(config);
    const auto known = images_.find(key);
    if (known != images_.end()) return known->second;
    return images_.emplace(key, compile_scene(scene_, scene_.camera->eye, config)).first->second;
}

Measurement Measurer::measure(const Config& config) {
    Measurement outcome;
    for (const HitFrame& frame : references_) outcome.pixels += frame.hits.size();
    try {
        is_plain() ? measure_plain(config, outcome) : measure_film(config, outcome);
    } catch (const UserError& e) {
        outcome.refused = e.what();
    }
    return outcome;
}

void Measurer::measure_plain(const Config& config, Measurement& outcome) {
    const MemoryImage& image = this->image(config);
    const Frame frame = make_frame(*scene_.camera, size_, image, config);
    const Trace trace = record_trace(image, frame, config, threads_);
    outcome.work = trace.visits + trace.triangle_tests;
    outcome.compile = image.report;
    outcome.direction_squares = largest_square(frame, config);
    const HitScale scale(frame, image.lattice, config);
    HitFrame hits{size_, {}};
    hits.hits.reserve(trace.hits.size());
    for (std::uint32_t i = 0; i < trace.hits.size(); ++i)
        hits.hits.push_back(scale({i % frame.width, i / frame.width, trace.hits[i]}));
    outcome.other = others(hits, references_[0]);
    outcome.psnr_db = compare(shade(scene_, hits), expected_[0]).psnr_db;
}

void Measurer::measure_film(const Config& config, Measurement& outcome) {
    Film film = film_of(scene_, size_, choice_, config, stopping({}));
    outcome.psnr_db = std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < film.frames(); ++f) {
        film.next();
        const RecordedFrame made = film.record(threads_, stopping({}));
        const HitFrame hits = hits_of(film.job(), made);
        const Picture picture = choice_.finished ? picture_from_colours(size_, made.trace.colours)
                                                 : shade(film.request().scene, hits);
        outcome.other += others(hits, references_[f]);
        outcome.psnr_db = std::min(outcome.psnr_db, compare(picture, expected_[f]).psnr_db);
        outcome.work += made.trace.visits + made.trace.triangle_tests;
        outcome.direction_squares = std::max(outcome.direction_squares, largest_square(made.frame, config));
        const CompileReport before = outcome.compile;
        outcome.compile = film.job().image.report;
        outcome.compile.bytes = std::max(outcome.compile.bytes, before.bytes);
        outcome.compile.stack_need = std::max(outcome.compile.stack_need, before.stack_need);
    }
}

}   // namespace rayclock::fit
