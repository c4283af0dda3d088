// Collects the stays of rays and the accounts of units within the chosen cycles.
#include "sim/view/timeline/timeline.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"

namespace rayclock {

Timeline::Timeline(const Config& config, FrameSize size, const TimelineChoice& choice)
    : config_(config),
      size_(size),
      choice_(choice),
      open_(std::size_t(config.pipelines) * std::size_t(config.contexts)),
      before_(std::size_t(config.pipelines) + 1),
      last_span_(std::size_t(config.pipelines) + 1) {
    choice_.x1 = std::min(choice_.x1, std::uint32_t(size.width - 1));
    choice_.y1 = std::min(choice_.y1, std::uint32_t(size.height - 1));
    left_ = std::uint64_t(choice_.x1 - choice_.x0 + 1) * (choice_.y1 - choice_.y0 + 1);
    for (auto& spans : last_span_) spans.fill(-1);
}

bool Timeline::wants(std::uint32_t pixel) {
    const std::uint32_t x = pixel % std::uint32_t(size_.width), y = pixel / std::uint32_t(size_.width);
    return x >= choice_.x0 && x <= choice_.x1 && y >= choice_.y0 && y <= choice_.y1;
}

void Timeline::event(const RayEvent& event) {
    Open& open = open_of(event);
    if (event.type == RayEvent::Type::lookup) {
        open.lookup = event.outcome;
        open.looked_up = event.cycle;
        return;
    }
    if (event.link == Link::slot) open = {};
    if (open.is_open) close(open, event.cycle, &event);
    if (event.link == Link::hit) {
        open = {};
        --left_;
        return;
    }
    if (event.link == Link::spawn) open.before = open.at, open.at = -1;
    open.is_open = true;
    open.begin = event;
    open.lookup.reset();
}

/// Closes the open stay before `cycle`. `end` is the transfer that ended the stay, or null at the end of the
/// timeline.
void Timeline::close(Open& open, std::uint64_t cycle, const RayEvent* end) {
    const RayEvent& begin = open.begin;
    const std::uint64_t first = std::max(begin.cycle, choice_.first), last = std::min(cycle, choice_.last);
    if (first >= last || !choice_.purposes[std::size_t(begin.purpose)]) return;
    if (open.at < 0) {
        open.at = int(rays.size());
        rays.push_back(
            {begin.pixel, begin.ray, begin.purpose, begin.pipeline, begin.context, open.before, {}});
    }
    TimelineStay stay{
        place_after(begin.link, config_.is_stream()), first, last, last, {}, open.lookup, begin.addr};
    std::uint64_t from = cycle;
    if (open.lookup && *open.lookup != CacheOutcome::hit) {
        from = open.looked_up + 1;
        stay.waits_for = place_name(memory_place);
    } else if (end && end->waits->run[index(end->link)] > 0) {
        from = cycle - std::min<std::uint64_t>(end->waits->run[index(end->link)], cycle - begin.cycle);
        stay.waits_for = link_infos[index(end->link)].to;
    }
    stay.wait_first = std::clamp(from, first, last);
    if (stay.wait_first == last) stay.waits_for.clear();
    rays[std::size_t(open.at)].stays.push_back(std::move(stay));
}

void Timeline::cycle_done(std::uint64_t cycle, const Machine& machine) {
    now_ = cycle + 1;
    if (!choice_.whole_frame && now_ >= choice_.first && now_ <= choice_.last)
        note_accounts(machine, now_ > choice_.first);
}

void Timeline::note_accounts(const Machine& machine, bool seen) {
    const std::size_t shared = std::size_t(config_.pipelines);
    for (std::size_t p = 0; p <= shared; ++p) {
        const Accounts now = p == shared ? machine.accounts() : machine.accounts(int(p));
        for (std::size_t u = 0; seen && u < unit_count; ++u) {
            const bool of_pipeline = unit_infos[u].place <= UnitPlace::engine;
            if (is_there(Unit(u), config_) && of_pipeline == (p != shared))
                see_unit(p == shared ? -1 : int(p), Unit(u), now.units[u], before_[p].units[u]);
        }
        before_[p] = now;
    }
}

void Timeline::see_unit(int pipeline, Unit unit, const CauseCounts& now, const CauseCounts& before) {
    std::size_t code = 0;
    while (code + 1 < cause_count && now[code] == before[code]) ++code;
    const std::size_t row = pipeline < 0 ? std::size_t(config_.pipelines) : std::size_t(pipeline);
    int& last = last_span_[row][index(unit)];
    if (last >= 0 && units[std::size_t(last)].code == code) {
        units[std::size_t(last)].last = now_;
        return;
    }
    last = int(units.size());
    units.push_back({pipeline, unit, code, now_ - 1, now_});
}

void Timeline::finish() {
    for (Open& open : open_)
        if (open.is_open) close(open, std::min(now_, choice_.last), nullptr);
}

std::string cause_name(Unit unit, std::size_t code) {
    const Cause& cause = unit_infos[index(unit)].causes[code];
    return cause.kind == CauseKind::busy      ? std::string("busy: ") + cause.name
           : cause.kind == CauseKind::starved ? std::string("starved by ") + cause.name
                                              : std::string("stalled by ") + cause.name;
}

std::function<std::string(const Timeline&)> timeline_writer(const std::string& path) {
    const std::string ending = std::filesystem::path(path).extension().string();
    if (ending == ".kanata") return kanata;
    if (ending == ".pftrace") return perfetto;
    if (ending == ".fst") return fst;
    throw UserError(fmt::format(
        "{}: a timeline's ending is .kanata (for Konata), .pftrace (for Perfetto) or .fst (for GTKWave)",
        printable(path)));
}

}   // namespace rayclock
