#pragma once
// Makes streams of rays with the reference tracer: camera rays, and the rays that a renderer sends next.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/base/progress.hpp"
#include "model/compile/stream.hpp"
#include "model/scene/camera.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

enum class RayStreamKind {
    camera,    ///< the rays that the chip's raygen sends, so a picture and its stream have the same hits
    shadow,    ///< from a camera ray's hit to each light: any hit before t = 1
    mirror,    ///< mirrored at the hits of camera rays, or of mirrored rays
    ao,        ///< ambient occlusion: cosine-weighted, any hit within a radius
    diffuse,   ///< cosine-weighted bounces
};
enum class RayOrder { recorded, morton, random };

/// The most rays that a chip can number (pixel_bits=14).
constexpr std::size_t max_rays = (std::size_t(1) << 28) - 1;

struct RayStreamPlan {
    RayStreamKind kind = RayStreamKind::camera;
    FrameSize size;
    int bounce = 1;      ///< for mirror and diffuse: number of the bounce, from 1
    int samples = 1;     ///< for ao and diffuse: rays from each hit
    double radius = 0;   ///< for ao, in scene units; 0: a tenth of the diagonal of the scene's bounds
    std::uint64_t seed = 1;
    RayOrder order = RayOrder::recorded;
};

/// The settings of a stream as the user gives them.
struct RayStreamChoice {
    std::string kind = "camera", order = "recorded";
    FrameSize size;
    int bounce = 1, samples = 1;
    std::optional<double> radius;
    std::uint64_t seed = 1;
};
/// Checks the settings. `prefix` stands before their names in messages: "--" on the command line. Throws
/// UserError.
RayStreamPlan ray_stream_plan(const RayStreamChoice& choice, const std::string& prefix);

/// Makes the rays of a stream, pixel by pixel. A ray from a surface begins on the side from which the surface
/// was seen, at a distance of 2^-16 of the diagonal of the scene's bounds. Diffuse directions are
/// cosine-weighted (Shirley, Morley 2003: a point of the unit sphere around the tip of the normal). The rays
/// do not depend on the number of threads. `config` gives the directions of camera rays. Throws UserError if
/// shadow rays are requested and the scene has no light, or if there might be more than max_rays.
std::vector<StreamRay> make_rays(const Scene& scene, const RayStreamPlan& plan, const Config& config,
                                 int threads = 0, const Progress& progress = {});

/// Orders rays: morton by origin and direction, random by the seed. recorded changes nothing.
void order_rays(std::vector<StreamRay>& rays, RayOrder order, std::uint64_t seed = 1);

/// Returns rays as an .npy file of float64: n x 6, or n x 9 if some have a t_max or ask for any hit. Throws
/// UserError for an empty stream; `scene` is the name of the scene in its message.
std::string rays_npy(const std::vector<StreamRay>& rays, const std::string& scene);

}   // namespace rayclock
