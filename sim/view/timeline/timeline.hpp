#pragma once
// A timeline: the place of every ray and the state of every unit in each cycle of a part of a frame.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/machine/machine.hpp"
#include "model/scene/camera.hpp"
#include "sim/view/observe/events.hpp"

namespace rayclock {

/// The chosen part of a frame: the cycles first..last-1, and the pixels and the kinds of rays to show.
struct TimelineChoice {
    std::uint64_t first = 0, last = ~0ull;
    bool whole_frame = true;   ///< no cycles were chosen; units are shown only for chosen cycles
    std::uint32_t x0 = 0, y0 = 0, x1 = ~0u, y1 = ~0u;   ///< corners, inclusive
    std::array<bool, 4> purposes{true, true, true, true};
};

/// The time of a ray in a unit, clipped to the chosen cycles.
struct TimelineStay {
    std::size_t place = 0;
    std::uint64_t first = 0, last = 0;   ///< half open: `last` is the cycle after the last one
    /// The cycle in which the ray began to wait; equal to `last` if it did not wait.
    std::uint64_t wait_first = 0;
    std::string waits_for;                ///< name of the unit
    std::optional<CacheOutcome> lookup;   ///< for a cache
    std::uint32_t addr = 0;               ///< for a cache
};
/// The stays of one ray.
struct TimelineRay {
    std::uint32_t pixel = 0, ray = 0;
    RayPurpose purpose{};
    int pipeline = 0;
    std::uint32_t context = 0;
    int sender = -1;   ///< index of the pixel's previous ray in Timeline::rays, -1 if the timeline lacks it
    std::vector<TimelineStay> stays;
};
/// A run of cycles in which a unit had the same state.
struct UnitSpan {
    int pipeline = -1;   ///< -1: a unit that all pipelines share
    Unit unit{};
    std::size_t code = 0;   ///< cause
    std::uint64_t first = 0, last = 0;
};

/// Records a timeline. Call finish() after the last cycle, then read `rays` and `units`.
class Timeline final : public EventSink {
public:
    Timeline(const Config& config, FrameSize size, const TimelineChoice& choice);

    void begins(const Machine& machine) override { note_accounts(machine, false); }
    bool wants(std::uint32_t pixel) override;
    void event(const RayEvent& event) override;
    void cycle_done(std::uint64_t cycle, const Machine& machine) override;
    bool done() const override { return now_ >= choice_.last || (!choice_.whole_frame ? false : left_ == 0); }
    /// Closes all open stays. Call it after the last cycle.
    void finish();

    const Config& config() const { return config_; }
    int width() const { return size_.width; }
    /// The rays in the order in which they began.
    std::vector<TimelineRay> rays;
    std::vector<UnitSpan> units;   ///< the spans of each unit are in the order of time

private:
    struct Open {
        bool is_open = false;
        RayEvent begin;
        std::optional<CacheOutcome> lookup;
        std::uint64_t looked_up = 0;
        int at = -1, before = -1;   ///< indices in `rays`: this ray, and the pixel's previous ray
    };
    Open& open_of(const RayEvent& event) {
        return open_[std::size_t(event.pipeline) * std::size_t(config_.contexts) + event.context];
    }
    /// Stores the accounts of every unit as the base of the next cycle. If `seen`, first appends the last
    /// cycle to a span.
    void note_accounts(const Machine& machine, bool seen);
    void close(Open& open, std::uint64_t cycle, const RayEvent* end);
    void see_unit(int pipeline, Unit unit, const CauseCounts& now, const CauseCounts& before);

    Config config_;
    FrameSize size_;
    TimelineChoice choice_;
    std::uint64_t now_ = 0, left_ = 0;   ///< cycles done; chosen pixels that are not done
    std::vector<Open> open_;
    std::vector<Accounts> before_;   ///< accounts of each pipeline, then of the shared units
    std::vector<std::array<int, unit_count>> last_span_;
};

/// Writes the text format Kanata 0004, which the viewer Konata reads. A ray is an instruction, units are the
/// stages of lane 0, and waits are the stages of lane 1. A ray depends on the ray that the pixel sent before
/// it.
std::string kanata(const Timeline& timeline);

/// Writes a Perfetto trace: protobuf messages of TrackEvent. A cycle is a nanosecond.
std::string perfetto(const Timeline& timeline);

/// Writes a waveform in the format FST, with text values. Each unit has its state; each context has its ray,
/// its place and what it waits for. A cycle is ten nanoseconds. fst_view() returns the save file with which
/// GTKWave opens the waveform.
std::string fst(const Timeline& timeline);
std::string fst_view(const Timeline& timeline, const std::string& path);

/// Returns the writer for a file's extension: .kanata, .pftrace or .fst. Throws UserError for any other.
std::function<std::string(const Timeline&)> timeline_writer(const std::string& path);

/// Returns the name of a cause, such as "box" or "starved by memory".
std::string cause_name(Unit unit, std::size_t code);

}   // namespace rayclock
