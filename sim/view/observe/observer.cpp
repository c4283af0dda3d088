// Attributes every transfer, cache look-up and memory request of a cycle to a pixel and a purpose.
#include "sim/view/observe/observer.hpp"

#include <bit>

namespace rayclock {

namespace {

constexpr int cache_of(Link request) {
    return request == Link::node_req ? 0 : request == Link::prim_req ? 1 : request == Link::surf_req ? 2 : -1;
}
constexpr std::array<Link, ray_caches> request_links{Link::node_req, Link::prim_req, Link::surf_req};

}   // namespace

Observer::Observer(const Machine& machine, const Frame& frame, EventSink* sink, std::uint64_t window)
    : machine_(machine),
      sink_(sink),
      start_(machine.cycle()),
      window_(window),
      tile_bits_(machine.config().tile_bits),
      has_l2_(machine.config().l2_sets > 0),
      shading_(machine.config().shading),
      lists_(machine.config().is_list()),
      line_words_{node_cache_shape(machine.config()).words, prim_cache_shape(machine.config()).words,
                  surf_cache_shape(machine.config()).words},
      pipelines_(std::size_t(machine.config().pipelines)),
      tile_columns_((frame.width + (1u << tile_bits_) - 1) >> tile_bits_),
      accounts_(machine.accounts()),
      memory_(machine.memory().stats()) {
    for (PipelineState& p : pipelines_) p.contexts.resize(std::size_t(machine.config().contexts));
    if (has_l2_) l2_line_words_ = l2_shape(machine.config()).words;
    costs_.width = frame.width;
    costs_.height = frame.height;
    costs_.pixels.resize(std::size_t(frame.width) * frame.height);
    tile_spans_.assign(std::size_t(tile_columns_) * ((frame.height + (1u << tile_bits_) - 1) >> tile_bits_),
                       -1);
    open_.accounts = accounts_;
    open_.memory = memory_;
}

void Observer::step(Machine& machine) {
    machine.step([this](const Move& move) { moved(move); });
    for (std::size_t p = 0; p < pipelines_.size(); ++p) {
        PipelineState& state = pipelines_[p];
        for (std::size_t c = 0; c < ray_caches - !shading_; ++c) {
            const CacheDeed deed = machine.deed(int(p), cache_units[c]);
            if (deed <= CacheDeed::merge) looked_up(int(p), c, deed);
            ++state.waits.deeds[c][std::size_t(deed)];
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
    const CacheDeed deed = machine.deed(0, Unit::l2);
    if (deed > CacheDeed::merge) return;
    if (deed == CacheDeed::miss) l2_missing_.push_back(l2_requests_.front());
    l2_requests_.pop_front();
}

void Observer::pay(std::uint32_t pixel, RayPurpose purpose) {
    costs_.pixels[pixel].bytes += line_bytes;
    costs_.purposes[std::size_t(purpose)].bytes += line_bytes;
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
        case Link::surf_miss: return asked_memory(p, 2);
        case Link::node_fill:
        case Link::prim_fill:
        case Link::surf_fill:
        case Link::l2_rsp:
        case Link::mem_rsp: return;
        case Link::l2_req: l2_requests_.push_back(owner_); return;
        case Link::mem_req:
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
    if (const int cache = cache_of(m.link); cache >= 0) {
        context.addr[cache] = m.addr;
        p.caches[std::size_t(cache)].requests.push_back(m.id);
    }
    if (context.watched) show(m.pipeline, m.id, RayEvent::What::moved, m.link, {}, m.addr);
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
    TileSpan& tile = costs_.tiles[std::size_t(
        tile_spans_[std::size_t(m.y >> tile_bits_) * tile_columns_ + (m.x >> tile_bits_)])];
    if (tile.last == tile.first) tile.first = now_;
    tile.last = std::max(tile.last, now_ + 1);
}

/// Records a transfer of a ray. The time since its last transfer counts for the place that it leaves.
void Observer::at(PipelineState& p, Context& context, Link link) {
    purpose(context).places[context.place] += now_ - context.since;
    context.since = now_;
    context.place = place_after(link);
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
            const std::uint32_t x = context.pixel % costs_.width, y = context.pixel / costs_.width;
            TileSpan& tile = costs_.tiles[std::size_t(
                tile_spans_[std::size_t(y >> tile_bits_) * tile_columns_ + (x >> tile_bits_)])];
            tile.last = std::max(tile.last, now_);
            return;
        }
        default: return;
    }
}

void Observer::looked_up(int pipeline, std::size_t cache, CacheDeed deed) {
    PipelineState& p = pipelines_[std::size_t(pipeline)];
    CacheQueue& queue = p.caches[cache];
    const std::uint32_t id = queue.requests.front();
    queue.requests.pop_front();
    Context& context = p.contexts[id];
    PurposeCost& sums = purpose(context);
    if (context.watched)
        show(pipeline, id, RayEvent::What::looked_up, request_links[cache], deed, context.addr[cache]);
    if (deed == CacheDeed::hit) {
        ++sums.hits[cache];
        return;
    }
    ++cost(context).misses;
    ++(deed == CacheDeed::miss ? sums.misses : sums.merges)[cache];
    if (deed == CacheDeed::miss) queue.missing.push_back(id);
    sums.places[context.place] += now_ - context.since;   // from here on the context waits for memory
    context.since = now_;
    context.place = memory_place;
}

void Observer::show(int pipeline, std::uint32_t id, RayEvent::What what, Link link, CacheDeed deed,
                    std::uint32_t addr) {
    const PipelineState& p = pipelines_[std::size_t(pipeline)];
    const Context& c = p.contexts[id];
    pending_.push_back(
        {now_, what, link, deed, addr, pipeline, id, c.pixel, c.ray, c.purpose, c.first, &p.waits});
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
