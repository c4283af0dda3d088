#pragma once
// The work of the unit shade on one context, without timing.
#include <optional>
#include <vector>

#include "model/layout/memory_image.hpp"
#include "model/scene/hit.hpp"
#include "model/scene/whitted.hpp"
#include "model/unit/shade/pass/pass.hpp"
#include "model/unit/tex/texel.hpp"

namespace rayclock {

/// An observer of one context. Events arrive in the order in which they happen.
class ShadeWatch {
public:
    virtual ~ShadeWatch() = default;
    virtual void sent(const Ray& ray) = 0;
    virtual void answered(const Closest& hit) = 0;
    virtual void passed(const PassIn& in, const PassOut& out) = 0;
    /// Handles the arrival of a texture's colour.
    virtual void filtered(const TexReq&, const TexRecord&, const TexelPlace&, const TexRsp&) {}
};

/// *What* shade does with one context: from a pixel's first camera ray to its colour, ray by ray, pass by
/// pass.
class Shader {
public:
    Shader(const Frame& frame, const Config& config, const MemoryImage& image)
        : frame_(&frame), config_(&config), image_(&image) {}

    /// Sets the observer from now on; null removes it.
    void watch(ShadeWatch* watch) { watch_ = watch; }

    /// sched -> raygen: starts a pixel.
    void start(const Slot& slot);
    /// raygen -> trav: a ray of this context was sent.
    void sent(const Ray& ray);
    /// list -> shade: accepts the ray's answer.
    void arrived(const Closest& hit) {
        arrived(hit, [this](std::uint32_t line) { return surface_at(line); });
    }
    /// Does the same with surfaces that the caller has read: surface_at(line).
    template <class SurfaceAt> void arrived(const Closest& hit, const SurfaceAt& surface_at) {
        in_.hit = hit;
        if (wants_surface() && config_->has_homes())
            instance_ = unpack<Placement>(image_->line(hit.instance_line), *config_);
        if (is_arrival() && hit.found) in_.placement = instance_;
        if (meets_cutout(in_)) in_.placement.texel_scale = instance_.texel_scale;
        if (watch_) watch_->answered(hit);
        if (is_arrival())
            signature_.met(hit.found ? hit.prim : no_primitive);
        else if (!meets_cutout(in_))   // the texture of a cut-out decides later
            signature_.asked(hit.found != 0);
        if (wants_surface()) {
            in_.surface = surface_at(surface_line());
            if (material_line() != 0) in_.surface = in_.surface.with_material(surface_at(material_line()));
        }
        lines_ = !config_->has_homes() ? 0 : material_line() != 0 ? 2 : 1;
        counts_.primary_hits += is_arrival() && hit.found && in_.state.depth == 0 && in_.state.holes == 0;
    }
    /// True if a surface must arrive before the next pass: the surface that was hit, or a cut-out in the way
    /// to a light. surface_line() is its line.
    bool wants_surface() const { return (is_arrival() && in_.hit.found != 0) || meets_cutout(in_); }
    std::uint32_t surface_line() const {
        if (config_->has_homes())
            return (instance_.first_surface_line + in_.hit.prim) & ((1u << config_->addr_bits) - 1);
        return frame_->shade.first_surface_line + in_.hit.prim;
    }
    Surface surface_at(std::uint32_t line) const { return unpack<Surface>(image_->line(line), *config_); }
    /// With two levels these lines come before the surface: the instance, then its material if it has one for
    /// all its primitives.
    std::uint32_t placement_line() const { return in_.hit.instance_line; }
    std::uint32_t material_line() const { return config_->has_homes() ? instance_.material : 0; }
    /// For callers that see lines arrive one by one. next_line() is the line awaited. got_line() records its
    /// arrival and returns true if it was the surface.
    std::uint32_t next_line() const {
        if (lines_ == 0) return surface_line();
        return lines_ == 1 && material_line() != 0 ? material_line() : placement_line();
    }
    bool got_line() { return lines_-- == 0; }

    /// Runs passes until a ray or the pixel leaves, and returns their number.
    int run();
    bool is_finished() const { return out_.leave == PassOut::Leave::pixel; }
    const Spawn& spawn() const { return out_.spawn; }
    /// The texture of the last answer's surface, for callers that process its requests one by one.
    struct Texture {
        TexReq request;
        TexRecord record;
        TexelPlace place;
        TexRsp answer;
        bool is_cutout = false;   ///< the surface is a cut-out in the way to a light
    };
    /// Returns the texture that the last run() read; null if it read none.
    const Texture* texture() const { return texture_ ? &*texture_ : nullptr; }
    /// Returns the purpose of that ray.
    RayPurpose purpose() const;
    const Pixel& pixel() const { return out_.pixel; }
    /// Returns the signature of the pixel so far.
    std::uint64_t signature() const { return signature_.value(); }
    /// Returns the counts of all pixels shaded so far.
    const RayCounts& counts() const { return counts_; }

private:
    bool is_arrival() const { return in_.state.next_event == ShadeEvent::arrive; }
    void count(ShadeEvent event);
    void read_texture();

    const Frame* frame_;
    const Config* config_;
    const MemoryImage* image_;
    ShadeWatch* watch_ = nullptr;
    ShadeEvent last_ = ShadeEvent::arrive;   ///< event of the last pass
    PassIn in_;
    Placement instance_;   ///< with two levels: the instance in the last answer
    PassOut out_;
    std::vector<Waiting> stack_;
    std::optional<Texture> texture_;
    RayCounts counts_;
    PathSignature signature_;
    int lines_ = 0;   ///< lines that are still to come before the surface
};

/// Returns the slot's ray in the form in which shade would spawn it.
inline Spawn first_spawn(const Slot& slot) {
    Spawn spawn;
    spawn.ray = slot.ray, spawn.x = slot.x, spawn.y = slot.y;
    return spawn;
}

}   // namespace rayclock
