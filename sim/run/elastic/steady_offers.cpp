// Compares each offer with the offer of the previous cycle.
#include "sim/run/elastic/steady_offers.hpp"

#include <algorithm>
#include <cstring>

#include "sim/run/lockstep/ray_end.hpp"

namespace rayclock {

SteadyOffers::SteadyOffers(const Config& config, const RtlMachine& rtl, Findings& findings)
    : config_(config),
      rtl_(rtl),
      findings_(findings),
      pipelines_(std::size_t(config.pipelines), Held{0, std::vector<Bytes>(link_count)}),
      shared_{0, std::vector<Bytes>(link_count)} {}

void SteadyOffers::forget() {
    for (Held& held : pipelines_) held.links = 0;
    shared_.links = 0;
}

void SteadyOffers::cycle(std::uint64_t now) {
    for (int p = 0; p < config_.pipelines; ++p)
        check(now, p, pipelines_[std::size_t(p)], rtl_.valid_mask(p), rtl_.fire_mask(p));
    check(now, 0, shared_, rtl_.shared_valid(), rtl_.shared_fire());
}

void SteadyOffers::check(std::uint64_t now, int pipeline, Held& held, LinkMask valid, LinkMask fires) {
    each_link(held.links & ~valid, [&](Link c) {
        report(now, pipeline, c, "valid stays 1 until the offer is accepted",
               "valid is 0, and the offer was not accepted");
    });
    each_link(held.links & valid, [&](Link c) {
        if (offered(pipeline, c) == held.payloads[index(c)]) return;
        report(now, pipeline, c, "the payload stays unchanged until it is accepted",
               "another payload: " + rtl_text(rtl_, pipeline, c, config_));
    });
    held.links = valid & ~fires;
    each_link(held.links, [&](Link c) { held.payloads[index(c)] = offered(pipeline, c); });
}

SteadyOffers::Bytes SteadyOffers::offered(int pipeline, Link c) const {
    const RcPort& port = rtl_.link(pipeline, c);
    const auto* const bytes = reinterpret_cast<const unsigned char*>(port.data);
    Bytes payload(bytes, bytes + port.bytes);
    if (c == Link::mem_req && config_.writes_hits())
        if (MemReq read = get_data<MemReq>(port, config_); !read.is_write) {
            read.line = {};
            const Words words = pack(read, config_);
            std::memcpy(payload.data(), words.data(), std::min(payload.size(), words.size() * 4));
        }
    return payload;
}

void SteadyOffers::report(std::uint64_t now, int pipeline, Link c, const char* expected, std::string got) {
    findings_.add([&] {
        Divergence d = difference(now, located(link_infos[index(c)].from, pipeline, c, config_), pipeline, c);
        d.ray = rtl_id(rtl_, pipeline, c, config_);
        d.expected = expected, d.got = std::move(got);
        return d;
    });
}

}   // namespace rayclock
