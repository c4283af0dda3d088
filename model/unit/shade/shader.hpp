#pragma once
#include <vector>

#include "model/layout/memory_image.hpp"
#include "model/scene/hit.hpp"
#include "model/scene/whitted.hpp"
#include "model/unit/shade/pass.hpp"

namespace rayclock {

/// Sees what happens to one context, in this order.
class ShadeWatch {
public:
    virtual ~ShadeWatch() = default;
    virtual void sent(const Ray& ray) = 0;
    virtual void answered(const Closest& hit) = 0;
    virtual void passed(const PassIn& in, const PassOut& out) = 0;
};

/// *What* shade does with one context: from a pixel's first camera ray to its colour, ray by ray, the passes
/// one after the other.
class Shader {
public:
    Shader(const Frame& frame, const Config& config, const MemoryImage& image)
        : frame_(&frame), config_(&config), image_(&image) {}

    /// From now on; null: nobody.
    void watch(ShadeWatch* watch) { watch_ = watch; }

    /// sched -> raygen: a pixel.
    void start(const Slot& slot);
    /// raygen -> trav: a ray of this context.
    void sent(const Ray& ray);
    /// list -> shade: its answer.
    void arrived(const Closest& hit) {
        arrived(hit, [this](std::uint32_t line) { return surface_at(line); });
    }
    /// The same, if somebody else has read the surface: surface_at(line).
    template <class SurfaceAt> void arrived(const Closest& hit, const SurfaceAt& surface_at) {
        in_.hit = hit;
        if (wants_surface() && config_->has_homes())
            in_.placement = unpack<Placement>(image_->line(hit.place), *config_);
        if (watch_) watch_->answered(hit);
        if (is_arrival())
            signature_.met(hit.found ? hit.prim : no_primitive);
        else
            signature_.asked(hit.found != 0);
        if (wants_surface()) {
            in_.surface = surface_at(surface_line());
            if (material_line() != 0) in_.surface = in_.surface.with_material(surface_at(material_line()));
        }
        lines_ = !config_->has_homes() ? 0 : material_line() != 0 ? 2 : 1;
        counts_.primary_hits += is_arrival() && hit.found && in_.state.depth == 0;
    }
    /// A surface must come before the next pass: its line.
    bool wants_surface() const { return is_arrival() && in_.hit.found != 0; }
    std::uint32_t surface_line() const {
        if (config_->has_homes())
            return (in_.placement.surfaces + in_.hit.prim) & ((1u << config_->addr_bits) - 1);
        return frame_->shade.surfaces + in_.hit.prim;
    }
    Surface surface_at(std::uint32_t line) const { return unpack<Surface>(image_->line(line), *config_); }
    /// With two levels the instance comes before the surface, and in between its material if it has one for
    /// all: their lines.
    std::uint32_t placement_line() const { return in_.hit.place; }
    std::uint32_t material_line() const { return config_->has_homes() ? in_.placement.material : 0; }
    /// For those who see lines come one by one: which is waited for; that it has come, and whether it was the
    /// surface.
    std::uint32_t next_line() const {
        if (lines_ == 0) return surface_line();
        return lines_ == 1 && material_line() != 0 ? material_line() : placement_line();
    }
    bool got_line() { return lines_-- == 0; }

    /// Passes until a ray or the pixel leaves; returns how many.
    int run();
    bool is_finished() const { return out_.leave == PassOut::Leave::pixel; }
    const Spawn& spawn() const { return out_.spawn; }
    /// What that ray is for.
    RayPurpose purpose() const;
    const Pixel& pixel() const { return out_.pixel; }
    /// Of the pixel so far.
    std::uint64_t signature() const { return signature_.value(); }
    /// Of all pixels that this has shaded.
    const RayCounts& counts() const { return counts_; }

private:
    bool is_arrival() const { return in_.state.event == std::uint32_t(ShadeEvent::arrive); }
    void count(ShadeEvent event);

    const Frame* frame_;
    const Config* config_;
    const MemoryImage* image_;
    ShadeWatch* watch_ = nullptr;
    ShadeEvent last_ = ShadeEvent::arrive;   ///< what the last pass was for
    PassIn in_;
    PassOut out_;
    std::vector<Waiting> stack_;
    RayCounts counts_;
    PathSignature signature_;
    int lines_ = 0;   ///< that come before the surface
};

/// The slot's ray as raygen would get it from shade.
inline Spawn first_spawn(const Slot& slot) {
    Spawn spawn;
    spawn.ray = slot.ray, spawn.x = slot.x, spawn.y = slot.y;
    return spawn;
}

}   // namespace rayclock
