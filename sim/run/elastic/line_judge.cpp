// Matches answers with requests, by id.
#include "sim/run/elastic/line_judge.hpp"

#include <algorithm>

#include "sim/run/lockstep/ray_end.hpp"

namespace rayclock {

LineJudge::LineJudge(const Config& config, const RtlMachine& rtl, Findings& findings)
    : config_(config),
      rtl_(rtl),
      findings_(findings),
      passed_on_(is_there(Link::l2_req, config) ? Link::l2_req : Link::mem_req) {
    constexpr std::pair<Link, Link> all[] = {
        {Link::mem_req, Link::mem_rsp},     {Link::l2_req, Link::l2_rsp},
        {Link::node_miss, Link::node_fill}, {Link::prim_miss, Link::prim_fill},
        {Link::surf_miss, Link::surf_fill}, {Link::stream_miss, Link::stream_fill},
        {Link::tex_miss, Link::tex_fill}};
    const auto ids = [&](Link c) {
        const int bits = c == Link::mem_req     ? config.mem_id_bits()
                         : c == Link::l2_req    ? config.client_id_bits()
                         : c == Link::node_miss ? config.node_miss_bits()
                         : c == Link::prim_miss ? config.prim_miss_bits()
                         : c == Link::surf_miss ? config.surf_miss_bits()
                         : c == Link::tex_miss  ? config.tex_miss_bits()
                                                : config.stream_miss_bits();
        return std::size_t(1) << bits;
    };
    for (const auto& [req, rsp] : all) {
        if (!is_there(req, config)) continue;
        const std::size_t pipelines = index(req) < pipeline_links ? std::size_t(config.pipelines) : 1;
        pairs_.push_back({req, rsp, {pipelines, std::vector<std::optional<Request>>(ids(req))}});
    }
}

void LineJudge::start(const MemoryImage& image, bool forget) {
    image_ = &image;
    if (!forget) return;
    asked_.clear();
    for (Pair& pair : pairs_)
        for (auto& waits : pair.waits) std::fill(waits.begin(), waits.end(), std::nullopt);
}

Divergence LineJudge::at(std::uint64_t now, int pipeline, Link c, std::uint32_t id) const {
    Divergence d = difference(now, located(link_infos[index(c)].from, pipeline, c, config_), pipeline, c);
    d.ray = id;
    return d;
}

/// Returns false if no request waits for the answer and this is not the last try.
bool LineJudge::answer(std::uint64_t now, Pair& pair, int pipeline, bool is_last) {
    return with_payload(pair.rsp, [&]<class P>() {
        if constexpr (requires(P p) { p.id, p.line; }) {
            const P got = get_data<P>(rtl_.link(pipeline, pair.rsp), config_);
            auto& waits = pair.waits[std::size_t(pipeline)];
            auto* const request = got.id < waits.size() && waits[got.id] ? &waits[got.id] : nullptr;
            if (!request) {
                if (!is_last) return false;
                ++findings_.events_compared;
                findings_.add([&] {
                    Divergence d = at(now, pipeline, pair.rsp, got.id);
                    d.expected = fmt::format("no answer: id {} has no request in flight", got.id);
                    d.got = fmt::format("an answer to id {}", got.id);
                    return d;
                });
                return true;
            }
            ++findings_.events_compared;
            P wanted{got.id, {}};
            std::copy_n(image_->line((*request)->addr), wanted.line.size(), wanted.line.begin());
            if (wanted.line != got.line)
                findings_.add([&] {
                    Divergence d = at(now, pipeline, pair.rsp, got.id);
                    describe(wanted, got, config_, d);
                    d.later = fmt::format("the answer to id {} is line {} of the memory image", got.id,
                                          (*request)->addr);
                    return d;
                });
            request->reset();
        }
        return true;
    });
}

void LineJudge::ask(std::uint64_t now, Pair& pair, int pipeline) {
    with_payload(pair.req, [&]<class P>() {
        if constexpr (requires(P p) { p.id, p.addr; }) {
            const P got = get_data<P>(rtl_.link(pipeline, pair.req), config_);
            if constexpr (requires { got.is_write; })   // RtlMachine checks what is written
                if (got.is_write) return;
            ++findings_.events_compared;
            auto& place = pair.waits[std::size_t(pipeline)][got.id];
            const bool outside = !image_->holds(got.addr, std::uint32_t(config_.longest_line() / line_bytes));
            if (place || outside)
                findings_.add([&] {
                    Divergence d = at(now, pipeline, pair.req, got.id);
                    d.expected = place
                                     ? "an id that has no request in flight"
                                     : fmt::format("one of the {} lines of the memory image", image_->end());
                    d.got = place ? fmt::format("id {}, which waits for line {}", got.id, place->addr)
                                  : fmt::format("line {}", got.addr);
                    return d;
                });
            place = Request{got.addr, now};
            if (index(pair.req) < pipeline_links) {
                asked_.insert(got.addr);
            } else if (pair.req == passed_on_) {
                const auto cause = asked_.find(got.addr);
                if (cause != asked_.end())
                    asked_.erase(cause);
                else
                    findings_.add([&] {
                        Divergence d = at(now, pipeline, pair.req, got.id);
                        d.expected = "a line that a cache requests";
                        d.got = fmt::format("line {}", got.addr);
                        return d;
                    });
            }
        }
    });
}

void LineJudge::cycle(std::uint64_t now) {
    // In one cycle a request may pass from a cache to memory, and an answer back. The report must name the
    // first faulty unit on the way. So requests are judged from the caches to memory, and answers from memory
    // to the caches. An answer frees its id for a request of the same cycle. A cache without latency answers
    // in the cycle of the request.
    std::vector<std::pair<Pair*, int>> early;
    for (Pair& pair : pairs_)
        for (int p = 0; p < int(pair.waits.size()); ++p)
            if (rtl_.fires(p, pair.rsp) && !answer(now, pair, p, false)) early.emplace_back(&pair, p);
    for (auto pair = pairs_.rbegin(); pair != pairs_.rend(); ++pair)
        for (int p = 0; p < int(pair->waits.size()); ++p)
            if (rtl_.fires(p, pair->req)) ask(now, *pair, p);
    for (const auto& [pair, p] : early) answer(now, *pair, p, true);
}

std::optional<Divergence> LineJudge::missing(std::uint64_t now) const {
    for (const Pair& pair : pairs_) {
        if (pair.req == Link::mem_req) continue;
        std::optional<Divergence> oldest;
        std::uint64_t since = now;
        for (int p = 0; p < int(pair.waits.size()); ++p) {
            const auto& waits = pair.waits[std::size_t(p)];
            for (std::uint32_t id = 0; id < waits.size(); ++id) {
                if (!waits[id] || waits[id]->since >= since) continue;
                since = waits[id]->since;
                oldest = at(now, p, pair.rsp, id);
                oldest->expected = fmt::format("the answer to id {}, which is line {} of the memory image",
                                               id, waits[id]->addr);
                oldest->got = fmt::format("no answer in {} cycles", now - since);
            }
        }
        if (oldest) return oldest;
    }
    return {};
}

}   // namespace rayclock
