#pragma once
#include <array>
#include <utility>

#include "model/core/ring.hpp"
#include "model/core/stages.hpp"

namespace rayclock {

/// The unit shade: when. A context that has its ray's answer passes once or more through a pipeline that does
/// one pass every shade_interval cycles; what a pass does is pass()'s business. A hit waits for its surface,
/// which shade asks for.
///
/// With two levels it asks for the instance first, and when that has come, which is always taken, for the
/// surface; requests for surfaces go before those for instances.
///
/// The pipeline takes surfaces first, then contexts that need another pass, then those whose ray hit nothing
/// or was a shadow ray. Its answers are always taken: a context goes on to its next ray, to its pixel's end,
/// or passes again. In a fast chip a ray's answer is looked at two cycles after it came. Mirror of
/// rtl/unit/shade/rc_shade.sv.
class Shade {
public:
    enum class Turn : std::uint8_t { again, spawn, pixel };

    explicit Shade(const Config& config)
        : fetch_(config.contexts),
          places_(config.has_homes() ? config.contexts : 1),
          arrived_(config.contexts),
          again_(config.contexts),
          spawns_(config.contexts),
          pixels_(config.contexts),
          pass_(config.shade_latency(), config.shade_queue),
          late_(std::size_t(Stages(config).closest)),
          rests_(std::uint32_t(config.shade_interval - 1)) {}

    /// A surface is asked for, or an instance.
    template <bool levels = false> bool surf_valid() const {
        return !fetch_.empty() | (levels && !places_.empty());
    }
    template <bool levels = false> std::uint32_t surf_ray() const {
        if constexpr (levels)
            if (surf_link_.second(!fetch_.empty())) return places_.front();
        return fetch_.front();
    }
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
    /// A ray's answer came to a fast chip, and was not looked at yet.
    bool comes() const { return came_[0].there | came_[1].there; }

    const char* where(std::uint32_t ray) const {
        const auto r = RayNumber(ray);
        return fetch_.contains(r) || places_.contains(r)    ? "shade: waits for the link to surf_cache"
               : arrived_.contains(r) || again_.contains(r) ? "shade: waits for a pass"
               : pass_.contains(r)                          ? "shade: in a pass"
               : spawns_.contains(r)                        ? "shade: waits for raygen"
               : pixels_.contains(r)                        ? "shade: waits for its pixel to be taken"
               : is_coming(ray)                             ? "shade: has just got its answer"
                                                            : nullptr;
    }

    /// What a ray whose answer came waits for.
    enum class Wants : std::uint8_t { nothing, surface, place };
    /// One clock edge: the ray whose answer came and what it wants, the one whose surface is there, the one
    /// whose instance is, and which outputs were taken. `turn(ray)` tells what a pass has led to.
    template <bool levels = false, class Decide>
    void clock(std::uint64_t now, OnLink closest, Wants wants, OnLink surface, OnLink place, bool surf_taken,
               bool spawn_taken, bool pixel_taken, Decide&& turn) {
        for (std::size_t i = 0; i < late_; ++i) {   // what came is looked at in a later cycle
            std::swap(closest, came_[i]);
            std::swap(wants, came_wants_[i]);
        }
        const bool open = ready(), again = !again_.empty(), arrived = !arrived_.empty();
        const bool answer = pass_.valid(now);
        const RayNumber done = pass_.front();
        if constexpr (levels) {
            const bool second = surf_link_.second(!fetch_.empty());
            surf_link_.clock(surf_valid<levels>(), surf_taken, second);
            places_.pop(surf_taken & second);
            fetch_.pop(surf_taken & !second);
        } else {
            fetch_.pop(surf_taken);
        }
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
        if constexpr (levels) {
            fetch_.push(RayNumber(place.ray), place.there);
            places_.push(RayNumber(closest.ray), closest.there & (wants == Wants::place));
        } else {
            fetch_.push(RayNumber(closest.ray), closest.there & (wants == Wants::surface));
        }
        arrived_.push(RayNumber(closest.ray), closest.there & (wants == Wants::nothing));
    }

private:
    bool is_coming(std::uint32_t ray) const {
        return (came_[0].there && came_[0].ray == ray) || (came_[1].there && came_[1].ray == ray);
    }

    RayRing fetch_, places_, arrived_, again_, spawns_, pixels_;
    Pipe<RayNumber> pass_;
    Merge surf_link_;              // of fetch_ and places_
    std::size_t late_;             // cycles until an answer is looked at,
    std::array<OnLink, 2> came_;   // and those that came before, the last one first
    std::array<Wants, 2> came_wants_{};
    std::uint32_t rests_, rest_ = 0;   // cycles after a pass in which it takes none; that are left
};

}   // namespace rayclock
