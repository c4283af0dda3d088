// raygen for every direction component of its width, and at a small width for every sum that is rounded to
// one. Judged by plain integers: d = floor((2^s sum + half) / 2^guard_bits) with the largest s that fits, and
// r m <= 2^(M+R-1) < (r + 1) m.
#include "model/unit/raygen/raygen.hpp"
#include "tests/support/cases/small.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

constexpr int row_bits = max_pixel_bits;   // pixels of a row: 2^14

bool right_component(std::int32_t d, std::uint32_t recip, std::uint32_t len, const Config& config) {
    if (d == 0) return recip == 1 && len == 0;
    const std::int64_t size = d < 0 ? -std::int64_t(d) : d,
                       power = std::int64_t(1) << (config.dir_bits + config.recip_bits - 1);
    if (size >> (len - 1) != 1) return false;
    const std::int64_t m = size << (config.dir_bits - int(len));
    return recip * m <= power && power < (std::int64_t(recip) + 1) * m;
}

/// One component per pixel. x takes every number of M bits in rising order. y falls by halves, which are
/// rounded up. z fills its width, so that nothing is shifted.
Frame every_direction(const Config& config) {
    Frame frame;
    const std::int64_t one = std::int64_t(1) << guard_bits, row = std::int64_t(1) << row_bits,
                       most = std::int64_t(1) << (config.dir_bits - 1);
    frame.corner = {-most * one, (most - 1) * one + one / 2, -most * one};
    frame.right = {one, -one, 0};
    frame.down = config.dir_bits > row_bits ? Vec3l{one * row, -one * row, 0} : Vec3l{};
    return frame;
}
/// One unit of the sum per pixel, from the least upwards; on the second axis from the greatest downwards.
Frame every_sum(const Config& config) {
    Frame frame;
    const std::int64_t half = std::int64_t(1) << (config.guard_dir_bits() - 1), row = std::int64_t(1)
                                                                                      << row_bits;
    frame.corner = {-half, half - 1, -half};
    frame.right = {1, -1, 1};
    frame.down = {row, -row, row};
    return frame;
}

Vec3i wanted(std::array<std::int64_t, 3> sum, const Config& config) {
    const std::int64_t end = std::int64_t(1) << (config.guard_dir_bits() - 1), one = std::int64_t(1)
                                                                                     << guard_bits;
    const auto fits = [&](std::int64_t v) { return -end <= 2 * v && 2 * v < end; };
    for (int n = 0; n < max_shift && fits(sum[0]) && fits(sum[1]) && fits(sum[2]); ++n)
        for (std::int64_t& v : sum) v *= 2;
    Vec3i d;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t twice = 2 * sum[k] + one,
                           whole = twice >= 0 ? twice / (2 * one) : -((-twice + 2 * one - 1) / (2 * one));
        d[k] = std::int32_t(std::min(whole, end / one - 1));
    }
    return d;
}

template <class Dut> void try_all(const Config& config, const Frame& frame, std::uint64_t pixels) {
    Dut dut{config, frame};
    std::uint64_t next = 0, seen = 0, wrong = 0;
    pour(
        dut, pixels,
        [&] {
            const std::uint64_t pixel = next++;
            return Slot{0, std::uint32_t(pixel % (1 << row_bits)), std::uint32_t(pixel >> row_bits)};
        },
        [&](const Slot& slot, const Ray& ray) {
            ++seen;
            std::array<std::int64_t, 3> sum;
            for (std::size_t k = 0; k < 3; ++k)
                sum[k] = frame.corner[k] + slot.x * frame.right[k] + slot.y * frame.down[k];
            wrong += ray.d != wanted(sum, config);
            for (std::size_t k = 0; k < 3; ++k)
                wrong += !right_component(ray.d[k], ray.recip[k], ray.len[k], config);
        });
    REQUIRE(seen == pixels);
    REQUIRE(wrong == 0);
}

}   // namespace

TEMPLATE_TEST_CASE("raygen is right for every direction of 6 and of 12 bits", "[raygen][small]",
                   Model<RaygenUnit>, Rtl<RaygenUnit>) {
    for (const Config& config : {small_format(4, 6, 4, 1, 2), small_format(4, 12, 9, 1, 2)})
        try_all<TestType>(config, every_direction(config), std::uint64_t(1) << config.dir_bits);
}

TEMPLATE_TEST_CASE("raygen is right for every sum of 20 bits", "[raygen][small][slow]", Model<RaygenUnit>,
                   Rtl<RaygenUnit>) {
    // M = 6: 2^20 sums.
    const Config config = small_format(4, 6, 4, 1, 2);
    try_all<TestType>(config, every_sum(config), std::uint64_t(1) << config.guard_dir_bits());
}

TEMPLATE_TEST_CASE("raygen is right for every direction of the configurations", "[raygen][small][slow]",
                   Model<RaygenUnit>, Rtl<RaygenUnit>) {
    for (const char* name : {"default", "small"}) {
        const Config config = format(name);
        try_all<TestType>(config, every_direction(config), std::uint64_t(1) << config.dir_bits);
    }
}
