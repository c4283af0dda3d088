#pragma once
// Judges single rays of hard cases with the exact oracle.
#include <array>
#include <memory>

#include "model/trace/walk.hpp"
#include "model/unit/tri/tri_test.hpp"
#include "sim/explore/stress/families.hpp"
#include "sim/judge/oracle/surface.hpp"

namespace rayclock::stress {

/// The sense in which a ray passes a triangle, as in oracle::Passage, for a test that moves corners.
using Sense = int (*)(const Vec3i& o, const Vec3i& d, const oracle::Corners& triangle, const Config& config);

/// Selects whether rays also walk a tree, and which one.
enum class Walks { no, tree, small_boxes };

/// Results of rays.
struct Counts {
    std::uint64_t rays = 0;
    std::uint64_t leaks = 0;               ///< rays that pass a closed surface without a hit
    std::uint64_t double_hits = 0;         ///< rays that hit a closed surface twice at one place
    std::uint64_t oracle_mismatches = 0;   ///< rays with any decision that differs from the exact one
    std::uint64_t crossings = 0;           ///< crossings that the oracle found
    std::uint64_t walked = 0;              ///< rays that also walked the tree
    std::uint64_t boxes = 0;               ///< child boxes that these rays visited
    std::uint64_t boxes_extra = 0;         ///< visited boxes that the ray does not meet
    std::uint64_t boxes_lost = 0;          ///< boxes that the ray meets but did not visit
    std::uint64_t shadow_rays = 0;         ///< secondary rays from the surface
    /// Shadow rays reported as blocked that are free; see sim/explore/stress/shadows.hpp.
    std::uint64_t false_shadows = 0;
    std::uint64_t light_leaks = 0;   ///< shadow rays reported as free that are blocked
    Counts& operator+=(const Counts& other);
    friend bool operator==(const Counts&, const Counts&) = default;
};
/// All counts, in the order of the state file.
inline constexpr std::array count_fields{
    &Counts::rays,       &Counts::leaks,       &Counts::double_hits,   &Counts::oracle_mismatches,
    &Counts::crossings,  &Counts::walked,      &Counts::boxes,         &Counts::boxes_extra,
    &Counts::boxes_lost, &Counts::shadow_rays, &Counts::false_shadows, &Counts::light_leaks};

/// The required result of a test.
enum class Demand {
    truth,        ///< exact: no leaks, no double hits, no other decision
    watertight,   ///< no leaks and no double hits
    nothing,
    double_hits,   ///< control: there must be some
    leaks,         ///< control: there must be some
    mismatches,    ///< control: there must be some
};

/// A triangle test with its name and its required result.
struct NamedTest {
    const char* name;
    const char* what;
    TriTest* test = nullptr;
    Walks walks = Walks::no;
    PrimitiveTest primitive_test = PrimitiveTest::exact;
    Demand demand = Demand::nothing;
    Sense sense = nullptr;   ///< the test's own sense, or null for that of the exact normal
    int margin = 0;          ///< lattice steps by which a corner may move
};
/// Returns true for tests of the hardware: exact and sheared. All others are baselines and controls.
inline bool in_machine(const NamedTest& test) {
    return test.demand == Demand::truth || test.demand == Demand::watertight;
}

/// Judges a test on one surface.
///
/// For each ray, the oracle and the test decide separately about every triangle that the ray may meet. Where
/// they disagree, hits are matched to crossings. A crossing is found if the test hits that triangle, or one
/// that shares a corner with it and is passed in the same sense. Each hit counts once. A crossing without a
/// hit is a leak, a hit without a crossing a double hit. Two of opposite sense that share a corner are
/// ignored: the ray grazes, and the test sees the outline elsewhere.
///
/// On a closed surface, crossings inwards minus crossings outwards must be minus the number of bodies around
/// the origin. If they are not and nothing else was counted, the surface itself lets the ray through, which
/// is a leak. A test that moves corners (with its own `sense`) has a different surface than the oracle, so
/// this sum alone decides. It is a double hit if the test found more hits than the oracle, else a leak. The
/// origin must be farther from the surface than the corners move.
///
/// Every `walk_every`th ray also walks the tree. Its closest hit must be the oracle's, and its stack must
/// stay within the depth that compilation promised. For every `box_check_every`th of these, the visited child
/// boxes are checked if the direction uses its full width.
class Judge {
public:
    Judge(const Case& subject, const Config& config, const NamedTest& test, bool closed);
    void judge(const Shot& shot, Counts& counts);

    static constexpr int walk_every = 16, box_check_every = 4;

private:
    struct Watch;
    struct Hit {
        std::uint32_t primitive;
        int sense;
    };
    void compare_hits(Counts& counts);
    bool clear_of_bounds(const Vec3i& o) const;
    bool walk_agrees(const Shot& shot, bool checks_boxes, Counts& counts);
    static void check_boxes(const Shot& shot, const WideNode& node, std::uint32_t told, Counts& counts);

    const Mesh& mesh_;
    Config config_;
    const NamedTest& test_;
    bool closed_;
    oracle::Surface surface_;
    std::vector<PrimData> triangles_;
    std::vector<std::uint32_t> candidates_;
    std::vector<Hit> truth_, found_;
    oracle::ExactHit closest_;
    TriRsp answer_;

    // The machine's walk to the closest hit; absent for tests that no machine has.
    MemoryImage image_;
    Frame frame_;
    std::unique_ptr<Decoder> decoder_;
    std::unique_ptr<Walk> walk_;
};

}   // namespace rayclock::stress
