#pragma once
// One ray of a hard case, judged by the oracle.
#include <array>
#include <memory>

#include "model/unit/isect/primitive.hpp"
#include "sim/judge/oracle/surface.hpp"
#include "model/trace/walk.hpp"
#include "sim/explore/stress/families.hpp"

namespace rayclock::stress {

/// In which sense a ray passes a triangle, as oracle::Passage has it, in the eyes of a test that moves
/// corners.
using Sense = int (*)(const Vec3i& o, const Vec3i& d, const oracle::Corners& triangle, const Config& config);

/// Whether rays go through the tree as well, and through which.
enum class Walks { no, tree, small_boxes };

/// What came of rays.
struct Counts {
    std::uint64_t rays = 0;
    std::uint64_t leaks = 0;               ///< rays that pass a closed surface without a hit
    std::uint64_t double_hits = 0;         ///< rays that hit a closed surface twice in one place
    std::uint64_t oracle_mismatches = 0;   ///< rays of which any decision is not the exact one
    std::uint64_t crossings = 0;           ///< that the oracle found
    std::uint64_t walked = 0;              ///< rays that went through the tree as well
    std::uint64_t boxes = 0;               ///< child boxes that some of these were told to look into
    std::uint64_t boxes_extra = 0;         ///< of these, such as the ray does not meet
    std::uint64_t boxes_lost = 0;          ///< child boxes that it meets, and was not told
    std::uint64_t shadow_rays = 0;         ///< secondary rays from the surface
    std::uint64_t false_shadows = 0;       ///< of these said to be blocked, though truly free; see
                                           ///< sim/explore/stress/shadows.hpp
    std::uint64_t light_leaks = 0;         ///< and the other way round
    Counts& operator+=(const Counts& other);
    friend bool operator==(const Counts&, const Counts&) = default;
};
/// All of them, in the order in which a state has them.
inline constexpr std::array count_fields{
    &Counts::rays,       &Counts::leaks,       &Counts::double_hits,   &Counts::oracle_mismatches,
    &Counts::crossings,  &Counts::walked,      &Counts::boxes,         &Counts::boxes_extra,
    &Counts::boxes_lost, &Counts::shadow_rays, &Counts::false_shadows, &Counts::light_leaks};

/// What a test's counts must be.
enum class Demand {
    truth,        ///< what the oracle says: nothing leaks, nothing is hit twice, no decision is another
    watertight,   ///< nothing leaks or is hit twice
    nothing,
    double_hits,
    leaks,
    mismatches,   ///< controls: there must be some
};

/// A test by name.
struct NamedTest {
    const char* name;
    const char* what;
    TriTest* test = nullptr;
    Walks walks = Walks::no;
    PrimitiveTest primitive_test = PrimitiveTest::exact;
    Demand demand = Demand::nothing;
    Sense sense = nullptr;   ///< that of the exact normal
    int margin = 0;          ///< lattice steps by which it may be off
};
/// True for tests that the hardware has: exact and sheared. Baselines and controls are there for comparison.
inline bool in_machine(const NamedTest& test) {
    return test.demand == Demand::truth || test.demand == Demand::watertight;
}

/// Judges a test on one surface.
///
/// For each ray the triangles that it may meet are put to the oracle and to the test, each by itself. Where
/// they disagree: a crossing that the oracle finds counts as found if the test hits that triangle, or one
/// that shares a corner with it and is passed in the same sense, each hit once; what is left over of the
/// oracle's is a leak, of the test's a double hit. Two of opposite sense that share a corner are no matter
/// (the ray grazes, and the test sees the outline elsewhere). And on a closed surface crossings inwards less
/// crossings outwards must be minus the number of bodies around the origin: if not, and nothing was counted,
/// the surface itself lets the ray through, a leak. A test that moves corners (it has a `sense` of its own)
/// has another surface than the oracle, so for it this sum alone decides: a leak if it found fewer hits than
/// the oracle, a double hit if not. Its origin must be clear of the surface by more than it moves.
///
/// Every `walk_every`th ray is walked through the tree as well, and its closest hit is compared with the
/// oracle's, its stack with the depth that compilation promised; of these every `look_every`th, if its
/// direction fills its bits, is asked which child boxes it was told to look into.
class Judge {
public:
    Judge(const Case& subject, const Config& config, const NamedTest& test, bool closed);
    void judge(const Shot& shot, Counts& counts);

    static constexpr int walk_every = 16, look_every = 4;

private:
    struct Watch;
    struct Hit {
        std::uint32_t primitive;
        int sense;
    };
    void compare_hits(Counts& counts);
    bool clear_of_bounds(const Vec3i& o) const;
    bool walk_agrees(const Shot& shot, bool look, Counts& counts);
    static void look_at_boxes(const Shot& shot, const WideNode& node, std::uint32_t told, Counts& counts);

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

    // The machine's own way to the closest hit; absent for tests that no machine has.
    MemoryImage image_;
    Frame frame_;
    std::unique_ptr<Decoder> decoder_;
    std::unique_ptr<Walk> walk_;
};

}   // namespace rayclock::stress
