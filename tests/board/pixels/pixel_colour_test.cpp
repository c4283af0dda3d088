// Pixels on their way to the screen: bytes as in the host's PNG, places in order, and the model's timing.
#include <deque>

#include <catch2/catch.hpp>

#include "model/base/rng.hpp"
#include "model/board/pixel_colour.hpp"
#include "model/core/payloads.hpp"
#include "sim/files/image/srgb.hpp"
#include "sim/run/rtl/rtl_module.hpp"
#include "sim/run/rtl/signal.hpp"

namespace rayclock::test::pixel_colour_test {

using namespace rayclock;

namespace {

constexpr std::uint32_t full = 1U << unit_bits;   // full light

std::uint32_t bytes_of(const std::array<std::uint8_t, 3>& colour) {
    return std::uint32_t(colour[0]) | std::uint32_t(colour[1]) << 8 | std::uint32_t(colour[2]) << 16;
}

std::uint32_t expected(const HitOut& hit, const Config& config) {
    if (!config.has_shade()) return bytes_of(label_colour(hit.closest.found, hit.closest.prim));
    std::array<std::uint8_t, 3> colour;
    for (std::size_t c = 0; c < 3; ++c) colour[c] = srgb_byte(double(hit.colour[c]) / full);
    return bytes_of(colour);
}

/// The RTL with its model. Both see the same pixels, and every cycle compares them.
class Pair {
public:
    explicit Pair(const Config& config)
        : config_(config), rtl_(config, "rc_pixel_colour"), model_(config.has_shade()) {
        hit_valid_ = 0, pixel_ready_ = 0;
        rtl_.reset();
    }

    /// One cycle with a pixel on offer, or null. Returns true if it was accepted.
    bool cycle(const HitOut* hit, bool ready) {
        hit_valid_ = hit != nullptr, pixel_ready_ = ready;
        if (hit) set_data(rtl_.port("hit"), *hit, config_);
        rtl_.settle();
        REQUIRE(bool(hit_ready_) == model_.ready());
        REQUIRE(bool(pixel_valid_) == model_.valid());
        const bool enters = hit && model_.ready(), leaves = ready && model_.valid();
        if (model_.valid()) {
            const HitOut& oldest = inside_.front();
            REQUIRE((model_.place().x == oldest.x && model_.place().y == oldest.y));
            REQUIRE(std::uint32_t(x_) == oldest.x);
            REQUIRE(std::uint32_t(y_) == oldest.y);
            REQUIRE(std::uint32_t(colour_) == expected(oldest, config_));
        }
        if (leaves) inside_.pop_front(), ++left;
        if (enters) inside_.push_back(*hit);
        const PixelColour::PixelPlace place =
            hit ? PixelColour::PixelPlace{hit->x, hit->y} : PixelColour::PixelPlace{};
        rtl_.clock();
        model_.clock(leaves, enters ? &place : nullptr);
        return enters;
    }

    std::uint64_t left = 0;   ///< pixels that have left

private:
    Config config_;
    RtlModule rtl_;
    Signal hit_valid_{rtl_, "hit_valid"}, pixel_ready_{rtl_, "pixel_ready"}, hit_ready_{rtl_, "hit_ready"},
        pixel_valid_{rtl_, "pixel_valid"}, x_{rtl_, "x"}, y_{rtl_, "y"}, colour_{rtl_, "colour"};
    PixelColour model_;
    std::deque<HitOut> inside_;
};

HitOut random_hit(Rng& rng, const Config& config) {
    HitOut hit;
    const auto draw = [&](std::uint32_t below) { return std::uint32_t(rng.below(int(below))); };
    hit.x = draw(1U << config.pixel_bits), hit.y = draw(1U << config.pixel_bits);
    hit.closest.found = draw(4) > 0;
    hit.closest.prim = draw(2) ? draw(1U << 20) : ~std::uint32_t(0) - draw(3);
    for (std::uint32_t& channel : hit.colour) channel = draw(8) ? draw(full + 1) : draw(2) * full;
    return hit;
}

}   // namespace

TEST_CASE("every linear value becomes the byte that a PNG has", "[rtl]") {
    Pair pair(named_config("ulx3s-shaded"));
    HitOut hit;
    for (std::uint32_t value = 0; value <= full;) {
        hit.colour = {value, full - value, (value * 40503u) % (full + 1)};
        value += pair.cycle(&hit, true);
    }
    for (int i = 0; i < 20; ++i) pair.cycle(nullptr, true);
    CHECK(pair.left == full + 1);
}

TEST_CASE("pixels keep their order and the model's timing under back-pressure", "[rtl]") {
    for (const char* name : {"ulx3s", "ulx3s-shaded"}) {
        const Config config = named_config(name);
        for (const int percent : {0, 30, 90, 100}) {
            INFO(name << ", the writer is ready in " << percent << " % of the cycles");
            Pair pair(config);
            Rng rng(std::uint64_t(percent) + 1);
            HitOut hit = random_hit(rng, config);
            for (int cycle = 0; cycle < 4000; ++cycle) {
                const bool offered = rng.below(8) > 0;
                if (pair.cycle(offered ? &hit : nullptr, rng.below(100) < percent))
                    hit = random_hit(rng, config);
            }
            CHECK((percent == 0 ? pair.left == 0 : pair.left > 400));
        }
    }
}

TEST_CASE("neighbouring primitives have different colours on the screen") {
    using Bytes = std::array<std::uint8_t, 3>;
    CHECK(label_colour(false, 5) == Bytes{0, 0, 0});
    CHECK(label_colour(true, 0) == Bytes{128, 0, 0});   // label 1 of PASCAL VOC
    CHECK(label_colour(true, 1) == Bytes{0, 128, 0});
    CHECK(label_colour(true, 2) == Bytes{128, 128, 0});
    CHECK(label_colour(true, 14) == Bytes{192, 128, 128});   // label 15, person
    CHECK(label_colour(true, 19) == Bytes{0, 64, 128});      // label 20, television
    CHECK(label_colour(true, ~std::uint32_t(0)) == Bytes{0, 0, 0});
}

}   // namespace rayclock::test::pixel_colour_test
