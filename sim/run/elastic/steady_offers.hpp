#pragma once
// Checks the handshake of the RTL's links: an offer stays unchanged until it is accepted.
#include <vector>

#include "sim/run/elastic/findings.hpp"

namespace rayclock {

/// Watches the links of every pipeline, and the links that pipelines share. Reports a source that withdraws
/// an offer or changes its payload before the receiver accepts the offer.
class SteadyOffers {
public:
    SteadyOffers(const Config& config, const RtlMachine& rtl, Findings& findings);

    /// Forgets all offers. Call it after a reset, and after cycles that were not watched.
    void forget();
    /// Checks the offers of a cycle, after RtlMachine::settle().
    void cycle(std::uint64_t now);

private:
    using Bytes = std::vector<unsigned char>;
    /// Offers that were not accepted in the last cycle: of one pipeline, or of the shared links.
    struct Held {
        LinkMask links = 0;
        std::vector<Bytes> payloads;   ///< [link]
    };
    void check(std::uint64_t now, int pipeline, Held& held, LinkMask valid, LinkMask fires);
    /// Returns the payload on offer, without the arbitrary line of a read (MemReq).
    Bytes offered(int pipeline, Link c) const;
    void report(std::uint64_t now, int pipeline, Link c, const char* expected, std::string got);

    const Config& config_;
    const RtlMachine& rtl_;
    Findings& findings_;
    std::vector<Held> pipelines_;
    Held shared_;
};

}   // namespace rayclock
