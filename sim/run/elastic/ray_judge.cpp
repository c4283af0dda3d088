// Follows the RTL's rays through their scripts, and describes each difference.
#include "sim/run/elastic/ray_judge.hpp"

#include <algorithm>
#include <cstring>

#include "sim/run/elastic/dont_care.hpp"
#include "sim/run/lockstep/ray_end.hpp"

namespace rayclock {

RayJudge::RayJudge(const Config& config, const RtlMachine& rtl, const std::array<bool, unit_count>& free,
                   Findings& findings)
    : config_(config),
      rtl_(rtl),
      free_(free),
      findings_(findings),
      contexts_(std::size_t(config.pipelines * config.contexts)) {
    for (std::size_t c = 0; c < pipeline_links; ++c)
        if (link_infos[c].carries_ray && is_there(Link(c), config)) ray_links_ |= bit(Link(c));
}

void RayJudge::start(const Frame& frame, const MemoryImage& image, Script script) {
    frame_ = frame;
    image_ = &image;
    script_ = std::move(script);
    payloads_ = std::make_unique<PayloadReplay>(image, config_);
    payloads_->start(frame);
    std::fill(contexts_.begin(), contexts_.end(), Context{});
    begun_.assign(script_->size(), false);
    tiles_ = script_->tiles();
    finished_ = wrong_ = 0;
    moved_at_ = rtl_.cycle();
}

Slot RayJudge::pixel(int pipeline, std::uint32_t ray) const {
    if (ray >= std::uint32_t(config_.contexts)) return {};
    const Context& c = contexts_[std::size_t(pipeline * config_.contexts) + ray];
    return {ray, c.x, c.y};
}

Divergence RayJudge::at(std::uint64_t now, int pipeline, Link c, std::uint32_t ray) const {
    const Slot at = pixel(pipeline, ray);
    Divergence d = difference(now, located(driver_of(c, {}, config_), pipeline, c, config_), pipeline, c);
    d.ray = ray, d.x = at.x, d.y = at.y;
    return d;
}

void RayJudge::cycle(std::uint64_t now) {
    for (int p = 0; p < config_.pipelines; ++p) {
        if (rtl_.fire_mask(p) & bit(Link::tile)) take_tile(now, p);
        // A ray may make several transfers in a cycle. They are tried until none is a ray's next one.
        LinkMask left = rtl_.fire_mask(p) & ray_links_;
        for (bool moves = true; moves && left;) {
            moves = false;
            each_link(left, [&](Link c) {
                if (!take(now, p, c)) return;
                left &= ~bit(c);
                moves = true;
            });
        }
        each_link(left, [&](Link c) { refuse(now, p, c); });
        see_ends(p);
    }
}

/// Notes transfers at the inner ports through which a ray's end passes.
void RayJudge::see_ends(int pipeline) {
    const RcPort &done = rtl_.done_port(pipeline), &pixel = rtl_.pixel_port(pipeline);
    if (*done.valid && *done.ready)
        if (Context* c = context(pipeline, get_data<Done>(done, config_).ray)) c->done = true;
    if (*pixel.valid && *pixel.ready)
        if (Context* c = context(pipeline, get_data<Pixel>(pixel, config_).first.ray)) c->pixel = true;
}

/// Returns the unit from which a context's next transfer is missing.
const char* RayJudge::driver(Link c, const Context& context) const {
    const bool is_end = c == Link::closest || (c == Link::hit && !config_.has_shade());
    return driver_of(c, {}, config_, {!is_end || context.done, c != Link::hit || context.pixel});
}

void RayJudge::take_tile(std::uint64_t now, int pipeline) {
    const Tile tile = get_data<Tile>(rtl_.link(pipeline, Link::tile), config_);
    ++findings_.events_compared;
    if (tiles_.erase({tile.x, tile.y}) == 1) return;
    findings_.add([&] {
        Divergence d = at(now, pipeline, Link::tile, 0);
        const bool is_known = script_->tiles().contains({tile.x, tile.y});
        d.expected = is_known ? "each tile once" : "a tile of the picture";
        d.got = fmt::format("tile ({}, {}){}", tile.x, tile.y, is_known ? " for the second time" : "");
        return d;
    });
}

/// Accepts a transfer if it is the next one of its ray.
bool RayJudge::take(std::uint64_t now, int pipeline, Link c) {
    const std::uint32_t ray = rtl_id(rtl_, pipeline, c, config_);
    Context* const context = this->context(pipeline, ray);
    if (!context) return false;
    if (c == Link::slot && context->state != Context::State::busy && !begin(now, pipeline, ray)) return false;
    if (context->state == Context::State::wrong) return true;
    if (context->state == Context::State::idle || context->links[context->next] != index(c)) return false;
    (*payloads_)(Move{pipeline, c, ray, 0, context->x, context->y},
                 [&](int, Link, const auto& wanted) { compare(now, pipeline, c, wanted, *context); });
    if (context->state == Context::State::wrong) return true;
    if (c == Link::ray) context->done = false;
    context->since = moved_at_ = now;
    if (++context->next < context->links.size()) return true;
    context->state = Context::State::idle;
    ++finished_;
    return true;
}

/// Gives the context of a slot its pixel. Returns false if the pixel is wrong.
bool RayJudge::begin(std::uint64_t now, int pipeline, std::uint32_t ray) {
    const Slot slot = get_data<Slot>(rtl_.link(pipeline, Link::slot), config_);
    if (!script_->has_pixel(slot.x, slot.y)) return false;
    const std::size_t place = script_->place(slot.x, slot.y);
    if (begun_[place]) return false;
    begun_[place] = true;
    *context(pipeline, ray) = {
        Context::State::busy, slot.x, slot.y, script_->links(place), 0, now, false, false};
    return true;
}

void RayJudge::mark_wrong(Context& ray) {
    if (ray.state == Context::State::busy) ++wrong_;
    ray.state = Context::State::wrong;
}

template <class P>
void RayJudge::compare(std::uint64_t now, int pipeline, Link c, const P& wanted, Context& ray) {
    ++findings_.events_compared;
    pack(wanted, config_, words_);
    const RcPort& port = rtl_.link(pipeline, c);
    if (std::memcmp(words_.data(), port.data, std::min<std::size_t>(words_.size() * 4, port.bytes)) == 0)
        return;
    P got = get_data<P>(port, config_);
    if (is_free(c, free_)) {
        drop_dont_care(c, wanted, got);
        if (pack(got, config_) == words_) return;
    }
    findings_.add([&] {
        Divergence d = at(now, pipeline, c, id_of(wanted));
        describe(wanted, got, config_, d);
        d.unit = located(driver_of(c, d.field, config_, ray_end(rtl_, pipeline, wanted, config_)), pipeline,
                         c, config_);
        d.later = explain(pipeline, c, id_of(wanted), ray);
        return d;
    });
    mark_wrong(ray);
}

/// Reports a transfer that is not the next one of its ray.
void RayJudge::refuse(std::uint64_t now, int pipeline, Link c) {
    ++findings_.events_compared;
    const std::uint32_t ray = rtl_id(rtl_, pipeline, c, config_);
    Context* const context = this->context(pipeline, ray);
    const bool busy = context && context->state == Context::State::busy;
    findings_.add([&] {
        Divergence d = at(now, pipeline, c, ray);
        d.got = fmt::format("a transfer: {}", rtl_text(rtl_, pipeline, c, config_));
        if (!context) {
            d.expected = fmt::format("a ray below {}", config_.contexts);
        } else if (busy) {
            const Link next = Link(context->links[context->next]);
            const std::vector<ExpectedTransfer> all = transfers(pipeline, ray, *context);
            d.expected = fmt::format("no transfer: the ray's next one is on {} ({})",
                                     link_infos[index(next)].name, all[context->next].text);
            d.later = explain(pipeline, c, ray, *context);
        } else if (c == Link::slot) {
            const Slot slot = get_data<Slot>(rtl_.link(pipeline, c), config_);
            d.x = slot.x, d.y = slot.y;
            d.expected = script_->has_pixel(slot.x, slot.y) ? "each pixel once" : "a pixel of the picture";
        } else {
            d.expected = "no transfer: the ray has no pixel";
        }
        return d;
    });
    if (busy) mark_wrong(*context);
}

/// Returns every transfer of a context's pixel.
std::vector<RayJudge::ExpectedTransfer> RayJudge::transfers(int pipeline, std::uint32_t ray,
                                                            const Context& context) const {
    PayloadReplay payloads(*image_, config_);
    payloads.start(frame_);
    std::vector<ExpectedTransfer> all;
    for (const std::uint8_t link : context.links)
        payloads(Move{pipeline, Link(link), ray, 0, context.x, context.y},
                 [&](int, Link c, const auto& payload) {
                     all.push_back({c, pack(payload, config_), fields_text(payload, config_)});
                 });
    return all;
}

bool RayJudge::equals_rtl(int pipeline, const ExpectedTransfer& wanted) const {
    const RcPort& port = rtl_.link(pipeline, wanted.link);
    return std::memcmp(wanted.words.data(), port.data,
                       std::min<std::size_t>(wanted.words.size() * 4, port.bytes)) == 0;
}

/// Says which other transfer of the same ray on this link has the RTL's value: one that it made, or one that
/// comes later. Returns an empty text if there is none.
std::string RayJudge::explain(int pipeline, Link c, std::uint32_t ray, const Context& context) const {
    const std::vector<ExpectedTransfer> all = transfers(pipeline, ray, context);
    std::size_t number = 0, made = 0;   // of the ray's transfers on this link, and how many it has made
    std::optional<std::size_t> before, after;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].link != c) continue;
        ++number;
        const bool is_made = i < context.next;
        made += is_made;
        if (!equals_rtl(pipeline, all[i])) continue;
        if (is_made) before = number;
        if (i > context.next && !after) after = number;
    }
    if (before && *before == made)
        return fmt::format("the ray made this transfer before: it was number {} of {} on this link", *before,
                           number);
    if (after)
        return fmt::format("this is the ray's transfer number {} of {} on this link, before number {}",
                           *after, number, made + 1);
    if (before)
        return fmt::format("this was the ray's transfer number {} of {} on this link, and number {} is due",
                           *before, number, made + 1);
    return {};
}

Divergence RayJudge::missing(std::uint64_t now) {
    const Context* oldest = nullptr;
    for (const Context& c : contexts_)
        if (c.state == Context::State::busy && (!oldest || c.since < oldest->since)) oldest = &c;
    if (!oldest) {   // no context works on a pixel that is missing
        const std::size_t place =
            std::size_t(std::find(begun_.begin(), begun_.end(), false) - begun_.begin());
        const Slot pixel = script_->pixel(place);
        Divergence d = at(now, 0, Link::slot, 0);
        d.x = pixel.x, d.y = pixel.y;
        d.expected = "a context for each pixel";
        d.got = fmt::format("none for this pixel in {} cycles", now - moved_at_);
        return d;
    }
    const std::size_t number = std::size_t(oldest - contexts_.data());
    const int pipeline = int(number / std::size_t(config_.contexts));
    const std::uint32_t ray = std::uint32_t(number % std::size_t(config_.contexts));
    const Link next = Link(oldest->links[oldest->next]);
    const bool offered =
        rtl_.valid_mask(pipeline) & bit(next) && rtl_id(rtl_, pipeline, next, config_) == ray;
    Divergence d = at(now, pipeline, next, ray);
    d.unit = located(offered ? link_infos[index(next)].to : driver(next, *oldest), pipeline, next, config_);
    d.expected = fmt::format("a transfer: {}", transfers(pipeline, ray, *oldest)[oldest->next].text);
    d.got = fmt::format("{} in {} cycles", offered ? "an offer that is not accepted" : "none",
                        now - oldest->since);
    d.later = fmt::format("the ray's last transfer was in cycle {}", oldest->since);
    return d;
}

}   // namespace rayclock
