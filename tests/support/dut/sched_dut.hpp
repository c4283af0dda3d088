#pragma once
// sched's model and RTL, with the same links.
#include "model/unit/sched/dispatch.hpp"
#include "model/unit/sched/sched.hpp"
#include "tests/support/dut/dut.hpp"

namespace rayclock::test {

/// The links of sched's model and RTL. A tile comes only if there is room. A finished ray's hit passes
/// through in the same cycle.
struct SchedLinks {
    Wire<Tile> tile;
    Wire<Slot> slot;
    Wire<Pixel> pixel;
    Wire<HitOut> hit;
    std::optional<std::uint32_t> cause;   ///< the cause of the cycle, if this machine reports it
};

class SchedModel : public SchedLinks {
public:
    SchedModel(const Frame& frame, const Config& config, int = 1) : sched_(config) { start(frame); }
    void start(const Frame& frame) { sched_.start(frame); }
    void eval() {
        tile.ready = sched_.tile_ready();
        slot.offer.reset();
        if (sched_.slot_valid()) slot.offer = sched_.slot();
        pixel.ready = hit.ready;
        hit.offer.reset();
        if (!pixel.offer) return;
        const Slot& place = sched_.pixel(pixel.offer->first.ray);
        hit.offer = HitOut{place.x, place.y, pixel.offer->first, pixel.offer->colour};
    }
    void commit() {
        sched_.clock(slot.fires(), tile.fires() ? &*tile.offer : nullptr,
                     {hit.fires(), pixel.offer ? pixel.offer->first.ray : 0});
    }

private:
    Sched sched_;
};

class SchedRtl : public SchedLinks {
public:
    SchedRtl(const Frame& frame, const Config& config, int seed = 1) : links_(config, "rc_sched", seed) {
        links_.fix("frame", frame);
        links_.drive_plain("start", 0);
        drive();
        links_.drive_in("tile", Wire<Tile>{});
        links_.reset();
    }
    void start(const Frame& frame) {
        links_.fix("frame", frame);
        links_.drive_plain("start", 1);
        links_.drive_in("tile", Wire<Tile>{});
        links_.settle();
        links_.clock();
        links_.drive_plain("start", 0);
    }
    void eval() {
        drive();
        links_.drive_in("tile", Wire<Tile>{});
        links_.settle();
        links_.read_in("tile", tile);
        if (tile.fires()) {
            links_.drive_in("tile", tile);
            links_.settle();
        }
        links_.read_out("slot", slot);
        links_.read_in("pixel", pixel);
        links_.read_out("hit", hit);
        cause = links_.plain("cause");
    }
    void commit() { links_.clock(); }

private:
    void drive() {
        links_.drive_out("slot", slot);
        links_.drive_in("pixel", pixel);
        links_.drive_out("hit", hit);
    }
    RtlLinks links_;
};

/// The links of dispatch's model and RTL: which pipelines have room for a tile (set by the test), the grants,
/// and the tile.
struct DispatchLinks {
    std::uint32_t tile_ready = 0;
    std::uint32_t fires = 0;
    Tile tile;
    std::optional<std::uint32_t> cause;
};

class DispatchModel : public DispatchLinks {
public:
    explicit DispatchModel(const Config& config, int = 1) : dispatch_(config) {}
    void start(const Frame& frame) { dispatch_.start(frame); }
    void eval() {
        granted_ = dispatch_.grant(tile_ready);
        fires = granted_ >= 0 ? 1u << granted_ : 0;
        tile = dispatch_.tile();
    }
    void commit() { dispatch_.clock(granted_); }

private:
    Dispatch dispatch_;
    int granted_ = -1;
};

class DispatchRtl : public DispatchLinks {
public:
    explicit DispatchRtl(const Config& config, int seed = 1) : links_(config, "rc_dispatch", seed) {
        links_.drive_plain("start", 0);
        links_.drive_plain("tile_ready", 0);
        links_.reset();
    }
    void start(const Frame& frame) {
        links_.fix("frame", frame);
        links_.drive_plain("start", 1);
        links_.drive_plain("tile_ready", tile_ready);
        links_.settle();
        links_.clock();
        links_.drive_plain("start", 0);
    }
    void eval() {
        links_.drive_plain("tile_ready", tile_ready);
        links_.settle();
        fires = links_.plain("tile_fires");
        tile = links_.payload<Tile>("tile");
        cause = links_.plain("cause");
    }
    void commit() { links_.clock(); }

private:
    RtlLinks links_;
};

}   // namespace rayclock::test
