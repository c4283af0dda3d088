#pragma once
// The unit shade in time. pass.hpp computes the passes.
#include <array>
#include <utility>

#include "model/core/ring.hpp"
#include "model/core/stages.hpp"

namespace rayclock {

/// The unit shade in time. A context with its ray's answer makes one or more passes through a pipeline that
/// accepts a pass every shade_interval cycles. pass() computes the passes. A hit waits for its surface, which
/// shade requests.
///
/// With two levels it requests the instance first. Once that has arrived, which is always accepted, it
/// requests the surface. Requests for surfaces have priority over those for instances.
///
/// A textured hit goes to tex, and makes its next pass when the colour has arrived.
///
/// The pipeline accepts surfaces first, then contexts that need another pass, then contexts whose texture
/// colour has arrived, then contexts whose ray hit nothing or was a shadow ray. Its answers are always
/// accepted: a context continues with its next ray, its pixel's end, or another pass. In a fast chip the unit
/// sees a ray's answer two cycles after its arrival. Mirror of rtl/unit/shade/rc_shade.sv.
class Shade {
public:
    enum class Leave : std::uint8_t { again, spawn, pixel, texture };

    explicit Shade(const Config& config)
        : fetch_(config.contexts),
          places_(config.has_homes() ? config.contexts : 1),
          arrived_(config.contexts),
          again_(config.contexts),
          spawns_(config.contexts),
          pixels_(config.contexts),
          textures_(config.has_textures() ? config.contexts : 1),
          textured_(config.has_textures() ? config.contexts : 1),
          pass_(config.shade_latency(), config.shade_queue),
          closest_delay_(std::size_t(Stages(config).closest_delay)),
          hold_cycles_(std::uint32_t(config.shade_interval - 1)) {}

    /// True if it requests a surface or an instance.
    template <bool levels = false> bool surf_valid() const {
        return !fetch_.empty() | (levels && !places_.empty());
    }
    template <bool levels = false, bool few = false> std::uint32_t surf_ray() const {
        if constexpr (levels)
            if (surf_link_.second(!fetch_.empty())) return places_.front<few>();
        return fetch_.front<few>();
    }
    /// True while it is still busy with the first stage of a pass and accepts no other.
    bool is_occupied() const { return hold_left_ > 0; }
    bool ready() const { return pass_.ready() & !is_occupied(); }   ///< can accept a surface
    /// The causes of a cycle, by their codes in the row of shade in model/machine/units.hpp.
    enum Code : std::uint8_t { busy, starved_by_memory, starved_by_list, stalled_by_queue };
    /// Returns the cause of this cycle. `surface`: one arrived. `surface_waits`: a surface is requested and
    /// has not arrived.
    Code code(bool surface, bool surface_waits) const {
        if (is_occupied() || (offers(surface) && pass_.ready())) return busy;
        return offers(surface) ? stalled_by_queue : surface_waits ? starved_by_memory : starved_by_list;
    }
    bool offers(bool surface) const {
        return surface | !again_.empty() | !arrived_.empty() | !textured_.empty();
    }
    /// A hit waits for tex to accept it.
    bool texture_valid() const { return !textures_.empty(); }
    std::uint32_t texture_ray() const { return textures_.front(); }
    bool spawn_valid() const { return !spawns_.empty(); }
    template <bool few = false> std::uint32_t spawn_ray() const { return spawns_.front<few>(); }
    bool pixel_valid() const { return !pixels_.empty(); }
    template <bool few = false> std::uint32_t pixel_ray() const { return pixels_.front<few>(); }
    std::uint64_t due() const { return pass_.due(); }
    bool answers(std::uint64_t now) const { return pass_.valid(now); }
    /// True if a ray's answer has arrived at a fast chip but is not yet seen.
    bool comes() const { return came_[0].valid | came_[1].valid; }

    const char* where(std::uint32_t ray) const {
        const auto r = RayNumber(ray);
        return fetch_.contains(r) || places_.contains(r) ? "shade: waits for the link to surf_cache"
               : arrived_.contains(r) || again_.contains(r) || textured_.contains(r)
                   ? "shade: waits for a pass"
               : textures_.contains(r) ? "shade: waits for tex"
               : pass_.contains(r)     ? "shade: in a pass"
               : spawns_.contains(r)   ? "shade: waits for raygen"
               : pixels_.contains(r)   ? "shade: waits for its pixel to be taken"
               : is_coming(ray)        ? "shade: has just got its answer"
                                       : nullptr;
    }

    /// The next need of a ray after its answer.
    enum class Fetch : std::uint8_t { none, surface, instance };
    /// What reaches the unit in a cycle, and which of its outputs were accepted.
    struct Inputs {
        LinkRay closest{};           ///< the ray whose answer arrived
        Fetch fetch = Fetch::none;   ///< its need
        LinkRay surface{};           ///< the ray whose surface arrived
        LinkRay place{};             ///< the ray whose instance arrived
        LinkRay textured{};          ///< the ray whose texture colour arrived
        bool surf_taken = false;     ///< by surf_cache: a request for a surface or an instance
        bool spawn_taken = false, pixel_taken = false;
        bool texture_taken = false;   ///< by tex: a hit
    };
    /// One clock edge. `turn(ray)` returns the outcome of a pass.
    template <bool levels = false, bool textures = false, bool few = false, class Decide>
    void clock(std::uint64_t now, Inputs in, Decide&& turn) {
        for (std::size_t i = 0; i < closest_delay_; ++i) {   // the unit sees an arrival in a later cycle
            std::swap(in.closest, came_[i]);
            std::swap(in.fetch, arrived_fetches_[i]);
        }
        const bool open = ready(), again = !again_.empty(), arrived = !arrived_.empty(),
                   shown = textures && !textured_.empty();
        const bool answer = pass_.valid(now);
        const RayNumber done = pass_.front();
        if constexpr (levels) {
            const bool second = surf_link_.second(!fetch_.empty());
            surf_link_.clock(surf_valid<levels>(), in.surf_taken, second);
            places_.pop(in.surf_taken & second);
            fetch_.pop(in.surf_taken & !second);
        } else {
            fetch_.pop(in.surf_taken);
        }
        spawns_.pop(in.spawn_taken);
        pixels_.pop(in.pixel_taken);
        const RayNumber next = in.surface.valid ? RayNumber(in.surface.ray)
                               : again          ? again_.front<few>()
                               : shown          ? textured_.front<few>()
                                                : arrived_.front<few>();
        const bool enters = open & (in.surface.valid | again | shown | arrived);
        pass_.clock(now, answer, enters, next);
        hold_left_ = enters ? hold_cycles_ : hold_left_ - is_occupied();
        again_.pop(open & !in.surface.valid & again);
        arrived_.pop(open & !in.surface.valid & !again & !shown & arrived);
        if constexpr (textures) {
            textured_.pop(open & !in.surface.valid & !again & shown);
            textures_.pop(in.texture_taken);
        }
        if (answer) switch (turn(done)) {
                case Leave::again: again_.push<few>(done); break;
                case Leave::spawn: spawns_.push<few>(done); break;
                case Leave::pixel: pixels_.push<few>(done); break;
                case Leave::texture: textures_.push<few>(done); break;
            }
        if constexpr (textures) textured_.push<few>(RayNumber(in.textured.ray), in.textured.valid);
        if constexpr (levels) {
            fetch_.push<few>(RayNumber(in.place.ray), in.place.valid);
            places_.push<few>(RayNumber(in.closest.ray), in.closest.valid & (in.fetch == Fetch::instance));
        } else {
            fetch_.push<few>(RayNumber(in.closest.ray), in.closest.valid & (in.fetch == Fetch::surface));
        }
        arrived_.push<few>(RayNumber(in.closest.ray), in.closest.valid & (in.fetch == Fetch::none));
    }

private:
    bool is_coming(std::uint32_t ray) const {
        return (came_[0].valid && came_[0].ray == ray) || (came_[1].valid && came_[1].ray == ray);
    }

    RayRing fetch_, places_, arrived_, again_, spawns_, pixels_;
    RayRing textures_, textured_;   // hits that wait for tex; hits whose colour has arrived
    Pipe<RayNumber> pass_;
    Merge surf_link_;               // of fetch_ and places_
    std::size_t closest_delay_;     // cycles until an answer is seen
    std::array<LinkRay, 2> came_;   // the answers of these cycles, the last one first
    std::array<Fetch, 2> arrived_fetches_{};
    std::uint32_t hold_cycles_, hold_left_ = 0;   // cycles after a pass in which it accepts none; cycles left
};

}   // namespace rayclock
