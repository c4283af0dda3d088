// The named tests, and the demand on each.
#include <algorithm>

#include "model/base/nearest.hpp"
#include "model/unit/tri/baselines/moller.hpp"
#include "model/unit/tri/sheared.hpp"
#include "model/unit/tri/tri.hpp"
#include "model/unit/tri/baselines/truncated.hpp"
#include "model/unit/tri/baselines/unit24.hpp"
#include "model/unit/tri/baselines/woop.hpp"
#include "sim/explore/stress/controls.hpp"

namespace rayclock::stress {

namespace {

/// Returns the sense in which the sheared test passes a triangle: that of its rounded corners in the ray's
/// plane.
int sheared_sense(const Vec3i& o, const Vec3i& d, const oracle::Corners& t, const Config& config) {
    const Shear shear = shear_of(d, config);
    const std::size_t z = shear.axis, x = (z + 1) % 3, y = (z + 2) % 3;
    const auto corner = [&](const Vec3i& p) {
        const std::int64_t height = std::int64_t(p[z]) - o[z], half = std::int64_t(1)
                                                                      << (config.slope_frac_bits() - 1);
        const auto moved = [&](std::size_t k, std::int32_t slope) {
            return std::int64_t(p[k]) - o[k] + ((half - slope * height) >> config.slope_frac_bits());
        };
        return std::array{moved(x, shear.slope[0]), moved(y, shear.slope[1])};
    };
    const auto a = corner(t.a), b = corner(t.b), c = corner(t.c);
    const bool up = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0;
    return up != (shear.neg != 0) ? -1 : 1;
}

}   // namespace

const std::vector<NamedTest>& named_tests() {
    static const std::vector<NamedTest> all = [] {
        std::vector<NamedTest> list{
            {"exact", "edge functions in whole numbers", tri_test, Walks::tree, PrimitiveTest::exact,
             Demand::truth},
            {"sheared", "corners rounded in the ray's plane, then edge functions in whole numbers",
             sheared_test, Walks::no, PrimitiveTest::sheared, Demand::watertight, sheared_sense, 2},
            {"unit24", "SaarCOR's and RPU's map to the unit triangle, in 24-bit floating point", unit24_test,
             Walks::no, PrimitiveTest::unit24, Demand::nothing, nullptr, 2},
            {"moller", "Moeller and Trumbore in float32", moller_test, Walks::no, PrimitiveTest::moller,
             Demand::nothing, nullptr, 2},
            {"woop", "Woop's watertight test in float32, without its double-precision fallback", woop_test,
             Walks::no, PrimitiveTest::woop, Demand::nothing, nullptr, 2},
            {"truncated", "Moeller and Trumbore in Q.16 with truncated products", truncated_test, Walks::no,
             PrimitiveTest::truncated, Demand::nothing, nullptr, 2},
        };
        list.insert(list.end(), controls().begin(), controls().end());
        return list;
    }();
    return all;
}

const NamedTest& named_test(const std::string& name) {
    return by_name(named_tests(), name, "--test: no test");
}

namespace {

/// With fewer rays an existing fault may stay unnoticed. No seam and no control needs more to show.
constexpr std::uint64_t enough_rays = 10'000;

/// The counts of a test, separated into sound families and families that must leak.
struct Found {
    Counts sound, leaky;

    Found(const NamedTest& test, const std::vector<Cell>& cells) {
        for (const Cell& cell : cells)
            if (cell.test == test.name) (family(cell.family).leaks ? leaky : sound) += cell.counts;
    }
    bool leaks_where_it_must() const { return leaky.rays == 0 || leaky.leaks > 0; }
    bool is_watertight() const { return sound.leaks == 0 && sound.double_hits == 0; }
    bool is_exact() const {
        return is_watertight() && sound.oracle_mismatches == 0 && sound.boxes_lost == 0 &&
               sound.false_shadows == 0 && sound.light_leaks == 0;
    }
};

}   // namespace

bool meets_demand(const NamedTest& test, const std::vector<Cell>& cells) {
    const Found found(test, cells);
    switch (test.demand) {
        case Demand::truth: return found.leaks_where_it_must() && found.is_exact();
        case Demand::watertight: return found.leaks_where_it_must() && found.is_watertight();
        case Demand::nothing: return true;
        case Demand::double_hits: return found.sound.double_hits > 0;
        case Demand::leaks: return found.sound.leaks > 0;
        case Demand::mismatches: return found.sound.oracle_mismatches > 0;
    }
    return false;
}

bool has_too_few_rays(const NamedTest& test, const std::vector<Cell>& cells) {
    const Found found(test, cells);
    switch (test.demand) {
        case Demand::truth:
            return found.is_exact() && !found.leaks_where_it_must() && found.leaky.rays < enough_rays;
        case Demand::watertight:
            return found.is_watertight() && !found.leaks_where_it_must() && found.leaky.rays < enough_rays;
        case Demand::nothing: return false;
        default: return !meets_demand(test, cells) && found.sound.rays < enough_rays;
    }
}

}   // namespace rayclock::stress
