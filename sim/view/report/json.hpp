#pragma once
// Reports as JSON; every key is explained in docs/report.md.
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "model/scene/scene.hpp"
#include "sim/judge/cause/cause.hpp"
#include "sim/run/engine/engine.hpp"
#include "sim/files/image/image.hpp"
#include "sim/run/lockstep/lockstep.hpp"

namespace rayclock {

/// The frames that a machine made at one clock. Reports are of the last, when caches are warm.
struct ClockRun {
    int khz = 0;
    std::vector<FrameRun> frames;
    const FrameRun& last() const { return frames.back(); }
    bool partial() const { return frames.back().partial; }
};

/// How a machine's frame differs from the reference's.
struct FrameError {
    std::uint64_t pixels = 0, pixels_other_primitive = 0;
    double psnr_db = 0;
    std::uint64_t depth_pixels = 0;   ///< hold a primitive, the same one in both pictures, and no plane
                                      ///< further away than the chip can say
    double max_abs_depth = 0;   ///< over these, scene units; of pixels with several samples the first one's
    double max_relative_depth = 0;   ///< likewise, as a share of the reference's depth
};
FrameError frame_error(const Scene& scene, const HitFrame& frame, const HitFrame& reference);
/// The same for pictures that were made otherwise.
FrameError frame_error(const HitFrame& frame, const Picture& picture, const HitFrame& reference,
                       const Picture& reference_picture);

nlohmann::ordered_json scene_json(const Scene& scene);
nlohmann::ordered_json camera_json(const Camera& camera);
nlohmann::ordered_json config_json_object(const Config& config);
nlohmann::ordered_json compile_json(const CompileReport& report);
nlohmann::ordered_json rays_json(const FrameRun& run);
nlohmann::ordered_json work_json(const FrameRun& run);
nlohmann::ordered_json clock_json(const Config& config, const ClockRun& run);
nlohmann::ordered_json units_json(const Config& config, const FrameRun& run);
nlohmann::ordered_json memory_json(const Config& config, int khz, const FrameRun& run);
/// What was judged, what was wrong, and what it cost; null without a judge.
nlohmann::ordered_json judge_json(const std::optional<Judgement>& judgement);
nlohmann::ordered_json error_json(const std::optional<FrameError>& error,
                                  const std::optional<Judgement>& judgement);
nlohmann::ordered_json causes_json(const PixelCauses& causes);
nlohmann::ordered_json divergence_json(const std::optional<Divergence>& divergence);
nlohmann::ordered_json counter_json(const std::optional<CounterDifference>& difference);

/// JSON has no infinity: equal pictures give null.
nlohmann::ordered_json decibel(double psnr_db);

/// 64 bits as 16 hexadecimal digits.
std::string digest_text(std::uint64_t digest);

}   // namespace rayclock
