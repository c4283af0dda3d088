#pragma once
// The machine, cycle by cycle: mirror of rtl/rc_top.sv with the memory that model and RTL share.
#include <bit>
#include <optional>
#include <vector>

#include "model/machine/pipeline.hpp"
#include "model/mem/arbiter.hpp"
#include "model/mem/memory.hpp"
#include "model/unit/hits/hits.hpp"
#include "model/unit/sched/dispatch.hpp"

namespace rayclock {

/// A transfer on a link, as far as timing needs it. A PayloadReplay computes the rest of the payload.
struct Move {
    int pipeline = 0;   ///< 0 for shared links
    Link link{};
    std::uint32_t id = 0;         ///< context on a pipeline's links, request on the memory's
    std::uint32_t addr = 0;       ///< of requests, and of the line that returns
    std::uint32_t x = 0, y = 0;   ///< tile, pixel
    /// Of a request to memory, in a chip that writes hits: the hits in the line that is being filled, and
    /// whether the request writes it.
    std::uint32_t records = 0, is_write = 0;
};

/// Replays a frame's trace cycle by cycle. It holds numbers of contexts and addresses, not payloads.
class Machine {
public:
    /// `khz`: clock of the chip. `disturbance` acts on memory and sinks, for tests.
    Machine(const Config& config, int khz, Disturbance disturbance = {});

    /// Starts a frame. The machine must be fresh or done. The caches keep their content. The trace must
    /// outlive the frame.
    void start(const Frame& frame, const Trace& trace) { start(frame, trace, {{}}, frame.pixels()); }
    /// Starts a part of a frame that contains `pixels` pixels of the picture. The trace needs only the rays
    /// of these tiles.
    void start(const Frame& frame, const Trace& trace, std::vector<Stretch> stretches, std::uint64_t pixels);

    /// Resets the chip between frames, and empties its caches. The memory continues its work for
    /// reset_cycles() of the configuration.
    void reset();
    /// Begins the host's writes of these memory lines, concurrently with the chip's reads.
    void write(const std::vector<std::uint32_t>& lines) { memory_.write(lines); }
    /// Waits between frames until the host has written all of them.
    void finish_writes();

    /// Performs one clock cycle.
    void step();
    /// Performs one clock cycle and sets the masks. `observe(Move)` sees every transfer before the clock
    /// edge, in link order.
    template <class Observer> void step(Observer&& observe) {
        settle_shared();
        settle_pipelines();
        show(observe);
        clock_pipelines();
        clock_shared();
    }
    /// Clocks until the frame is done, at most up to cycle `until`. It skips idle times.
    void run(std::uint64_t until) { run(until, pixels_); }
    /// Does the same, but stops early as soon as `pixels` pixels of the frame are finished.
    void run(std::uint64_t until, std::uint64_t pixels);
    /// Puts the lines that a pixel's rays read into the caches, which takes no simulated time. `pipeline` is
    /// taken modulo the number of pipelines.
    void warm(std::uint32_t pipeline, const std::uint32_t* pixel);
    /// Performs one clock cycle with the pipelines' clock edges in another order of units.
    void step_in_order(const std::array<int, pipeline_units>& order);

    const Config& config() const { return config_; }
    /// With a chip that writes hits, a ray counts when its record is written.
    bool done() const { return finished_pixels_ == pixels_; }
    std::uint64_t cycle() const { return now_; }                         ///< since construction
    std::uint64_t finished_pixels() const { return finished_pixels_; }   ///< of the frame
    /// Returns the number of cycles since the last transfer. After run() it may be off by the latency of the
    /// units: a window counts only hits, look-ups and transfers of the shared units.
    std::uint64_t quiet() const { return now_ - moved_at_; }
    const Slot& pixel(int pipeline, std::uint32_t ray) const {
        return pipelines_[std::size_t(pipeline)].pixel(ray);
    }
    Accounts accounts() const;
    /// Returns the account of the units of one pipeline.
    Accounts accounts(int pipeline) const { return pipelines_[std::size_t(pipeline)].accounts(); }
    const Memory& memory() const { return memory_; }
    /// Returns the outcome of a pipeline's cache, or of l2, at the last observed clock edge.
    CacheOutcome outcome(int pipeline, Unit cache) const {
        return cache == Unit::l2 ? l2_outcome_ : pipelines_[std::size_t(pipeline)].outcome(cache);
    }
    /// Returns the purpose of a ray. Call it while its transfer on the link spawn is observed.
    RayPurpose purpose(int pipeline, std::uint32_t ray) const {
        return pipelines_[std::size_t(pipeline)].purpose(ray);
    }
    std::string where(int pipeline, std::uint32_t ray) const {
        return pipelines_[std::size_t(pipeline)].where(ray, now_);
    }

    /// Valid and fire masks of the last observed cycle, of a pipeline and of the shared links.
    LinkMask valid_mask(int pipeline) const { return masks_[std::size_t(pipeline)].valid; }
    LinkMask fire_mask(int pipeline) const { return masks_[std::size_t(pipeline)].fire; }
    LinkMask shared_valid() const { return valid_; }
    LinkMask shared_fire() const { return fire_; }

private:
    struct Masks {
        LinkMask valid = 0, fire = 0;
    };
    void settle_shared(bool tiles = true);
    bool shared_is_still() const;
    std::uint64_t window(std::uint64_t until, std::uint64_t pixels) const;
    void pass_window(std::uint64_t cycles);
    void leave_windows();
    bool looks_idle() const;
    void settle_pipelines();
    void clock_pipelines();
    void clock_shared();
    void route(bool answered, std::uint32_t id);
    void pass_cycle();
    void sleep(std::uint64_t until);
    template <class Observer> void show(Observer& observe) const;
    bool fires(Link c) const { return fire_ >> index(c) & 1; }
    /// Returns the request to memory.
    Memory::Answer asked() const {
        if (is_write_) return {0, hits_unit_->addr(), true};
        const Cache::Request& read = has_l2_ ? l2_miss_ : client_request_;
        return {read.id, read.addr};
    }
    /// True if memory accepts a request of the caches.
    bool reads() const { return fires(Link::mem_req) & !is_write_; }

    Config config_;
    Disturbance disturbance_;
    bool has_l2_;
    Dispatch dispatch_;
    std::vector<Pipeline> pipelines_;
    std::uint32_t clients_;
    int client_shift_;   ///< position of a cache's number in the id of its request
    Arbiter arbiter_;
    std::optional<Cache> l2_;
    std::optional<Hits> hits_unit_;
    Arbiter port_{2};   // between reads and the writes of hits
    Memory memory_;
    bool undisturbed_;

    // The cycle, once settled.
    std::vector<SharedMoves> shared_moves_;     // [pipeline]
    std::vector<std::array<Fills, 4>> fills_;   // [pipeline], of a window
    std::vector<Masks> masks_;
    LinkMask valid_ = 0, fire_ = 0;   // of the shared links
    // Pipeline that gets a tile; cache whose request is chosen; cache that gets a word.
    int granted_ = -1, client_ = -1, fill_client_ = -1;
    std::uint64_t client_valid_ = 0;   ///< caches with requests
    std::uint32_t fill_id_ = 0;
    Cache::Request client_request_{}, l2_miss_{};
    std::uint32_t port_valid_ = 0;   // bit 0: a read is on offer to memory; bit 1: a line of hits
    bool is_write_ = false;          // the line is chosen

    std::uint64_t now_ = 0, moved_at_ = 0, finished_pixels_ = 0, pixels_ = 0;
    std::uint32_t finished_now_ = 0;   // pixels finished in this cycle
    Memory::PixelPlace place_;         // of the pixel, if the memory draws it
    std::uint32_t last_shared_ = 0;    // codes of dispatch and memport
    CacheOutcome l2_outcome_{};
    std::array<std::uint64_t, 16> shared_counts_{};
    CauseCounts l2_counts_{};
};

template <class Observer> void Machine::show(Observer& observe) const {
    for (int p = 0; p < config_.pipelines; ++p) {
        const Pipeline& pipeline = pipelines_[std::size_t(p)];
        for (LinkMask left = masks_[std::size_t(p)].fire; left; left &= left - 1) {
            const Link c = Link(std::countr_zero(left));
            Move move{p, c, 0, 0, 0, 0};
            switch (c) {
                case Link::tile: move.x = dispatch_.tile().x, move.y = dispatch_.tile().y; break;
                case Link::node_miss:
                    move.id = pipeline.node_miss().id, move.addr = pipeline.node_miss().addr;
                    break;
                case Link::prim_miss:
                    move.id = pipeline.prim_miss().id, move.addr = pipeline.prim_miss().addr;
                    break;
                case Link::node_fill:
                case Link::surf_fill:
                case Link::stream_fill:
                case Link::tex_fill:
                case Link::prim_fill: move.id = fill_id_; break;
                case Link::surf_miss:
                case Link::stream_miss:
                    move.id = pipeline.surf_or_stream_miss().id,
                    move.addr = pipeline.surf_or_stream_miss().addr;
                    break;
                case Link::tex_miss:
                    move.id = pipeline.tex_miss().id, move.addr = pipeline.tex_miss().addr;
                    break;
                default: {
                    move.id = pipeline.ray_on(c);
                    const Slot& pixel = c == Link::slot ? pipeline.slot() : pipeline.pixel(move.id);
                    move.x = pixel.x, move.y = pixel.y;
                    if (c == Link::node_req) move.addr = pipeline.node_addr(move.id);
                    if (c == Link::surf_req) move.addr = pipeline.surf_addr(move.id);
                    if (c == Link::texel_req) move.addr = pipeline.texel_addr(move.id);
                    if (c == Link::prim_req) move.addr = pipeline.prim_addr(move.id);
                }
            }
            observe(move);
        }
    }
    if (fires(Link::l2_req)) observe(Move{0, Link::l2_req, client_request_.id, client_request_.addr, 0, 0});
    if (fires(Link::l2_rsp)) observe(Move{0, Link::l2_rsp, l2_->answer(), 0, 0, 0});
    if (fires(Link::mem_req))
        observe(Move{0, Link::mem_req, asked().id, asked().addr, 0, 0, hits_unit_ ? hits_unit_->records() : 0,
                     is_write_});
    if (fires(Link::mem_rsp))
        observe(Move{0, Link::mem_rsp, memory_.answer().id, memory_.answer().addr, 0, 0});
}

}   // namespace rayclock
