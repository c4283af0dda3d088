// The tracer's public functions, on a flat or a folded scene.
#include "sim/judge/reference/reference.hpp"

#include "model/base/error.hpp"
#include "model/scene/folded.hpp"
#include "sim/judge/reference/geometry.hpp"
#include "sim/judge/reference/instances.hpp"
#include "sim/judge/reference/tiles.hpp"
#include "sim/judge/reference/whitted.hpp"

namespace rayclock {

struct Reference::Impl {
    std::unique_ptr<RefInstances> instances;   ///< only for a folded scene; the geometry is empty then
    RefGeometry geometry;
    const Scene& scene;   ///< only whitted() and pixel() use it

    explicit Impl(const Scene& s)
        : instances(is_folded(s) ? std::make_unique<RefInstances>(*s.placed) : nullptr),
          geometry(instances ? Scene{} : s),
          scene(s) {}
    Hit trace(const glm::dvec3& origin, const glm::dvec3& direction) const {
        if (instances) return instances->trace(origin, direction);
        RefPath path;
        return geometry.find_path(origin, direction, path) ? ref_hit(geometry.closest(path), geometry.space())
                                                           : Hit{};
    }
};

Reference::Reference(const Scene& scene) : impl_(std::make_unique<Impl>(scene)) {}
Reference::~Reference() = default;
Reference::Reference(Reference&&) noexcept = default;

Hit Reference::trace(const glm::dvec3& origin, const glm::dvec3& direction) const {
    return impl_->trace(origin, direction);
}

HitFrame Reference::frame(const Camera& camera, FrameSize size, int threads, const Progress& progress) const {
    check_frame_size(size);
    const PixelRays rays = pixel_rays(camera, size);
    HitFrame frame{size, std::vector<Hit>(static_cast<std::size_t>(size.width) * size.height)};
    for_each_tile(size, threads, "reference", progress, [&](const PixelTile& tile) {
        for (int y = tile.rows().begin(); y < tile.rows().end(); ++y)
            for (int x = tile.cols().begin(); x < tile.cols().end(); ++x)
                frame.hits[static_cast<std::size_t>(y) * size.width + x] =
                    impl_->trace(rays.eye, rays.direction(x, y));
    });
    return frame;
}

WhittedFrame Reference::whitted(const Camera& camera, FrameSize size, const Whitted& settings, int threads,
                                const Progress& progress, const RayWatch& watch) const {
    if (impl_->instances)
        throw UserError(impl_->scene.name +
                        ": so many placed triangles have no finished picture, only camera rays");
    return ref_whitted(impl_->geometry, impl_->scene, camera, size, settings, threads, progress, watch);
}

WhittedPixel Reference::pixel(const Camera& camera, FrameSize size, const Whitted& settings, std::uint32_t x,
                              std::uint32_t y, RefSteer* steer) const {
    return ref_pixel(impl_->geometry, impl_->scene, camera, size, settings, x, y, steer);
}

const RefGeometry& Reference::geometry() const { return impl_->geometry; }

}   // namespace rayclock
