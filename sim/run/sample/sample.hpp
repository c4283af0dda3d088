#pragma once
// Samples of a frame. Only some parts of the frame are recorded and replayed. They give estimates of all
// figures: docs/guide/sampling.md.
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "sim/run/frame/frame.hpp"
#include "sim/run/sample/estimate.hpp"

namespace rayclock::sample {

/// The size of a sample.
struct Ask {
    double share = 0;   ///< share of the frame's parts to measure, up to max_share; 0: the smallest sample
    std::uint64_t seed = 1;
};
constexpr double max_share = 0.3;

/// Returns the number of strata of a sample. Throws UserError if the frame is too small.
std::uint32_t strata_of(const Frame& frame, const Config& config, double share);

/// The work of a sample.
struct Effort {
    std::uint32_t parts = 0, measured = 0, strata = 0;
    std::uint64_t pixels = 0;            ///< of the frame
    std::uint64_t measured_pixels = 0;   ///< in measured parts
    std::uint64_t replayed_pixels = 0;   ///< with warm-up and tail
    std::uint64_t single_pixels = 0;     ///< walked alone, for the auxiliary variable
    double seconds = 0;                  ///< of the host
    Effort& operator+=(const Effort& other);
};

/// Kinds of work of a pixel's rays, independent of timing. Single pixels, spread over the frame, give
/// estimates of their totals.
enum class Work : std::uint8_t {
    expected_cycles,   ///< cycles of one pipeline for the pixel, in 64ths: see Pace
    visits,
    box_tests,
    triangle_tests,
    primary,
    shadow,
    reflection,
    refraction,
    primary_hits,
    instances,   ///< visits of instances
    slots,       ///< places of tiles, also outside the picture; their total is exact
};
constexpr std::size_t work_kinds = 11;
using WorkCounts = std::array<std::uint64_t, work_kinds>;

/// A figure of a frame or of a part. The figures of all parts sum to the figure of the frame.
using Figure = std::function<double(const FrameTiming&)>;

/// Returns the kind of work to which a unit's busy cycles are most nearly proportional.
Work work_of(Unit unit);

/// The sampled frame at one clock.
class Sampled {
public:
    struct Measured {
        FrameTiming timing;
        WorkCounts work{};
    };
    /// `coarse` has the totals of all kinds of work.
    Sampled(int khz, Effort effort, std::vector<Stratum> strata, std::vector<Measured> parts,
            std::vector<std::uint32_t> numbers, std::array<Auxiliary, work_kinds> coarse);

    int khz() const { return khz_; }
    const Effort& effort() const { return effort_; }
    Estimate work(Work kind) const { return sample::total(works_[std::size_t(kind)]); }
    /// Estimates a figure. `by` should be the kind of work to which the figure is most nearly proportional.
    Estimate total(const Figure& figure, Work by = Work::expected_cycles) const {
        return sample::total(strata_, values(figure), works_[std::size_t(by)]);
    }
    Estimate ratio(const Figure& above, const Figure& below, Work by = Work::expected_cycles) const {
        return sample::ratio(strata_, values(above), values(below), works_[std::size_t(by)]);
    }
    /// Estimates the cycles of a unit that have the cause with this code.
    Estimate account(const Config& config, Unit unit, std::size_t code) const;
    /// Returns all totals as whole numbers, in the form of a frame that was simulated. In the accounts, the
    /// causes of a unit sum to the cycles. It has no hits, no colours and no digest.
    FrameResult frame(const Config& config) const;

private:
    PartValues values(const Figure& figure) const;

    int khz_;
    Effort effort_;
    std::vector<Stratum> strata_;
    std::vector<Measured> parts_;          ///< the measured parts, in ascending order
    std::vector<std::uint32_t> numbers_;   ///< the numbers of these parts
    std::array<Auxiliary, work_kinds> works_;
};

/// Samples a job's frame at each clock. The result does not depend on the number of threads. `before` is the
/// frame before it in a film, if the caches keep its lines; its rays read lines of the job's image. Throws
/// UserError if the frame is too small, and Interrupted after Ctrl-C.
std::vector<Sampled> run(const Job& job, const std::vector<int>& khz, const Ask& ask,
                         Disturbance disturbance = {}, int threads = 0, const Progress& progress = {},
                         const Frame* before = nullptr);

/// Returns the cycles of the host's writes before a frame, and of the reset. All writes are simulated, on a
/// machine without other work.
UploadTiming upload_timing(const Config& config, int khz, Disturbance disturbance, const Upload& upload);

}   // namespace rayclock::sample
