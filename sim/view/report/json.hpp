#pragma once
// Reports as JSON. docs/guide/report.md explains every key.
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "model/scene/scene.hpp"
#include "sim/files/image/image.hpp"
#include "sim/judge/cause/cause.hpp"
#include "sim/run/frame/frame.hpp"
#include "sim/run/lockstep/lockstep.hpp"

namespace rayclock {

/// The frames that a machine rendered at one clock. Reports describe the last frame, when the caches are
/// warm.
struct FramesAtClock {
    int khz = 0;
    std::vector<FrameResult> frames;
    const FrameResult& last() const { return frames.back(); }
    bool partial() const { return frames.back().partial; }
};

/// The differences between a machine's frame and the reference.
struct FrameError {
    std::uint64_t pixels = 0, pixels_other_primitive = 0;
    double psnr_db = 0;
    /// Pixels with the same primitive in both pictures, without planes beyond the chip's range of depth.
    std::uint64_t depth_pixels = 0;
    double max_abs_depth = 0;        ///< over depth_pixels, scene units; uses the first sample of a pixel
    double max_relative_depth = 0;   ///< over depth_pixels, relative to the reference's depth
};
FrameError frame_error(const Scene& scene, const HitFrame& frame, const HitFrame& reference);
/// Compares frames whose pictures are already rendered.
FrameError frame_error(const HitFrame& frame, const Picture& picture, const HitFrame& reference,
                       const Picture& reference_picture);

nlohmann::ordered_json scene_json(const Scene& scene);
nlohmann::ordered_json camera_json(const Camera& camera);
nlohmann::ordered_json config_json_object(const Config& config);
nlohmann::ordered_json compile_json(const CompileReport& report);
nlohmann::ordered_json rays_json(const RayCounts& rays);
nlohmann::ordered_json work_json(const FrameResult& run);
nlohmann::ordered_json clock_json(const Config& config, const FramesAtClock& run);
nlohmann::ordered_json units_json(const Config& config, const FrameResult& run);
nlohmann::ordered_json memory_json(const Config& config, int khz, const FrameResult& run);
/// Returns what was judged, what was wrong and the judge's cost; null without a judgement.
nlohmann::ordered_json judge_json(const std::optional<Judgement>& judgement);
nlohmann::ordered_json error_json(const std::optional<FrameError>& error,
                                  const std::optional<Judgement>& judgement);
nlohmann::ordered_json causes_json(const PixelCauses& causes);
nlohmann::ordered_json divergence_json(const std::optional<Divergence>& divergence);
nlohmann::ordered_json counter_json(const std::optional<CounterDifference>& difference);

/// Returns null for infinity, the PSNR of equal pictures, because JSON has no infinity.
nlohmann::ordered_json decibel(double psnr_db);

/// Returns 64 bits as 16 hexadecimal digits.
std::string digest_text(std::uint64_t digest);

}   // namespace rayclock
