#pragma once
// One ray of a hard case, judged by the oracle.
#include <memory>

#include "model/oracle/surface.hpp"
#include "model/trace/walk.hpp"
#include "sim/stress/families.hpp"

namespace rayclock::stress {

/// A primitive test as model/isect has them: whether the triangle is hit closer than `best`, and where.
using Test = void (*)(const Vec3i& o, const Vec3i& d, const PrimData& triangle, const Best& best, const Config& config, TriRsp& out);

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
    Counts& operator+=(const Counts& other);
    friend bool operator==(const Counts&, const Counts&) = default;
};

/// Judges a test on one surface.
///
/// For each ray the triangles that it may meet are put to the oracle and to the test, each by itself. Where they disagree: a
/// crossing that the oracle finds counts as found if the test hits that triangle, or one that shares a corner with it and is
/// passed in the same sense, each hit once; what is left over of the oracle's is a leak, of the test's a double hit. Two of
/// opposite sense that share a corner are no matter (the ray grazes, and the test sees the outline elsewhere). And on a closed
/// surface crossings inwards less crossings outwards must be minus the number of bodies around the origin: if not, and nothing
/// was counted, the surface itself lets the ray through, a leak. A ray is walked through the tree as well, every
/// `walk_every`th, and its closest hit is compared with the oracle's.
class Judge {
public:
    Judge(const Case& subject, const Config& config, Test test, bool closed, Walks walks);
    void judge(const Shot& shot, Counts& counts);

    static constexpr int walk_every = 8;

private:
    struct Hit {
        std::uint32_t primitive;
        int sense;
    };
    void compare_hits(const Shot& shot, Counts& counts);
    bool walk_agrees(const Shot& shot);

    const Mesh& mesh_;
    Config config_;
    Test test_;
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

} // namespace rayclock::stress
