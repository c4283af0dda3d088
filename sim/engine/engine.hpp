#pragma once
// Whole frames on the model or on the RTL, with what they cost.
#include <string>

#include "model/accel/memory_image.hpp"
#include "model/core/channels.hpp"
#include "model/core/progress.hpp"
#include "model/mem/memport.hpp"
#include "model/scene/hit.hpp"

namespace rayclock {

/// A scene compiled for one configuration and one picture: all that a machine needs.
struct Job {
    Config config;
    Frame frame;
    MemoryImage image;
    FrameSize size;
};
Job make_job(const Scene& scene, const Camera& camera, FrameSize size, const Config& config, const Progress& progress = {});

/// A frame that a machine made.
struct FrameRun {
    HitFrame hits;
    std::uint64_t cycles = 0;
    ChannelCounts counts{};
    std::uint64_t box_tests = 0;
    double seconds = 0;        ///< of the host
    std::uint64_t digest = 0;  ///< over every pixel's primitive, t, u and v, and the cycles
};
FrameRun run_model(const Job& job, Traffic traffic = {}, const Progress& progress = {});
FrameRun run_rtl(const Job& job, Traffic traffic = {}, const Progress& progress = {}, int seed = 1);

/// Gathers hits as they come out.
class FrameCollector {
public:
    explicit FrameCollector(const Job& job);
    void add(const HitOut& out);
    /// Finishes a run: picture, digest.
    void finish(FrameRun& run);

private:
    const Job& job_;
    std::vector<HitOut> outs_;
};

/// Cycles without any transfer after which a run is given up: longer than any memory request can take.
std::uint64_t patience(const Config& config, const Traffic& traffic);

} // namespace rayclock
