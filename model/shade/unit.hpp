#pragma once
#include "model/base/ring.hpp"

namespace rayclock {

/// The unit shade: when. A context that has its ray's answer passes once or more through a pipeline that does
/// one pass every shade_interval cycles; what a pass does is pass()'s business. A hit waits for its surface,
/// which shade asks for.
///
/// The pipeline takes surfaces first, then contexts that need another pass, then those whose ray hit nothing
/// or was a shadow ray. Its answers are always taken: a context goes on to its next ray, to its pixel's end,
/// or passes again. Mirror of rtl/shade/rc_shade.sv.
class Shade {
public:
    enum class Turn : std::uint8_t { again, spawn, pixel };

    explicit Shade(const Config& config)
        : fetch_(config.contexts),
          arrived_(config.contexts),
          again_(config.contexts),
          spawns_(config.contexts),
          pixels_(config.contexts),
          pass_(config.shade_latency(), config.shade_queue),
          rests_(std::uint32_t(config.shade_interval - 1)) {}

    bool surf_valid() const { return !fetch_.empty(); }   ///< a surface is asked for
    std::uint32_t surf_ray() const { return fetch_.front(); }
    bool rests() const { return rest_ > 0; }                  ///< it took a pass, and takes no other yet
    bool ready() const { return pass_.ready() & !rests(); }   ///< for a surface
    /// What it does in this cycle, of units.hpp, with or without a surface that came, or that memory owes.
    std::uint32_t code(bool surface, bool surface_waits) const {
        if (rests()) return 0;
        return offers(surface) ? (pass_.ready() ? 0 : 3) : surface_waits ? 1 : 2;
    }
    bool offers(bool surface) const { return surface | !again_.empty() | !arrived_.empty(); }
    bool spawn_valid() const { return !spawns_.empty(); }
    std::uint32_t spawn_ray() const { return spawns_.front(); }
    bool pixel_valid() const { return !pixels_.empty(); }
    std::uint32_t pixel_ray() const { return pixels_.front(); }
    std::uint64_t due() const { return pass_.due(); }
    bool answers(std::uint64_t now) const { return pass_.valid(now); }

    const char* where(std::uint32_t ray) const {
        const auto r = RayNumber(ray);
        return fetch_.contains(r)                           ? "shade: waits for the link to surf_cache"
               : arrived_.contains(r) || again_.contains(r) ? "shade: waits for a pass"
               : pass_.contains(r)                          ? "shade: in a pass"
               : spawns_.contains(r)                        ? "shade: waits for raygen"
               : pixels_.contains(r)                        ? "shade: waits for its pixel to be taken"
                                                            : nullptr;
    }

    /// One clock edge: the ray whose answer came and whether it wants a surface, the one whose surface is
    /// there, and which outputs were taken. `turn(ray)` tells what a pass has led to.
    template <class Decide> void clock(std::uint64_t now, OnLink closest, bool wants_surface, OnLink surface,
                                       bool surf_taken, bool spawn_taken, bool pixel_taken, Decide&& turn) {
        const bool open = ready(), again = !again_.empty(), arrived = !arrived_.empty();
        const bool answer = pass_.valid(now);
        const RayNumber done = pass_.front();
        fetch_.pop(surf_taken);
        spawns_.pop(spawn_taken);
        pixels_.pop(pixel_taken);
        const RayNumber next = surface.there ? RayNumber(surface.ray)
                               : again       ? again_.front()
                                             : arrived_.front();
        const bool enters = open & (surface.there | again | arrived);
        pass_.clock(now, answer, enters, next);
        rest_ = enters ? rests_ : rest_ - rests();
        again_.pop(open & !surface.there & again);
        arrived_.pop(open & !surface.there & !again & arrived);
        if (answer) switch (turn(done)) {
                case Turn::again: again_.push(done); break;
                case Turn::spawn: spawns_.push(done); break;
                case Turn::pixel: pixels_.push(done); break;
            }
        fetch_.push(RayNumber(closest.ray), closest.there & wants_surface);
        arrived_.push(RayNumber(closest.ray), closest.there & !wants_surface);
    }

private:
    RayRing fetch_, arrived_, again_, spawns_, pixels_;
    Pipe<RayNumber> pass_;
    std::uint32_t rests_, rest_ = 0;   // cycles after a pass in which it takes none; that are left
};

}   // namespace rayclock
