// Clocks the pipelines and the shared units together.
#include "model/machine/machine.hpp"

#include <algorithm>

#include "model/compile/upload.hpp"

namespace rayclock {

Machine::Machine(const Config& config, int khz, Disturbance disturbance)
    : config_(config),
      disturbance_(disturbance),
      has_l2_(config.l2_sets > 0),
      dispatch_(config),
      clients_(std::uint32_t(config.clients())),
      client_shift_(config.client_id_bits() - config.client_bits()),
      arbiter_(config.clients() * config.pipelines),
      memory_(config, khz, disturbance),
      undisturbed_(disturbance.none()),
      shared_moves_(std::size_t(config.pipelines)),
      fills_(std::size_t(config.pipelines)),
      masks_(std::size_t(config.pipelines)) {
    for (int p = 0; p < config.pipelines; ++p) pipelines_.emplace_back(config, disturbance, p);
    if (has_l2_) l2_.emplace(l2_shape(config));
    if (config.writes_hits()) hits_unit_.emplace(config);
}

void Machine::start(const Frame& frame, const Trace& trace, std::vector<Stretch> stretches,
                    std::uint64_t pixels) {
    memory_.start_frame(frame.width, frame.height);
    dispatch_.start(frame, std::move(stretches));
    for (Pipeline& pipeline : pipelines_) pipeline.start(frame, trace);
    if (hits_unit_) hits_unit_->start(frame);
    pixels_ = pixels;
    finished_pixels_ = 0;
    moved_at_ = now_;
}

void Machine::pass_cycle() {
    memory_.clock(nullptr);
    ++now_;
}

void Machine::finish_writes() {
    while (memory_.writes()) pass_cycle();
}

void Machine::reset() {
    dispatch_ = Dispatch(config_);
    pipelines_.clear();
    for (int p = 0; p < config_.pipelines; ++p) pipelines_.emplace_back(config_, disturbance_, p);
    arbiter_ = Arbiter(config_.clients() * config_.pipelines);
    if (has_l2_) l2_.emplace(l2_shape(config_));
    if (hits_unit_) hits_unit_.emplace(config_);
    port_ = Arbiter(2);
    for (int i = 0; i < reset_cycles(config_); ++i) pass_cycle();
}

// Settles the shared links: tiles to the pipelines; misses through the arbiter to the shared cache or to
// memory; answers back to the requesting cache. All of it depends only on registered state.
// Within a window of several cycles no tile is granted, and the pipelines are ahead of the shared units.
void Machine::settle_shared(bool tiles) {
    std::uint32_t want = 0;
    std::uint64_t misses = 0;
    for (std::uint32_t p = 0; p < pipelines_.size(); ++p) {
        const Pipeline& pipeline = pipelines_[p];
        want |= std::uint32_t(tiles & pipeline.tile_ready()) << p;
        misses |= std::uint64_t(pipeline.misses(now_)) << clients_ * p;
        shared_moves_[p] = {};
    }
    granted_ = dispatch_.grant(want);
    if (granted_ >= 0) shared_moves_[std::size_t(granted_)].tile = &dispatch_.tile();
    client_valid_ = misses;
    client_ = misses ? arbiter_.choose(misses) : -1;

    const bool memory_valid = memory_.valid();
    valid_ = LinkMask(memory_valid) << index(Link::mem_rsp);
    fire_ = valid_;
    const auto link = [&](Link c, bool valid, bool ready) {
        valid_ |= LinkMask(valid) << index(c);
        fire_ |= LinkMask(valid && ready) << index(c);
    };
    port_valid_ = has_l2_ ? l2_->miss_valid() : client_ >= 0;
    if (hits_unit_) {
        port_valid_ |= std::uint32_t(hits_unit_->full()) << 1;
        is_write_ = port_valid_ != 0 && port_.choose(port_valid_) == 1;
    }
    if (port_valid_) link(Link::mem_req, true, memory_.ready());
    if (has_l2_) {
        link(Link::l2_req, client_ >= 0, l2_->ready());
        link(Link::l2_rsp, l2_->valid(), true);
        if (l2_->miss_valid()) l2_miss_ = l2_->miss();
        route(fires(Link::l2_rsp), fires(Link::l2_rsp) ? l2_->answer() : 0);
    } else {
        route(memory_valid, memory_valid ? memory_.answer().id : 0);
    }
    const bool taken = has_l2_ ? fires(Link::l2_req) : reads();
    if (client_ >= 0) {
        const std::size_t p = std::size_t(client_) / clients_;
        const std::uint32_t cache = std::uint32_t(client_) % clients_;
        const Cache::Miss miss = cache == 0   ? pipelines_[p].node_miss()
                                 : cache == 1 ? pipelines_[p].prim_miss()
                                 : cache == 2 ? pipelines_[p].surf_or_stream_miss()
                                              : pipelines_[p].tex_miss();
        client_request_ = {std::uint32_t(client_) << client_shift_ | miss.id, miss.addr};
        (cache == 0   ? shared_moves_[p].node_miss
         : cache == 1 ? shared_moves_[p].prim_miss
         : cache == 2 ? shared_moves_[p].surf_or_stream_miss
                      : shared_moves_[p].tex_miss) = taken;
    }
    const std::uint32_t dispatch = granted_ >= 0 ? 0 : dispatch_.more() ? 2 : 1;
    last_shared_ = dispatch | (client_ < 0 ? 1u : taken ? 0u : 2u) << 2;
    ++shared_counts_[last_shared_];
}

void Machine::route(bool answered, std::uint32_t id) {
    fill_client_ = -1;
    if (!answered) return;
    fill_client_ = int(id >> client_shift_);
    fill_id_ = id & ((1u << client_shift_) - 1);
    SharedMoves& moves = shared_moves_[std::size_t(fill_client_) / clients_];
    const std::uint32_t cache = std::uint32_t(fill_client_) % clients_;
    (cache == 0   ? moves.node_fill
     : cache == 1 ? moves.prim_fill
     : cache == 2 ? moves.surf_or_stream_fill
                  : moves.tex_fill) = &fill_id_;
}

void Machine::settle_pipelines() {
    if (memory_.draws()) pipelines_[0].open_sink(memory_.accepts_pixel());
    for (std::size_t p = 0; hits_unit_ && p < pipelines_.size(); ++p)
        pipelines_[p].open_sink(hits_unit_->accepts(p));
    for (std::size_t p = 0; p < pipelines_.size(); ++p) {
        pipelines_[p].settle(now_);
        masks_[p] = {pipelines_[p].valid_mask(shared_moves_[p]), pipelines_[p].fire_mask(shared_moves_[p])};
    }
}

void Machine::clock_pipelines() {
    finished_now_ = 0;
    if (memory_.draws() && masks_[0].fire >> index(Link::hit) & 1) {
        const Slot& pixel = pipelines_[0].pixel(pipelines_[0].ray_on(Link::hit));
        place_ = {pixel.x, pixel.y};
    }
    for (std::size_t p = 0; p < pipelines_.size(); ++p) {
        if (masks_[p].fire) moved_at_ = now_ + 1;
        finished_now_ += std::uint32_t(masks_[p].fire >> index(Link::hit) & 1);
        pipelines_[p].clock(now_, shared_moves_[p]);
    }
    if (!hits_unit_) finished_pixels_ += finished_now_;
}

void Machine::clock_shared() {
    dispatch_.clock(granted_);
    const bool taken = has_l2_ ? fires(Link::l2_req) : reads();
    if (taken && client_ >= 0)
        pipelines_[std::size_t(client_) / clients_].take_miss(std::uint32_t(client_) % clients_);
    arbiter_.clock(client_valid_, client_, taken);
    if (has_l2_) {
        const std::uint32_t filled = fires(Link::mem_rsp) ? memory_.answer().id : 0;
        if (reads()) l2_->take_miss();
        l2_outcome_ =
            l2_->clock(taken, client_request_, fires(Link::l2_rsp), fires(Link::mem_rsp) ? &filled : nullptr);
        ++l2_counts_[std::size_t(l2_outcome_)];
    }
    const Memory::Answer request = asked();
    if (hits_unit_) {
        port_.clock(port_valid_, is_write_, fires(Link::mem_req));
        finished_pixels_ += hits_unit_->clock(finished_now_ > 0, fires(Link::mem_req) && is_write_);
    }
    memory_.clock(fires(Link::mem_req) ? &request : nullptr, finished_now_,
                  finished_now_ > 0 ? &place_ : nullptr);
    ++now_;
    if (fire_) moved_at_ = now_;
}

// In most cycles nothing moves between the pipelines and the shared units.
inline bool Machine::shared_is_still() const {
    if (has_l2_ || memory_.valid()) return false;
    bool requests = false;   // without branches, because every cycle evaluates this
    for (const Pipeline& pipeline : pipelines_) requests |= pipeline.has_request(dispatch_.more());
    return !requests;
}

void Machine::step() {
    if (memory_.draws() || hits_unit_) return step([](const Move&) {});
    static constexpr SharedMoves nothing{};
    const bool still = shared_is_still();
    if (!still) settle_shared();
    bool asleep = true;
    finished_now_ = 0;
    for (std::size_t p = 0; p < pipelines_.size(); ++p) {
        finished_now_ += pipelines_[p].step(now_, still ? nothing : shared_moves_[p]);
        asleep &= pipelines_[p].slept();
    }
    finished_pixels_ += finished_now_;
    if (still) {
        last_shared_ = (dispatch_.more() ? 2 : 1) | 1 << 2;   // the codes of waiting units
        ++shared_counts_[last_shared_];
        valid_ = fire_ = 0;
        memory_.clock(nullptr, finished_now_);
        ++now_;
    } else {
        clock_shared();
    }
    if (!asleep) moved_at_ = now_;
}

void Machine::step_in_order(const std::array<int, pipeline_units>& order) {
    settle_shared();
    settle_pipelines();
    finished_now_ = 0;
    for (std::size_t p = pipelines_.size(); p-- > 0;) {
        finished_now_ += std::uint32_t(masks_[p].fire >> index(Link::hit) & 1);
        pipelines_[p].clock_in_order(now_, shared_moves_[p], order);
    }
    if (!hits_unit_) finished_pixels_ += finished_now_;
    clock_shared();
}

void Machine::run(std::uint64_t until, std::uint64_t pixels) {
    const std::uint64_t last = std::min(pixels, pixels_);
    while (finished_pixels_ < last && now_ < until) {
        const std::uint64_t cycles = window(until, last);
        if (cycles > 1) {
            pass_window(cycles);
            if (!looks_idle()) continue;
            if (finished_pixels_ >= last || now_ >= until) break;
        }
        leave_windows();
        step();
        if (moved_at_ < now_ && undisturbed_) sleep(until);
    }
    leave_windows();
}

void Machine::leave_windows() {
    for (Pipeline& pipeline : pipelines_) pipeline.leave_windows(now_);
}

bool Machine::looks_idle() const {
    return std::ranges::all_of(pipelines_, [](const Pipeline& p) { return p.looks_idle(); });
}

/// Returns the number of cycles in which the sides of the pipelines, and the shared units, can run one after
/// the other. A hit beyond `pixels`, a tile or an answer of memory that depends on these cycles ends it.
std::uint64_t Machine::window(std::uint64_t until, std::uint64_t pixels) const {
    if (has_l2_ || hits_unit_ || !undisturbed_) return 1;
    std::uint64_t cycles =
        std::min({until - now_, (pixels - finished_pixels_ + pipelines_.size() - 1) / pipelines_.size(),
                  memory_.known()});
    for (const Pipeline& pipeline : pipelines_) cycles = std::min(cycles, pipeline.window(dispatch_.more()));
    return cycles;
}

/// Performs this many cycles, at most window(): first the pipelines, then the shared units.
void Machine::pass_window(std::uint64_t cycles) {
    for (auto& fills : fills_)
        for (Fills& of_cache : fills) of_cache.cycles = 0;
    bool moved = false;
    memory_.each_known(cycles, [&](std::size_t cycle, std::uint32_t id) {
        moved = true;
        const std::uint32_t client = id >> client_shift_;
        fills_[client / clients_][client % clients_].add(cycle, id & ((1u << client_shift_) - 1));
    });
    const std::uint64_t finished_before = finished_pixels_;
    for (std::size_t p = 0; p < pipelines_.size(); ++p) {
        finished_pixels_ += pipelines_[p].run(now_, cycles, fills_[p]);
        moved |= pipelines_[p].looked_up();
    }
    moved |= finished_pixels_ != finished_before;
    finished_now_ = 0;
    for (const std::uint64_t end = now_ + cycles; now_ < end;) {
        // Cycle of the next request. A cache offers it from the cycle after the look-up on.
        std::uint64_t next = end;
        for (const Pipeline& pipeline : pipelines_) next = std::min(next, pipeline.next_miss());
        if (next <= now_) {
            settle_shared(false);
            clock_shared();
            continue;
        }
        const std::uint64_t still = next - now_;
        last_shared_ = (dispatch_.more() ? 2 : 1) | 1 << 2;   // the codes of waiting units
        shared_counts_[last_shared_] += still;
        valid_ = fire_ = 0;
        memory_.pass(still);
        now_ = next;
    }
    if (moved) moved_at_ = now_;
}

void Machine::warm(std::uint32_t pipeline, const std::uint32_t* pixel) {
    pipelines_[pipeline % pipelines_.size()].replay_reads(pixel, [&](Cache& cache, std::uint32_t word) {
        if (cache.warm(word) || !has_l2_) return;
        const auto words = std::uint32_t(cache.words());
        for (std::uint32_t i = 0; i < words; ++i) l2_->warm((word & ~(words - 1)) + i);
    });
}

// If nothing can change before an answer of a pipe or of memory, the cycles until then are like the last one.
void Machine::sleep(std::uint64_t until) {
    // In the next cycle an answer arrives, or a waiting request is accepted.
    if (memory_.valid() || ((valid_ & bit(Link::mem_req)) && memory_.ready())) return;
    // A line of hits waits for memory, or a hit waits for its pipeline's turn.
    if (hits_unit_ && (hits_unit_->full() ||
                       std::ranges::any_of(masks_, [](const Masks& m) { return m.valid & bit(Link::hit); })))
        return;
    std::uint64_t wake = until;
    for (const Pipeline& pipeline : pipelines_) {
        if (!pipeline.slept()) return;
        wake = std::min(wake, pipeline.wakes(now_));
    }
    if (has_l2_) {
        if (l2_outcome_ <= CacheOutcome::drain) return;
        if (l2_->answers() || l2_->loaded()) return;
    }
    wake = std::min(wake, memory_.quiet_until());
    if (wake <= now_) return;
    const std::uint64_t cycles = wake - now_;
    for (Pipeline& pipeline : pipelines_) pipeline.skip(now_, cycles);
    shared_counts_[last_shared_] += cycles;
    if (has_l2_) l2_counts_[std::size_t(l2_outcome_)] += cycles;
    if (hits_unit_) hits_unit_->skip(cycles);
    memory_.skip(cycles);
    now_ = wake;
}

Accounts Machine::accounts() const {
    Accounts sums;
    for (const Pipeline& pipeline : pipelines_) sums += pipeline.accounts();
    for (std::size_t i = 0; i < shared_counts_.size(); ++i) {
        sums.units[index(Unit::dispatch)][i & 3] += shared_counts_[i];
        sums.units[index(Unit::memport)][i >> 2] += shared_counts_[i];
    }
    sums.units[index(Unit::l2)] = l2_counts_;
    if (hits_unit_) sums.units[index(Unit::hits)] = hits_unit_->causes();
    sums.units[index(Unit::memory)] = memory_.outcomes();
    return sums;
}

}   // namespace rayclock
