#pragma once
// The unit tex in time. texel.hpp computes its values.
#include "model/core/ring.hpp"

namespace rayclock {

/// The unit tex in time. For each hit it reads the triangle's texture record, computes the address of the
/// texels, reads the line that has them, and filters them. Requests for texels have priority over those for
/// records. It always accepts lines, and shade always accepts colours. Mirror of rtl/unit/tex/rc_tex.sv.
class Tex {
public:
    explicit Tex(const Config& config)
        : texels_(config.contexts),
          address_(config.tex_address_latency() - 1, config.contexts),
          filter_(config.tex_filter_latency() - 1, config.contexts) {}

    /// True if the unit requests texels, false if it requests the record of the hit that shade offers.
    bool requests_texels() const { return !link_.second(!texels_.empty()); }
    bool texels_wait() const { return !texels_.empty(); }
    std::uint32_t texel_ray() const { return texels_.front(); }
    /// Returns the colour that leaves in this cycle.
    LinkRay answer(std::uint64_t now) const { return filter_.answer(now); }
    /// True if no hit waits to request texels, and no address becomes ready in this cycle.
    bool is_idle(std::uint64_t now) const { return texels_.empty() & !address_.answer(now).valid; }
    std::uint64_t due(std::uint64_t now) const { return std::min(address_.due(now), filter_.due(now)); }

    /// One clock edge. `offers`: a request is offered to the cache; `taken`: it was accepted. `record`,
    /// `texels`: the rays whose lines have come.
    void clock(std::uint64_t now, bool offers, bool taken, LinkRay record, LinkRay texels) {
        const bool second = !requests_texels();
        link_.clock(offers, taken, second);
        texels_.pop(taken & !second);
        const LinkRay addressed = address_.answer(now);
        texels_.push(RayNumber(addressed.ray), addressed.valid);
        address_.clock(now, record);
        filter_.clock(now, texels);
    }

    /// Skips cycles in which nothing enters or leaves.
    void skip(std::uint64_t now, std::uint64_t cycles) {
        address_.skip(now, cycles);
        filter_.skip(now, cycles);
    }
    void start() { address_.clear(), filter_.clear(); }   ///< begins a frame

    const char* where(std::uint32_t ray, std::uint64_t now) const {
        const auto r = RayNumber(ray);
        return texels_.contains(r)         ? "tex: waits for the link to tex_cache"
               : address_.contains(r, now) ? "tex: computes the address of its texels"
               : filter_.contains(r, now)  ? "tex: filters its texels"
                                           : nullptr;
    }

private:
    RayRing texels_;   // hits whose address is known
    Merge link_;       // of texels_ and of shade's hits
    Delay address_, filter_;
};

}   // namespace rayclock
