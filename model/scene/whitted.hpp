#pragma once
// The definition of the finished picture that all engines share: the depth of the tree of rays, and the
// places of a pixel's samples.
#include <array>
#include <cstdint>

namespace rayclock {

constexpr int max_depth = 15, max_aa = 8;
/// Maximum number of holes that a ray passes before its next bounce, and that light passes on its way to a
/// point. The next hole counts as opaque.
constexpr int max_holes = 63;

/// Whitted 1980, "An improved illumination model for shaded display": local light, shadow rays, reflection,
/// refraction.
struct Whitted {
    int depth = 5;   ///< bounces of a camera ray, 0..15; a hit at this depth does not reflect or refract
    /// A reflected or refracted ray of less weight is not traced (Hall, Greenberg 1983); 0: all are.
    double threshold = 0;
    int aa = 1;            ///< a pixel has aa x aa samples, 1..8
    bool jitter = false;   ///< 1: each sample lies anywhere in its cell (Cook 1986), not in the middle
    /// If not 0: after 4 samples, trace the rest only if some channel differs by more among them.
    double contrast = 0;
    std::uint32_t seed = 1;   ///< of the jitter
};

/// True if a weight is not below the threshold, so that its ray is traced. Both represent the decimal numbers
/// as written. Their products may be low by a few units of 2^-53, so a relative error of 2^-46 is allowed.
inline bool weighs_enough(double weight, double threshold) { return weight >= threshold * (1 - 0x1p-46); }

/// The purpose of a ray.
enum class RayPurpose : std::uint8_t { camera, shadow, reflection, refraction };
constexpr std::array<const char*, 4> purpose_names{"camera", "shadow", "reflection", "refraction"};

/// Numbers of rays sent, with and without hits. A total reflection counts as a refracted ray, as
/// Haines counts it.
struct RayCounts {
    std::uint64_t primary = 0, shadow = 0, reflection = 0, refraction = 0;
    std::uint64_t primary_hits = 0;
    RayCounts& operator+=(const RayCounts& o) {
        primary += o.primary, shadow += o.shadow, reflection += o.reflection, refraction += o.refraction,
            primary_hits += o.primary_hits;
        return *this;
    }
    friend RayCounts operator-(RayCounts a, const RayCounts& b) {
        a.primary -= b.primary, a.shadow -= b.shadow, a.reflection -= b.reflection,
            a.refraction -= b.refraction, a.primary_hits -= b.primary_hits;
        return a;
    }
    std::uint64_t all() const { return primary + shadow + reflection + refraction; }
    friend bool operator==(const RayCounts&, const RayCounts&) = default;
};

/// The hits of a pixel's rays as one number. Two engines with equal numbers have made the same decisions
/// throughout. Rays come in the order of the tree, depth first: a surface, its lights, its reflection, its
/// refraction.
class PathSignature {
public:
    void start() { state_ = 0xcbf29ce484222325u; }
    void met(std::uint32_t primitive) { add(std::uint64_t(primitive) + 2); }
    void asked(bool blocked) { add(blocked); }
    std::uint64_t value() const { return state_; }

private:
    void add(std::uint64_t what) {
        state_ = (state_ ^ what) * 0x9e3779b97f4a7c15u;
        state_ ^= state_ >> 29;
    }
    std::uint64_t state_ = 0xcbf29ce484222325u;
};

/// Number of samples that decide whether a pixel gets the rest.
constexpr std::uint32_t first_samples = 4;

/// Returns the step from one sample's cell to the next one's, of n x n cells; prime to n * n.
std::uint32_t sample_stride(int n);

/// Offset from the pixel's middle to a sample, right and down, in 1/256 of a pixel: -128..127.
struct SampleOffset {
    std::int32_t x = 0, y = 0;
    friend bool operator==(const SampleOffset&, const SampleOffset&) = default;
};
/// Returns the offset of sample s, 0..n * n - 1, of pixel (x, y). The pixel has n x n cells; s visits them in
/// strides, so that the first few lie far apart. This is part of the camera's definition, the same for every
/// engine. Mirror of rtl/unit/raygen/rc_sample.sv.
SampleOffset sample_offset(std::uint32_t x, std::uint32_t y, std::uint32_t s, int n, bool jitter,
                           std::uint32_t seed);

}   // namespace rayclock
