// The positions of a pixel's samples. Pictures cannot show errors, because reference and machine share the
// rule.
#include <catch2/catch.hpp>

#include <cmath>
#include <set>

#include "model/scene/whitted.hpp"

using namespace rayclock;

namespace {

/// Returns true if an offset in 1/256 of a pixel lies in a cell of n per side, as exactly as it can be
/// represented.
bool is_within(int offset, int cell, int n) {
    const int from = (offset + 128) * n;   // in 1/256 of a cell
    return from <= 256 * cell + 255 && from + n > 256 * cell;
}

}   // namespace

TEST_CASE("every cell of a pixel holds one sample, and the first four lie in three quarters at least",
          "[scene][samples]") {
    const int n = GENERATE(range(1, max_aa + 1));
    const bool jitter = GENERATE(false, true);
    for (std::uint32_t pixel = 0; pixel < 50; ++pixel) {
        std::set<int> cells;
        std::set<std::pair<bool, bool>> quarters;
        for (int s = 0; s < n * n; ++s) {
            const SampleOffset at = sample_offset(7 * pixel, pixel, std::uint32_t(s), n, jitter, 3);
            const int cell = s * int(sample_stride(n)) % (n * n), column = cell % n, row = cell / n;
            cells.insert(cell);
            CHECK(is_within(at.x, column, n));
            CHECK(is_within(at.y, row, n));
            if (s < int(first_samples) && n % 2 == 0) quarters.emplace(2 * column < n, 2 * row < n);
            if (jitter) continue;
            CHECK(std::abs(at.x + 128 - 256 * (column + 0.5) / n) < 1);   // in the middle
            CHECK(std::abs(at.y + 128 - 256 * (row + 0.5) / n) < 1);
        }
        CHECK(cells.size() == std::size_t(n * n));
        CHECK(quarters.size() >= (n % 2 == 0 ? 3 : 0));
    }
}
