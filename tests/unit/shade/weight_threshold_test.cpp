// "A ray of less weight than the threshold is not traced", for weights and thresholds as written. These are
// decimal numbers whose products are compared in whole hundredths and ten thousandths. The chip rounds them
// to binary fractions.
#include <cmath>

#include <catch2/catch.hpp>

#include "model/compile/surfaces.hpp"
#include "model/scene/whitted.hpp"
#include "model/unit/shade/bounce/bounce.hpp"
#include "model/unit/shade/pass/pass.hpp"

using namespace rayclock;

namespace {

enum class Way { reflected, refracted, total };

/// A scene of one triangle whose material has these weights in hundredths, with everything that a pass needs.
struct Chip {
    Scene scene;
    Config config;
    MemoryImage image;
    Chip() {
        scene.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        scene.triangles = {{{0, 1, 2}, 0}};
        scene.materials = {{}};
        scene.materials[0].index = 1.5;
        config.shading = config.refraction = 1;
        config.bounces = 15;
    }
    Surface surface(int mirror, int transmit) {
        scene.materials[0].mirror = mirror / 100.0, scene.materials[0].transmit = transmit / 100.0;
        return surface_of(scene, image.lattice, config, 0);
    }
    Frame frame(double threshold) {
        Whitted settings;
        settings.depth = 15, settings.threshold = threshold;
        Frame frame;
        frame.shade = make_shade_frame(scene, settings, image, 1, config);
        return frame;
    }
};

/// The result for a ray of some weight that meets a surface at a right angle: `weight` is the weight of the
/// next ray, and `sent` says whether it is traced.
struct Bounced {
    std::uint32_t weight = 0;
    bool sent = false;
};
Bounced bounced(const Chip& chip, const Frame& frame, const Surface& s, std::uint32_t weight,
                std::uint32_t depth, Way way) {
    PassIn in;
    ShadeState& state = in.state;
    state = fresh_state(0, 0);
    state.next_event = way == Way::refracted ? ShadeEvent::refract : ShadeEvent::reflect;
    state.weight = weight, state.depth = depth;
    state.mirror = s.mirror, state.transmit = s.transmit, state.ratio = s.enter,
    state.total = way == Way::total;
    state.n = {0, 0, 1000}, state.normal = state.view = {0, 0, 1 << unit_bits}, state.cosine = 1 << unit_bits;
    const PassOut out = pass(in, frame, chip.config);
    if (way == Way::refracted) return {refract(chip.config, state).weight, out.push};
    return {reflect(chip.config, state).weight, out.leave == PassOut::Leave::spawn};
}

Surface surface_for(Chip& chip, int weight, Way way) {
    // The weight of a total reflection is written in two parts.
    if (way == Way::total) return chip.surface(weight / 3, weight - weight / 3);
    return way == Way::reflected ? chip.surface(weight, 0) : chip.surface((100 - weight) / 2, weight);
}

constexpr std::uint32_t one = 1 << unit_bits;

}   // namespace

TEST_CASE("a weight that is the threshold is traced, as written, and one that is a hundredth less is not",
          "[threshold]") {
    const Way way = GENERATE(Way::reflected, Way::refracted, Way::total);
    Chip chip;
    for (int threshold = 0; threshold <= 100; ++threshold) {
        const Frame frame = chip.frame(threshold / 100.0);
        for (int weight = 1; weight <= 100; ++weight) {
            CAPTURE(int(way), threshold, weight);
            const bool sent = bounced(chip, frame, surface_for(chip, weight, way), one, 0, way).sent;
            REQUIRE(sent == (weight >= threshold));
            REQUIRE(weighs_enough(weight / 100.0, threshold / 100.0) == (weight >= threshold));
        }
    }
}

TEST_CASE("products of two weights are compared with the threshold as written", "[threshold]") {
    const Way first = GENERATE(Way::reflected, Way::refracted, Way::total),
              second = GENERATE(Way::reflected, Way::refracted, Way::total);
    Chip chip;
    std::vector<Frame> frames;
    for (int threshold = 0; threshold <= 100; ++threshold) frames.push_back(chip.frame(threshold / 100.0));
    for (int a = 1; a <= 100; ++a)
        for (int b = 1; b <= 100; ++b) {
            const std::uint32_t weight =
                bounced(chip, frames[0], surface_for(chip, a, first), one, 0, first).weight;
            const Surface surface = surface_for(chip, b, second);
            // Thresholds around the product. The hundredths below it and at it are the ties.
            for (int threshold = std::max(0, a * b / 100 - 1); threshold <= std::min(100, a * b / 100 + 2);
                 ++threshold) {
                CAPTURE(int(first), int(second), threshold, a, b);
                const bool sent =
                    bounced(chip, frames[std::size_t(threshold)], surface, weight, 1, second).sent;
                REQUIRE(sent == (a * b >= 100 * threshold));
                REQUIRE(weighs_enough(a / 100.0 * (b / 100.0), threshold / 100.0) ==
                        (a * b >= 100 * threshold));
            }
        }
}

TEST_CASE("no product of weights loses its tie in fifteen bounces, and none far below passes",
          "[threshold]") {
    Chip chip;
    const Way ways[] = {Way::reflected, Way::refracted, Way::total};
    for (int mirror = 30; mirror <= 100; ++mirror)
        for (int start = 0; start < 3; ++start) {
            std::uint32_t weight = one;
            long double written = 1;
            for (std::uint32_t bounce = 1; bounce <= 15; ++bounce) {
                const Way way = ways[(start + int(bounce)) % 3];
                const Surface surface = surface_for(chip, mirror, way);
                written *= mirror / 100.0L;
                const double tie = double(written), margin = (3 * bounce + 0.5) / one;
                CAPTURE(mirror, start, bounce, tie);
                REQUIRE(bounced(chip, chip.frame(tie), surface, weight, bounce - 1, way).sent);
                const Bounced far =
                    bounced(chip, chip.frame(std::min(1.0, tie + margin)), surface, weight, bounce - 1, way);
                REQUIRE((!far.sent || tie + margin > 1));
                weight = far.weight;
            }
        }
}

TEST_CASE("without a threshold every weight above zero is traced", "[threshold]") {
    Chip chip;
    chip.scene.materials[0].mirror = 1e-9, chip.scene.materials[0].transmit = 1e-9;
    const Surface s = surface_of(chip.scene, chip.image.lattice, chip.config, 0);
    CHECK((s.mirror == 1 && s.transmit == 1));
    const Frame frame = chip.frame(0);
    CHECK(bounced(chip, frame, s, one, 0, Way::reflected).sent);
    CHECK(bounced(chip, frame, s, 0, 14, Way::refracted).sent);
}
