#include "sim/fit/measure.hpp"

#include <stdexcept>

#include "model/base/error.hpp"
#include "model/base/interrupted.hpp"
#include "model/hits.hpp"
#include "model/raygen/raygen.hpp"
#include "model/reference/reference.hpp"

namespace rayclock::fit {

namespace {

/// What the bytes of an image depend on.
std::vector<int> image_key(const Config& c) {
    return {c.coord_bits, c.box_bits, c.node_width, c.leaf_size, c.addr_bits, c.prim_bits, c.stack_depth};
}
/// What an outcome depends on.
std::vector<int> outcome_key(const Config& c) {
    std::vector<int> key = image_key(c);
    key.insert(key.end(), {c.dir_bits, c.t_frac_bits, c.recip_bits, c.bary_bits, c.pixel_bits});
    return key;
}

/// Of any pixel's direction.
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

}   // namespace

Measure::Measure(const Scene& scene, FrameSize size, int threads)
    : scene_(scene),
      size_(size),
      threads_(threads),
      reference_(Reference(scene).frame(*scene.camera, size, threads)),
      expected_(shade(scene, reference_)) {}

const Outcome& Measure::operator()(const Config& config) {
    const std::vector<int> key = outcome_key(config);
    const auto known = done_.find(key);
    if (known != done_.end()) return known->second;
    if (interrupted()) throw Interrupted("interrupted: nothing is written");
    if (tell) tell(config, done_.size());
    return done_.emplace(key, measure(config)).first->second;
}

const MemoryImage& Measure::image(const Config& config) {
    const std::vector<int> key = image_key(config);
    const auto known = images_.find(key);
    if (known != images_.end()) return known->second;
    return images_.emplace(key, compile_scene(scene_, scene_.camera->eye, config)).first->second;
}

Outcome Measure::measure(const Config& config) {
    Outcome outcome;
    outcome.pixels = reference_.hits.size();
    try {
        const MemoryImage& image = this->image(config);
        const Frame frame = make_frame(*scene_.camera, size_, image, config);
        const Trace trace = record_trace(image, frame, config, threads_);
        outcome.work = trace.visits + trace.triangle_tests;
        outcome.compile = image.report;
        outcome.direction_squares = largest_square(frame, config);
        const HitScale scale(frame, image.lattice, config);
        HitFrame hits{size_, {}};
        hits.hits.reserve(trace.hits.size());
        for (std::uint32_t i = 0; i < trace.hits.size(); ++i) {
            hits.hits.push_back(scale({i % frame.width, i / frame.width, trace.hits[i]}));
            outcome.other += hits.hits[i].primitive != reference_.hits[i].primitive;
        }
        outcome.psnr_db = compare(shade(scene_, hits), expected_).psnr_db;
    } catch (const UserError& e) {
        outcome.refused = e.what();
    }
    return outcome;
}

}   // namespace rayclock::fit
