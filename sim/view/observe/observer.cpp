// Attributes every transfer, cache look-up and memory request of a cycle to a pixel and a purpose.
#include "sim/view/observe/observer.hpp"

#include <bit>

namespace rayclock {

namespace {

/// Returns the link of the requests to a cache.
constexpr Link request_link(std::size_t cache, bool streams) {
    return cache == 0   ? Link::node_req
           : cache == 1 ? Link::prim_req
           : cache == 3 ? Link::texel_req
           : streams    ? Link::slot
                        : Link::surf_req;
}
constexpr int cache_of(Link request, bool streams) {
    for (std::size_t cache = 0; cache < ray_caches; ++cache)
        if (request_link(cache, streams) == request) return int(cache);
    return -1;
}
/// Returns the number of tiles of a frame, or of the groups of a stream.
std::size_t tiles_of(const Frame& frame, int tile_bits) {
    if (frame.ray_count > 0) return ((frame.ray_count - 1) >> 2 * tile_bits) + 1;
    const std::uint32_t last = (1u << tile_bits) - 1;
    return std::size_t((frame.width + last) >> tile_bits) * ((frame.height + last) >> tile_bits);
}

}   // namespace

Observer::Observer(const Machine& machine, const Frame& frame, EventSink* sink, std::uint64_t window)
    : machine_(machine),
      sink_(sink),
      start_(machine.cycle()),
      window_(window),
      tile_bits_(machine.config().tile_bits),
      has_l2_(machine.config().l2_sets > 0),
      caches_(ray_caches_of(machine.config())),
      lists_(machine.config().is_list()),
      streams_(machine.config().is_stream()),
      records_(frame.first_ray_line),
      line_words_{
          node_cache_shape(machine.config()).words, prim_cache_shape(machine.config()).words,
          (streams_ ? stream_cache_shape(machine.config()) : surf_cache_shape(machine.config())).words,
          tex_cache_shape(machine.config()).words},
      pipelines_(std::size_t(machine.config().pipelines)),
      tile_columns_(streams_ ? 1u << machine.config().tile_coord_bits()
                             : (frame.width + (1u << tile_bits_) - 1) >> tile_bits_),
      accounts_(machine.accounts()),
      memory_(machine.memory().stats()) {
    for (PipelineState& p : pipelines_) p.contexts.resize(std::size_t(machine.config().contexts));
    if (has_l2_) l2_line_words_ = l2_shape(machine.config()).words;
    costs_.width = frame.width;
    costs_.height = frame.height;
    costs_.pixels.resize(std::size_t(frame.pixels()));
    tile_spans_.assign(tiles_of(frame, tile_bits_), -1);
    open_.accounts = accounts_;
    open_.memory = memory_;
}

void Observer::step(Machine& machine) {
    machine.step([this](const Move& move) { moved(move); });
    for (std::size_t p = 0; p < pipelines_.size(); ++p) {
        PipelineState& state = pipelines_[p];
        for (std::size_t c = 0; c < caches_; ++c) {
            const CacheOutcome outcome = machine.outcome(int(p), cache_units[c]);
            if (outcome <= CacheOutcome::merge) looked_up(int(p), c, outcome);
            ++state.waits.outcomes[c][std::size_t(outcome)];
        }
        const LinkMask fire = machine.fire_mask(int(p));
        for (LinkMask left = machine.valid_mask(int(p)) & ~fire; left; left &= left - 1) {
            const int link = std::countr_zero(left);
            ++costs_.refused[std::size_t(link)];
            if (std::size_t(link) < pipeline_links) ++state.waits.refused[std::size_t(link)];
        }
        open_.contexts += state.in_use;
    }
    shared(machine);
    if (sink_) {
        for (const RayEvent& event : pending_) sink_->event(event);
        pending_.clear();
        sink_->cycle_done(now_, machine);
        count_runs(machine);
    }
    ++now_;
    if (window_ != 0 && now_ % window_ == 0) close_window(machine);
}

void Observer::count_runs(const Machine& machine) {
    for (std::size_t p = 0; p < pipelines_.size(); ++p) {
        const LinkMask refused = machine.valid_mask(int(p)) & ~machine.fire_mask(int(p));
        std::uint32_t link = 0;
        for (std::uint32_t& run : pipelines_[p].waits.run) run = refused >> link++ & 1 ? run + 1 : 0;
    }
}

void Observer::shared(const Machine& machine) {
    for (LinkMask left = machine.shared_valid() & ~machine.shared_fire(); left; left &= left - 1)
        ++costs_.refused[std::size_t(std::countr_zero(left))];
    if (!has_l2_) return;
    const CacheOutcome outcome = machine.outcome(0, Unit::l2);
    if (outcome > CacheOutcome::merge) return;
    if (outcome == CacheOutcome::miss) l2_missing_.push_back(l2_requests_.front());
    l2_requests_.pop_front();
}

void Observer::pay(std::uint32_t pixel, RayPurpose purpose) {
    costs_.pixels[pixel].bytes += line_bytes;
    costs_.purposes[std::size_t(purpose)].bytes += line_bytes;
}

TileSpan& Observer::tile_of(std::uint32_t pixel) {
    const std::uint32_t x = pixel % costs_.width >> tile_bits_, y = pixel / costs_.width >> tile_bits_;
    const std::size_t tile =
        streams_ ? std::size_t(pixel >> 2 * tile_bits_) : std::size_t(y) * tile_columns_ + x;
    return costs_.tiles[std::size_t(tile_spans_[tile])];
}

void Observer::asked_memory(PipelineState& p, std::size_t cache) {
    CacheQueue& queue = p.caches[cache];
    const Context& context = p.contexts[queue.missing.front()];
    owner_ = {context.pixel, context.purpose};
    if (++queue.words == line_words_[cache]) {
        queue.missing.pop_front();
        queue.words = 0;
    }
}

void Observer::moved(const Move& m) {
    ++costs_.moved[index(m.link)];
    PipelineState& p = pipelines_[std::size_t(m.pipeline)];
    switch (m.link) {
        case Link::tile: {
            const std::size_t tile = std::size_t(m.y) * tile_columns_ + m.x;
            tile_spans_[tile] = std::int32_t(costs_.tiles.size());
            costs_.tiles.push_back({m.x, m.y, m.pipeline, now_, now_});
            return;
        }
        case Link::node_miss: return asked_memory(p, 0);
        case Link::prim_miss: return asked_memory(p, 1);
        case Link::surf_miss:
        case Link::stream_miss: return asked_memory(p, 2);
        case Link::tex_miss: return asked_memory(p, 3);
        case Link::node_fill:
        case Link::prim_fill:
        case Link::surf_fill:
        case Link::stream_fill:
        case Link::tex_fill:
        case Link::l2_rsp:
        case Link::mem_rsp: return;
        case Link::l2_req: l2_requests_.push_back(owner_); return;
        case Link::mem_req:
            if (m.is_write) return;   // hits of several rays
            if (!has_l2_) return pay(owner_.pixel, owner_.purpose);
            pay(l2_missing_.front().pixel, l2_missing_.front().purpose);
            if (++l2_words_ == l2_line_words_) {
                l2_missing_.pop_front();
                l2_words_ = 0;
            }
            return;
        default: break;
    }
    if (m.link == Link::slot) began(p, m);
    Context& context = p.contexts[m.id];
    at(p, context, m.link);
    // A request for a record is a slot, which has no address.
    const std::uint32_t addr = streams_ && m.link == Link::slot ? records_ + context.pixel / 2 : m.addr;
    if (const int cache = cache_of(m.link, streams_); cache >= 0) {
        context.addr[cache] = addr;
        p.caches[std::size_t(cache)].requests.push_back(m.id);
    }
    if (context.watched) show(m.pipeline, m.id, RayEvent::Type::transfer, m.link, {}, addr);
    if (m.link == Link::hit) context = {};
}

void Observer::began(PipelineState& p, const Move& m) {
    Context& context = p.contexts[m.id];
    const std::uint32_t pixel = m.y * costs_.width + m.x;
    context = {};
    context.pixel = pixel;
    context.first = std::uint32_t(now_);
    context.in_use = true;
    context.since = now_;
    context.watched = sink_ && sink_->wants(pixel);
    ++p.in_use;
    cost(context).first = context.first;
    ++cost(context).rays;
    ++purpose(context).rays;
    TileSpan& tile = tile_of(pixel);
    if (tile.last == tile.first) tile.first = now_;
    tile.last = std::max(tile.last, now_ + 1);
}

/// Records a transfer of a ray. The time since its last transfer counts for the place that it leaves.
void Observer::at(PipelineState& p, Context& context, Link link) {
    purpose(context).places[context.place] += now_ - context.since;
    context.since = now_;
    context.place = place_after(link, streams_);
    switch (link) {
        case Link::leaves:
            if (!lists_) return;   // visits pages without a request
            [[fallthrough]];
        case Link::node_req:
            ++cost(context).visits;
            ++purpose(context).visits;
            return;
        case Link::prim_req:
            ++cost(context).tests;
            ++purpose(context).tests;
            return;
        case Link::spawn:
            context.purpose =
                machine_.purpose(int(&p - pipelines_.data()), std::uint32_t(&context - p.contexts.data()));
            ++context.ray;
            ++cost(context).rays;
            ++purpose(context).rays;
            return;
        case Link::hit: {
            cost(context).cycles = std::uint32_t(now_) - context.first;
            --p.in_use;
            TileSpan& tile = tile_of(context.pixel);
            tile.last = std::max(tile.last, now_);
            return;
        }
        default: return;
    }
}

void Observer::looked_up(int pipeline, std::size_t cache, CacheOutcome outcome) {
    PipelineState& p = pipelines_[std::size_t(pipeline)];
    CacheQueue& queue = p.caches[cache];
    const std::uint32_t id = queue.requests.front();
    queue.requests.pop_front();
    Context& context = p.contexts[id];
    PurposeCost& sums = purpose(context);
    if (context.watched)
        show(pipeline, id, RayEvent::Type::lookup, request_link(cache, streams_), outcome,
             context.addr[cache]);
    if (outcome == CacheOutcome::hit) {
        ++sums.hits[cache];
        return;
    }
    ++cost(context).misses;
    ++(outcome == CacheOutcome::miss ? sums.misses : sums.merges)[cache];
    if (outcome == CacheOutcome::miss) queue.missing.push_back(id);
    sums.places[context.place] += now_ - context.since;   // from here on the context waits for memory
    context.since = now_;
    context.place = memory_place;
}

void Observer::show(int pipeline, std::uint32_t id, RayEvent::Type what, Link link, CacheOutcome outcome,
                    std::uint32_t addr) {
    const PipelineState& p = pipelines_[std::size_t(pipeline)];
    const Context& c = p.contexts[id];
    pending_.push_back(
        {now_, what, link, outcome, addr, pipeline, id, c.pixel, c.ray, c.purpose, c.first, &p.waits});
}

void Observer::close_window(const Machine& machine) {
    const Accounts accounts = machine.accounts();
    const MemoryStats memory = machine.memory().stats();
    open_.cycles = now_ - open_.first;
    costs_.windows.push_back(
        {open_.first, open_.cycles, accounts - open_.accounts, memory - open_.memory, open_.contexts});
    open_ = {now_, 0, accounts, memory, 0};
}

FrameCosts Observer::finish(const Machine& machine) {
    if (window_ != 0 && now_ > open_.first) close_window(machine);
    costs_.cycles = machine.cycle() - start_;
    costs_.accounts = machine.accounts() - accounts_;
    costs_.memory = machine.memory().stats() - memory_;
    return std::move(costs_);
}

}   // namespace rayclock
