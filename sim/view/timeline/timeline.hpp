#pragma once
// A stretch of a frame's time: where every ray was, and what every unit did, in each cycle.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/machine/machine.hpp"
#include "sim/view/observe/events.hpp"

namespace rayclock {

/// What of a frame is wanted: cycles first..last-1 of the frame, and of these the pixels and rays asked for.
struct TimelineChoice {
    std::uint64_t first = 0, last = ~0ull;
    bool whole_frame = true;   ///< no cycles were named; units are shown only of cycles that were
    std::uint32_t x0 = 0, y0 = 0, x1 = ~0u, y1 = ~0u;   ///< corners, both included
    std::array<bool, 4> purposes{true, true, true, true};
};

/// A ray in a unit, within the cycles that are wanted.
struct TimelineStay {
    std::size_t place = 0;
    std::uint64_t first = 0, last = 0;   ///< cycle after the last
    std::uint64_t wait_first = 0;        ///< from here on it waited; last: it did not
    std::string waits_for;               ///< unit
    std::optional<CacheDeed> lookup;     ///< of a cache
    std::uint32_t addr = 0;              ///< likewise
};
struct TimelineRay {
    std::uint32_t pixel = 0, ray = 0;
    RayPurpose purpose{};
    int pipeline = 0;
    std::uint32_t context = 0;
    int sender = -1;   ///< the pixel's ray before it, if that is there as well
    std::vector<TimelineStay> stays;
};
struct UnitSpan {
    int pipeline = -1;   ///< -1: of what all share
    Unit unit{};
    std::size_t code = 0;   ///< cause
    std::uint64_t first = 0, last = 0;
};

class Timeline final : public EventSink {
public:
    Timeline(const Config& config, FrameSize size, const TimelineChoice& choice);

    void begins(const Machine& machine) override { note_accounts(machine, false); }
    bool wants(std::uint32_t pixel) override;
    void event(const RayEvent& event) override;
    void cycle_done(std::uint64_t cycle, const Machine& machine) override;
    bool done() const override { return now_ >= choice_.last || (!choice_.whole_frame ? false : left_ == 0); }
    /// After the last cycle.
    void finish();

    const Config& config() const { return config_; }
    int width() const { return size_.width; }
    /// In the order in which they began.
    std::vector<TimelineRay> rays;
    std::vector<UnitSpan> units;   ///< of a unit in the order of time

private:
    struct Open {
        bool is_open = false;
        RayEvent begin;
        std::optional<CacheDeed> lookup;
        std::uint64_t looked_up = 0;
        int at = -1, before = -1;   ///< in `rays`: this ray, the pixel's ray before it
    };
    Open& open_of(const RayEvent& event) {
        return open_[std::size_t(event.pipeline) * std::size_t(config_.contexts) + event.context];
    }
    /// Of every unit: from here on its next cycles count; before that, the last one is a span's if `seen`.
    void note_accounts(const Machine& machine, bool seen);
    void close(Open& open, std::uint64_t cycle, const RayEvent* end);
    void see_unit(int pipeline, Unit unit, const CauseCounts& now, const CauseCounts& before);

    Config config_;
    FrameSize size_;
    TimelineChoice choice_;
    std::uint64_t now_ = 0, left_ = 0;   ///< cycles done; pixels that are wanted and not done
    std::vector<Open> open_;
    std::vector<Accounts> before_;   ///< of each pipeline, then of all
    std::vector<std::array<int, unit_count>> last_span_;
};

/// As text in the format Kanata 0004, which the viewer Konata reads: a ray is an instruction, units are the
/// stages of lane 0, waits those of lane 1, and a ray depends on the one that was sent before it.
std::string kanata(const Timeline& timeline);

/// As a trace of Perfetto: protobuf messages of TrackEvent. A cycle is a nanosecond.
std::string perfetto(const Timeline& timeline);

/// As a waveform in the format FST: of every unit what it did, of every context whose ray it has, where that
/// is and what it waits for, all as text. A cycle is ten nanoseconds. And the save file that GTKWave opens it
/// with.
std::string fst(const Timeline& timeline);
std::string fst_view(const Timeline& timeline, const std::string& path);

/// The writer for a file's ending, .kanata, .pftrace or .fst. Throws UserError.
std::function<std::string(const Timeline&)> timeline_writer(const std::string& path);

/// "box", "starved by memory".
std::string cause_name(Unit unit, std::size_t code);

}   // namespace rayclock
